// Copies snapshots and bins under a mutex, and derives codes of conditions from a seed.

#include "app/session/session_monitor.h"

#include <algorithm>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "protocols/kinds/kind_list.h"

namespace asperity {

namespace {

constexpr auto kBinsKept =
    static_cast<std::size_t>(SessionMonitor::kKept_s / SessionMonitor::kBin_s + 0.5);

/// A key that is equal for two surfaces of a plan that feel the same.
std::string stimulus_key(const PlannedPresentation& surface) {
  std::string key = surface.item + '\n' + surface.stimulus.name + '\n' + surface.stimulus.model +
                    '\n' + surface.stimulus.texture;
  for (const auto& [name, value] : surface.stimulus.parameters) {
    const double* number = std::get_if<double>(&value);
    key += '\n' + name + ' ' +
           (number == nullptr ? std::get<std::string>(value) : number_text(*number));
  }
  return key;
}

}  // namespace

const char* text_of(SessionPhase phase) noexcept {
  switch (phase) {
    case SessionPhase::idle:
      return "idle";
    case SessionPhase::ready:
      return "ready";
    case SessionPhase::iti:
      return "iti";
    case SessionPhase::fore:
      return "fore";
    case SessionPhase::contact:
      return "contact";
    case SessionPhase::response:
      return "response";
    case SessionPhase::feedback:
      return "feedback";
    case SessionPhase::rest:
      return "rest";
    case SessionPhase::questions:
      return "questions";
    case SessionPhase::paused:
      return "paused";
    case SessionPhase::fault:
      return "fault";
    case SessionPhase::ended:
      return "ended";
  }
  return "idle";
}

SessionSnapshot SessionMonitor::snapshot() const {
  const std::lock_guard lock(mutex_);
  return snapshot_;
}

std::shared_ptr<const SessionFacts> SessionMonitor::facts() const {
  const std::lock_guard lock(mutex_);
  return facts_;
}

std::uint64_t SessionMonitor::bins_from(std::uint64_t first, std::vector<LiveBin>& bins) const {
  bins.clear();
  const std::lock_guard lock(mutex_);
  const std::uint64_t oldest = bins_added_ - bins_.size();
  for (std::uint64_t number = std::max(first, oldest); number < bins_added_; ++number) {
    bins.push_back(bins_[number % kBinsKept]);
  }
  return bins_added_;
}

void SessionMonitor::set_facts(SessionFacts facts) {
  auto shared = std::make_shared<const SessionFacts>(std::move(facts));
  const std::lock_guard lock(mutex_);
  facts_ = std::move(shared);
  ++snapshot_.version;
}

void SessionMonitor::set_plan(std::shared_ptr<const Plan> plan) {
  SessionFacts facts = *facts_;
  facts.plan = std::move(plan);
  set_facts(std::move(facts));
}

void SessionMonitor::update(const std::function<void(SessionSnapshot&)>& change) {
  const std::lock_guard lock(mutex_);
  change(snapshot_);
  ++snapshot_.version;
}

void SessionMonitor::show(ParticipantScene scene) {
  auto shared = std::make_shared<const ParticipantScene>(std::move(scene));
  const std::lock_guard lock(mutex_);
  snapshot_.scene = std::move(shared);
  ++snapshot_.version;
}

void SessionMonitor::add_attempt(AttemptSummary attempt) {
  const std::lock_guard lock(mutex_);
  // Readers keep the list that they received.
  auto attempts = std::make_shared<std::vector<AttemptSummary>>(*snapshot_.attempts);
  attempts->push_back(std::move(attempt));
  snapshot_.attempts = std::move(attempts);
  ++snapshot_.version;
}

void SessionMonitor::add_bin(const LiveBin& bin) {
  const std::lock_guard lock(mutex_);
  if (bins_.size() < kBinsKept) {
    bins_.push_back(bin);
  } else {
    bins_[bins_added_ % kBinsKept] = bin;
  }
  ++bins_added_;
}

bool is_named_by_places(const Trial& trial) {
  return trial.is_of_procedure() || trial.kind == discrimination_kind().id;
}

BlindCodes::BlindCodes(const Plan& plan, const std::string& seed) {
  for (const Trial& trial : plan.trials) {
    if (is_named_by_places(trial)) continue;
    for (const PlannedPresentation& surface : trial.presentations) {
      codes_.emplace_back(stimulus_key(surface), "");
    }
  }
  std::sort(codes_.begin(), codes_.end());
  codes_.erase(std::unique(codes_.begin(), codes_.end()), codes_.end());
  std::vector<std::size_t> order(codes_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  Random random = Random(std::stoull(seed)).split("blind codes");
  random.shuffle(std::span(order));
  for (std::size_t i = 0; i < order.size(); ++i) {
    codes_[order[i]].second = "S" + std::to_string(i + 1);
  }
}

const std::string& BlindCodes::of(const PlannedPresentation& surface) const {
  const std::string key = stimulus_key(surface);
  const auto found = std::lower_bound(
      codes_.begin(), codes_.end(), key,
      [](const auto& code, const std::string& wanted) { return code.first < wanted; });
  static const std::string kUnknown = "?";
  return found == codes_.end() || found->first != key ? kUnknown : found->second;
}

std::string BlindCodes::of(const Trial& trial) const {
  std::string text{};
  for (const PlannedPresentation& surface : trial.presentations) {
    if (!text.empty()) text += ' ';
    text += is_named_by_places(trial) ? surface.code : of(surface);
  }
  return text;
}

std::string unblinded_text(const Trial& trial) {
  std::string text{};
  for (const PlannedPresentation& surface : trial.presentations) {
    if (!text.empty()) text += ", ";
    text += surface.stimulus.model;
    if (!surface.stimulus.texture.empty()) text += ' ' + surface.stimulus.texture;
  }
  return text;
}

}  // namespace asperity

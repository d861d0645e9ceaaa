// Implements the checks that the flow runs every block, and of the size of a session.

#include <algorithm>

#include "protocols/file/meaning_checks.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/level_tracks.h"

namespace asperity {

using Block = Protocol::Block;
using Run = Protocol::Run;

void Meaning::check_flow() {
  std::set<std::string> run_blocks{};
  std::set<std::string> iterated{};
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    const std::string pointer = pointer_to("/flow", i);
    if (const auto* const ask = std::get_if<Protocol::Ask>(&protocol_.flow[i])) {
      for (std::size_t j = 0; j < ask->questions.size(); ++j) {
        if (!protocol_.questions.contains(ask->questions[j])) {
          report(pointer_to(pointer + "/ask", j),
                 unknown_name("question", ask->questions[j], protocol_.questions));
        }
      }
    }
    const auto* const run = std::get_if<Run>(&protocol_.flow[i]);
    const auto* const pause = std::get_if<Protocol::Break>(&protocol_.flow[i]);
    if (pause != nullptr) check_break(*pause, pointer + "/break");
    if (run != nullptr && run->pause) check_break(*run->pause, pointer + "/pause");
    if (run == nullptr) continue;
    run_blocks.insert(run->block);
    if (!protocol_.blocks.contains(run->block)) {
      report(pointer + "/run", unknown_name("block", run->block, protocol_.blocks));
    }
    if (!run->for_each.empty()) {
      iterated.insert(run->for_each);
      if (!protocol_.factors.contains(run->for_each)) {
        report(pointer + "/for_each", unknown_name("factor", run->for_each, protocol_.factors));
      }
    }
    const bool has_breaks_by_contact = run->break_every_contact_s > 0.0;
    for (const auto& [key, is_stated] :
         {std::pair("break_every_trials", run->break_every_trials > 0),
          std::pair("break_every_contact_minutes", has_breaks_by_contact)}) {
      if (!is_stated || run->pause) continue;
      report(pointer,
             std::string(key) +
                 " needs a \"pause\" that states the duration of the break, such as \"pause\": "
                 "{\"minimum_s\": 60, \"text\": \"Please rest your hand.\"}");
    }
    if (run->pause && run->break_every_trials == 0 && !has_breaks_by_contact &&
        run->for_each.empty()) {
      report(pointer + "/pause",
             "the time of this pause is not stated: add break_every_trials, "
             "break_every_contact_minutes or for_each");
    }
  }
  for (const auto& [name, block] : protocol_.blocks) {
    if (!run_blocks.contains(name)) {
      report_key(pointer_to("/blocks", name), "the block " + in_quotes(name) +
                                                  " is never run; add {\"run\": \"" + name +
                                                  "\"} to the flow, or remove the block");
    }
  }
  const auto is_practised = [this](const std::string& name) {
    const auto block = protocol_.blocks.find(name);
    return block != protocol_.blocks.end() && block->second.phase == Phase::practice;
  };
  if (protocol_.resume.practice_trials > 0 &&
      std::none_of(run_blocks.begin(), run_blocks.end(), is_practised)) {
    report("/resume/practice_trials",
           "no block has the phase \"practice\", so that nothing can be practised again; remove "
           "this key, or add such a block");
  }
  if (protocol_.counterbalance != Protocol::Counterbalance::none && iterated.empty()) {
    report("/counterbalance",
           "there is nothing to counterbalance: no step of the flow has a \"for_each\"; add one, "
           "or remove this key");
  }
  constexpr std::size_t kMaximumLevels = 32;
  for (const std::string& name : iterated) {
    const auto factor = protocol_.factors.find(name);
    if (factor != protocol_.factors.end() && factor->second.levels.size() > kMaximumLevels) {
      report(pointer_to("/factors", name) + "/levels",
             "a factor of for_each has at most 32 levels; remove some, or cross the factor in the "
             "block");
    }
  }
}

bool Meaning::check_level(const std::string& factor, const Level& level,
                          const std::string& pointer) {
  const auto found = protocol_.factors.find(factor);
  if (found == protocol_.factors.end()) {
    report_key(pointer, unknown_name("factor", factor, protocol_.factors));
    return false;
  }
  const std::vector<Level>& levels = found->second.levels;
  if (std::find(levels.begin(), levels.end(), level) != levels.end()) return true;
  std::vector<std::string> names{};
  for (const Level& each : levels) names.push_back(text_of(each));
  report(pointer, in_quotes(text_of(level)) + " is not a level of the factor " + in_quotes(factor) +
                      "; use " + one_of(names) + did_you_mean(text_of(level), names));
  return false;
}

void Meaning::check_break(const Protocol::Break& pause, const std::string& pointer) {
  if (pause.drift_check && !pause.zero_force) {
    report_key(pointer + "/zero_force",
               "a drift check sends zero force to the device; remove this key, or drift_check");
  }
}

void Meaning::check_size() {
  std::size_t trials = 0;
  std::size_t rows = 1;
  std::set<std::string> iterated{};
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&protocol_.flow[i]);
    if (run == nullptr) continue;
    const Block& block = protocol_.blocks.at(run->block);
    std::size_t runs = 1;
    if (!run->for_each.empty()) {
      runs = protocol_.factors.at(run->for_each).levels.size();
      // At most two rows per level; the product is limited long before it could overflow.
      if (iterated.insert(run->for_each).second) rows = std::min(rows * 2 * runs, 2 * kMaximumRows);
    }
    const std::size_t anchors = block.has_anchors() ? block.anchor_places.size() : 0;
    trials += runs * (anchors + (block.procedure ? most_trials_of(protocol_, block)
                                                 : trial_count(protocol_, block)));
    if (trials > kMaximumSessionTrials) {
      return report(
          pointer_to("/flow", i),
          "up to here the session has more than " + std::to_string(kMaximumSessionTrials) +
              " trials, too many for a participant; reduce the number of blocks or of repetitions");
    }
  }
  if (protocol_.counterbalance != Protocol::Counterbalance::none && rows > kMaximumRows) {
    report("/counterbalance",
           "there would be more orders than participants; use for_each with fewer factors");
  }
}

}  // namespace asperity

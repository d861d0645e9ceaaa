// Implements the checks that the flow runs every block, and of the size of a session.

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/level_tracks.h"

namespace asperity {

using Block = Protocol::Block;
using Run = Protocol::Run;

namespace {

void check_break(CheckedDocument& checked, const Protocol::Break& pause,
                 const std::string& pointer) {
  if (pause.drift_check && !pause.zero_force) {
    checked.report_key(
        pointer + "/zero_force",
        "a drift check sends zero force to the device; remove this key, or drift_check");
  }
}

}  // namespace

void check_flow(CheckedDocument& checked) {
  std::set<std::string> run_blocks{};
  std::set<std::string> iterated{};
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    const std::string pointer = pointer_to("/flow", i);
    if (const auto* const ask = std::get_if<Protocol::Ask>(&checked.protocol.flow[i])) {
      for (std::size_t j = 0; j < ask->questions.size(); ++j) {
        if (!checked.protocol.questions.contains(ask->questions[j])) {
          checked.report(pointer_to(pointer + "/ask", j),
                         unknown_name("question", ask->questions[j], checked.protocol.questions));
        }
      }
    }
    const auto* const run = std::get_if<Run>(&checked.protocol.flow[i]);
    const auto* const pause = std::get_if<Protocol::Break>(&checked.protocol.flow[i]);
    if (pause != nullptr) check_break(checked, *pause, pointer + "/break");
    if (run != nullptr && run->pause) check_break(checked, *run->pause, pointer + "/pause");
    if (run == nullptr) continue;
    run_blocks.insert(run->block);
    if (!checked.protocol.blocks.contains(run->block)) {
      checked.report(pointer + "/run", unknown_name("block", run->block, checked.protocol.blocks));
    }
    if (!run->for_each.empty()) {
      iterated.insert(run->for_each);
      if (!checked.protocol.factors.contains(run->for_each)) {
        checked.report(pointer + "/for_each",
                       unknown_name("factor", run->for_each, checked.protocol.factors));
      }
    }
    const bool has_breaks_by_contact = run->break_every_contact_s > 0.0;
    for (const auto& [key, is_stated] :
         {std::pair("break_every_trials", run->break_every_trials > 0),
          std::pair("break_every_contact_minutes", has_breaks_by_contact)}) {
      if (!is_stated || run->pause) continue;
      checked.report(
          pointer,
          std::string(key) +
              " needs a \"pause\" that states the duration of the break, such as \"pause\": "
              "{\"minimum_s\": 60, \"text\": \"Please rest your hand.\"}");
    }
    if (run->pause && run->break_every_trials == 0 && !has_breaks_by_contact &&
        run->for_each.empty()) {
      checked.report(pointer + "/pause",
                     "the time of this pause is not stated: add break_every_trials, "
                     "break_every_contact_minutes or for_each");
    }
  }
  for (const auto& [name, block] : checked.protocol.blocks) {
    if (!run_blocks.contains(name)) {
      checked.report_key(pointer_to("/blocks", name), "the block " + in_quotes(name) +
                                                          " is never run; add {\"run\": \"" + name +
                                                          "\"} to the flow, or remove the block");
    }
  }
  const auto is_practised = [&checked](const std::string& name) {
    const auto block = checked.protocol.blocks.find(name);
    return block != checked.protocol.blocks.end() && block->second.phase == Phase::practice;
  };
  if (checked.protocol.resume.practice_trials > 0 &&
      std::none_of(run_blocks.begin(), run_blocks.end(), is_practised)) {
    checked.report(
        "/resume/practice_trials",
        "no block has the phase \"practice\", so that nothing can be practised again; remove "
        "this key, or add such a block");
  }
  if (checked.protocol.counterbalance != Protocol::Counterbalance::none && iterated.empty()) {
    checked.report(
        "/counterbalance",
        "there is nothing to counterbalance: no step of the flow has a \"for_each\"; add one, "
        "or remove this key");
  }
  constexpr std::size_t kMaximumLevels = 32;
  for (const std::string& name : iterated) {
    const auto factor = checked.protocol.factors.find(name);
    if (factor != checked.protocol.factors.end() && factor->second.levels.size() > kMaximumLevels) {
      checked.report(
          pointer_to("/factors", name) + "/levels",
          "a factor of for_each has at most 32 levels; remove some, or cross the factor in the "
          "block");
    }
  }
}

bool check_level(CheckedDocument& checked, const std::string& factor, const Level& level,
                 const std::string& pointer) {
  const auto found = checked.protocol.factors.find(factor);
  if (found == checked.protocol.factors.end()) {
    checked.report_key(pointer, unknown_name("factor", factor, checked.protocol.factors));
    return false;
  }
  const std::vector<Level>& levels = found->second.levels;
  if (std::find(levels.begin(), levels.end(), level) != levels.end()) return true;
  std::vector<std::string> names{};
  for (const Level& each : levels) names.push_back(text_of(each));
  checked.report(pointer, in_quotes(text_of(level)) + " is not a level of the factor " +
                              in_quotes(factor) + "; use " + one_of(names) +
                              did_you_mean(text_of(level), names));
  return false;
}

void check_size(CheckedDocument& checked) {
  std::size_t trials = 0;
  std::size_t rows = 1;
  std::set<std::string> iterated{};
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&checked.protocol.flow[i]);
    if (run == nullptr) continue;
    const Block& block = checked.protocol.blocks.at(run->block);
    std::size_t runs = 1;
    if (!run->for_each.empty()) {
      runs = checked.protocol.factors.at(run->for_each).levels.size();
      // At most two rows per level; the product is limited long before it could overflow.
      if (iterated.insert(run->for_each).second) rows = std::min(rows * 2 * runs, 2 * kMaximumRows);
    }
    const std::size_t anchors = block.has_anchors() ? block.anchor_places.size() : 0;
    trials += runs * (anchors + (block.procedure ? most_trials_of(checked.protocol, block)
                                                 : trial_count(checked.protocol, block)));
    if (trials > kMaximumSessionTrials) {
      return checked.report(
          pointer_to("/flow", i),
          "up to here the session has more than " + std::to_string(kMaximumSessionTrials) +
              " trials, too many for a participant; reduce the number of blocks or of repetitions");
    }
  }
  if (checked.protocol.counterbalance != Protocol::Counterbalance::none && rows > kMaximumRows) {
    checked.report("/counterbalance",
                   "there would be more orders than participants; use for_each with fewer factors");
  }
}

}  // namespace asperity

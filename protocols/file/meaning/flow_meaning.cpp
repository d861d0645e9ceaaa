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
        phrase("Protocols", "a drift check sends zero force to the device; remove this key, or %1")
            .with(key_name("drift_check")));
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
          pointer, phrase("Protocols", "%1 needs a %2 that states the duration of the break%3")
                       .with(key_name(key), key_name("pause"),
                             such_as_json("\"pause\": {\"minimum_s\": 60, \"text\": \"Please rest "
                                          "your hand.\"}")));
    }
    if (run->pause && run->break_every_trials == 0 && !has_breaks_by_contact &&
        run->for_each.empty()) {
      checked.report(pointer + "/pause",
                     phrase("Protocols", "the time of this pause is not stated: add %1")
                         .with(joined_by_or(key_names(
                             {"break_every_trials", "break_every_contact_minutes", "for_each"}))));
    }
  }
  for (const auto& [name, block] : checked.protocol.blocks) {
    if (!run_blocks.contains(name)) {
      checked.report_key(
          pointer_to("/blocks", name),
          phrase("Protocols",
                 "the block %1 is never run; run it in the flow%2, or remove the block")
              .with(in_quotes(name), with_json("{\"run\": " + in_quotes(name) + "}")));
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
        phrase("Protocols",
               "no block has the phase %1, so that nothing can be practised again; remove this "
               "key, or add such a block")
            .with(word_name("practice")));
  }
  if (checked.protocol.counterbalance != Protocol::Counterbalance::none && iterated.empty()) {
    checked.report(
        "/counterbalance",
        phrase("Protocols",
               "there is nothing to counterbalance: no step of the flow has a %1; add one, or "
               "remove this key")
            .with(key_name("for_each")));
  }
  constexpr std::size_t kMaximumLevels = 32;
  for (const std::string& name : iterated) {
    const auto factor = checked.protocol.factors.find(name);
    if (factor != checked.protocol.factors.end() && factor->second.levels.size() > kMaximumLevels) {
      checked.report(
          pointer_to("/factors", name) + "/levels",
          phrase("Protocols",
                 "a factor of %1 has at most %2 levels; remove some, or cross the factor in the "
                 "block")
              .with(key_name("for_each"), std::to_string(kMaximumLevels)));
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
  checked.report(pointer,
                 with_guess(phrase("Protocols", "%1 is not a level of the factor %2; use %3")
                                .with(in_quotes(text_of(level)), in_quotes(factor),
                                      joined_by_or(quoted(names))),
                            text_of(level), names));
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
          phrase("Protocols",
                 "up to here the session has more than %1 trials, too many for a participant; "
                 "reduce the number of blocks or of repetitions")
              .with(std::to_string(kMaximumSessionTrials)));
    }
  }
  if (checked.protocol.counterbalance != Protocol::Counterbalance::none && rows > kMaximumRows) {
    checked.report("/counterbalance",
                   phrase("Protocols",
                          "there would be more orders than participants; use %1 with fewer factors")
                       .with(key_name("for_each")));
  }
}

}  // namespace asperity

// Implements the checks that the trials of a block can be made and ordered.

#include <algorithm>
#include <span>
#include <string_view>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

using Block = Protocol::Block;
using Run = Protocol::Run;

namespace {

/// The factors to which values of the stimulus are bound.
std::set<std::string> factors_needed_by(const StimulusTemplate& stimulus) {
  std::set<std::string> needed{stimulus.model.factor, stimulus.texture.factor,
                               stimulus.surface.factor, stimulus.tool.factor};
  for (const auto& [name, binding] : stimulus.parameters) needed.insert(binding.factor);
  needed.erase("");
  return needed;
}

void check_anchor_pair(CheckedDocument& checked, const Block& block, const std::string& place) {
  if (!block.all_pairs) return;
  if (block.anchor_pair.size() != 2) {
    checked.report(block.anchor_pair.empty() ? place.substr(0, place.rfind('/')) : place,
                   phrase("Protocols",
                          "the anchor does not set the levels of %1; write the two levels under %2")
                       .with(in_quotes(block.all_pairs->factor), key_name("anchor_pair")));
    return;
  }
  for (std::size_t i = 0; i < block.anchor_pair.size(); ++i) {
    check_level(checked, block.all_pairs->factor, block.anchor_pair[i], pointer_to(place, i));
  }
  if (block.anchor_pair[0] == block.anchor_pair[1] && !block.all_pairs->with_identical) {
    checked.report(place,
                   phrase("Protocols",
                          "both levels are equal, and the pairs of this block are different; write "
                          "two different levels"));
  }
}

void check_anchor(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const std::string place = pointer + "/anchor";
  const nlohmann::json& stated = checked.document.root().at("blocks").at(block.name);
  if (!block.has_anchors()) {
    if (stated.contains("anchor_at")) {
      checked.report_key(
          place + "_at",
          phrase("Protocols",
                 "without %1 there are no anchors to place; add %1, or remove this key")
              .with(key_name("anchor")));
    }
    return;
  }
  check_anchor_pair(checked, block, place + "_pair");
  std::set<std::string> needed(block.crossed.begin(), block.crossed.end());
  needed.insert(block.drawn.begin(), block.drawn.end());
  for (const FactorLevels& row : block.listed) {
    for (const auto& [name, level] : row) needed.insert(name);
  }
  if (block.vary) needed.insert(block.vary->factor);
  for (const auto& [name, level] : block.anchor) {
    const bool is_varied = block.vary && block.vary->factor == name;
    if (is_varied && !std::holds_alternative<double>(level)) {
      checked.report(
          pointer_to(place, name),
          phrase("Protocols", "the level of %1 is a number, in the measure of %2; write a number")
              .with(in_quotes(name), key_name("vary")));
    }
    if (!is_varied && !check_level(checked, name, level, pointer_to(place, name))) continue;
    if (needed.erase(name) == 0) {
      checked.report_key(pointer_to(place, name),
                         phrase("Protocols",
                                "the trials of this block do not set the factor %1; remove it from "
                                "the anchor")
                             .with(in_quotes(name)));
    }
  }
  for (const std::string& name : needed) {
    checked.report(stated.contains("anchor") ? place : pointer,
                   phrase("Protocols",
                          "the anchor does not set %1, which the trials of this block set; add it "
                          "to the anchor")
                       .with(in_quotes(name)));
  }
}

void check_presented(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const std::span<const std::string_view> roles = kind_of(block).roles;
  const std::size_t stated =
      checked.document.root().at("blocks").at(block.name).at("presented").size();
  for (std::size_t i = 0; i < stated; ++i) {
    const Protocol::Presented& presented = block.presented[i];
    const std::string place = pointer_to(pointer + "/presented", i);
    if (std::find(roles.begin(), roles.end(), presented.role) == roles.end()) {
      checked.report(
          place + "/role",
          phrase("Protocols",
                 "in this kind of protocol the role of every surface is %1; write this role")
              .with(joined_by_or(quoted({roles.begin(), roles.end()}))));
    }
    for (const auto& [factor, level] : presented.with) {
      check_level(checked, factor, level, pointer_to(place + "/with", factor));
    }
    const auto stimulus = checked.protocol.stimuli.find(presented.stimulus);
    if (stimulus == checked.protocol.stimuli.end()) {
      checked.report(place + "/stimulus",
                     unknown_name("stimulus", presented.stimulus, checked.protocol.stimuli));
      continue;
    }
    const std::set<std::string> needed = factors_needed_by(stimulus->second);
    for (const Run* const run : runs_of(checked.protocol, block)) {
      std::set<std::string> given = factors_of(checked, block, run);
      if (block.all_pairs) given.insert(block.all_pairs->factor);
      for (const std::string& factor : needed) {
        if (given.contains(factor) || presented.with.contains(factor)) continue;
        checked.report(
            place, phrase("Protocols",
                          "the stimulus %1 needs the factor %2, which the trials of this block "
                          "do not set: cross, list or draw it, run the block %3 of its levels, "
                          "or fix it here with %4")
                       .with(in_quotes(presented.stimulus), in_quotes(factor), key_name("for_each"),
                             key_name("with")));
      }
    }
    for (const auto& [factor, level] : presented.with) {
      if (!needed.contains(factor)) {
        checked.report_key(pointer_to(place + "/with", factor),
                           phrase("Protocols",
                                  "the stimulus %1 does not depend on the factor %2; remove this "
                                  "key")
                               .with(in_quotes(presented.stimulus), in_quotes(factor)));
      }
    }
  }
}

/// Identical pairs, and parts of the pairs.
void check_shared_pairs(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const Block::AllPairs& pairs = *block.all_pairs;
  const auto factor = checked.protocol.factors.find(pairs.factor);
  if (factor == checked.protocol.factors.end() || factor->second.levels.size() < 2) return;
  for (const auto& [name, other] : checked.protocol.blocks) {
    if (!other.all_pairs || other.all_pairs->parts == 1 || pairs.parts == 1) continue;
    if (other.all_pairs->parts == pairs.parts) continue;
    checked.report(
        pointer + "/all_pairs/parts",
        phrase("Protocols",
               "the pairs of the block %1 are divided into %2 parts, and a participant has the "
               "same part of all blocks; write this number")
            .with(in_quotes(name), std::to_string(other.all_pairs->parts)));
    return;
  }
  const std::size_t rounds = round_count(factor->second.levels.size());
  if (static_cast<std::size_t>(pairs.parts) <= rounds) return;
  checked.report(pointer + "/all_pairs/parts",
                 phrase("Protocols",
                        "the pairs of %1 levels can be divided into at most %2 parts; write this "
                        "number or a smaller one")
                     .with(std::to_string(factor->second.levels.size()), std::to_string(rounds)));
}

/// The two surfaces of a pair are one stimulus with two levels of the factor.
void check_pairs(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  // Other kinds do not have this key.
  if (!block.all_pairs || kind_of(block).roles.front() != "alternative") return;
  check_shared_pairs(checked, block, pointer);
  const std::string& name = block.all_pairs->factor;
  const std::string at_factor = pointer + "/all_pairs/factor";
  const auto factor = checked.protocol.factors.find(name);
  if (factor == checked.protocol.factors.end()) return;
  if (factor->second.levels.size() < 2) {
    checked.report(at_factor, phrase("Protocols",
                                     "the factor %1 has one level and therefore no pairs; give it "
                                     "two levels or more")
                                  .with(in_quotes(name)));
  }
  const auto& stated = checked.document.root().at("blocks").at(block.name).at("presented");
  if (stated.size() != 1) {
    checked.report(
        pointer + "/presented",
        phrase("Protocols",
               "with %1 one stimulus is presented with two levels of the factor; list it once")
            .with(key_name("all_pairs")));
    return;
  }
  const Protocol::Presented& presented = block.presented.front();
  const std::string place = pointer_to(pointer + "/presented", 0);
  if (presented.with.contains(name)) {
    checked.report_key(
        pointer_to(place + "/with", name),
        phrase("Protocols", "the pairs set the factor %1; remove this key").with(in_quotes(name)));
  }
  if (!presented.item.empty()) {
    checked.report_key(
        place + "/item",
        phrase("Protocols", "with %1 each surface has the name of its level; remove this key")
            .with(key_name("all_pairs")));
  }
  const auto stimulus = checked.protocol.stimuli.find(presented.stimulus);
  if (stimulus != checked.protocol.stimuli.end() &&
      !factors_needed_by(stimulus->second).contains(name)) {
    checked.report(at_factor,
                   phrase("Protocols",
                          "the stimulus %1 does not depend on the factor %2, so that the two "
                          "surfaces of a pair would be the same; bind its model, texture, a body "
                          "or a parameter to the factor")
                       .with(in_quotes(presented.stimulus), in_quotes(name)));
  }
  const bool is_as_listed = block.positions == Block::Positions::as_listed;
  if (block.all_pairs->in_both_orders && !is_as_listed) {
    checked.report(pointer + "/positions",
                   phrase("Protocols", "%1 presents each pair in both orders; remove this key")
                       .with(key_name("in_both_orders")));
  }
  if (!block.all_pairs->in_both_orders && is_as_listed && block.phase == Phase::main) {
    checked.report(
        pointer + "/all_pairs",
        phrase("Protocols",
               "the same level of each pair would always be presented first, so that an order "
               "effect could not be distinguished from a difference; set %1 to true, or %2 to %3 "
               "or %4")
            .with(key_name("in_both_orders"), key_name("positions"), word_name("balanced"),
                  word_name("shuffle")));
  }
}

}  // namespace

void check_block(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  std::map<std::string, Phrase> setters{};
  const Phrase another_key = phrase("Protocols", "another key of the block");
  const auto claim = [&](const std::string& factor, const Phrase& by, const std::string& at) {
    if (!checked.protocol.factors.contains(factor)) {
      checked.report(at, unknown_name("factor", factor, checked.protocol.factors));
      return;
    }
    const auto [earlier, is_new] = setters.emplace(factor, by);
    if (!is_new) {
      checked.report(
          at, phrase("Protocols", "the factor %1 is already set by %2; set it in one place only")
                  .with(in_quotes(factor), earlier->second));
    }
  };
  for (std::size_t i = 0; i < block.crossed.size(); ++i) {
    claim(block.crossed[i], key_name("crossed"), pointer_to(pointer + "/crossed", i));
  }
  for (std::size_t i = 0; i < block.listed.size(); ++i) {
    const std::string row = pointer_to(pointer + "/listed", i);
    for (const auto& [name, level] : block.listed[i]) {
      if (check_level(checked, name, level, pointer_to(row, name)))
        setters.emplace(name, key_name("listed"));
    }
    for (const auto& [name, level] : block.listed.front()) {
      if (!block.listed[i].contains(name)) {
        checked.report(row, phrase("Protocols",
                                   "this row does not set %1, which the first row sets; set the "
                                   "same factors in every row")
                                .with(in_quotes(name)));
      }
    }
    for (const auto& [name, level] : block.listed[i]) {
      if (!block.listed.front().contains(name)) {
        checked.report_key(
            pointer_to(row, name),
            phrase("Protocols", "the first row does not set %1; set the same factors in every row")
                .with(in_quotes(name)));
      }
    }
  }
  for (std::size_t i = 0; i < block.drawn.size(); ++i) {
    claim(block.drawn[i], another_key, pointer_to(pointer + "/drawn", i));
  }
  if (block.vary) {
    claim(block.vary->factor, key_name("vary"), pointer + "/vary/parameter");
  }
  for (const auto& [name, formula] : block.derived) setters.emplace(name, key_name("derived"));
  if (block.all_pairs) {
    claim(block.all_pairs->factor, another_key, pointer + "/all_pairs/factor");
  }
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&checked.protocol.flow[i]);
    if (run != nullptr && run->block == block.name && setters.contains(run->for_each)) {
      checked.report(pointer_to("/flow", i) + "/for_each",
                     phrase("Protocols",
                            "the factor %1 is already set inside the block; set it in one place "
                            "only")
                         .with(in_quotes(run->for_each)));
    }
  }
  for (const auto& [name, place] : texts_of(checked, block.exploration, pointer + "/exploration")) {
    if (!checked.protocol.explorations.contains(name)) {
      checked.report(place, unknown_name("exploration", name, checked.protocol.explorations));
    }
  }
  for (const Run* const run : runs_of(checked.protocol, block)) {
    const std::string& factor = block.exploration.factor;
    if (factor.empty() || !checked.protocol.factors.contains(factor) ||
        factors_of(checked, block, run).contains(factor)) {
      continue;
    }
    checked.report(pointer + "/exploration",
                   phrase("Protocols",
                          "the trials of this block do not set the factor %1: cross, list or draw "
                          "it, or run the block %2 of its levels")
                       .with(in_quotes(factor), key_name("for_each")));
  }
  check_anchor(checked, block, pointer);
  check_presented(checked, block, pointer);
  check_dimension(checked, block, pointer);
  check_procedure(checked, block, pointer);
  check_pairs(checked, block, pointer);
  check_arrangement(checked, block, pointer);
  check_equal_roughness(checked, block, pointer);
  check_question(checked, block, pointer);
  check_rows(checked, block, pointer);
  check_order(checked, block, pointer);
}

void check_criterion(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  if (!block.until) return;
  const Protocol::Criterion& criterion = *block.until;
  const std::string place = pointer + "/until";
  if (kind_of(block).correct_of == nullptr) {
    checked.report(place, phrase("Protocols",
                                 "a criterion needs correct responses, and no response of a %1 is "
                                 "correct or incorrect; remove this key")
                              .with(kind_of(block).name));
  }
  if (criterion.correct > criterion.of_last) {
    checked.report(
        place + "/correct",
        phrase("Protocols",
               "the criterion cannot be met: it requires %1 correct of %2; lower this number or "
               "raise %3")
            .with(std::to_string(criterion.correct), std::to_string(criterion.of_last),
                  key_name("of_last")));
  }
  if (criterion.correct > criterion.maximum_trials) {
    checked.report(
        place + "/maximum_trials",
        phrase("Protocols", "the block ends before %1 responses can be correct: %2 is %3; raise it")
            .with(std::to_string(criterion.correct), key_name("maximum_trials"),
                  std::to_string(criterion.maximum_trials)));
  }
}

}  // namespace asperity

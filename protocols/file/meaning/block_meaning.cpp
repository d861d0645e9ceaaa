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
                   "the anchor does not set the levels of " + in_quotes(block.all_pairs->factor) +
                       "; write the two levels under \"anchor_pair\"");
    return;
  }
  for (std::size_t i = 0; i < block.anchor_pair.size(); ++i) {
    check_level(checked, block.all_pairs->factor, block.anchor_pair[i], pointer_to(place, i));
  }
  if (block.anchor_pair[0] == block.anchor_pair[1] && !block.all_pairs->with_identical) {
    checked.report(place,
                   "both levels are equal, and the pairs of this block are different; write two "
                   "different levels");
  }
}

void check_anchor(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const std::string place = pointer + "/anchor";
  const nlohmann::json& stated = checked.document.root().at("blocks").at(block.name);
  if (!block.has_anchors()) {
    if (stated.contains("anchor_at")) {
      checked.report_key(
          place + "_at",
          "without \"anchor\" there are no anchors to place; add \"anchor\", or remove this "
          "key");
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
      checked.report(pointer_to(place, name),
                     "the level of " + in_quotes(name) +
                         " is a number, in the measure of \"vary\"; write a "
                         "number");
    }
    if (!is_varied && !check_level(checked, name, level, pointer_to(place, name))) continue;
    if (needed.erase(name) == 0) {
      checked.report_key(pointer_to(place, name),
                         "the trials of this block do not set the factor " + in_quotes(name) +
                             "; remove it from the anchor");
    }
  }
  for (const std::string& name : needed) {
    checked.report(stated.contains("anchor") ? place : pointer,
                   "the anchor does not set " + in_quotes(name) +
                       ", which the trials of this block set; add it to the anchor");
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
      checked.report(place + "/role", "in this kind of protocol the role of every surface is " +
                                          one_of({roles.begin(), roles.end()}) +
                                          "; write this role");
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
        checked.report(place,
                       "the stimulus " + in_quotes(presented.stimulus) + " needs the factor " +
                           in_quotes(factor) +
                           ", which the trials of this block do not set: cross, list or draw it, "
                           "run the block for_each of its levels, or fix it here with \"with\"");
      }
    }
    for (const auto& [factor, level] : presented.with) {
      if (!needed.contains(factor)) {
        checked.report_key(pointer_to(place + "/with", factor),
                           "the stimulus " + in_quotes(presented.stimulus) +
                               " does not depend on the factor " + in_quotes(factor) +
                               "; remove this key");
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
        "the pairs of the block " + in_quotes(name) + " are divided into " +
            std::to_string(other.all_pairs->parts) +
            " parts, and a participant has the same part of all blocks; write this number");
    return;
  }
  const std::size_t rounds = round_count(factor->second.levels.size());
  if (static_cast<std::size_t>(pairs.parts) <= rounds) return;
  checked.report(pointer + "/all_pairs/parts",
                 "the pairs of " + std::to_string(factor->second.levels.size()) +
                     " levels can be divided into at most " + std::to_string(rounds) +
                     " parts; write this number or a smaller one");
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
    checked.report(at_factor, "the factor " + in_quotes(name) +
                                  " has one level and therefore no pairs; "
                                  "give it two levels or more");
  }
  const auto& stated = checked.document.root().at("blocks").at(block.name).at("presented");
  if (stated.size() != 1) {
    checked.report(
        pointer + "/presented",
        "with all_pairs one stimulus is presented with two levels of the factor; list it once");
    return;
  }
  const Protocol::Presented& presented = block.presented.front();
  const std::string place = pointer_to(pointer + "/presented", 0);
  if (presented.with.contains(name)) {
    checked.report_key(pointer_to(place + "/with", name),
                       "the pairs set the factor " + in_quotes(name) + "; remove this key");
  }
  if (!presented.item.empty()) {
    checked.report_key(place + "/item",
                       "with all_pairs each surface has the name of its level; remove this key");
  }
  const auto stimulus = checked.protocol.stimuli.find(presented.stimulus);
  if (stimulus != checked.protocol.stimuli.end() &&
      !factors_needed_by(stimulus->second).contains(name)) {
    checked.report(at_factor,
                   "the stimulus " + in_quotes(presented.stimulus) +
                       " does not depend on the factor " + in_quotes(name) +
                       ", so that the two surfaces of a pair would be the same; bind its model, "
                       "texture, a body or a parameter to the factor");
  }
  const bool is_as_listed = block.positions == Block::Positions::as_listed;
  if (block.all_pairs->in_both_orders && !is_as_listed) {
    checked.report(pointer + "/positions",
                   "in_both_orders presents each pair in both orders; remove this key");
  }
  if (!block.all_pairs->in_both_orders && is_as_listed && block.phase == Phase::main) {
    checked.report(
        pointer + "/all_pairs",
        "the same level of each pair would always be presented first, so that an order "
        "effect could not be distinguished from a difference; set \"in_both_orders\" to true, or "
        "\"positions\" to \"balanced\" or \"shuffle\"");
  }
}

}  // namespace

void check_block(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  std::map<std::string, std::string> setters{};
  const auto claim = [&](const std::string& factor, const std::string& by, const std::string& at) {
    if (!checked.protocol.factors.contains(factor)) {
      checked.report(at, unknown_name("factor", factor, checked.protocol.factors));
      return;
    }
    const auto [earlier, is_new] = setters.emplace(factor, by);
    if (!is_new) {
      checked.report(at, "the factor " + in_quotes(factor) + " is already set by " +
                             earlier->second + "; set it in one place only");
    }
  };
  for (std::size_t i = 0; i < block.crossed.size(); ++i) {
    claim(block.crossed[i], "crossed", pointer_to(pointer + "/crossed", i));
  }
  for (std::size_t i = 0; i < block.listed.size(); ++i) {
    const std::string row = pointer_to(pointer + "/listed", i);
    for (const auto& [name, level] : block.listed[i]) {
      if (check_level(checked, name, level, pointer_to(row, name))) setters.emplace(name, "listed");
    }
    for (const auto& [name, level] : block.listed.front()) {
      if (!block.listed[i].contains(name)) {
        checked.report(row, "this row does not set " + in_quotes(name) +
                                ", which the first row sets; set the same factors in every row");
      }
    }
    for (const auto& [name, level] : block.listed[i]) {
      if (!block.listed.front().contains(name)) {
        checked.report_key(pointer_to(row, name), "the first row does not set " + in_quotes(name) +
                                                      "; set the same factors in every row");
      }
    }
  }
  for (std::size_t i = 0; i < block.drawn.size(); ++i) {
    claim(block.drawn[i], "another key of the block", pointer_to(pointer + "/drawn", i));
  }
  if (block.vary) {
    claim(block.vary->factor, "vary", pointer + "/vary/parameter");
  }
  for (const auto& [name, formula] : block.derived) setters.emplace(name, "derived");
  if (block.all_pairs) {
    claim(block.all_pairs->factor, "another key of the block", pointer + "/all_pairs/factor");
  }
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&checked.protocol.flow[i]);
    if (run != nullptr && run->block == block.name && setters.contains(run->for_each)) {
      checked.report(pointer_to("/flow", i) + "/for_each",
                     "the factor " + in_quotes(run->for_each) +
                         " is already set inside the block; set it in one place only");
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
                   "the trials of this block do not set the factor " + in_quotes(factor) +
                       ": cross, list or draw it, or run the block for_each of its levels");
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
    checked.report(place, "a criterion needs correct responses, and no response of a " +
                              std::string(kind_of(block).name) +
                              " is correct or incorrect; remove this key");
  }
  if (criterion.correct > criterion.of_last) {
    checked.report(place + "/correct", "the criterion cannot be met: it requires " +
                                           std::to_string(criterion.correct) + " correct of " +
                                           std::to_string(criterion.of_last) +
                                           "; lower this number or raise of_last");
  }
  if (criterion.correct > criterion.maximum_trials) {
    checked.report(place + "/maximum_trials",
                   "the block ends before " + std::to_string(criterion.correct) +
                       " responses can be correct: maximum_trials is " +
                       std::to_string(criterion.maximum_trials) + "; raise it");
  }
}

}  // namespace asperity

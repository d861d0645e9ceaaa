// Implements the checks that the trials of a block can be made and ordered.

#include <algorithm>
#include <span>
#include <string_view>

#include "protocols/file/meaning_checks.h"
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

}  // namespace

void Meaning::check_block(const Block& block, const std::string& pointer) {
  if (!block.crossed.empty() && !block.listed.empty()) {
    report_key(pointer + "/listed", "crossed and listed exclude each other; keep one");
    return;
  }
  std::map<std::string, std::string> setters{};
  const auto claim = [&](const std::string& factor, const std::string& by, const std::string& at) {
    if (!protocol_.factors.contains(factor)) {
      report(at, unknown_name("factor", factor, protocol_.factors));
      return;
    }
    const auto [earlier, is_new] = setters.emplace(factor, by);
    if (!is_new) {
      report(at, "the factor " + in_quotes(factor) + " is already set by " + earlier->second +
                     "; set it in one place only");
    }
  };
  for (std::size_t i = 0; i < block.crossed.size(); ++i) {
    claim(block.crossed[i], "crossed", pointer_to(pointer + "/crossed", i));
  }
  for (std::size_t i = 0; i < block.listed.size(); ++i) {
    const std::string row = pointer_to(pointer + "/listed", i);
    for (const auto& [name, level] : block.listed[i]) {
      if (check_level(name, level, pointer_to(row, name))) setters.emplace(name, "listed");
    }
    for (const auto& [name, level] : block.listed.front()) {
      if (!block.listed[i].contains(name)) {
        report(row, "this row does not set " + in_quotes(name) +
                        ", which the first row sets; set the same factors in every row");
      }
    }
    for (const auto& [name, level] : block.listed[i]) {
      if (!block.listed.front().contains(name)) {
        report_key(pointer_to(row, name), "the first row does not set " + in_quotes(name) +
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
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    const auto* const run = std::get_if<Run>(&protocol_.flow[i]);
    if (run != nullptr && run->block == block.name && setters.contains(run->for_each)) {
      report(pointer_to("/flow", i) + "/for_each",
             "the factor " + in_quotes(run->for_each) +
                 " is already set inside the block; set it in one place only");
    }
  }
  for (const auto& [name, place] : texts_of(block.exploration, pointer + "/exploration")) {
    if (!protocol_.explorations.contains(name)) {
      report(place, unknown_name("exploration", name, protocol_.explorations));
    }
  }
  for (const Run* const run : runs_of(protocol_, block)) {
    const std::string& factor = block.exploration.factor;
    if (factor.empty() || !protocol_.factors.contains(factor) ||
        factors_of(block, run).contains(factor)) {
      continue;
    }
    report(pointer + "/exploration",
           "the trials of this block do not set the factor " + in_quotes(factor) +
               ": cross, list or draw it, or run the block for_each of its levels");
  }
  check_anchor(block, pointer);
  check_presented(block, pointer);
  check_dimension(block, pointer);
  check_procedure(block, pointer);
  check_pairs(block, pointer);
  check_arrangement(block, pointer);
  check_equal_roughness(block, pointer);
  check_question(block, pointer);
  check_rows(block, pointer);
  check_order(block, pointer);
}

void Meaning::check_anchor(const Block& block, const std::string& pointer) {
  const std::string place = pointer + "/anchor";
  const nlohmann::json& stated = document_.root().at("blocks").at(block.name);
  if (!block.has_anchors()) {
    if (stated.contains("anchor_at")) {
      report_key(place + "_at",
                 "without \"anchor\" there are no anchors to place; add \"anchor\", or remove this "
                 "key");
    }
    return;
  }
  if (block.until) {
    report_key(stated.contains("anchor") ? place : place + "_pair",
               "a block that ends at a criterion has no anchors, because they do not count for it; "
               "remove this key, or \"until\"");
  }
  check_anchor_pair(block, place + "_pair");
  std::set<std::string> needed(block.crossed.begin(), block.crossed.end());
  needed.insert(block.drawn.begin(), block.drawn.end());
  for (const FactorLevels& row : block.listed) {
    for (const auto& [name, level] : row) needed.insert(name);
  }
  if (block.vary) needed.insert(block.vary->factor);
  for (const auto& [name, level] : block.anchor) {
    const bool is_varied = block.vary && block.vary->factor == name;
    if (is_varied && !std::holds_alternative<double>(level)) {
      report(pointer_to(place, name), "the level of " + in_quotes(name) +
                                          " is a number, in the measure of \"vary\"; write a "
                                          "number");
    }
    if (!is_varied && !check_level(name, level, pointer_to(place, name))) continue;
    if (needed.erase(name) == 0) {
      report_key(pointer_to(place, name), "the trials of this block do not set the factor " +
                                              in_quotes(name) + "; remove it from the anchor");
    }
  }
  for (const std::string& name : needed) {
    report(stated.contains("anchor") ? place : pointer,
           "the anchor does not set " + in_quotes(name) +
               ", which the trials of this block set; add it to the anchor");
  }
}

void Meaning::check_anchor_pair(const Block& block, const std::string& place) {
  if (!block.all_pairs) {
    if (!block.anchor_pair.empty()) {
      report_key(place, "this block has no pairs; remove this key");
    }
    return;
  }
  if (block.anchor_pair.size() != 2) {
    report(block.anchor_pair.empty() ? place.substr(0, place.rfind('/')) : place,
           "the anchor does not set the levels of " + in_quotes(block.all_pairs->factor) +
               "; write the two levels under \"anchor_pair\"");
    return;
  }
  for (std::size_t i = 0; i < block.anchor_pair.size(); ++i) {
    check_level(block.all_pairs->factor, block.anchor_pair[i], pointer_to(place, i));
  }
  if (block.anchor_pair[0] == block.anchor_pair[1] && !block.all_pairs->with_identical) {
    report(place,
           "both levels are equal, and the pairs of this block are different; write two "
           "different levels");
  }
}

void Meaning::check_presented(const Block& block, const std::string& pointer) {
  const std::span<const std::string_view> roles = kind_of(block).roles;
  const std::size_t stated = document_.root().at("blocks").at(block.name).at("presented").size();
  for (std::size_t i = 0; i < stated; ++i) {
    const Protocol::Presented& presented = block.presented[i];
    const std::string place = pointer_to(pointer + "/presented", i);
    if (std::find(roles.begin(), roles.end(), presented.role) == roles.end()) {
      report(place + "/role", "in this kind of protocol the role of every surface is " +
                                  one_of({roles.begin(), roles.end()}) + "; write this role");
    }
    for (const auto& [factor, level] : presented.with) {
      check_level(factor, level, pointer_to(place + "/with", factor));
    }
    const auto stimulus = protocol_.stimuli.find(presented.stimulus);
    if (stimulus == protocol_.stimuli.end()) {
      report(place + "/stimulus", unknown_name("stimulus", presented.stimulus, protocol_.stimuli));
      continue;
    }
    const std::set<std::string> needed = factors_needed_by(stimulus->second);
    for (const Run* const run : runs_of(protocol_, block)) {
      std::set<std::string> given = factors_of(block, run);
      if (block.all_pairs) given.insert(block.all_pairs->factor);
      for (const std::string& factor : needed) {
        if (given.contains(factor) || presented.with.contains(factor)) continue;
        report(place, "the stimulus " + in_quotes(presented.stimulus) + " needs the factor " +
                          in_quotes(factor) +
                          ", which the trials of this block do not set: cross, list or draw it, "
                          "run the block for_each of its levels, or fix it here with \"with\"");
      }
    }
    for (const auto& [factor, level] : presented.with) {
      if (!needed.contains(factor)) {
        report_key(pointer_to(place + "/with", factor),
                   "the stimulus " + in_quotes(presented.stimulus) +
                       " does not depend on the factor " + in_quotes(factor) + "; remove this key");
      }
    }
  }
}

/// Identical pairs, and parts of the pairs.
void Meaning::check_shared_pairs(const Block& block, const std::string& pointer) {
  const Block::AllPairs& pairs = *block.all_pairs;
  if (!kind_of(block).rates_differences) {
    for (const auto& [key, is_used] :
         {std::pair{"with_identical", pairs.with_identical}, std::pair{"parts", pairs.parts > 1}}) {
      if (!is_used) continue;
      report_key(pointer + "/all_pairs/" + key,
                 "only a similarity has identical pairs and parts of the pairs; remove this key");
    }
    return;
  }
  const auto factor = protocol_.factors.find(pairs.factor);
  if (factor == protocol_.factors.end() || factor->second.levels.size() < 2) return;
  for (const auto& [name, other] : protocol_.blocks) {
    if (!other.all_pairs || other.all_pairs->parts == 1 || pairs.parts == 1) continue;
    if (other.all_pairs->parts == pairs.parts) continue;
    report(pointer + "/all_pairs/parts",
           "the pairs of the block " + in_quotes(name) + " are divided into " +
               std::to_string(other.all_pairs->parts) +
               " parts, and a participant has the same part of all blocks; write this number");
    return;
  }
  const std::size_t rounds = round_count(factor->second.levels.size());
  if (static_cast<std::size_t>(pairs.parts) <= rounds) return;
  report(pointer + "/all_pairs/parts",
         "the pairs of " + std::to_string(factor->second.levels.size()) +
             " levels can be divided into at most " + std::to_string(rounds) +
             " parts; write this number or a smaller one");
}

/// The two surfaces of a pair are one stimulus with two levels of the factor.
void Meaning::check_pairs(const Block& block, const std::string& pointer) {
  if (!block.all_pairs) return;
  if (kind_of(block).roles.front() != "alternative") {
    report_key(pointer + "/all_pairs", "a " + std::string(kind_of(block).name) +
                                           " does not compare surfaces; remove this key");
    return;
  }
  check_shared_pairs(block, pointer);
  const std::string& name = block.all_pairs->factor;
  const std::string at_factor = pointer + "/all_pairs/factor";
  const auto factor = protocol_.factors.find(name);
  if (factor == protocol_.factors.end()) return;
  if (factor->second.levels.size() < 2) {
    report(at_factor, "the factor " + in_quotes(name) +
                          " has one level and therefore no pairs; "
                          "give it two levels or more");
  }
  const auto& stated = document_.root().at("blocks").at(block.name).at("presented");
  if (stated.size() != 1) {
    report(pointer + "/presented",
           "with all_pairs one stimulus is presented with two levels of the factor; list it once");
    return;
  }
  const Protocol::Presented& presented = block.presented.front();
  const std::string place = pointer_to(pointer + "/presented", 0);
  if (presented.with.contains(name)) {
    report_key(pointer_to(place + "/with", name),
               "the pairs set the factor " + in_quotes(name) + "; remove this key");
  }
  if (!presented.item.empty()) {
    report_key(place + "/item",
               "with all_pairs each surface has the name of its level; remove this key");
  }
  const auto stimulus = protocol_.stimuli.find(presented.stimulus);
  if (stimulus != protocol_.stimuli.end() && !factors_needed_by(stimulus->second).contains(name)) {
    report(at_factor, "the stimulus " + in_quotes(presented.stimulus) +
                          " does not depend on the factor " + in_quotes(name) +
                          ", so that the two surfaces of a pair would be the same; bind its model, "
                          "texture, a body or a parameter to the factor");
  }
  const bool is_as_listed = block.positions == Block::Positions::as_listed;
  if (block.all_pairs->in_both_orders && !is_as_listed) {
    report(pointer + "/positions",
           "in_both_orders presents each pair in both orders; remove this key");
  }
  if (!block.all_pairs->in_both_orders && is_as_listed && block.phase == Phase::main) {
    report(
        pointer + "/all_pairs",
        "the same level of each pair would always be presented first, so that an order "
        "effect could not be distinguished from a difference; set \"in_both_orders\" to true, or "
        "\"positions\" to \"balanced\" or \"shuffle\"");
  }
}

void Meaning::check_criterion(const Block& block, const std::string& pointer) {
  if (!block.until) return;
  const Protocol::Criterion& criterion = *block.until;
  const std::string place = pointer + "/until";
  if (!kind_of(block).has_correct_responses) {
    report(place, "a criterion needs correct responses, and no response of a " +
                      std::string(kind_of(block).name) +
                      " is correct or incorrect; remove this key");
  }
  if (criterion.correct > criterion.of_last) {
    report(place + "/correct", "the criterion cannot be met: it requires " +
                                   std::to_string(criterion.correct) + " correct of " +
                                   std::to_string(criterion.of_last) +
                                   "; lower this number or raise of_last");
  }
  if (criterion.correct > criterion.maximum_trials) {
    report(place + "/maximum_trials", "the block ends before " + std::to_string(criterion.correct) +
                                          " responses can be correct: maximum_trials is " +
                                          std::to_string(criterion.maximum_trials) + "; raise it");
  }
}

}  // namespace asperity

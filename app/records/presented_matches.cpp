// Collects every combination of block, stimulus and amplitude once, in the order of the plan.

#include "app/records/presented_matches.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "results_schema/stored_json.h"

namespace asperity {

namespace {

void add_once(PresentedMatch match, std::vector<PresentedMatch>& matches) {
  if (std::find(matches.begin(), matches.end(), match) == matches.end()) {
    matches.push_back(std::move(match));
  }
}

}  // namespace

bool presents_matches(const Protocol& protocol) {
  return std::any_of(protocol.blocks.begin(), protocol.blocks.end(),
                     [](const auto& each) { return each.second.equal_roughness.has_value(); });
}

std::vector<PresentedMatch> presented_matches(const Protocol& protocol,
                                              std::span<const PlannedTrialRow> trials) {
  std::vector<PresentedMatch> matches{};
  for (const PlannedTrialRow& row : trials) {
    const auto block = protocol.blocks.find(row.block);
    if (block == protocol.blocks.end() || !block->second.equal_roughness) continue;
    const nlohmann::json trial = stored_json(row.plan_json, "trial.plan_json");
    for (const nlohmann::json& surface : trial.at("presentations")) {
      const auto status = match_status_named(surface.value("roughness_match", ""));
      if (!status || *status == MatchStatus::reference) continue;
      add_once({.block = row.block,
                .matched_in = block->second.equal_roughness->matched_in,
                .stimulus = surface.value("stimulus", ""),
                .model = surface.value("model", ""),
                .texture = surface.value("texture", ""),
                .relative_amplitude = surface.value("relative_amplitude", 1.0),
                .status = *status},
               matches);
    }
  }
  return matches;
}

std::vector<PresentedMatch> without_blocks(std::vector<PresentedMatch> matches) {
  std::vector<PresentedMatch> distinct{};
  for (PresentedMatch& match : matches) {
    match.block.clear();
    add_once(std::move(match), distinct);
  }
  return distinct;
}

}  // namespace asperity

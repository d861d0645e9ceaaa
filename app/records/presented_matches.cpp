#include "app/records/presented_matches.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace asperity {

std::vector<PresentedMatch> presented_matches(std::span<const PlannedTrialRow> plan) {
  std::vector<PresentedMatch> matches{};
  for (const PlannedTrialRow& row : plan) {
    if (row.plan_json.find("\"roughness_match\"") == std::string::npos) continue;
    const nlohmann::json trial = nlohmann::json::parse(row.plan_json);
    for (const nlohmann::json& surface : trial.at("presentations")) {
      const auto status = match_status_named(surface.value("roughness_match", ""));
      if (!status || *status == MatchStatus::reference) continue;
      const PresentedMatch match{.block = row.block,
                                 .model = surface.value("model", ""),
                                 .texture = surface.value("texture", ""),
                                 .relative_amplitude = surface.value("relative_amplitude", 1.0),
                                 .status = *status};
      if (std::find(matches.begin(), matches.end(), match) == matches.end()) {
        matches.push_back(match);
      }
    }
  }
  return matches;
}

}  // namespace asperity

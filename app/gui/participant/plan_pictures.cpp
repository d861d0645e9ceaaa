// Lays out the questions of each trial, and collects the names of their pictures by size in pixels.

#include "app/gui/participant/plan_pictures.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

namespace asperity {

std::map<int, std::vector<QString>> pictures_of_plan(const Plan& plan,
                                                     ParticipantLayoutInputs inputs,
                                                     const std::function<int(double)>& side_px) {
  std::map<int, std::vector<QString>> by_side{};
  std::set<std::vector<QString>> seen{};
  inputs.page = 0;
  for (const Trial& trial : plan.trials) {
    std::vector<int> felt{};
    for (const PlannedPresentation& surface : trial.presentations) felt.push_back(surface.position);
    std::vector<QString> names{};
    std::vector<std::pair<int, QString>> wanted{};
    for (const std::span<const Question> page : pages_of(trial)) {
      for (const ParticipantItem& item : lay_out(scene_of_question(trial, page, felt), inputs)) {
        if (item.picture.isEmpty()) continue;
        names.push_back(item.picture);
        wanted.emplace_back(side_px(item.side), item.picture);
      }
    }
    std::sort(names.begin(), names.end());
    if (!seen.insert(names).second) continue;
    for (const auto& [side, name] : wanted) by_side[side].push_back(name);
  }
  return by_side;
}

}  // namespace asperity

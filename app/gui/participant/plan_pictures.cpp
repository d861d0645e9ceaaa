// Lays out the questions that show other pictures than those before, and collects the pictures by size in pixels.

#include "app/gui/participant/plan_pictures.h"

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <tuple>

namespace asperity {

namespace {

std::vector<QString> pictures_of(const ParticipantScene& scene) {
  std::vector<QString> names{};
  if (scene.standard_picture) names.push_back(QString::fromStdString(*scene.standard_picture));
  for (const ParticipantScene::Choice& choice : scene.choices) {
    if (choice.picture) names.push_back(QString::fromStdString(*choice.picture));
  }
  return names;
}

}  // namespace

// To lay a question out takes a millisecond or two, a plan has hundreds, and all trials of most plans show the same pictures.
std::map<int, std::vector<QString>> pictures_of_plan(const Plan& plan,
                                                     ParticipantLayoutInputs inputs,
                                                     const std::function<int(double)>& side_px) {
  std::map<int, std::vector<QString>> by_side{};
  // What determines the sizes: the same pictures may stand under a longer question, or beside more options.
  std::set<std::tuple<std::vector<QString>, std::string, std::size_t>> seen{};
  inputs.page = 0;
  for (const Trial& trial : plan.trials) {
    std::vector<int> felt{};
    for (const PlannedPresentation& surface : trial.presentations) felt.push_back(surface.position);
    for (const std::span<const Question> page : pages_of(trial)) {
      const ParticipantScene scene = scene_of_question(trial, page, felt);
      std::vector<QString> names = pictures_of(scene);
      std::sort(names.begin(), names.end());
      if (names.empty() || !seen.emplace(names, scene.text, scene.choices.size()).second) continue;
      for (const ParticipantItem& item : lay_out(scene, inputs)) {
        if (!item.picture.isEmpty()) by_side[side_px(item.side)].push_back(item.picture);
      }
    }
  }
  return by_side;
}

}  // namespace asperity

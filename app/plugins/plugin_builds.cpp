// Keeps several builds of a model by the checksum of their files, and makes registries of chosen builds.

#include "app/plugins/plugin_builds.h"

#include <algorithm>
#include <utility>

namespace asperity {

std::map<std::string, std::string> plugin_builds_of(const AttemptRow& attempt) {
  std::map<std::string, std::string> builds{};
  for (const PresentationRow& surface : attempt.presentations) {
    const auto sha256 = asset_sha256(surface.assets, kPluginRole);
    if (sha256) builds.emplace(surface.model, *sha256);
  }
  return builds;
}

void ModelBuilds::add(ForceModel build) {
  const std::string& id = build.declaration.id;
  if (build.plugin && find(id, build.plugin->sha256) != nullptr) return;
  const ForceModel* const first = models_.find(id);
  if (first == nullptr || !first->plugin) {
    models_.add(std::move(build));
  } else {
    further_.push_back(std::move(build));
  }
}

const ForceModel* ModelBuilds::find(std::string_view model,
                                    std::string_view sha256) const noexcept {
  const auto is_wanted = [&](const ForceModel& build) {
    return build.declaration.id == model && build.plugin && build.plugin->sha256 == sha256;
  };
  for (const std::vector<ForceModel>* const all : {&models_.models(), &further_}) {
    const auto found = std::find_if(all->begin(), all->end(), is_wanted);
    if (found != all->end()) return &*found;
  }
  return nullptr;
}

bool ModelBuilds::has(const std::map<std::string, std::string>& builds) const noexcept {
  return std::all_of(builds.begin(), builds.end(), [this](const auto& build) {
    return find(build.first, build.second) != nullptr;
  });
}

ModelRegistry ModelBuilds::with(const std::map<std::string, std::string>& builds) const {
  ModelRegistry models{};
  for (const ForceModel& model : models_.models()) {
    const auto wanted = builds.find(model.declaration.id);
    const ForceModel* const build =
        wanted == builds.end() ? nullptr : find(wanted->first, wanted->second);
    models.add(build == nullptr ? model : *build);
  }
  return models;
}

}  // namespace asperity

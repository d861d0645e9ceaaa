// Several builds of plug-ins, to render attempts again with the builds that rendered them.

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderers/force/force_model.h"
#include "results_schema/rows.h"

namespace asperity {

/// The builds of plug-ins that rendered an attempt: force model → SHA-256.
std::map<std::string, std::string> plugin_builds_of(const AttemptRow& attempt);

/// Force models, with any number of builds of each plug-in.
class ModelBuilds final {
 public:
  /// Implicit: models with one build of each plug-in.
  ModelBuilds(ModelRegistry models) : models_(std::move(models)) {}

  /// Adds a build. The first one of a force model is among `models`; a build that is there already is ignored.
  ///
  /// Errors: std::invalid_argument as ModelRegistry::add, for the id of a built-in model.
  void add(ForceModel build);

  const ModelRegistry& models() const noexcept { return models_; }
  /// Null if the build is not there.
  const ForceModel* find(std::string_view model, std::string_view sha256) const noexcept;
  /// Whether all of these builds are there.
  bool has(const std::map<std::string, std::string>& builds) const noexcept;
  /// The models with these builds in place of the first ones, where they are there.
  ModelRegistry with(const std::map<std::string, std::string>& builds) const;

 private:
  ModelRegistry models_{};
  std::vector<ForceModel> further_{};
};

}  // namespace asperity

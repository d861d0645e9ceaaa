// Declares the force models of the windows: the built-in ones and those of plug-ins.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"

namespace asperity {

struct LoadedModels {
  ModelRegistry models = built_in_models();
  std::vector<std::string> problems{};  ///< why plug-ins were not loaded, a sentence each
};

/// Loads plug-ins and checks each of them with the conformance suite, which takes from a moment to minutes.
///
/// Empty when a stop was requested, which takes effect between two parts of the suite: a plug-in whose code does not return
/// cannot be stopped. `progress` receives 0 to 1. Threads: any, one at a time (conformance_of).
std::optional<LoadedModels> load_models(const std::vector<std::filesystem::path>& plugins,
                                        const std::stop_token& stop,
                                        const std::function<void(double)>& progress);

}  // namespace asperity

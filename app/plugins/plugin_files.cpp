#include "app/plugins/plugin_files.h"

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <dlfcn.h>

#include "renderers/built_in_models.h"
#include "renderers/conformance/conformance.h"
#include "renderers/plugin/plugin_model.h"
#include "results_schema/sha256.h"

namespace asperity {

namespace {

constexpr const char* kFunction = "asperity_plugin_model";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw std::runtime_error("the plug-in " + file.string() + " cannot be used: " + problem);
}

/// Shared ownership: the model and each of its renderers keep the library.
std::shared_ptr<void> loaded(const std::filesystem::path& file) {
  // Without a folder the system would search its own folders.
  void* const library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const why = dlerror();
    refuse(file, std::string(why == nullptr ? "it cannot be loaded" : why) +
                     "; give a shared library for this computer");
  }
  return {library, [](void* opened) { dlclose(opened); }};
}

const asperity_model& description_in(const std::filesystem::path& file, void* library) {
  using Function = const asperity_model* (*)();
  const auto function = reinterpret_cast<Function>(dlsym(library, kFunction));
  if (function == nullptr) {
    refuse(file, std::string("it has no function ") + kFunction +
                     "; define it as asperity_plugin.h declares it");
  }
  const asperity_model* description = nullptr;
  try {
    description = function();
  } catch (...) {
    refuse(file, std::string("its function ") + kFunction + " threw an exception; correct it");
  }
  if (description == nullptr) {
    refuse(file, std::string("its function ") + kFunction + " returned no model; correct it");
  }
  return *description;
}

void require_conformance(const std::filesystem::path& file, const ForceModel& model) {
  std::string violated{};
  for (const ConformanceCheck& check : conformance_of(model)) {
    if (check.result != Conformance::violated) continue;
    violated += (violated.empty() ? "" : "; ") + std::string(check.name) + ": " + check.measured +
                " (required: " + check.required + ")";
  }
  if (violated.empty()) return;
  refuse(file, "its model " + model.declaration.id + " violates the conformance suite: " +
                   violated + "; correct it, then run asperity models --conformance --plugin FILE");
}

enum class Suite { run, leave_out };

ModelRegistry models_and(const std::vector<std::filesystem::path>& plugins, Suite suite) {
  ModelRegistry models = built_in_models();
  for (const std::filesystem::path& file : plugins) {
    ForceModel model = open_plugin(file);
    if (suite == Suite::run) require_conformance(file, model);
    try {
      models.add(std::move(model));
    } catch (const std::invalid_argument& error) {
      refuse(file, error.what());
    }
  }
  return models;
}

}  // namespace

ForceModel open_plugin(const std::filesystem::path& file) {
  std::error_code none{};
  if (!std::filesystem::is_regular_file(file, none)) {
    refuse(file, "there is no such file; check its name");
  }
  PluginOrigin origin{.file = file.filename().string(), .sha256 = sha256_of_file(file)};
  const std::shared_ptr<void> library = loaded(file);
  const asperity_model& description = description_in(file, library.get());
  try {
    ForceModel model = model_of_plugin(description, library);
    model.plugin = std::move(origin);
    return model;
  } catch (const std::invalid_argument& error) {
    refuse(file, error.what());
  }
}

ModelRegistry models_with(const std::vector<std::filesystem::path>& plugins) {
  return models_and(plugins, Suite::run);
}

ModelRegistry models_with_unchecked(const std::vector<std::filesystem::path>& plugins) {
  return models_and(plugins, Suite::leave_out);
}

}  // namespace asperity

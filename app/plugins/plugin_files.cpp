// Loads a private copy of each library, reads its description, and runs the conformance suite.

#include "app/plugins/plugin_files.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <dlfcn.h>

#include "renderers/built_in_models.h"
#include "renderers/plugin/plugin_call.h"
#include "renderers/plugin/plugin_model.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"

namespace asperity {

namespace {

constexpr const char* kFunction = "asperity_plugin_model";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw std::runtime_error("the plug-in " + file.string() + " cannot be used: " + problem);
}

/// A file with the same content, in a folder of its own with a new name.
///
/// The system returns a library that is loaded already if its path is given again, although the file has changed, and a file
/// that is overwritten while it is loaded changes running code.
class PrivateCopy final {
 public:
  PrivateCopy(const std::filesystem::path& file, const std::string& content) {
    std::string folder =
        (std::filesystem::temp_directory_path() / "asperity-plugin-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
      refuse(file, "no folder can be made in " + std::filesystem::temp_directory_path().string() +
                       "; set TMPDIR to a folder that you may write to");
    }
    folder_ = folder;
    path_ = folder_ / file.filename();
    write_file(path_, content, Overwrite::refuse);
  }
  PrivateCopy(const PrivateCopy&) = delete;
  PrivateCopy& operator=(const PrivateCopy&) = delete;
  ~PrivateCopy() {
    std::error_code kept{};
    std::filesystem::remove_all(folder_, kept);
  }
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path folder_{};
  std::filesystem::path path_{};
};

/// Shared ownership: the model and each of its renderers keep the library, which needs no file once it is loaded.
std::shared_ptr<void> loaded(const std::filesystem::path& file, const std::string& content) {
  const PrivateCopy copy(file, content);
  const std::string name = file.filename().string();
  const auto dlopened = [&] {
    const PluginCall call(name.c_str(), PluginFunction::initialisation);
    return dlopen(copy.path().c_str(), RTLD_NOW | RTLD_LOCAL);
  };
  void* const library = dlopened();
  if (library == nullptr) {
    const char* const reason = dlerror();
    std::string why = reason == nullptr ? "it cannot be loaded" : reason;
    const std::string copied = copy.path().string() + ": ";
    if (why.starts_with(copied)) why.erase(0, copied.size());
    refuse(file, why + "; give a shared library for this computer");
  }
  return {library, [name](void* opened) {
            const PluginCall call(name.c_str(), PluginFunction::finalisation);
            dlclose(opened);
          }};
}

const asperity_model& description_in(const std::filesystem::path& file, void* library) {
  using Function = const asperity_model* (*)();
  const auto function = reinterpret_cast<Function>(dlsym(library, kFunction));
  if (function == nullptr) {
    refuse(file, std::string("it has no function ") + kFunction +
                     "; define it as asperity_plugin.h declares it");
  }
  const asperity_model* description = nullptr;
  const std::string name = file.filename().string();
  const PluginCall call(name.c_str(), PluginFunction::model);
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

void require_conformance(const std::filesystem::path& file, const ForceModel& model,
                         const ConformanceCourse& course) {
  std::string violated{};
  for (const ConformanceCheck& check : conformance_of(model, course)) {
    if (check.result != Conformance::violated) continue;
    violated += (violated.empty() ? "" : "; ") + std::string(check.name) + ": " + check.measured +
                " (required: " + check.required + ")";
  }
  if (course.stop.stop_requested()) refuse(file, "its checks were stopped; load it again");
  if (violated.empty()) return;
  refuse(file, "its model " + model.declaration.id + " violates the conformance suite: " +
                   violated + "; correct it, then run asperity models --conformance --plugin FILE");
}

/// A plug-in that meets the conformance suite.
ForceModel checked(const std::filesystem::path& file, const ConformanceCourse& course = {}) {
  ForceModel model = open_plugin(file);
  require_conformance(file, model, course);
  return model;
}

template <class Models>
void add(const std::filesystem::path& file, ForceModel model, Models& models) {
  try {
    models.add(std::move(model));
  } catch (const std::invalid_argument& error) {
    refuse(file, error.what());
  }
}

}  // namespace

ForceModel open_plugin(const std::filesystem::path& file) {
  std::error_code none{};
  if (!std::filesystem::is_regular_file(file, none)) {
    refuse(file, "there is no such file; check its name");
  }
  const std::string content = read_file(file);
  PluginOrigin origin{.file = file.filename().string(), .sha256 = sha256_of(content)};
  name_plugins_that_end_the_program();
  const std::shared_ptr<void> library = loaded(file, content);
  const asperity_model& description = description_in(file, library.get());
  try {
    ForceModel model = model_of_plugin(description, library, origin.file);
    model.plugin = origin;
    return model;
  } catch (const std::invalid_argument& error) {
    refuse(file, error.what());
  }
}

void add_plugin(const std::filesystem::path& file, ModelRegistry& models,
                const ConformanceCourse& course) {
  add(file, checked(file, course), models);
}

ModelRegistry models_with(const std::vector<std::filesystem::path>& plugins) {
  ModelRegistry models = built_in_models();
  for (const std::filesystem::path& file : plugins) add_plugin(file, models);
  return models;
}

ModelBuilds models_with_builds(const std::vector<std::filesystem::path>& plugins) {
  ModelBuilds builds(built_in_models());
  for (const std::filesystem::path& file : plugins) add(file, checked(file), builds);
  return builds;
}

ModelRegistry models_with_unchecked(const std::vector<std::filesystem::path>& plugins) {
  ModelRegistry models = built_in_models();
  for (const std::filesystem::path& file : plugins) add(file, open_plugin(file), models);
  return models;
}

}  // namespace asperity

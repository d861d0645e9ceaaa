// Loads the plug-ins into the registry of built-in force models, and collects the message of each that fails.

#include "app/gui/base/loaded_models.h"

#include <cstddef>
#include <exception>

#include "app/plugins/plugin_files.h"
#include "results_schema/error_text.h"

namespace asperity {

std::optional<LoadedModels> load_models(const std::vector<std::filesystem::path>& plugins,
                                        const std::stop_token& stop,
                                        const std::function<void(double)>& progress) {
  LoadedModels loaded{};
  for (std::size_t i = 0; i < plugins.size(); ++i) {
    const auto of_all = [&](double done) {
      progress((static_cast<double>(i) + done) / static_cast<double>(plugins.size()));
    };
    try {
      add_plugin(plugins[i], loaded.models, {.stop = stop, .progress = of_all});
    } catch (const std::exception& error) {
      loaded.problems.emplace_back(message_of(error));
    }
    if (stop.stop_requested()) return {};
  }
  return loaded;
}

}  // namespace asperity

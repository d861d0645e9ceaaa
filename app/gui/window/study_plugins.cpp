// Loads the plug-ins of the settings before a study is shown.

#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "app/gui/base/loaded_models.h"
#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "app/gui/study/plugin_loading.h"
#include "app/gui/study/plugins_dialog.h"
#include "app/gui/window/study_window.h"

namespace asperity {

void StudyWindow::ask_for_plugins() {
  if (refuse_to_cover()) return;
  auto* dialog = new PluginsDialog(plugin_files(), this);
  connect(dialog, &PluginsDialog::wanted, this, &StudyWindow::load_plugins);
  dialog->open();
}

void StudyWindow::load_plugins(const std::vector<std::filesystem::path>& files) {
  if (must_stay([this, files] { load_plugins(files); })) return;
  // They are loaded before they are remembered: one that ends the program must not end it at every start.
  with_plugins(
      files,
      [this, files](const LoadedModels& models) {
        remember_plugin_files(files);
        if (study_ != nullptr) show_study(study_->folder(), models);
      },
      tr("The plug-ins are unchanged, because loading them was cancelled."));
}

void StudyWindow::with_plugins(const std::vector<std::filesystem::path>& files,
                               std::function<void(const LoadedModels&)> use,
                               const QString& cancelled) {
  if (files.empty()) {
    use({});
    return;
  }
  auto* loading = new PluginLoading(files, this);
  loading_ = loading;
  connect(loading, &PluginLoading::loaded, this,
          [this, use = std::move(use)](const LoadedModels& models) {
            loading_ = nullptr;
            use(models);
          });
  connect(loading, &PluginLoading::cancelled, this, [this, cancelled] {
    loading_ = nullptr;
    banner_->show_news(State::look, cancelled);
  });
  loading->open();
}

}  // namespace asperity

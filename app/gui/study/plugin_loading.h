// Declares the dialog that is shown while plug-ins are loaded and checked.

#pragma once

#include <filesystem>
#include <vector>

#include <QtWidgets/QDialog>

#include "app/gui/base/loaded_models.h"
#include "app/gui/look/background_task.h"

class QProgressBar;
class QPushButton;

namespace asperity {

/// Loads plug-ins and checks them on another thread. Begins when it is made; emits one of its signals, after it was hidden.
///
/// Closing the dialog cancels: it stays until the part of the checks that runs has ended, so that the code of a plug-in never
/// runs twice at a time. If the dialog is destroyed earlier, its destructor waits for this part, and nothing is emitted.
///
/// The names of its parts: "loading_progress", "loading_cancel".
class PluginLoading final : public QDialog {
  Q_OBJECT
 public:
  explicit PluginLoading(const std::vector<std::filesystem::path>& plugins,
                         QWidget* parent = nullptr);

  void reject() override;

 signals:
  void loaded(const asperity::LoadedModels& models);
  void cancelled();

 private:
  QProgressBar* bar_ = nullptr;
  QPushButton* cancel_ = nullptr;
  bool is_cancelled_ = false;
  BackgroundTask task_{};
};

}  // namespace asperity

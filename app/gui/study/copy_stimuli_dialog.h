// Declares the dialog in which stimuli of another study are chosen and copied.

#pragma once

#include <filesystem>
#include <vector>

#include <QtWidgets/QDialog>

#include "app/gui/base/commands_button.h"
#include "app/gui/look/background_task.h"
#include "app/tasks/stimulus_files.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace asperity {

class OpenStudy;
class StateLabel;

/// The stimuli of the other study with a tick; those whose name the study has cannot be chosen, with the reason.
class CopyStimuliDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit CopyStimuliDialog(OpenStudy& study, QWidget* parent = nullptr);

  void show_study(const std::filesystem::path& other);
  /// While stimuli are copied, no further one is begun, and the dialog stays until the present one is complete.
  void reject() override;

 signals:
  void copied(int stimuli);  ///< so many; can be fewer than chosen, and none

 private:
  void choose_study();
  void show_stimuli(const std::vector<ForeignStimulus>& stimuli);
  void show_whether_chosen();
  std::vector<std::string> chosen() const;
  std::vector<ShownCommand> commands() const;
  void copy();
  void set_copying(bool is_copying);

  OpenStudy& study_;
  std::filesystem::path other_{};
  bool is_copying_ = false;
  QPushButton* choose_ = nullptr;
  QLabel* folder_ = nullptr;
  QListWidget* list_ = nullptr;
  StateLabel* state_ = nullptr;
  QPushButton* commands_ = nullptr;
  QPushButton* copy_ = nullptr;
  BackgroundTask task_{};
};

}  // namespace asperity

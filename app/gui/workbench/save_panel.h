// Under the recipe: what the relief measures, its name in the study, and saving it there.

#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include <QtWidgets/QFrame>

#include "app/gui/base/commands_button.h"
#include "app/gui/look/background_task.h"
#include "app/gui/workbench/opened_picture.h"
#include "results_schema/files/atomic_file.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace asperity {

class Banner;
class OpenStudy;
class TaskLine;

/// Saves as stimuli/NAME.png, its sidecar and NAME_photo.png, from the whole photograph and the
/// recipe of that moment. Why a name is refused stands under it.
class SavePanel final : public QFrame {
  Q_OBJECT
 public:
  /// News of saving goes to `banner`, which outlives the panel as `study` does.
  /// `unready` gives the reason for which a photograph cannot be saved yet, or an empty text.
  SavePanel(OpenStudy& study, Banner& banner, std::function<TextureRecipe()> recipe,
            std::function<QString()> unready, QWidget* parent = nullptr);

  /// Proposes a name.
  void show_opened(std::shared_ptr<const OpenedPicture> opened);
  void show_facts(const HeightField& field);
  /// Enables or disables saving, with the reason.
  void check();
  bool is_saving() const noexcept { return saving_.is_running(); }

 signals:
  /// What is shown is what was saved as stimuli/NAME.png.
  void saved(const QString& name);

 private:
  void save(Overwrite overwrite);
  std::vector<ShownCommand> commands() const;

  OpenStudy& study_;
  Banner& banner_;
  std::function<TextureRecipe()> recipe_{};
  std::function<QString()> unready_{};
  std::shared_ptr<const OpenedPicture> opened_{};
  QLabel* facts_ = nullptr;
  QLineEdit* name_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* commands_ = nullptr;
  QLabel* name_problem_ = nullptr;
  TaskLine* line_ = nullptr;
  BackgroundTask saving_{};
};

/// Its extent and how high it is, in millimetres and micrometres.
QString facts_of(const HeightField& field);

/// A name for the relief of this file that can be saved in the folder `stimuli` and replaces
/// nothing there: what is plain of the file's own name, without the ending of photographs.
QString proposed_name(const std::filesystem::path& file, const std::filesystem::path& stimuli);

}  // namespace asperity

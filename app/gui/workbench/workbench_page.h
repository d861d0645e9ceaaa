// The workbench: from a photograph to a relief, and what the force models make of it.

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/gui/look/background_task.h"
#include "app/gui/look/newest_work.h"
#include "app/gui/workbench/step_strip.h"
#include "app/gui/workbench/texture_preview.h"
#include "app/height_field_files.h"
#include "stimuli/photograph_advice.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QLayout;
class QLineEdit;
class QMenu;
class QPushButton;
class QStackedWidget;

namespace asperity {

class Banner;
class EmptyState;
class ForceComparison;
class OpenStudy;
class ParameterForm;
class ReliefView;
class SignalPlots;
class StateLabel;

/// A photograph is dropped or opened, its steps and its relief are shown, its parameters changed;
/// the result is saved to the study as stimuli/NAME.png, its sidecar and NAME_photo.png. A relief
/// (also a height field of the study) is compared through the force models.
///
/// A photograph of more than kPreviewSide pixels a side is shown reduced, and computed whole when
/// it is saved. What cannot be read or computed is said in a banner, and what was there stays.
class WorkbenchPage final : public QWidget {
  Q_OBJECT
 public:
  explicit WorkbenchPage(OpenStudy& study, QWidget* parent = nullptr);
  ~WorkbenchPage() override;

  /// In the background. A PNG that has a sidecar beside it is a height field.
  void open_file(const std::filesystem::path& file);

  TextureRecipe recipe() const;
  /// What is shown; null while there is nothing.
  std::shared_ptr<const HeightField> field() const noexcept { return preview_.field; }
  /// Nothing is being computed, drawn, read or written.
  bool is_settled() const;

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Opened {
    std::filesystem::path file{};
    TextureRecipe recipe{};     ///< when it was opened
    LoadedPhotograph loaded{};  ///< empty for a height field
    GreyImage reduced{};
    GreyImage coarse{};
    QImage original{};
    std::string advice{};
    PhotographResemblance resemblance = PhotographResemblance::nothing_clear;
    TexturePreview preview{};
  };
  enum class Mode { making, comparing };

  QWidget* make_head();
  QWidget* make_workspace();
  QWidget* make_recipe_panel();
  void add_recipe_groups(QLayout* layout, QWidget* parent);
  QWidget* make_save_panel();
  void set_mode(Mode mode);
  void fill_study_menu(QMenu& menu);
  void choose_file();
  void take(std::shared_ptr<const Opened> opened);
  void show_preview(TexturePreview preview);
  void recompute();
  void say_what_it_shows(int kind);
  void choose_step(Step step);
  void show_line(double y_m);
  void show_forces();
  void check_name();
  void keep_unsaved(bool unsaved);
  void save(Overwrite overwrite);

  OpenStudy& study_;
  Banner* banner_ = nullptr;
  Banner* recipe_banner_ = nullptr;
  QButtonGroup* mode_ = nullptr;
  QStackedWidget* pages_ = nullptr;   // empty, working
  QStackedWidget* centre_ = nullptr;  // relief, a step
  QStackedWidget* plots_ = nullptr;   // profile, forces
  QStackedWidget* side_ = nullptr;    // recipe, models
  StepStrip* strip_ = nullptr;
  ReliefView* relief_ = nullptr;
  QLabel* step_picture_ = nullptr;
  QLabel* caption_ = nullptr;
  SignalPlots* profile_ = nullptr;
  SignalPlots* forces_ = nullptr;
  ForceComparison* comparison_ = nullptr;
  QWidget* recipe_panel_ = nullptr;
  QLabel* finished_ = nullptr;  // why a height field has no recipe here
  QComboBox* kind_ = nullptr;
  QLabel* expectation_ = nullptr;
  StateLabel* hint_ = nullptr;
  QLabel* advice_ = nullptr;
  QLabel* facts_ = nullptr;
  std::vector<ParameterForm*> forms_{};
  QLineEdit* name_ = nullptr;
  QPushButton* save_ = nullptr;
  QLabel* name_problem_ = nullptr;

  std::shared_ptr<const Opened> opened_{};
  TexturePreview preview_{};
  bool has_sound_ = false;  // asked for when forces are first looked at
  double line_y_m_ = 0.0;
  BackgroundTask opening_{};
  BackgroundTask saving_{};
  NewestWork work_{};
};

}  // namespace asperity

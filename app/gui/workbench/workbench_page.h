// The workbench: from a photograph to a relief, and what the force models make of it.

#pragma once

#include <filesystem>
#include <memory>

#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

#include "app/gui/look/background_task.h"
#include "app/gui/look/newest_work.h"
#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/opened_picture.h"
#include "app/gui/workbench/recipe_panel.h"
#include "app/gui/workbench/rendering_panel.h"
#include "app/gui/workbench/step_strip.h"

class QButtonGroup;
class QLabel;
class QMenu;
class QStackedWidget;

namespace asperity {

class Banner;
class OpenStudy;
class ReliefView;
class SavePanel;
class SignalPlot;
class SignalPlots;
class TaskLine;

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

  /// In the background, and can be cancelled. A PNG that has a sidecar beside it is a height field; a rendering of the
  /// study is its texture with its force model.
  void open_file(const std::filesystem::path& file);

  /// What is open, for a page that takes the place of this one.
  struct Work {
    std::shared_ptr<const OpenedPicture> opened{};  ///< null: nothing
    TextureRecipe recipe{};
    RecipePanel::Statements stated{};
    std::string saved_as{};
    bool compares = false;
    ForceComparison::Choices comparison{};
  };
  Work work() const;
  /// Of a page that is gone and had nothing unsaved.
  void resume(const Work& work);

  TextureRecipe recipe() const;
  /// What is shown; null while there is nothing.
  std::shared_ptr<const HeightField> field() const noexcept { return preview_.field; }
  /// Nothing is being computed, drawn, read or written.
  bool is_settled() const;

 signals:
  /// These renderings are to be used in an experiment.
  void use_wanted(const QStringList& renderings);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Mode { making, comparing };

  QWidget* make_empty();
  QLayout* make_head();
  QWidget* make_workspace();
  void set_mode(Mode mode);
  void fill_study_menu(QMenu& menu);
  void choose_file();
  void read(const std::filesystem::path& file, const QStringList& remarks);
  void open_rendering(const std::filesystem::path& file);
  void take(std::shared_ptr<const OpenedPicture> opened, const QStringList& remarks);
  void take_rendering(const Rendering& rendering);
  void show_preview(TexturePreview preview);
  void choose_panels();
  void recompute();
  void choose_step(Step step);
  void show_line(double y_m);
  void show_forces();
  void show_dent();
  void keep_unsaved(bool unsaved);
  std::string relief_of_study() const;
  RenderingPanel::Compared compared() const;

  OpenStudy& study_;
  Banner* banner_ = nullptr;
  TaskLine* reading_ = nullptr;
  QButtonGroup* mode_ = nullptr;
  QStackedWidget* pages_ = nullptr;   // empty, working
  QStackedWidget* centre_ = nullptr;  // relief, a step
  QStackedWidget* plots_ = nullptr;   // profile, forces
  QStackedWidget* side_ = nullptr;    // recipe and saving, models
  StepStrip* strip_ = nullptr;
  ReliefView* relief_ = nullptr;
  QLabel* finished_ = nullptr;
  QLabel* step_picture_ = nullptr;
  QLabel* caption_ = nullptr;
  SignalPlots* profile_ = nullptr;
  SignalPlots* forces_ = nullptr;
  SignalPlot* roughness_ = nullptr;
  ForceComparison* comparison_ = nullptr;
  RecipePanel* recipe_ = nullptr;
  SavePanel* save_ = nullptr;
  RenderingPanel* renderings_ = nullptr;

  std::shared_ptr<const OpenedPicture> opened_{};
  std::string
      saved_as_{};  ///< relative to the study; empty while the relief of a photograph is not saved
  TexturePreview preview_{};
  bool has_sound_ = false;  // asked for when forces are first looked at
  double line_y_m_ = 0.0;
  QString dent_of_{};  // the model whose dent is shown
  BackgroundTask opening_{};
  NewestWork work_{};
};

}  // namespace asperity

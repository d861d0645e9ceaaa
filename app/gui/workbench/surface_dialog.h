// Declares the dialog in which a texture with known heights is computed.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtGui/QImage>
#include <QtWidgets/QDialog>

#include "app/gui/base/commands_button.h"
#include "app/gui/look/background_task.h"
#include "app/gui/look/newest_work.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/heights/surface_declaration.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace asperity {

class OpenStudy;
class ParameterForm;
class StateLabel;

/// Everything that `asperity synth` does, with a preview: its kinds and parameters are those that the surfaces declare.
class SurfaceDialog final : public QDialog {
  Q_OBJECT
 public:
  /// `study` outlives the dialog.
  explicit SurfaceDialog(OpenStudy& study, QWidget* parent = nullptr);

  /// The preview is that of the present values.
  bool is_settled() const { return !work_.is_busy() && !saving_.is_running(); }

 signals:
  /// Relative to the study.
  void saved(const QString& path);

 private:
  struct Preview;

  QWidget* make_forms();
  QWidget* make_picture();
  void choose_kind();
  void compute();
  void take(const Preview& preview);
  void check();
  void save();
  SurfaceCanvas canvas() const;
  ParameterValues given() const;
  std::string kind() const;
  std::string path() const;  ///< relative to the study
  std::vector<ShownCommand> commands() const;

  OpenStudy& study_;
  std::vector<SurfaceDeclaration> surfaces_{};
  std::vector<ParameterForm*> forms_{};  ///< by surface
  QComboBox* kind_ = nullptr;
  QLabel* summary_ = nullptr;
  QStackedWidget* parameters_ = nullptr;
  ParameterForm* canvas_ = nullptr;
  QLabel* picture_ = nullptr;
  QLabel* facts_ = nullptr;
  QLabel* warnings_ = nullptr;
  QLineEdit* name_ = nullptr;
  StateLabel* state_ = nullptr;
  QPushButton* save_ = nullptr;
  QString refusal_{};  ///< of the present values
  std::shared_ptr<const HeightField> field_{};
  NewestWork work_{};
  BackgroundTask saving_{};
};

}  // namespace asperity

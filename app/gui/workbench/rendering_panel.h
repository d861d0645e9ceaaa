// Declares the panel that saves the compared force models as renderings of the study.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QStringList>
#include <QtWidgets/QFrame>

#include "app/gui/look/background_task.h"
#include "app/study_files/rendering_files.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace asperity {

class Banner;
class OpenStudy;

/// Under the compared models: their name in the study, and their use in an experiment. Each model is saved as
/// stimuli/NAME_MODEL.rendering.json; a file that exists is never replaced.
class RenderingPanel final : public QFrame {
  Q_OBJECT
 public:
  /// What is compared now.
  struct Compared {
    std::vector<Rendering> renderings{};  ///< with the SHA-256 of a texture that was opened
    QString problem{};                    ///< why none can be saved
    QString left_out{};                   ///< why some models are left out, a sentence
  };
  /// News goes to `banner`, which outlives the panel as `study` does.
  RenderingPanel(OpenStudy& study, Banner& banner, std::function<Compared()> compared,
                 QWidget* parent = nullptr);

  /// Proposes a name.
  void show_relief(const std::string& stem);
  /// Enables or disables saving, with the reason.
  void check();
  bool is_saving() const noexcept { return saving_.is_running(); }

 signals:
  /// These files are to be used in an experiment.
  void use_wanted(const QStringList& renderings);

 private:
  std::string name_of(const Rendering& rendering) const;
  void save(bool then_use);

  OpenStudy& study_;
  Banner& banner_;
  std::function<Compared()> compared_{};
  QLineEdit* name_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* use_ = nullptr;
  QLabel* note_ = nullptr;
  BackgroundTask saving_{};
};

}  // namespace asperity

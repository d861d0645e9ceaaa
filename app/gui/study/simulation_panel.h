// Virtual participants through one protocol of the study.

#pragma once

#include <filesystem>

#include <QtWidgets/QWidget>

#include "app/gui/look/background_task.h"
#include "app/gui/study/open_study.h"
#include "app/tasks/simulation.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace asperity {

/// Asks how many and begins; shows progress; can be cancelled and gone on with.
class SimulationPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit SimulationPanel(OpenStudy& study, QWidget* parent = nullptr);

  /// What the next simulation is of; one that runs goes on.
  void set_protocol(const std::filesystem::path& file, const QString& name);
  bool is_running() const noexcept { return task_.is_running(); }

 signals:
  void sessions_wanted(const QString& protocol_name);

 private:
  void begin(bool go_on);
  void show_state();

  OpenStudy& study_;
  std::filesystem::path file_{};
  QString name_{};
  QString simulated_name_{};
  SimulationInputs inputs_{};
  bool was_cancelled_ = false;
  QLabel* words_ = nullptr;
  QSpinBox* participants_ = nullptr;
  QSpinBox* seed_ = nullptr;
  QPushButton* begin_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* go_on_ = nullptr;
  QPushButton* show_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* outcome_ = nullptr;
  BackgroundTask task_{};
};

}  // namespace asperity

// Simulates several virtual participants in the background of the study window.

#pragma once

#include <string>

#include <QtCore/QObject>
#include <QtCore/QPointer>

#include "app/gui/look/background_task.h"
#include "app/tasks/simulation/simulation.h"

namespace asperity {

class StudyWindow;
class TaskLine;

/// Shows the progress on a line below the window's banner, with a button that cancels it, and states the end on the banner.
///
/// When a simulation is complete, the Analysis page shows its results; if another page has been opened meanwhile, a button
/// on the banner leads there. A simulation that was cancelled or failed can be resumed.
class BatchSimulation final : public QObject {
  Q_OBJECT
 public:
  /// `window` outlives it.
  explicit BatchSimulation(StudyWindow& window, QObject* parent = nullptr);
  ~BatchSimulation() override;

  bool is_running() const noexcept { return task_.is_running(); }
  /// In the study of the window, which stays open meanwhile; on half of the processors. Not while one is running.
  void run(SimulationInputs inputs);

 signals:
  /// When it begins and when it has ended.
  void running(bool now);
  /// The user wants to resume one that is not complete.
  void wanted(const asperity::SimulationInputs& inputs);

 private:
  void show_line(int participants);
  void show_results(const std::string& protocol);
  void report_incomplete(const QString& what, const SimulationInputs& inputs, int trials);

  StudyWindow& window_;
  BackgroundTask task_{};
  QPointer<TaskLine> line_{};
  bool cancelled_ = false;
};

}  // namespace asperity

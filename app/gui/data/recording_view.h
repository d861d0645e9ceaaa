// The plots of a recording: all of it or one surface; or why there are none.

#pragma once

#include <memory>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/gui/data/time_plots.h"
#include "app/gui/look/controls.h"

class QComboBox;
class QStackedWidget;

namespace asperity {

class PathPlots;

class RecordingView final : public QWidget {
  Q_OBJECT
 public:
  /// A surface of the attempt by its names.
  struct Surface {
    int position = 0;
    QString name{};
  };

  explicit RecordingView(QWidget* parent = nullptr);

  void show_reason(State state, const QString& why_none);
  void show_recording(std::shared_ptr<const RecordingCurves> curves,
                      const std::vector<Surface>& surfaces, const AskedBands& bands);
  /// What of it is drawn; null while there is a reason in its place.
  const RecordingCurves* curves() const noexcept { return curves_.get(); }

 signals:
  void export_wanted();

 private:
  void show_chosen();

  std::shared_ptr<const RecordingCurves> curves_{};
  QStackedWidget* stack_ = nullptr;
  StateLabel* reason_ = nullptr;
  QComboBox* choice_ = nullptr;
  TimePlots* time_ = nullptr;
  PathPlots* path_ = nullptr;
};

}  // namespace asperity

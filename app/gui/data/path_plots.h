// Where the hand went, from above, and how fine the force was that it felt.

#pragma once

#include <optional>

#include <QtWidgets/QFrame>

#include "app/records/recording_curves.h"

class QCustomPlot;
class QLabel;

namespace asperity {

class PathPlots final : public QFrame {
  Q_OBJECT
 public:
  explicit PathPlots(QWidget* parent = nullptr);

  /// Of the surface at `position` of the trial; of all where there is none given.
  void show_surfaces(const RecordingCurves& curves, std::optional<int> position);

 private:
  struct Extent {
    double low_x = 0.0;
    double high_x = 0.0;
    double low_y = 0.0;
    double high_y = 0.0;
  };

  void add_path(const SurfaceCurves& surface);
  void add_spectrum(const SurfaceCurves& surface);
  void fit_path();

  QLabel* path_heading_ = nullptr;
  QLabel* spectrum_heading_ = nullptr;
  QCustomPlot* path_ = nullptr;
  QCustomPlot* spectrum_ = nullptr;
  std::optional<Extent> extent_{};  ///< of the paths, in millimetres
  double highest_ = 0.0;            ///< line of the spectra
};

}  // namespace asperity

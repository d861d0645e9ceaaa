// How far a device answers to tones, over their frequency.

#pragma once

#include <QtWidgets/QFrame>

#include "app/profiles/device_profile.h"

class QCustomPlot;
class QLabel;

namespace asperity {

/// Amplitude of the motion over that of the force, both axes logarithmic, a curve for x, y and z; a dotted line
/// where a resonance was found.
class ResponsePlot final : public QFrame {
  Q_OBJECT
 public:
  explicit ResponsePlot(QWidget* parent = nullptr);

  /// Says so where the profile has no response.
  void show_profile(const DeviceProfile& profile);
  /// For tests: how many points are drawn.
  int points() const;

 private:
  QLabel* heading_ = nullptr;
  QCustomPlot* plot_ = nullptr;
  QLabel* nothing_ = nullptr;
};

}  // namespace asperity

// A recording over time: force, penetration, speed and position, one below the other.

#pragma once

#include <memory>
#include <vector>

#include <QtWidgets/QFrame>

#include "analysis/signals/compliance.h"
#include "app/records/recording_curves.h"

namespace asperity {

/// What was asked of the hand, as far as it can be drawn.
struct AskedBands {
  AskedBand force_N{};
  AskedBand speed_m_per_s{};
};

/// Four plots with one axis of time: what zooms one zooms all. However long the recording is, what
/// is drawn is its envelope, two points per column of pixels, so that no peak is lost.
///
/// The wheel, + and − zoom, the mouse and the arrow keys move, Home shows all.
class TimePlots final : public QFrame {
  Q_OBJECT
 public:
  explicit TimePlots(QWidget* parent = nullptr);
  ~TimePlots() override;

  void show_curves(std::shared_ptr<const RecordingCurves> curves, const AskedBands& bands);
  /// As much of it as there is.
  void see(const TimeStretch& wanted);
  const TimeStretch& seen() const noexcept { return seen_; }
  /// About the middle of what is seen; below 1 comes nearer.
  void zoom(double factor);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Strip;
  struct Curve;

  void add_strip(const char* name, const QString& heading, std::vector<Curve> curves);
  void add_marks();
  void write_headings();
  void fit_values(Strip& strip, const AskedBand& asked);
  void draw();

  std::vector<Strip> strips_;
  std::shared_ptr<const RecordingCurves> curves_;
  TimeStretch seen_{};
  bool following_ = false;  ///< the axes are being set, and need not be listened to
};

}  // namespace asperity

// What the hand did in the last ten seconds: force, speed and path, with what was asked for.

#pragma once

#include <memory>
#include <optional>

#include <QtWidgets/QWidget>

#include "app/session/session_monitor.h"

namespace asperity {

/// Three plots, each with its allowed band as a shaded area. Beside it in words how much of the
/// contact with the present surface has been inside, as the attempt will be judged; of strokes those in
/// sight.
///
/// A frame costs what has changed: the axes and bands lie in layers of their own, which are drawn
/// anew only when they change; without new bins nothing is drawn at all. The time axis ends at the
/// newest bin.
///
/// While blind, the force is the pressing force alone, which tells no texture; otherwise its
/// extremes as sent are drawn behind it. Positions are in the surface's frame.
class LivePlots final : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kShown_s = 10.0;

  explicit LivePlots(QWidget* parent = nullptr);
  ~LivePlots() override;

  void set_patch(const SurfacePatch& patch);
  /// What is asked of the trial under way; absent: nothing.
  void set_exploration(const std::optional<Exploration>& exploration);
  /// How the surface under the hand has been explored so far.
  void set_hand(const HandSoFar& hand);
  void set_blind(bool blind);
  /// Takes the bins that came since; draws if there were any.
  void take_bins(const SessionMonitor& monitor);

  /// For tests: how many points of the sent force are drawn.
  int sent_force_points() const;
  int pressing_points() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Drawing;
  void draw_bins();
  void write_compliance();
  void restyle();

  std::unique_ptr<Drawing> drawing_;
};

}  // namespace asperity

// How the hand meets its bands, for the participant's eyes while a surface is felt.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QPointF>
#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "app/session/respondents/participant_scene.h"
#include "app/session/session_monitor.h"
#include "protocols/design/protocol.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// Where a target is that goes to and fro along a stroke at a steady speed: from the middle, positive
/// along the stroke, at its beginning when no time has gone by.
double target_along_m(double elapsed_s, double stroke_length_m, double speed_m_per_s);

/// Draws what the scene of the monitor asks of the hand (ParticipantScene::guide) and what the hand
/// does, 60 times a second while it is visible.
///
/// A bar for each of force and speed that has a band, on the scene's scale (GuideScale), with numbers in
/// newtons and millimetres per second under it where the layout has room for them, in the language of the scene: the band is shaded, between two edges; the mark is
/// a disc inside it and an arrow towards it outside. The mark is a ring that asks for nothing while no
/// surface is felt, while the hand is to lift, and for the speed until it has stroked far enough. Over
/// them, where a target moves, the stroke from above: the target a disc with a ring, the probe a cross.
/// Rows are those of `guide_rows`.
///
/// Values are those of the monitor's last bin, which are those that the attempt is judged by: the speed
/// is that of a stroke, and does not fall where the hand turns. Nothing here knows the stimulus or the
/// answer.
class LiveGuide final : public QWidget {
  Q_OBJECT
 public:
  struct Shown {
    bool touching = false;
    std::optional<double> pressing_N{};        ///< absent where the bar asks for nothing
    std::optional<double> stroking_m_per_s{};  ///< likewise
    QPointF probe_m{};                         ///< from above, x to the right and y up
    std::optional<double> target_along_m{};    ///< absent where no target moves
  };

  /// `monitor` must outlive the widget.
  explicit LiveGuide(const SessionMonitor& monitor, QWidget* parent = nullptr);

  /// Of the numbers under bars, in pixels of the widget; 0: there are none.
  void set_number_size(double size_px);

  const Shown& shown() const noexcept { return shown_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void look_again();

  const SessionMonitor& monitor_;
  QTimer timer_{};
  std::uint64_t next_bin_ = 0;
  std::vector<LiveBin> bins_{};
  LiveBin last_{};
  Exploration asked_{};
  GuideScale scale_{};
  std::string language_{"en"};
  double number_size_px_ = 0.0;
  SurfacePatch patch_{};
  Shown shown_{};
};

}  // namespace asperity

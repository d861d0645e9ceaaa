// A participant's mouse or pen as the probe of the device "mouse".

#pragma once

#include <optional>

#include <QtCore/QObject>
#include <QtCore/QPointF>

#include "app/session/session_monitor.h"
#include "device/latest_value.h"
#include "device/pointer_sample.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

class ParticipantView;

/// Looks on at what a mouse or a pen does over the view, and tells the device where that is on the surface:
/// under the pointer where the workspace or the surface is shown; otherwise on a table as seen from above that fills
/// the view, the surface that was felt last in its middle, 10 % of its size around it.
///
/// A mouse presses while its left button is held, unless that went down on something that can be pressed; a
/// pen as hard as it does. A pointer that leaves, and a window that loses the keyboard, lift.
///
/// Frame and units: the device's, in metres; a mirrored session has its surface where that is.
///
/// Threads: the GUI's, the only writer of `samples`.
class PointerFeed final : public QObject {
  Q_OBJECT
 public:
  /// All of them outlive the feed.
  PointerFeed(ParticipantView& view, const SessionMonitor& monitor,
              LatestValue<PointerSample>& samples, QObject* parent = nullptr);
  ~PointerFeed() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move_to(QPointF at, double pressure);
  void lift();
  glm::dvec2 place_of(QPointF at);
  const SurfacePatch& patch();

  ParticipantView& view_;
  const SessionMonitor& monitor_;
  LatestValue<PointerSample>& samples_;
  SurfacePatch patch_{};  ///< that was felt last
  PointerSample last_{};
  bool is_held_ = false;
};

}  // namespace asperity

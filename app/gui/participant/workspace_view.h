// What a participant may see while feeling: the object, the tool, and where the probe is.

#pragma once

#include <memory>
#include <optional>

#include <QtGui/QImage>
#include <QtWidgets/QWidget>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/gui/look/background_task.h"
#include "app/gui/scene/body_picture.h"
#include "app/gui/scene/workspace_picture.h"

namespace asperity {

/// Shows the workspace in perspective, without names, numbers or anything that is written.
///
/// What does not move is drawn once for each object and size, away from the GUI thread; until it is
/// there the object is seen plain. A frame draws that picture, the tool and its shadow: about a
/// millisecond at 1280 × 720, so `set_probe` may be called at 60 Hz.
///
/// Frame and units: the device's, in metres, as it is under the hand; nothing is flipped for a left
/// hand but the tool, which leans to that side. A probe below the surface is drawn on it: how far it
/// gives way is for the hand to find out.
class WorkspaceView final : public QWidget {
  Q_OBJECT
 public:
  explicit WorkspaceView(QWidget* parent = nullptr);

  /// `relief` is read only where its look is asked for; null looks plain. An object that looks like
  /// the one that is there is not drawn again.
  void set_object(const SurfacePatch& patch, std::shared_ptr<const HeightField> relief,
                  SurfaceLook look);
  /// The same for two bodies: the surface's mesh with its own frame in the patch's centre, and the
  /// tool's, whose frame is the probe's. Both show their relief, or the surface the pattern.
  void set_bodies(const SurfacePatch& patch, std::shared_ptr<const TexturedMesh> surface,
                  std::shared_ptr<const TexturedMesh> tool, SurfaceLook look);
  void set_probe(double x_m, double y_m, double z_m, bool touching);
  /// How the probe is turned; seen only of a tool with a body.
  void set_probe_orientation(const glm::dquat& orientation);
  /// The position of the probe is not known: neither it nor the tool is drawn.
  void take_probe_away();
  /// The point on the plane of the surface that is seen at this pixel, in the device's frame; nothing
  /// while no object was set.
  std::optional<glm::dvec2> place_at(QPointF pixel) const;
  /// The tool is held in the left hand.
  void set_mirrored(bool mirrored);
  /// The object is seen as it is to be, not as it is while that is being drawn.
  bool is_drawn() const noexcept { return drawn_; }

 signals:
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  QSize sizeHint() const override { return {960, 540}; }

 private:
  struct Probe {
    glm::dvec3 position_m{};
    bool touching = false;
  };

  void draw_again();
  void draw_tool(QPainter& painter) const;
  void draw_tool_body(QPainter& painter) const;

  SurfacePatch patch_{};  ///< of the camera
  double thickness_m_ = 0.0;
  WorkspacePicture picture_{};
  std::optional<SeenBody> surface_{};  ///< hides the tool where that is behind it
  std::optional<SeenBody> tool_{};
  glm::dquat orientation_{1.0, 0.0, 0.0, 0.0};
  bool mirrored_ = false;
  std::optional<Probe> probe_{};
  std::optional<WorkspaceCamera> camera_{};  // in the widget's own pixels
  QImage image_{};
  bool drawn_ = false;
  BackgroundTask task_{};
};

}  // namespace asperity

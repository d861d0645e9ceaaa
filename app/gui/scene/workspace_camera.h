// The view of the workspace that all its pictures share: camera, light and appearance of surfaces.

#pragma once

#include <numbers>

#include <QtCore/QPointF>
#include <QtCore/QSize>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// What the surface of the object shows.
enum class SurfaceLook {
  relief,   ///< its relief, lit from the upper left
  plain,    ///< nothing
  pattern,  ///< points 10 mm apart, which belong to no texture
};

// The appearance of the slab under a point, and of a body in its place.
inline constexpr double kPatternSpacing_m = 0.010;
inline constexpr double kPatternPoint_m = 0.0006;  ///< radius
inline constexpr double kShownSlope = 0.42;        ///< RMS of the slopes of a relief as displayed
inline const glm::dvec3 kSceneStone{0.80, 0.775, 0.735};  ///< linear RGB: a pale, warm stone
/// The unit vector towards the lamp, in the device's frame.
inline const glm::dvec3 kLight = glm::normalize(glm::dvec3{-0.50, 0.42, 0.76});
inline constexpr double kElevation_rad = 48.0 * std::numbers::pi / 180.0;

/// The coordinate of the nearest point of the pattern: (⌊x/s⌋ + ½)·s with the spacing s.
double nearest_pattern_point_m(double x_m);

/// The larger side of a patch, in which lengths of the scene are given.
double larger_extent_m(const SurfacePatch& patch);

/// The light on a surface with this outward normal, in the device's frame: slightly above 1 if it faces the lamp.
///
///   L = 0.33·(0.68 + 0.32·n_z) + 0.69·max(0, n·l)
///
/// l points to the lamp; the first term is the light from all around, most of which comes from above.
double workspace_light(const glm::dvec3& normal);

/// The perspective view of the workspace: from the front, kElevation_rad above the surface. Right in the device's frame
/// is right in the picture, for either hand.
///
/// The object is a slab with the extent of the patch, whose upper face is the plane of the surface. It fills a picture of
/// `size` pixels, with room for the tool above it. A body in its place has its own patch and thickness
/// (`seen_patch_of`).
///
/// With d the vector from the eye to a point and e the elevation, the depth is d_y·cos e − d_z·sin e and the height in the
/// picture d_y·sin e + d_z·cos e; both d_x and the height are multiplied by focal length over depth.
class WorkspaceCamera final {
 public:
  WorkspaceCamera(const SurfacePatch& patch, QSize size);
  WorkspaceCamera(const SurfacePatch& patch, QSize size, double thickness_m);

  QSize size() const noexcept { return size_; }
  const SurfacePatch& patch() const noexcept { return patch_; }
  double thickness_m() const noexcept { return thickness_m_; }  ///< of the slab
  /// The pixel of a point in the device's frame.
  QPointF project(const glm::dvec3& point_m) const noexcept;
  /// Pixels per metre across the line of sight at this point.
  double scale_at(const glm::dvec3& point_m) const noexcept;
  /// The point seen at `pixel` that is `z_m` above the surface, relative to the centre of the patch.
  glm::dvec3 point_at(QPointF pixel, double z_m) const noexcept;

 private:
  SurfacePatch patch_{};
  QSize size_{};
  double thickness_m_ = 0.0;
  glm::dvec3 eye_m_{};  ///< relative to the patch's centre
  double focal_px_ = 1.0;
  QPointF centre_px_{};
};

}  // namespace asperity

// Declares the curve along which a held tool is dragged: a straight line, an arc, or the profile of a body.

#pragma once

#include <memory>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "renderers/proxy/body_surface.h"

namespace asperity {

/// A place of a curve, in the frame of the device.
struct GuidePlace {
  glm::dvec3 origin_m{0.0};          ///< of the curve
  glm::dvec3 along{1.0, 0.0, 0.0};   ///< unit tangent
  glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit normal of the surface, perpendicular to `along`
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};  ///< of the tool
};

/// The curve of a stroke by its arc length s. The tip is at origin + w·normal, with w its height above the curve.
///
/// Motion: the tool moves by ṡ·along + ẇ·normal and turns by ṡ·`turn_rad_per_m` about +z. The force of the surface on the
/// tool acts along s as F·along + τ_z·`turn_rad_per_m`, with τ the torque about the tip, and along w as F·normal. The inertial
/// forces of a curved path (m·ṡ²/R, 17 mN for 50 g at 100 mm/s on a radius of 30 mm) and the difference between the lengths
/// of paths at different heights (w/R) are neglected.
///
/// Units and frame: metres, the device's frame.
///
/// Threads: any number at a time. Real-time: `at` does not allocate, lock or throw.
class StrokeGuide {
 public:
  virtual ~StrokeGuide() = default;
  StrokeGuide(const StrokeGuide&) = delete;
  StrokeGuide& operator=(const StrokeGuide&) = delete;

  virtual GuidePlace at(double s_m) const noexcept = 0;
  virtual double turn_rad_per_m() const noexcept { return 0.0; }

 protected:
  StrokeGuide() = default;
};

/// The x axis.
class StraightGuide final : public StrokeGuide {
 public:
  GuidePlace at(double s_m) const noexcept override;
};

/// A circle in the plane z = 0 that touches the x axis at the origin, about an axis along +z through (0, r, 0): with φ = s/r the
/// tip is at (r·sin φ, r·(1 − cos φ), 0), and the tool is turned by φ about +z.
///
/// Errors: std::invalid_argument for a radius that is not positive.
class TurningGuide final : public StrokeGuide {
 public:
  explicit TurningGuide(double radius_m);
  GuidePlace at(double s_m) const noexcept override;
  double turn_rad_per_m() const noexcept override { return 1.0 / radius_m_; }

 private:
  double radius_m_ = 0.0;
};

/// The upper side of a body in the plane y = `line_m` of its frame, as far as it is inclined by less than 30° to the left and
/// right of its highest point, and 1 mm of it at each end left out. There the texture of a point model is stretched by at
/// most 15 % (point_on_body.h). s = 0 is the middle of the highest part.
///
/// The normals are those of the body's surface (SurfaceProxy), without their component along y. Between 2048 samples places and
/// normals are interpolated; beyond its ends the curve continues straight.
///
/// Errors: std::invalid_argument for a body that the plane does not meet, or whose upper side there is shorter than 4 mm.
class BodyGuide final : public StrokeGuide {
 public:
  BodyGuide(const std::shared_ptr<const BodySurface>& body, double line_m);
  GuidePlace at(double s_m) const noexcept override;

  /// Where the body's frame has its origin: the place s = 0 is the origin of the device's frame.
  const glm::dvec3& body_origin_m() const noexcept { return body_origin_m_; }
  double from_m() const noexcept { return s_m_.front(); }
  double to_m() const noexcept { return s_m_.back(); }

 private:
  glm::dvec3 body_origin_m_{0.0};
  std::vector<double> s_m_{};
  std::vector<GuidePlace> places_{};
};

}  // namespace asperity

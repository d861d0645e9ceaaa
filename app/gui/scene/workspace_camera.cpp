// Implements a perspective projection whose measures are multiples of the patch, and its inverse.

#include "app/gui/scene/workspace_camera.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QRectF>

namespace asperity {
namespace {

constexpr double kDistance = 2.6;    // of the eye, in patches: the strength of the perspective
constexpr double kThickness = 0.07;  // of the slab, in patches

}  // namespace

double nearest_pattern_point_m(double x_m) {
  return kPatternSpacing_m * (std::floor(x_m / kPatternSpacing_m) + 0.5);
}

double larger_extent_m(const SurfacePatch& patch) {
  return std::max(patch.extent_m.x, patch.extent_m.y);
}

double workspace_light(const glm::dvec3& normal) {
  const double direct = std::max(0.0, glm::dot(normal, kLight));
  const double around = 0.68 + 0.32 * normal.z;
  return 0.33 * around + 0.69 * direct;
}

WorkspaceCamera::WorkspaceCamera(const SurfacePatch& patch, QSize size)
    : WorkspaceCamera(patch, size, kThickness * larger_extent_m(patch)) {}

WorkspaceCamera::WorkspaceCamera(const SurfacePatch& patch, QSize size, double thickness_m)
    : patch_(patch), size_(size), thickness_m_(thickness_m) {
  const double extent_m = larger_extent_m(patch);
  eye_m_ =
      kDistance * extent_m * glm::dvec3{0.0, -std::cos(kElevation_rad), std::sin(kElevation_rad)};
  // The slab and some space for the tool above it fit into the picture.
  QRectF seen{};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z_m : {-thickness_m_, 0.22 * extent_m}) {
        const QPointF at =
            project(patch.centre_m + glm::dvec3{x * patch.extent_m.x, y * patch.extent_m.y, z_m});
        if (z_m > 0.0 && y < 0.0) continue;  // the tool covers the front of the slab
        seen = seen.isNull() ? QRectF(at, QSizeF(1e-9, 1e-9))
                             : seen.united(QRectF(at, QSizeF(1e-9, 1e-9)));
      }
    }
  }
  constexpr double kFilled = 0.84;
  focal_px_ = kFilled * std::min(size.width() / seen.width(), size.height() / seen.height());
  centre_px_ = QPointF(0.5 * size.width(), 0.5 * size.height()) - focal_px_ * seen.center();
}

double WorkspaceCamera::scale_at(const glm::dvec3& point_m) const noexcept {
  const glm::dvec3 from_eye = point_m - patch_.centre_m - eye_m_;
  return focal_px_ /
         (from_eye.y * std::cos(kElevation_rad) - from_eye.z * std::sin(kElevation_rad));
}

QPointF WorkspaceCamera::project(const glm::dvec3& point_m) const noexcept {
  const glm::dvec3 from_eye = point_m - patch_.centre_m - eye_m_;
  const double up = from_eye.y * std::sin(kElevation_rad) + from_eye.z * std::cos(kElevation_rad);
  const double scale = scale_at(point_m);
  return centre_px_ + QPointF(scale * from_eye.x, -scale * up);
}

glm::dvec3 WorkspaceCamera::point_at(QPointF pixel, double z_m) const noexcept {
  const double right = (pixel.x() - centre_px_.x()) / focal_px_;
  const double up = -(pixel.y() - centre_px_.y()) / focal_px_;
  const double s = std::sin(kElevation_rad);
  const double c = std::cos(kElevation_rad);
  const glm::dvec3 ray{right, c + up * s, up * c - s};
  // A ray that does not point downwards does not meet the plane: a distant point instead.
  const double way = ray.z < -1e-3 ? (z_m - eye_m_.z) / ray.z : (z_m - eye_m_.z) / -1e-3;
  return eye_m_ + way * ray;
}

}  // namespace asperity

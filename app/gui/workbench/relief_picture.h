// A relief in light, drawn on the CPU.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <QtCore/QPointF>
#include <QtCore/QSize>
#include <QtGui/QColor>
#include <QtGui/QImage>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "renderers/elastic/surface_dent.h"
#include "stimuli/heights/height_field.h"

namespace asperity {

/// Heights ready to be drawn: averaged over the cells of a coarser grid, made tall enough to see.
///
/// `exaggeration` is the factor on the heights, one of 1, 2, 5, 10 …: the largest with which the
/// relief is no taller than a twelfth of its width and its slopes have an RMS of at most 0.6.
struct ReliefMesh {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double width_m = 0.0;  ///< of the whole field
  double length_m = 0.0;
  double exaggeration = 1.0;
  double lowest_m = 0.0;  ///< exaggerated, about the mean
  double highest_m = 0.0;
  std::vector<float> heights_m{};    ///< exaggerated, about the mean, row by row, top first
  std::vector<glm::vec3> normals{};  ///< of the exaggerated surface
};

/// `longest_side` samples at most along the longer side.
ReliefMesh relief_mesh(const HeightField& field, std::size_t longest_side);

/// The relief with a dent, exaggerated as its heights are. The limits stay those of the relief without it.
ReliefMesh pressed_in(const ReliefMesh& mesh, const SurfaceDent& dent);

/// From where it is looked at and where the light comes from. Angles are about and above the plane
/// of the relief.
struct ReliefLook {
  double turn_rad = -0.35;  ///< of the relief about its normal
  double tilt_rad = 0.85;   ///< of the view above the plane, up to ½π: straight from above
  double light_azimuth_rad = 2.2;
  double light_elevation_rad = 0.7;
  double zoom = 1.0;
};

/// Parallel projection onto a picture, and back onto the plane of the mean height.
class ReliefProjection final {
 public:
  /// Whatever the turn, the whole relief fits at zoom 1.
  ReliefProjection(const ReliefLook& look, double width_m, double length_m, QSize size);

  QPointF on_screen(const glm::dvec3& point_m) const noexcept;
  /// Nothing outside the relief.
  std::optional<glm::dvec2> on_surface(QPointF screen) const noexcept;
  double pixels_per_m() const noexcept { return scale_; }

 private:
  double cos_turn_ = 1.0;
  double sin_turn_ = 0.0;
  double cos_tilt_ = 0.0;
  double sin_tilt_ = 1.0;
  double scale_ = 1.0;
  QPointF centre_{};
  glm::dvec2 half_m_{};
};

/// Draws back to front: a height field in parallel light rays needs no more. The picture is
/// transparent around the relief. Any thread.
QImage draw_relief(const ReliefMesh& mesh, const ReliefLook& look, QSize size);

}  // namespace asperity

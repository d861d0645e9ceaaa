// Implements the conversion of corners to cells and to ramps over the window.

#include "renderers/pd_gradient/sampling/sampled_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

// Points at a greater distance are not part of the window, and a float still resolves cells at this distance.
constexpr double kFarAway_cells = 1e6;
constexpr double kWeightOfTexture = 16384.0;  // the factor of a texel in the loops

// The position of a corner in cells. Faces that share it get the same numbers.
struct WindowCorner {
  float x = 0.0F;
  float y = 0.0F;
};

// The line from one corner to another. Its direction does not depend on the face, so that neighbouring faces assign
// samples consistently.
EdgeLine edge(const WindowCorner& low, const WindowCorner& high) {
  const float rise = high.y - low.y;
  return {.x = low.x, .y = low.y, .slope = rise > 0.0F ? (high.x - low.x) / rise : 0.0F};
}

// From the lowest corner to the highest, and from left to right in one row. From a table: which corners are lower varies from face to
// face, and a wrongly predicted branch takes longer than everything else here.
const std::array<std::uint8_t, 3>& order_of(const std::array<WindowCorner, 3>& corners) {
  const auto is_before = [&corners](std::size_t i, std::size_t j) {
    const WindowCorner& p = corners[i];
    const WindowCorner& q = corners[j];
    return static_cast<unsigned>(p.y < q.y) |
           (static_cast<unsigned>(p.y == q.y) & static_cast<unsigned>(p.x < q.x));
  };
  // By whether 0 is before 1, 0 before 2, 1 before 2; two of the eight combinations are impossible.
  static constexpr std::array<std::array<std::uint8_t, 3>, 8> kOrders{
      {{2, 1, 0}, {1, 2, 0}, {2, 1, 0}, {1, 0, 2}, {2, 0, 1}, {0, 1, 2}, {0, 2, 1}, {0, 1, 2}}};
  return kOrders[is_before(0, 1) << 2 | is_before(0, 2) << 1 | is_before(1, 2)];
}

// How far a face of this normal sinks. Most faces do not, which can be seen without a root.
double sunk_for(const glm::dvec3& normal, const LeaningFaces& leaning) noexcept {
  constexpr double kRounding = 1.0 + 1e-12;
  const double squares = glm::dot(normal, normal);
  if (normal.z * normal.z > kRounding * leaning.cosine * leaning.cosine * squares) return 0.0;
  return sunk_m(normal.z / glm::length(normal), leaning.cosine, leaning.window_m);
}

// Computes ramps over the window from the values at a face's corners. In double precision: corners may be far away, and
// the edges of a sliver closer to each other than single precision resolves.
class Ramps final {
 public:
  Ramps(const std::array<glm::dvec3, 3>& points, double middle)
      : ab_(points[1] - points[0]),
        ac_(points[2] - points[0]),
        to_middle_(middle - points[0].x, middle - points[0].y),
        per_area_(1.0 / (ab_.x * ac_.y - ac_.x * ab_.y)) {}

  Ramp through(double a, double b, double c) const {
    const double per_column = ((b - a) * ac_.y - (c - a) * ab_.y) * per_area_;
    const double per_row = ((c - a) * ab_.x - (b - a) * ac_.x) * per_area_;
    return {.middle = static_cast<float>(a + per_column * to_middle_.x + per_row * to_middle_.y),
            .per_column = static_cast<float>(per_column),
            .per_row = static_cast<float>(per_row)};
  }

 private:
  glm::dvec2 ab_{0.0};
  glm::dvec2 ac_{0.0};
  glm::dvec2 to_middle_{0.0};
  double per_area_ = 0.0;
};

}  // namespace

ToWindow to_window(const Pose& pose, const ContactFrame& frame, const SamplingGrid& grid,
                   double outwards) noexcept {
  const double per_m = 1.0 / grid.spacing_m();
  const double middle = 0.5 * (grid.samples - 1);
  const glm::dmat3 axes(frame.u * per_m, frame.v * per_m, frame.n * outwards);
  const glm::dmat3 rotation = glm::transpose(axes) * pose.rotation;
  return {.rotation = rotation,
          .shift = glm::transpose(axes) * (pose.position_m - frame.origin_m) +
                   glm::dvec3{middle, middle, 0.0},
          .outwards = glm::transpose(rotation)[2],
          .cells_per_m = per_m,
          .middle = middle,
          .handedness = outwards};
}

std::optional<SampledTriangle> sampled_triangle(const PackedSurface::Triangle& triangle,
                                                const ToWindow& window, const FieldEnds& ends,
                                                const LeaningFaces& leaning,
                                                double texture_step_m) noexcept {
  const double lift_m = texture_step_m / kWeightOfTexture;
  std::array<glm::dvec3, 3> points;
  std::array<WindowCorner, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 p = window.rotation * triangle[i].point_m + window.shift;
    if (!(std::abs(p.x) < kFarAway_cells && std::abs(p.y) < kFarAway_cells)) return std::nullopt;
    points[i] = p;
    corners[i] = {.x = static_cast<float>(p.x), .y = static_cast<float>(p.y)};
  }
  const glm::dvec3 in_cells{1.0, 1.0, window.cells_per_m};
  const glm::dvec3 normal = window.handedness * glm::cross((points[1] - points[0]) * in_cells,
                                                           (points[2] - points[0]) * in_cells);
  constexpr double kSteepest = kSteepest_cosine * kSteepest_cosine;
  if (!(normal.z > 0.0 && normal.z * normal.z > kSteepest * glm::dot(normal, normal))) {
    return std::nullopt;
  }
  const double sunk_by_m = sunk_for(normal, leaning);
  if (!std::isfinite(sunk_by_m)) return std::nullopt;

  const std::array<std::uint8_t, 3>& order = order_of(corners);
  const WindowCorner& low = corners[order[0]];
  const WindowCorner& middle = corners[order[1]];
  const WindowCorner& high = corners[order[2]];
  const auto first_from = [&ends](float at) {
    const int cut = static_cast<int>(at);  // std::ceil is a function call without SSE4.1
    return std::clamp(static_cast<float>(cut) < at ? cut + 1 : cut, ends.first, ends.end);
  };
  const auto [left, right] = std::minmax({low.x, middle.x, high.x});
  SampledTriangle result{.whole = edge(low, high),
                         .below = edge(low, middle),
                         .above = edge(middle, high),
                         .middle_y = middle.y,
                         .first_row = first_from(low.y),
                         .end_row = first_from(high.y),
                         .first_column = first_from(left),
                         .end_column = first_from(right)};
  if (result.first_row >= result.end_row || result.first_column >= result.end_column) {
    return std::nullopt;
  }
  const Ramps ramps(points, window.middle);
  const auto& [a, b, c] = triangle;
  const auto lift = [&](const PackedSurface::Corner& at) {
    return lift_m * glm::dot(window.outwards, at.normal);
  };
  result.place_x = ramps.through(a.place_x, b.place_x, c.place_x);
  result.place_y = ramps.through(a.place_y, b.place_y, c.place_y);
  result.height_m =
      ramps.through(points[0].z - sunk_by_m, points[1].z - sunk_by_m, points[2].z - sunk_by_m);
  result.lift_m = ramps.through(lift(a), lift(b), lift(c));
  return result;
}

int stride_of_samples(int across) noexcept {
  const int stride = (across + kMostLanes - 1) / kMostLanes * kMostLanes + kMostLanes;
  return stride / kMostLanes % 2 == 0 ? stride + kMostLanes : stride;
}

}  // namespace asperity

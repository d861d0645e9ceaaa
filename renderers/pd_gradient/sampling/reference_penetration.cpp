// Implements sampling by triangle and sample, with a new sampling of A for each difference.

#include "renderers/pd_gradient/sampling/reference_penetration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>

#include "renderers/pd_gradient/sampling/moved_poses.h"

namespace asperity {
namespace {

// Two sheets with a greater distance than this (and than the texture's steps) do not share an edge.
constexpr double kSameSheet_m = 1e-6;

// A corner of a triangle in the contact's frame.
struct Corner {
  glm::dvec3 point_m{0.0};
  glm::dvec3 normal{0.0};
  glm::dvec2 place{0.0};
  std::uint32_t vertex = 0;
};

struct Displacement {
  double value_m = 0.0;
  glm::dvec2 slope_m{0.0};  // per texel
};

Displacement displacement_at(const DisplacementAtlas& atlas, const glm::dvec2& place) {
  // The last texel of a row or column has no right or lower neighbour: it belongs to the cell before it.
  const auto cell = [](double at, std::size_t texels) {
    const double last = static_cast<double>(texels) - 1.0;
    const double inside = std::clamp(at, 0.0, last);
    const double start = std::min(std::floor(inside), std::max(0.0, last - 1.0));
    return std::pair{static_cast<std::size_t>(start), inside - start};
  };
  const auto [column, x] = cell(place.x, atlas.columns);
  const auto [row, y] = cell(place.y, atlas.rows);
  const std::size_t right = std::min(column + 1, atlas.columns - 1);
  const std::size_t below = std::min(row + 1, atlas.rows - 1);
  const auto at = [&](std::size_t r, std::size_t c) {
    return atlas.step_m * atlas.values[r * atlas.columns + c];
  };
  const double upper_left = at(row, column);
  const double upper_right = at(row, right);
  const double lower_left = at(below, column);
  const double lower_right = at(below, right);
  const double upper = upper_left + x * (upper_right - upper_left);
  const double lower = lower_left + x * (lower_right - lower_left);
  return {.value_m = upper + y * (lower - upper),
          .slope_m = {(1.0 - y) * (upper_right - upper_left) + y * (lower_right - lower_left),
                      lower - upper}};
}

std::array<Corner, 3> corners_in_frame(const ContactPatch& patch, const ContactFrame& frame,
                                       std::uint32_t triangle) {
  std::array<Corner, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t vertex = patch.mesh.triangles[triangle][i];
    const Pose& pose = patch.pose;
    const glm::dvec3 world_m = pose.rotation * patch.mesh.vertices_m[vertex] + pose.position_m;
    corners[i] = {.point_m = frame.to_frame(world_m - frame.origin_m),
                  .normal = frame.to_frame(pose.rotation * patch.mesh.normals[vertex]),
                  .place = patch.mesh.places[triangle][i],
                  .vertex = vertex};
  }
  return corners;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Twice the area of (from, to, sample), positive on the left of the edge. Both faces of an edge get the same number
// with opposite signs, so that a sample next to it is never outside both.
double side_of(const Corner& from, const Corner& to, const glm::dvec2& sample) {
  const glm::dvec2 a{from.point_m};
  const glm::dvec2 b{to.point_m};
  return from.vertex < to.vertex ? cross(b - a, sample - a) : -cross(a - b, sample - b);
}

// A face with the required orientation, prepared for the evaluation of its height at samples.
class Face final {
 public:
  Face(const std::array<Corner, 3>& corners, const DisplacementAtlas& atlas)
      : corners_(corners), atlas_(atlas) {
    const glm::dvec2 p0{corners[0].point_m};
    const glm::dvec2 p1{corners[1].point_m};
    const glm::dvec2 p2{corners[2].point_m};
    area_m2_ = cross(p1 - p0, p2 - p0);
    const auto slope = [this](const glm::dvec2& edge) {  // of the weight of the opposite corner
      return glm::dvec2{-edge.y, edge.x} / area_m2_;
    };
    weight_slopes_ = {slope(p2 - p1), slope(p0 - p2), slope(p1 - p0)};
  }

  std::optional<std::array<double, 3>> weights(const glm::dvec2& sample) const {
    std::array<double, 3> weights{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double side = side_of(corners_[(i + 1) % 3], corners_[(i + 2) % 3], sample);
      weights[i] = side / area_m2_;
      if (weights[i] < 0.0) return std::nullopt;
    }
    return weights;
  }

  double height_m(const std::array<double, 3>& weights) const {
    const Corner at = interpolated(weights);
    return at.point_m.z + displacement_at(atlas_, at.place).value_m * at.normal.z;
  }

  // The undisplaced point moves with the body; afterwards a different point is at the sample.
  HeightRates rates(const std::array<double, 3>& weights) const {
    const Corner at = interpolated(weights);
    const Displacement d = displacement_at(atlas_, at.place);
    glm::dvec2 slope{0.0};  // of the height over the window
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& corner = corners_[i];
      const double height_m = corner.point_m.z + d.value_m * corner.normal.z +
                              glm::dot(d.slope_m, corner.place) * at.normal.z;
      slope += weight_slopes_[i] * height_m;
    }
    const glm::dvec3& p = at.point_m;
    const glm::dvec3 lift_m = d.value_m * at.normal;
    return {-slope.x, -slope.y, p.y + lift_m.y + p.z * slope.y, -p.x - lift_m.x - p.z * slope.x,
            p.y * slope.x - p.x * slope.y};
  }

 private:
  Corner interpolated(const std::array<double, 3>& weights) const {
    Corner at;
    for (std::size_t i = 0; i < 3; ++i) {
      at.point_m += weights[i] * corners_[i].point_m;
      at.normal += weights[i] * corners_[i].normal;
      at.place += weights[i] * corners_[i].place;
    }
    return at;
  }

  std::array<Corner, 3> corners_{};
  const DisplacementAtlas& atlas_;
  double area_m2_ = 0.0;  // twice the signed area perpendicular to n
  std::array<glm::dvec2, 3> weight_slopes_{};
};

bool looks(const std::array<Corner, 3>& corners, Facing facing) {
  const glm::dvec3 normal =
      glm::cross(corners[1].point_m - corners[0].point_m, corners[2].point_m - corners[0].point_m);
  const double along_n = facing == Facing::along_n ? normal.z : -normal.z;
  return along_n > kSteepest_cosine * glm::length(normal);
}

// The first and last of N samples between two positions.
std::pair<int, int> samples_between(const SamplingGrid& grid, double low_m, double high_m) {
  const double middle = 0.5 * (grid.samples - 1);
  const double last = grid.samples - 1.0;
  const double first = std::clamp(std::ceil(low_m / grid.spacing_m() + middle), 0.0, last + 1.0);
  const double end = std::clamp(std::floor(high_m / grid.spacing_m() + middle), -1.0, last);
  return {static_cast<int>(first), static_cast<int>(end)};
}

enum class Rates { not_wanted, wanted };

SampledSurface sampled(const ContactPatch& patch, const ContactFrame& frame,
                       const SamplingGrid& grid, Facing facing, Rates rates) {
  require_sound(frame);
  require_sound(grid);
  require_sound(patch);
  const auto side = static_cast<std::size_t>(grid.samples);
  SampledSurface surface;
  surface.height_m.assign(side * side, 0.0);
  surface.covered.assign(side * side, 0);
  if (rates == Rates::wanted) surface.rates.assign(side * side, {});
  std::vector<std::uint8_t> folded(side * side, 0);
  const double same_sheet_m = kSameSheet_m + 2.0 * std::abs(patch.mesh.atlas.step_m);

  for (const std::uint32_t triangle : patch.triangles) {
    const std::array<Corner, 3> corners = corners_in_frame(patch, frame, triangle);
    if (!looks(corners, facing)) continue;
    const Face face(corners, patch.mesh.atlas);
    const auto [left_m, right_m] =
        std::minmax({corners[0].point_m.x, corners[1].point_m.x, corners[2].point_m.x});
    const auto [low_m, high_m] =
        std::minmax({corners[0].point_m.y, corners[1].point_m.y, corners[2].point_m.y});
    const auto [first_column, last_column] = samples_between(grid, left_m, right_m);
    const auto [first_row, last_row] = samples_between(grid, low_m, high_m);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const auto weights = face.weights({grid.place_m(column), grid.place_m(row)});
        if (!weights) continue;
        const std::size_t i =
            static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column);
        const double height_m = face.height_m(*weights);
        const double further_out_m = facing == Facing::along_n ? height_m - surface.height_m[i]
                                                               : surface.height_m[i] - height_m;
        if (surface.covered[i] != 0) {
          if (std::abs(further_out_m) > same_sheet_m) folded[i] = 1;
          if (further_out_m <= 0.0) continue;
        }
        surface.covered[i] = 1;
        surface.height_m[i] = height_m;
        if (rates == Rates::wanted) surface.rates[i] = face.rates(*weights);
      }
    }
  }
  surface.folded = static_cast<int>(std::count(folded.begin(), folded.end(), 1));
  return surface;
}

// The position with the greatest overlap of two surfaces, h_B − h_A.
struct Deepest {
  std::size_t sample = 0;
  double depth_m = 0.0;
  int covered = 0;
};

std::optional<Deepest> deepest(const SampledSurface& a, const SampledSurface& b) {
  Deepest found;
  for (std::size_t i = 0; i < a.height_m.size(); ++i) {
    if (a.covered[i] == 0 || b.covered[i] == 0) continue;
    const double depth_m = b.height_m[i] - a.height_m[i];
    if (found.covered == 0 || depth_m > found.depth_m) {
      found.depth_m = depth_m;
      found.sample = i;
    }
    ++found.covered;
  }
  if (found.covered == 0) return std::nullopt;
  return found;
}

bool at_border(const SampledSurface& a, const SampledSurface& b, const SamplingGrid& grid,
               std::size_t sample) {
  const auto side = static_cast<std::size_t>(grid.samples);
  if (grid.is_outermost(static_cast<int>(sample / side), static_cast<int>(sample % side))) {
    return true;
  }
  const std::array<std::size_t, 4> neighbours = {sample - 1, sample + 1, sample - side,
                                                 sample + side};
  return std::any_of(neighbours.begin(), neighbours.end(),
                     [&](std::size_t i) { return a.covered[i] == 0 || b.covered[i] == 0; });
}

Penetration without_gradient(const Deepest& found, const SampledSurface& a, const SampledSurface& b,
                             const SamplingGrid& grid) {
  const int row = static_cast<int>(found.sample) / grid.samples;
  const int column = static_cast<int>(found.sample) % grid.samples;
  return {.depth_m = found.depth_m,
          .deepest_m = {grid.place_m(column), grid.place_m(row), a.height_m[found.sample]},
          .covered = found.covered,
          .folded = a.folded + b.folded,
          .at_border = at_border(a, b, grid, found.sample),
          .at_window = grid.is_outermost(row, column)};
}

std::optional<Penetration> hard_maximum(const ContactPatch& a, const ContactPatch& b,
                                        const ContactFrame& frame, const SamplingGrid& grid,
                                        const HardMaximum& law) {
  const SampledSurface surface_b = sample_surface(b, frame, grid, Facing::along_n);
  const auto depth_m = [&](const Pose& pose) -> std::optional<double> {
    const ContactPatch moved{.mesh = a.mesh, .triangles = a.triangles, .pose = pose};
    const auto found = deepest(sample_surface(moved, frame, grid, Facing::against_n), surface_b);
    return found ? std::optional(found->depth_m) : std::nullopt;
  };
  const SampledSurface surface_a = sample_surface(a, frame, grid, Facing::against_n);
  const std::optional<Deepest> found = deepest(surface_a, surface_b);
  if (!found) return std::nullopt;
  const DifferenceSteps steps = difference_steps(grid, law.step_m);
  std::array<std::optional<double>, kMovedPoses> moved_m{};
  const std::array<Pose, kMovedPoses> poses = moved_poses(a.pose, frame, steps);
  std::transform(poses.begin(), poses.end(), moved_m.begin(), depth_m);
  Penetration result = without_gradient(*found, surface_a, surface_b, grid);
  set_gradient(found->depth_m, moved_m, steps, result);
  return result;
}

std::optional<Penetration> smooth_maximum(const ContactPatch& a, const ContactPatch& b,
                                          const ContactFrame& frame, const SamplingGrid& grid,
                                          const SmoothMaximum& law) {
  const SampledSurface surface_a = sample_surface_and_rates(a, frame, grid, Facing::against_n);
  const SampledSurface surface_b = sample_surface(b, frame, grid, Facing::along_n);
  const std::optional<Deepest> found = deepest(surface_a, surface_b);
  if (!found) return std::nullopt;
  double sum = 0.0;
  double sum_of_logs = 0.0;
  HeightRates weighted{};
  HeightRates weighted_by_log{};
  for (std::size_t i = 0; i < surface_a.height_m.size(); ++i) {
    if (surface_a.covered[i] == 0 || surface_b.covered[i] == 0) continue;
    const double depth_m = surface_b.height_m[i] - surface_a.height_m[i];
    const double log = (depth_m - found->depth_m) / law.tau_m;  // at most 0
    const double weight = std::exp(log);
    sum += weight;
    sum_of_logs += weight * log;
    for (std::size_t q = 0; q < weighted.size(); ++q) {
      weighted[q] -= weight * surface_a.rates[i][q];  // δ decreases where A rises
      weighted_by_log[q] -= weight * log * surface_a.rates[i][q];
    }
  }
  const double sunk = sum_of_logs / sum;  // (δ − here)/τ
  HeightRates rates{};
  for (std::size_t q = 0; q < rates.size(); ++q) {
    rates[q] = ((1.0 - sunk) * weighted[q] + weighted_by_log[q]) / sum;
  }
  Penetration result = without_gradient(*found, surface_a, surface_b, grid);
  result.depth_m = found->depth_m + law.tau_m * sunk;
  result.slope = {rates[0], rates[1]};
  result.lever_m = {rates[2], rates[3], rates[4]};
  return result;
}

}  // namespace

SampledSurface sample_surface(const ContactPatch& patch, const ContactFrame& frame,
                              const SamplingGrid& grid, Facing facing) {
  return sampled(patch, frame, grid, facing, Rates::not_wanted);
}

SampledSurface sample_surface_and_rates(const ContactPatch& patch, const ContactFrame& frame,
                                        const SamplingGrid& grid, Facing facing) {
  return sampled(patch, frame, grid, facing, Rates::wanted);
}

std::optional<Penetration> reference_penetration(const ContactPatch& a, const ContactPatch& b,
                                                 const ContactFrame& frame,
                                                 const SamplingGrid& grid, const MaximumLaw& law) {
  require_sound(law);
  if (const auto* hard = std::get_if<HardMaximum>(&law)) {
    return hard_maximum(a, b, frame, grid, *hard);
  }
  return smooth_maximum(a, b, frame, grid, std::get<SmoothMaximum>(law));
}

}  // namespace asperity

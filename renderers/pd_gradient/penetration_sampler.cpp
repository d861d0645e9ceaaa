// Triangles in the window, and the gradient from eleven maxima.

#include "renderers/pd_gradient/penetration_sampler.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace asperity {
namespace {

constexpr int kColumnsPerStep = 2 * kMostLanes;  // a turn's table has one entry for so many lanes
constexpr int kMostStepCells = 8;
constexpr double kWholeCell = 1e-6;  // a step that is this close to whole cells is
constexpr int kRoomQuantities = 4;
// What lies so far from the window is not part of it, and a float still counts cells there.
constexpr double kFarAway_cells = 1e6;
constexpr double kWeightOfTexture = 16384.0;  // what the loops multiply a texel by

const SampleLoops& loops_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::sse2:
      return kSse2Loops;
    case InstructionSet::avx2:
      return kAvx2Loops;
    case InstructionSet::avx512:
      return kAvx512Loops;
  }
  return kSse2Loops;
}

int rounded_up(int value, int multiple) { return (value + multiple - 1) / multiple * multiple; }

// From a mesh to the window: x and y in cells from its first sample, z outwards in metres.
struct ToWindow {
  glm::dmat3 rotation{1.0};
  glm::dvec3 shift{0.0};
  glm::dvec3 outwards{0.0};  // in the mesh's axes
  double cells_per_m = 0.0;
  double middle = 0.0;      // of the window, in cells
  double handedness = 1.0;  // −1 for A: with z against n the axes are left-handed
};

ToWindow to_window(const Pose& pose, const ContactFrame& frame, const SamplingGrid& grid,
                   double outwards) {
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

// Where a corner stands in cells. Faces that share it get the same numbers.
struct WindowCorner {
  float x = 0.0F;
  float y = 0.0F;
};

// The line from one corner to another. The order does not depend on the face, so that neighbours
// agree on which samples belong to whom.
EdgeLine edge(const WindowCorner& low, const WindowCorner& high) {
  const float rise = high.y - low.y;
  return {.x = low.x, .y = low.y, .slope = rise > 0.0F ? (high.x - low.x) / rise : 0.0F};
}

// What the corners of a face have, as a ramp over the window. In double: corners may be far away, and
// a sliver's edges closer to each other than single precision tells.
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

// Where a field ends: its apron included.
struct FieldEnds {
  int first = 0;
  int end = 0;
};

std::optional<SampledTriangle> sampled_triangle(const PackedSurface::Triangle& triangle,
                                                const ToWindow& window, const FieldEnds& ends,
                                                double lift_m) {
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

  std::sort(corners.begin(), corners.end(), [](const WindowCorner& p, const WindowCorner& q) {
    return p.y < q.y || (p.y == q.y && p.x < q.x);
  });
  const auto& [low, middle, high] = corners;
  const auto first_from = [&ends](float at) {
    const int cut = static_cast<int>(at);  // std::ceil is a call without SSE4.1
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
  result.height_m = ramps.through(points[0].z, points[1].z, points[2].z);
  result.lift_m = ramps.through(lift(a), lift(b), lift(c));
  return result;
}

}  // namespace

PenetrationSampler::PenetrationSampler(const SamplerSettings& settings)
    : grid_(settings.grid), law_(settings.law), loops_(&loops_of(settings.instructions)) {
  require_sound(grid_);
  require_sound(law_);
  int apron = kSlopeApron;
  if (const auto* hard = std::get_if<HardMaximum>(&law_)) {
    prepare_steps(*hard);
    apron = step_cells_;
  }
  const int samples_in = step_cells_ > 0 ? kColumnsPerStep * step_cells_ : kMostLanes;
  if (grid_.samples % samples_in != 0) {
    throw std::invalid_argument("PenetrationSampler: a window of " + std::to_string(grid_.samples) +
                                " samples; with this law it has to be a multiple of " +
                                std::to_string(samples_in) + ".");
  }
  a_ = field_with_apron(apron);
  b_ = field_with_apron(0);
  triangles_.resize(settings.most_triangles);
  const auto band = static_cast<std::size_t>(kBandRows * a_.samples.stride + kMostLanes);
  room_.assign(kRoomQuantities * band, 0.0F);
  const auto side = static_cast<std::size_t>(grid_.samples);
  row_most_m_.assign(side * kMostLanes, 0.0F);
  column_most_m_.assign(side, 0.0F);
  if (step_cells_ > 0) prepare_turn();
}

void PenetrationSampler::prepare_steps(const HardMaximum& law) {
  const double cells = law.step_m / grid_.spacing_m();
  if (!(std::abs(cells - std::round(cells)) < kWholeCell && cells > 0.5 &&
        cells < kMostStepCells + 0.5)) {
    throw std::invalid_argument("PenetrationSampler: a step of " + std::to_string(cells) +
                                " cells; it has to be 1 to " + std::to_string(kMostStepCells) +
                                ", a whole number.");
  }
  step_cells_ = static_cast<int>(std::lround(cells));
  steps_ = difference_steps(grid_, law.step_m);
}

PenetrationSampler::Field PenetrationSampler::field_with_apron(int apron) const {
  const int across = grid_.samples + 2 * apron;
  // Odd multiples of 16 floats: rows a power of two apart would share their places in the cache.
  int stride = rounded_up(across, kMostLanes) + kMostLanes;
  if (stride / kMostLanes % 2 == 0) stride += kMostLanes;
  Field field;
  field.height_m.assign(static_cast<std::size_t>(across * stride + kMostLanes), kNoSurface_m);
  field.samples = {.samples = grid_.samples, .apron = apron, .stride = stride};
  return field;
}

// Turning A by +θ shows at (x, y) what stood at (x + θ·y, y − θ·x).
void PenetrationSampler::prepare_turn() {
  const auto side = static_cast<std::size_t>(grid_.samples);
  const std::size_t blocks = side / kMostLanes;
  turn_cells_.resize(2 * blocks);
  turn_weights_.resize(2 * side);
  for (std::size_t way = 0; way < 2; ++way) {
    const double turn_rad = way == 0 ? -steps_.turn_rad : steps_.turn_rad;
    const auto offset = [&](double column) {
      return turn_rad * (column - 0.5 * (grid_.samples - 1));
    };
    for (std::size_t block = 0; block < blocks; ++block) {
      const double middle = static_cast<double>(block * kMostLanes) + 0.5 * (kMostLanes - 1);
      const double cells = std::floor(offset(middle));
      turn_cells_[way * blocks + block] = static_cast<std::int32_t>(cells);
      for (std::size_t lane = 0; lane < kMostLanes; ++lane) {
        const std::size_t column = block * kMostLanes + lane;
        const double weight = std::clamp(offset(static_cast<double>(column)) - cells, 0.0, 1.0);
        turn_weights_[way * side + column] = static_cast<float>(weight);
      }
    }
  }
}

int PenetrationSampler::sample(const PackedPatch& patch, const ContactFrame& frame, double outwards,
                               Field& field) {
  assert(patch.triangles.size() <= triangles_.size());
  const ToWindow window = to_window(patch.pose, frame, grid_, outwards);
  const FieldEnds ends{.first = -field.samples.apron, .end = grid_.samples + field.samples.apron};
  const double lift_m = patch.surface.step_m() / kWeightOfTexture;
  std::size_t count = 0;
  for (const std::uint32_t index : patch.triangles) {
    assert(index < patch.surface.triangles().size());
    const auto triangle = sampled_triangle(patch.surface.triangles()[index], window, ends, lift_m);
    if (triangle) triangles_[count++] = *triangle;
  }
  const auto band = room_.size() / kRoomQuantities;
  return loops_->sample_surface({.triangles = triangles_.data(),
                                 .count = static_cast<std::int32_t>(count),
                                 .texels = patch.surface.texels(),
                                 .field = samples_of(field),
                                 .room = {.place_x = room_.data(),
                                          .place_y = room_.data() + band,
                                          .height_m = room_.data() + 2 * band,
                                          .lift_m = room_.data() + 3 * band}});
}

float PenetrationSampler::height_m(const Field& field, int row, int column) const noexcept {
  const int apron = field.samples.apron;
  return field
      .height_m[static_cast<std::size_t>((row + apron) * field.samples.stride + column + apron)];
}

bool PenetrationSampler::at_border(int row, int column) const noexcept {
  const int last = grid_.samples - 1;
  if (row == 0 || column == 0 || row == last || column == last) return true;
  const auto missing = [this](int r, int c) {
    return height_m(a_, r, c) + height_m(b_, r, c) < kNothing_m;
  };
  return missing(row - 1, column) || missing(row + 1, column) || missing(row, column - 1) ||
         missing(row, column + 1);
}

std::optional<Penetration> PenetrationSampler::evaluate(const PackedPatch& a, const PackedPatch& b,
                                                        const ContactFrame& frame) noexcept {
  const int folded = sample(a, frame, -1.0, a_) + sample(b, frame, 1.0, b_);
  const auto* smooth = std::get_if<SmoothMaximum>(&law_);
  std::optional<Penetration> found = smooth != nullptr ? smooth_maximum(*smooth) : hard_maximum();
  if (found) found->folded = folded;
  return found;
}

HeightSamples PenetrationSampler::samples_of(Field& field) noexcept {
  HeightSamples samples = field.samples;
  samples.height_m = field.height_m.data();
  return samples;
}

Penetration PenetrationSampler::deepest_at(int row, int column) const noexcept {
  return {
      .deepest_m = {grid_.place_m(column), grid_.place_m(row), -double{height_m(a_, row, column)}},
      .at_border = at_border(row, column)};
}

std::optional<Penetration> PenetrationSampler::hard_maximum() noexcept {
  const auto side = static_cast<std::size_t>(grid_.samples);
  const std::size_t blocks = side / kMostLanes;
  ElevenMaxima found;
  loops_->compare({.a = samples_of(a_),
                   .b = samples_of(b_),
                   .step_cells = step_cells_,
                   .tilt_rise_m = static_cast<float>(steps_.tilt_rad * grid_.spacing_m()),
                   .turn = {.turn_rad = static_cast<float>(steps_.turn_rad),
                            .forth_cells = turn_cells_.data(),
                            .forth_weight = turn_weights_.data(),
                            .back_cells = turn_cells_.data() + blocks,
                            .back_weight = turn_weights_.data() + side},
                   .row_most_m = row_most_m_.data(),
                   .column_most_m = column_most_m_.data()},
                  found);
  if (!(found.here_m > kNothing_m)) return std::nullopt;

  const auto difference = [&found](const float(&moved_m)[2], double step) {
    const double here_m = found.here_m;
    const bool forth = moved_m[0] > kNothing_m;
    const bool back = moved_m[1] > kNothing_m;
    if (forth && back) return (double{moved_m[0]} - double{moved_m[1]}) / (2.0 * step);
    if (forth) return (moved_m[0] - here_m) / step;
    if (back) return (here_m - moved_m[1]) / step;
    return 0.0;
  };
  Penetration result = deepest_at(found.row, found.column);
  const double z_m = result.deepest_m.z;
  result.depth_m = found.here_m;
  result.covered = found.covered;
  result.slope = {difference(found.u_m, steps_.along_m), difference(found.v_m, steps_.along_m)};
  result.lever_m = {difference(found.tilt_u_m, steps_.tilt_rad) - z_m * result.slope.y,
                    difference(found.tilt_v_m, steps_.tilt_rad) + z_m * result.slope.x,
                    difference(found.turn_m, steps_.turn_rad)};
  return result;
}

// The derivatives of the reference, with sums for means: see reference_penetration.cpp.
std::optional<Penetration> PenetrationSampler::smooth_maximum(const SmoothMaximum& law) noexcept {
  WeightedSums sums;
  loops_->weigh({.a = samples_of(a_),
                 .b = samples_of(b_),
                 .per_tau_per_m = static_cast<float>(1.0 / law.tau_m),
                 .row_most_m = row_most_m_.data()},
                sums);
  if (!(sums.here_m > kNothing_m)) return std::nullopt;
  const double cell_m = grid_.spacing_m();
  const double per_weight = 1.0 / sums.weight;
  const double per_slope = per_weight / kSlope_cells;  // of what is in cells both up and along
  Penetration result = deepest_at(sums.row, sums.column);
  result.depth_m = sums.here_m + law.tau_m * std::log(sums.weight * cell_m * cell_m / law.area_m2);
  result.covered = sums.covered;
  result.slope = glm::dvec2{sums.slope_x_m, sums.slope_y_m} * (per_slope / cell_m);
  result.lever_m = {-sums.y * per_weight * cell_m - sums.z_slope_y_m2 * (per_slope / cell_m),
                    sums.x * per_weight * cell_m + sums.z_slope_x_m2 * (per_slope / cell_m),
                    sums.turn_m * per_slope};
  return result;
}

}  // namespace asperity

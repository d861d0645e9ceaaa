// Implements the sampling of triangles in the window and the gradient from eleven maxima.

#include "renderers/pd_gradient/sampling/penetration_sampler.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "renderers/pd_gradient/sampling/found_gradient.h"
#include "renderers/pd_gradient/sampling/sampled_triangles.h"

namespace asperity {
namespace {

constexpr int kColumnsPerStep = 2 * kMostLanes;  // columns per entry of the turn table
constexpr int kMostStepCells = 8;
constexpr double kWholeCell = 1e-6;  // tolerance for a whole number of cells

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
    throw std::invalid_argument("PenetrationSampler: the number of samples of a window is " +
                                std::to_string(grid_.samples) +
                                "; with this law it must be a multiple of " +
                                std::to_string(samples_in) + ".");
  }
  a_ = field_with_apron(apron);
  b_ = field_with_apron(0);
  triangles_.resize(settings.most_triangles);
  const auto band = static_cast<std::size_t>(kBandRows * a_.samples.stride + kMostLanes);
  room_.assign(4 * band, 0.0F);  // the quantities of a BandRoom
  const auto side = static_cast<std::size_t>(grid_.samples);
  row_most_m_.assign(side * kMostLanes, 0.0F);
  column_most_m_.assign(side, 0.0F);
  if (step_cells_ > 0) prepare_turn();
}

void PenetrationSampler::prepare_steps(const HardMaximum& law) {
  const double cells = law.step_m / grid_.spacing_m();
  if (!(std::abs(cells - std::round(cells)) < kWholeCell && cells > 0.5 &&
        cells < kMostStepCells + 0.5)) {
    throw std::invalid_argument("PenetrationSampler: the number of cells of a step is " +
                                number_text(cells) + "; it must be a whole number from 1 to " +
                                std::to_string(kMostStepCells) + ".");
  }
  step_cells_ = static_cast<int>(std::lround(cells));
  steps_ = difference_steps(grid_, law.step_m);
}

PenetrationSampler::Field PenetrationSampler::field_with_apron(int apron) const {
  const int across = grid_.samples + 2 * apron;
  const int stride = stride_of_samples(across);
  Field field;
  field.height_m.assign(static_cast<std::size_t>(across * stride + kMostLanes), kNoSurface_m);
  field.samples = {.samples = grid_.samples, .apron = apron, .stride = stride};
  return field;
}

// Turning A by +θ moves the point at (x + θ·y, y − θ·x) to (x, y).
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
  std::size_t count = 0;
  for (const std::uint32_t index : patch.triangles) {
    assert(index < patch.surface.triangles().size());
    const auto triangle = sampled_triangle(
        patch.surface.triangles()[index], window, ends,
        {.cosine = patch.leaning_cosine, .window_m = grid_.width_m}, patch.surface.step_m());
    if (triangle) triangles_[count++] = *triangle;
  }
  const auto band = room_.size() / 4;
  return loops_->sample_surface({.triangles = triangles_.data(),
                                 .count = static_cast<std::int32_t>(count),
                                 .texels = patch.surface.texels(),
                                 .field = samples_of(field),
                                 .room = {.place_x = room_.data(),
                                          .place_y = room_.data() + band,
                                          .height_m = room_.data() + 2 * band,
                                          .lift_m = room_.data() + 3 * band},
                                 .first_row = 0,
                                 .end_row = grid_.samples + 2 * field.samples.apron});
}

std::size_t PenetrationSampler::bytes() const noexcept {
  return std::as_bytes(std::span(a_.height_m)).size() +
         std::as_bytes(std::span(b_.height_m)).size() + std::as_bytes(std::span(triangles_)).size();
}

float PenetrationSampler::height_m(const Field& field, int row, int column) const noexcept {
  const int apron = field.samples.apron;
  return field
      .height_m[static_cast<std::size_t>((row + apron) * field.samples.stride + column + apron)];
}

bool PenetrationSampler::at_border(int row, int column) const noexcept {
  if (grid_.is_outermost(row, column)) return true;
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

FieldSamples PenetrationSampler::samples_of(Field& field) noexcept {
  FieldSamples samples = field.samples;
  samples.height_m = field.height_m.data();
  return samples;
}

glm::dvec3 PenetrationSampler::deepest_m(int row, int column) const noexcept {
  return {grid_.place_m(column), grid_.place_m(row), -double{height_m(a_, row, column)}};
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

  Penetration result = gradient_of(found, steps_, deepest_m(found.row, found.column));
  result.covered = found.covered;
  result.at_border = at_border(found.row, found.column);
  result.at_window = grid_.is_outermost(found.row, found.column);
  return result;
}

std::optional<Penetration> PenetrationSampler::smooth_maximum(const SmoothMaximum& law) noexcept {
  WeightedSums sums;
  loops_->weigh({.a = samples_of(a_),
                 .b = samples_of(b_),
                 .per_tau_per_m = static_cast<float>(1.0 / law.tau_m),
                 .row_most_m = row_most_m_.data()},
                sums);
  if (!(sums.here_m > kNothing_m)) return std::nullopt;
  Penetration result = gradient_of(sums, law, grid_.spacing_m(), deepest_m(sums.row, sums.column));
  result.covered = sums.covered;
  result.at_border = at_border(sums.row, sums.column);
  result.at_window = grid_.is_outermost(sums.row, sums.column);
  return result;
}

}  // namespace asperity

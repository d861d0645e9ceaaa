// Implements the overlap of a tip with a relief.

#include "renderers/elastic/pressed_tip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace asperity {
namespace {

constexpr double kApart_m = -1.0;  // beyond the face of a flat end

/// The index of a sample, or of the one that stands for it beyond the field.
std::size_t continued(std::ptrdiff_t at, std::ptrdiff_t count, Tiling tiling) noexcept {
  switch (tiling) {
    case Tiling::repeat:
      at = (at % count + count) % count;
      break;
    case Tiling::mirror:
      at = (at % (2 * count) + 2 * count) % (2 * count);
      if (at >= count) at = 2 * count - 1 - at;
      break;
    case Tiling::bounded:
      break;
  }
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, count - 1));
}

/// The parts of samples from −n to n that lie in an interval of this length, in pitches, about sample 0; their sum is 1.
std::vector<double> weights_of(double pitches) {
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(0.5 * pitches - 0.5));
  std::vector<double> weights{};
  for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
    const double from = std::max(static_cast<double>(k) - 0.5, -0.5 * pitches);
    const double to = std::min(static_cast<double>(k) + 0.5, 0.5 * pitches);
    weights.push_back(std::max(0.0, to - from) / pitches);
  }
  return weights;
}

/// The means along one axis of a grid: `lines` lines of `count` samples that are `apart` numbers apart.
void average(std::vector<double>& heights_m, std::size_t lines, std::size_t between_lines,
             std::size_t count, std::size_t apart, const std::vector<double>& weights,
             Tiling tiling) {
  const auto reach = static_cast<std::ptrdiff_t>(weights.size() / 2);
  std::vector<double> line_m(count);
  for (std::size_t line = 0; line < lines; ++line) {
    double* const first = heights_m.data() + line * between_lines;
    for (std::size_t i = 0; i < count; ++i) {
      double sum_m = 0.0;
      for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
        const std::size_t at = continued(static_cast<std::ptrdiff_t>(i) + k,
                                         static_cast<std::ptrdiff_t>(count), tiling);
        sum_m += weights[static_cast<std::size_t>(k + reach)] * first[at * apart];
      }
      line_m[i] = sum_m;
    }
    for (std::size_t i = 0; i < count; ++i) first[i * apart] = line_m[i];
  }
}

}  // namespace

std::shared_ptr<const HeightField> means_over_squares(std::shared_ptr<const HeightField> field,
                                                      double side_m, Tiling tiling) {
  const HeightField::Grid grid = field->grid();
  const double pitches = side_m / grid.pitch_m;
  if (!(pitches > 1.0)) return field;
  std::vector<double> heights_m(field->heights_m().begin(), field->heights_m().end());
  const std::vector<double> weights = weights_of(pitches);
  average(heights_m, grid.rows, grid.columns, grid.columns, 1, weights, tiling);
  average(heights_m, grid.columns, 1, grid.rows, grid.columns, weights, tiling);
  std::vector<float> means_m(heights_m.size());
  std::transform(heights_m.begin(), heights_m.end(), means_m.begin(),
                 [](double height_m) { return static_cast<float>(height_m); });
  return std::make_shared<const HeightField>(grid, std::move(means_m));
}

PressedTip::PressedTip(const Shape& shape, const Relief& relief)
    : relief_(relief), cell_m_(shape.radius_m / kCellsInRadius) {
  relief_.field = means_over_squares(relief.field, cell_m_ * relief.motion_scale, relief.tiling);
  // Between samples the cubics exceed the highest one by less than 0.29 of the range.
  constexpr double kBeyond = 0.3;
  const HeightField& field = *relief_.field;
  highest_m_ = relief_.height_scale *
               (field.maximum_m() + kBeyond * (field.maximum_m() - field.minimum_m()));
  for (std::size_t row = 0; row < kCellsAcross; ++row) {
    for (std::size_t column = 0; column < kCellsAcross; ++column) {
      const double r_m = cell_m_ * std::hypot(from_centre(column), from_centre(row));
      double& profile_m = profile_m_[row * kCellsAcross + column];
      if (shape.end == TipEnd::ball) {
        profile_m = 0.5 * r_m * r_m / shape.radius_m;
      } else {
        profile_m = r_m < shape.radius_m ? 0.0 : -kApart_m;
      }
    }
  }
}

const PressedTip::Overlap& PressedTip::overlap(const Pose& pose,
                                               std::span<const Place> places) noexcept {
  found_.deepest_m = 0.0;
  const double step_m = cell_m_ * relief_.motion_scale;
  const double per_slope = relief_.height_scale * relief_.motion_scale;
  for (std::size_t row = 0; row < kCellsAcross; ++row) {
    const double y = from_centre(row);
    for (std::size_t column = 0; column < kCellsAcross; ++column) {
      const double x = from_centre(column);
      const std::size_t cell = row * kCellsAcross + column;
      const double tool_m =
          profile_m_[cell] + pose.height_m + cell_m_ * (pose.tilt.x * x + pose.tilt.y * y);
      double height_m = highest_m_;
      found_.slope_x[cell] = 0.0;
      found_.slope_y[cell] = 0.0;
      if (highest_m_ > tool_m) {
        height_m = 0.0;
        for (const Place& place : places) {
          const glm::dvec2 from_place_m = place.turn * (step_m * glm::dvec2(x, y));
          const HeightSample sample = relief_.field->sample(
              place.x_m + from_place_m.x, place.y_m + from_place_m.y, relief_.tiling);
          const glm::dvec2 slope = glm::dvec2(sample.slope_x, sample.slope_y) * place.turn;
          height_m += place.weight * (relief_.height_scale * sample.height_m);
          found_.slope_x[cell] += place.weight * per_slope * slope.x;
          found_.slope_y[cell] += place.weight * per_slope * slope.y;
        }
      }
      found_.depth_m[cell] = height_m - tool_m;
      found_.deepest_m = std::max(found_.deepest_m, found_.depth_m[cell]);
    }
  }
  return found_;
}

}  // namespace asperity

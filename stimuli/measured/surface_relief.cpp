// Implements the subtraction of the form, the filling of missing points and the resampling.

#include "stimuli/measured/surface_relief.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "analysis/words/phrased_error.h"
#include "stimuli/measured/surface_decoding.h"

namespace asperity {

namespace {

constexpr double kSamePitch = 1e-4;
// Best for a hole of 60 points across, and sufficient for holes of 200 within the passes.
constexpr double kRelaxation = 1.9;
constexpr int kMostPasses = 1000;
constexpr double kSettled = 1e-6;

/// h = mean + slope_x (x − x of the mean) + slope_y (y − y of the mean); x to the right and y upwards, in metres.
struct FittedForm {
  double x_m = 0.0;
  double y_m = 0.0;
  double mean_m = 0.0;
  double slope_x = 0.0;
  double slope_y = 0.0;
};

/// Calls `action(x_m, y_m, height_m)` for every measured point, from the top left corner.
template <typename Action>
void for_measured(MeasuredSurface& surface, const Action& action) {
  for (std::size_t i = 0; i < surface.rows; ++i) {
    for (std::size_t j = 0; j < surface.columns; ++j) {
      double& height_m = surface.heights_m[i * surface.columns + j];
      if (std::isnan(height_m)) continue;
      action(static_cast<double>(j) * surface.pitch_x_m,
             -static_cast<double>(i) * surface.pitch_y_m, height_m);
    }
  }
}

/// `measured` is the number of measured points, at least 1.
FittedForm fitted_form(MeasuredSurface& surface, SurfaceForm form, std::size_t measured,
                       const std::string& name) {
  FittedForm fitted{};
  for_measured(surface, [&](double x_m, double y_m, double height_m) {
    fitted.x_m += x_m;
    fitted.y_m += y_m;
    fitted.mean_m += height_m;
  });
  for (double* sum : {&fitted.x_m, &fitted.y_m, &fitted.mean_m}) {
    *sum /= static_cast<double>(measured);
  }
  if (form == SurfaceForm::mean) return fitted;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double xh = 0.0;
  double yh = 0.0;
  for_measured(surface, [&](double x_m, double y_m, double height_m) {
    const double x = x_m - fitted.x_m;
    const double y = y_m - fitted.y_m;
    const double h = height_m - fitted.mean_m;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xh += x * h;
    yh += y * h;
  });
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-9 * xx * yy)) {
    throw PhrasedRefusal(phrase("Stimuli",
                                "%1: the measured points lie on a line and determine no plane. "
                                "Measure the surface again, or use --form mean.")
                             .with(name));
  }
  fitted.slope_x = (xh * yy - yh * xy) / determinant;
  fitted.slope_y = (yh * xx - xh * xy) / determinant;
  return fitted;
}

/// Replaces each height at `holes` by the mean of its neighbours, until they agree.
void fill(std::vector<double>& heights_m, std::size_t columns,
          const std::vector<std::size_t>& holes, double settled_m) {
  for (const std::size_t at : holes) heights_m[at] = 0.0;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    double change_m = 0.0;
    for (const std::size_t at : holes) {
      double sum_m = 0.0;
      int neighbours = 0;
      const auto add = [&](bool is_inside, std::size_t neighbour) {
        if (!is_inside) return;
        sum_m += heights_m[neighbour];
        ++neighbours;
      };
      const std::size_t column = at % columns;
      add(column > 0, at - 1);
      add(column + 1 < columns, at + 1);
      add(at >= columns, at - columns);
      add(at + columns < heights_m.size(), at + columns);
      const double step_m = kRelaxation * (sum_m / neighbours - heights_m[at]);
      heights_m[at] += step_m;
      change_m = std::max(change_m, std::abs(step_m));
    }
    if (change_m <= settled_m) return;
  }
}

/// The number of samples at the distance `fine_m` that fit between the outermost of `count` samples.
std::uint64_t samples_between(std::size_t count, double coarse_m, double fine_m) {
  const double intervals = static_cast<double>(count - 1) * coarse_m / fine_m;
  return static_cast<std::uint64_t>(std::floor(intervals + kSamePitch)) + 1;
}

/// The field with square cells. `heights_m` has the grid of `surface`.
HeightField resampled(const MeasuredSurface& surface, std::vector<float> heights_m,
                      const std::string& name) {
  const double pitch_m = std::min(surface.pitch_x_m, surface.pitch_y_m);
  const std::uint64_t columns = samples_between(surface.columns, surface.pitch_x_m, pitch_m);
  const std::uint64_t rows = samples_between(surface.rows, surface.pitch_y_m, pitch_m);
  const Phrase problem = points_problem(columns, rows);
  if (!problem.empty()) {
    throw PhrasedRefusal(phrase("Stimuli", "%1: resampled at the smaller of its two distances, %2.")
                             .with(name, problem));
  }
  // In this field the unit of length is the distance of two samples, along both axes.
  const HeightField stored({.rows = surface.rows, .columns = surface.columns, .pitch_m = 1.0},
                           std::move(heights_m));
  std::vector<float> square(columns * rows);
  for (std::uint64_t i = 0; i < rows; ++i) {
    const double y = (0.5 * static_cast<double>(rows - 1) - static_cast<double>(i)) * pitch_m /
                     surface.pitch_y_m;
    for (std::uint64_t j = 0; j < columns; ++j) {
      const double x = (static_cast<double>(j) - 0.5 * static_cast<double>(columns - 1)) * pitch_m /
                       surface.pitch_x_m;
      square[i * columns + j] = static_cast<float>(stored.sample(x, y, Tiling::bounded).height_m);
    }
  }
  return HeightField({.rows = rows, .columns = columns, .pitch_m = pitch_m}, std::move(square));
}

HeightField without_mean(const HeightField& field) {
  std::vector<float> heights_m = field.heights_m();
  for (float& height_m : heights_m) {
    height_m = static_cast<float>(static_cast<double>(height_m) - field.mean_m());
  }
  return HeightField(field.grid(), std::move(heights_m));
}

}  // namespace

SurfaceRelief surface_relief(MeasuredSurface surface, SurfaceForm form, const std::string& name) {
  std::vector<double>& heights_m = surface.heights_m;
  std::vector<std::size_t> holes{};
  for (std::size_t at = 0; at < heights_m.size(); ++at) {
    if (std::isnan(heights_m[at])) holes.push_back(at);
  }
  const std::size_t measured = heights_m.size() - holes.size();
  if (2 * measured < heights_m.size()) {
    throw PhrasedRefusal(
        phrase("Stimuli",
               "%1: only %2 of %3 points are measured; at least half are "
               "necessary. Measure the surface again, or crop it.")
            .with(name, std::to_string(measured), std::to_string(heights_m.size())));
  }
  const FittedForm fitted = fitted_form(surface, form, measured, name);
  double squares = 0.0;
  for_measured(surface, [&](double x_m, double y_m, double& height_m) {
    height_m -=
        fitted.mean_m + fitted.slope_x * (x_m - fitted.x_m) + fitted.slope_y * (y_m - fitted.y_m);
    squares += height_m * height_m;
  });
  fill(heights_m, surface.columns, holes,
       kSettled * std::sqrt(squares / static_cast<double>(measured)));
  std::vector<float> relief_m(heights_m.begin(), heights_m.end());
  const bool is_square = std::abs(surface.pitch_x_m - surface.pitch_y_m) <=
                         kSamePitch * std::max(surface.pitch_x_m, surface.pitch_y_m);
  const HeightField field =
      is_square
          ? HeightField(
                {.rows = surface.rows, .columns = surface.columns, .pitch_m = surface.pitch_x_m},
                std::move(relief_m))
          : resampled(surface, std::move(relief_m), name);
  return {.field = without_mean(field),
          .points = heights_m.size(),
          .missing = holes.size(),
          .slope_x = fitted.slope_x,
          .slope_y = fitted.slope_y,
          .is_resampled = !is_square};
}

ParameterValues parameter_values(const MeasuredSurface& surface, SurfaceForm form,
                                 const SurfaceRelief& relief) {
  ParameterValues values{{"file_format", std::string(name_of(surface.format))},
                         {"form", std::string(form == SurfaceForm::plane ? "plane" : "mean")},
                         {"slope_x", relief.slope_x},
                         {"slope_y", relief.slope_y},
                         {"points", static_cast<double>(relief.points)},
                         {"missing_points", static_cast<double>(relief.missing)},
                         {"missing_proportion",
                          static_cast<double>(relief.missing) / static_cast<double>(relief.points)},
                         {"pitch_x_m", surface.pitch_x_m},
                         {"pitch_y_m", surface.pitch_y_m}};
  if (!surface.channel.empty()) values.emplace("channel", surface.channel);
  return values;
}

}  // namespace asperity

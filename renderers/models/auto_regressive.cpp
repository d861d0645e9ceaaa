// Implements friction that varies along the path of the hand.

#include "renderers/models/auto_regressive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "analysis/numbers/random.h"
#include "analysis/signals/autoregression.h"
#include "analysis/words/phrased_error.h"
#include "renderers/force/layers.h"
#include "renderers/force/motion_gate.h"
#include "renderers/force/path_clock.h"
#include "renderers/force/recursive_noise.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

constexpr std::size_t kCoefficients = RecursiveNoise::kMostCoefficients;
constexpr double kStep_m = 1e-4;
constexpr double kShortestStep_m = 5e-5;
constexpr double kLongestStep_m = 0.01;
constexpr double kLargestSd = 2.0;
// 2·r·cos(2π·λ_n/λ₀) and −r² with r 0.9, λ_n 0.1 mm and λ₀ 1 mm, as numbers so that they have the same bits everywhere.
constexpr std::array<double, kCoefficients> kDefaults{1.4562305898749055, -0.81, 0.0, 0.0};

std::string name_of_coefficient(std::size_t i) { return "coefficient_" + std::to_string(i + 1); }

std::vector<double> coefficients_of(const ParameterValues& parameters) {
  std::vector<double> coefficients{};
  for (std::size_t i = 0; i < kCoefficients; ++i) {
    coefficients.push_back(number_of(parameters, name_of_coefficient(i)));
  }
  return coefficients;
}

std::optional<ParameterConflict> conflict_of_coefficients(const ParameterValues& parameters) {
  if (stationary_predictors(coefficients_of(parameters))) return {};
  ParameterConflict conflict{};
  std::string values{};
  for (std::size_t i = 0; i < kCoefficients; ++i) {
    conflict.parameters.push_back(name_of_coefficient(i));
    values += (i == 0 ? "" : ", ") + std::to_string(number_of(parameters, name_of_coefficient(i)));
  }
  conflict.message =
      phrase("Protocols",
             "with coefficient_1 to coefficient_4 = %1 the friction grows without limit along the "
             "path. Choose coefficients whose roots are inside the unit circle; of order 2: "
             "|coefficient_2| < 1 and |coefficient_1| < 1 - coefficient_2.")
          .with(values);
  return conflict;
}

class AutoRegressive final : public ForceRenderer {
 public:
  explicit AutoRegressive(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        variation_({.coefficients = coefficients_of(inputs.parameters),
                    .sd = number_of(inputs.parameters, "friction_sd"),
                    .steps_per_m =
                        inputs.patch.motion_scale / number_of(inputs.parameters, "noise_length_m")},
                   Random(inputs.seed).split("auto_regressive")),
        friction_(inputs.material.friction),
        largest_friction_(std::max(kLargest, inputs.material.friction)),
        rest_speed_m_per_s_(number_of(inputs.parameters, "friction_speed_m_per_s")),
        clock_(number_of(inputs.parameters, "device_step_m")) {}

  void reset(const ProbeState& first) noexcept override {
    contact_.reset();
    clock_.reset(first.position_m);
    gate_.reset();
    variation_.reset();
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const double length_m = clock_.advance(probe.position_m);
    const double variation = gate_.advance(length_m, dt_s) * variation_.advance(length_m);
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    const double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const double effective = std::clamp(friction_ + variation, 0.0, largest_friction_);
    const glm::dvec3& v = probe.velocity_m_per_s;
    const double per_speed_N =
        (friction_ - effective) * normal_N /
        std::sqrt(v.x * v.x + v.y * v.y + rest_speed_m_per_s_ * rest_speed_m_per_s_);
    return contact_.force(point, probe,
                          {.texture_N = {per_speed_N * v.x, per_speed_N * v.y, normal_N},
                           .normal_N = normal_N,
                           .penetration_m = penetration_m},
                          dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  static constexpr double kLargest = 2.0;  // of μ_e; rubber on glass

  SurfaceContact contact_;
  RecursiveNoise variation_;
  double friction_ = 0.0;
  double largest_friction_ = 0.0;
  double rest_speed_m_per_s_ = 0.0;
  PathClock clock_;
  MotionGate gate_{};
};

std::vector<Parameter> parameters_of_friction() {
  std::vector<Parameter> parameters{
      number_parameter(
          "friction_sd", "1", 0.0, kLargestSd, 0.06,
          phrase("Models", "Standard deviation of the coefficient of friction along the path")),
      number_parameter("noise_length_m", "m", kShortestStep_m, kLongestStep_m, kStep_m,
                       phrase("Models", "Length of path between the values of the process"))};
  for (std::size_t i = 0; i < kCoefficients; ++i) {
    parameters.push_back(
        {.name = name_of_coefficient(i),
         .kind = ParameterKind::number,
         .unit = "1",
         .minimum = -6.0,  // of a stationary process of order 4
         .maximum = 6.0,
         .choices = {},
         .default_value = kDefaults[i],
         .meaning = (i == 0 ? phrase("Models",
                                     "Coefficient a_%1 of the process, for the value %1 "
                                     "step back")
                            : phrase("Models",
                                     "Coefficient a_%1 of the process, for the value %1 "
                                     "steps back"))
                        .with(std::to_string(i + 1))});
  }
  parameters.push_back(device_step_parameter());
  add_layer_parameters(parameters);
  return parameters;
}

}  // namespace

namespace {

// The ratio of force to normal force, 0 where there is none, less its least-squares line over the path.
std::vector<double> ratio_without_trend(const RecordedStroke& stroke) {
  std::vector<double> ratio(stroke.force_N.size(), 0.0);
  double count = 0.0;
  double mean = 0.0;
  double middle_m = 0.0;
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    if (!(stroke.normal_N[i] > 0.0)) continue;
    ratio[i] = stroke.force_N[i] / stroke.normal_N[i];
    mean += ratio[i];
    middle_m += stroke.path_m[i];
    count += 1.0;
  }
  mean /= count;
  middle_m /= count;
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    if (!(stroke.normal_N[i] > 0.0)) continue;
    product += (stroke.path_m[i] - middle_m) * (ratio[i] - mean);
    square += (stroke.path_m[i] - middle_m) * (stroke.path_m[i] - middle_m);
  }
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    if (!(stroke.normal_N[i] > 0.0)) continue;
    ratio[i] -= mean + (square > 0.0 ? product / square * (stroke.path_m[i] - middle_m) : 0.0);
  }
  return ratio;
}

}  // namespace

ParameterValues autoregression_of_profiles(std::span<const std::vector<double>> segments,
                                           double step_m) {
  constexpr std::size_t kOrder = 2;
  constexpr std::size_t kFewestSamples = 8;
  constexpr double kPoleRadius = 0.999;
  std::vector<std::vector<double>> long_enough{};
  double sum_of_squares = 0.0;
  std::size_t count = 0;
  for (std::vector<double> segment : segments) {
    if (segment.size() < kFewestSamples) continue;
    double mean = 0.0;
    for (const double value : segment) mean += value / static_cast<double>(segment.size());
    for (double& value : segment) {
      value -= mean;
      sum_of_squares += value * value;
    }
    count += segment.size();
    long_enough.push_back(std::move(segment));
  }
  if (long_enough.empty()) return {};
  Autoregression model = burg_autoregression(long_enough, kOrder);
  shrink_poles(model, kPoleRadius);
  ParameterValues values{
      {"friction_sd", std::min(kLargestSd, std::sqrt(sum_of_squares / static_cast<double>(count)))},
      {"noise_length_m", std::clamp(step_m, kShortestStep_m, kLongestStep_m)}};
  for (std::size_t i = 0; i < kCoefficients; ++i) {
    values[name_of_coefficient(i)] = i < kOrder ? model.coefficients[i] : 0.0;
  }
  return values;
}

ParameterValues autoregression_of_relief(const HeightField& field) {
  constexpr std::size_t kMostRows = 64;
  const HeightField::Grid& grid = field.grid();
  const double step_m = std::clamp(grid.pitch_m, kStep_m, kLongestStep_m);
  const auto samples =
      static_cast<std::size_t>(static_cast<double>(grid.columns - 1) * grid.pitch_m / step_m);
  const std::size_t rows = std::min(grid.rows, kMostRows);
  const double left_m = -0.5 * static_cast<double>(grid.columns - 1) * grid.pitch_m;
  std::vector<std::vector<double>> segments(rows);
  for (std::size_t line = 0; line < rows; ++line) {
    const std::size_t row = line * grid.rows / rows;
    const double y_m =
        (0.5 * static_cast<double>(grid.rows - 1) - static_cast<double>(row)) * grid.pitch_m;
    double before_m = field.sample(left_m, y_m, Tiling::bounded).height_m;
    for (std::size_t i = 1; i <= samples; ++i) {
      const double height_m =
          field.sample(left_m + static_cast<double>(i) * step_m, y_m, Tiling::bounded).height_m;
      segments[line].push_back((height_m - before_m) / step_m);
      before_m = height_m;
    }
  }
  return autoregression_of_profiles(segments, step_m);
}

ParameterValues autoregression_of_recording(const TextureRecording& recording) {
  require_strokes(recording, "the recorded texture");
  double step_m = kStep_m;
  for (const RecordedStroke& stroke : recording.strokes) {
    step_m = std::max(step_m, (stroke.path_m.back() - stroke.path_m.front()) /
                                  static_cast<double>(stroke.path_m.size() - 1));
  }
  std::vector<std::vector<double>> segments{};
  for (const RecordedStroke& stroke : recording.strokes) {
    const std::vector<double> ratio = ratio_without_trend(stroke);
    segments.emplace_back();
    double sum = 0.0;
    int count = 0;
    std::int64_t step = 0;
    for (std::size_t i = 0; i < ratio.size(); ++i) {
      if (!(stroke.normal_N[i] > 0.0)) continue;
      // The middle of the steps of a stroke with one sample in each, so that rounding moves none.
      const auto its_step = static_cast<std::int64_t>(
          std::floor((stroke.path_m[i] - stroke.path_m.front()) / step_m + 0.25));
      if (count > 0 && its_step != step) {
        segments.back().push_back(sum / count);
        if (its_step > step + 1) segments.emplace_back();
        sum = 0.0;
        count = 0;
      }
      step = its_step;
      sum += ratio[i];
      ++count;
    }
    if (count > 0) segments.back().push_back(sum / count);
  }
  return autoregression_of_profiles(segments, step_m);
}

ForceModel auto_regressive_model() {
  return {.declaration = {.id = "auto_regressive",
                          .version = "1",
                          .summary =
                              phrase("Models", "A flat plate whose friction varies along the path"),
                          .source = "Pai, van den Doel, James, Lang, Lloyd, Richmond, Yau (2001), "
                                    "Scanning physical interaction behavior of 3D objects",
                          .needs_height_field = false,
                          .amplitude_parameter = "friction_sd",
                          .replay_tolerance_N = 1e-9,
                          .parameters = parameters_of_friction(),
                          .conflict_among = conflict_of_coefficients},
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            if (const auto conflict = conflict_of_coefficients(inputs.parameters)) {
              throw PhrasedRefusal(Phrase("auto_regressive: %1").with(conflict->message));
            }
            return std::make_unique<AutoRegressive>(inputs);
          },
          .suggested_by = [](const HeightField& field,
                             const Material&) { return autoregression_of_relief(field); },
          .band =
              [](const RendererInputs& inputs) {
                return TextureBand{.per_m = 0.5 * inputs.patch.motion_scale /
                                            number_of(inputs.parameters, "noise_length_m")};
              },
          .band_formula = "v/(2*noise_length_m)"};
}

}  // namespace asperity

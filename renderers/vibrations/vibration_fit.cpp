// Implements the fit of vibration models by Burg's method.

#include "renderers/vibrations/vibration_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/autoregression.h"
#include "analysis/signals/band_limited.h"
#include "analysis/signals/line_spectrum.h"
#include "analysis/words/phrased_error.h"
#include "device/refusal.h"
#include "renderers/recordings/even_stroke.h"

namespace asperity {
namespace {

constexpr double kSpeedsOfOneModel = 1.1;
constexpr double kForcesOfOneModel = 1.25;
constexpr double kSameRate = 1e-3;
constexpr double kNoiseFloor = 1e-4;
constexpr double kSharpest = 0.9999;  // of the reflection coefficients of a resonance
constexpr double kStationaryRadius = 0.9999;
constexpr double kLeastVariance = 1e-300;  // of which a logarithm is taken
constexpr double kSilence_m_per_s2 = 1e-9;

struct Acceleration {
  double speed_m_per_s = 0.0;
  double normal_N = 0.0;
  std::vector<double> samples_m_per_s2{};  ///< at 1 kHz
};

Acceleration acceleration_of(const RecordedStroke& stroke, double mass_kg,
                             const BandLimitedInterpolation& between, const std::string& which) {
  const EvenStroke even = even_stroke(stroke, SpectrumAxis::temporal, 0.0);
  const double rate_Hz = 1.0 / even.step;
  const double ratio = rate_Hz / kVibrationRate_Hz;
  if (ratio < 1.0 - kSameRate) {
    throw std::invalid_argument(which + " has " + fixed(rate_Hz, 0) +
                                " samples per second; vibration models need at least 1000. Record "
                                "at a higher rate");
  }
  Acceleration result{.speed_m_per_s = even.speed_m_per_s, .normal_N = stroke.mean_normal_N()};
  if (ratio <= 1.0 + kSameRate) {
    result.samples_m_per_s2 = even.force;
  } else {
    // Without the ends, where samples beyond them are missing.
    const double last = static_cast<double>(even.force.size() - 1);
    const double reach = BandLimitedInterpolation::kReach * ratio;
    for (double place = reach; place <= last - reach; place += ratio) {
      result.samples_m_per_s2.push_back(between.value(even.force, place, 1.0 / ratio));
    }
  }
  if (result.samples_m_per_s2.size() < kFewestSamplesOfStroke) {
    throw std::invalid_argument(which + " has " +
                                counted(result.samples_m_per_s2.size(), "sample", "samples") +
                                " at 1 kHz; record strokes of at least 0.1 s");
  }
  for (double& sample : result.samples_m_per_s2) sample /= mass_kg;
  return result;
}

/// The strokes of each model, in increasing order of the speed and then of the normal force.
std::vector<std::vector<Acceleration>> groups_of(std::vector<Acceleration> strokes) {
  std::sort(strokes.begin(), strokes.end(), [](const Acceleration& a, const Acceleration& b) {
    return a.speed_m_per_s < b.speed_m_per_s;
  });
  std::vector<std::vector<Acceleration>> groups{};
  for (auto from = strokes.begin(); from != strokes.end();) {
    const auto to = std::find_if(from, strokes.end(), [&](const Acceleration& stroke) {
      return stroke.speed_m_per_s >= kSpeedsOfOneModel * from->speed_m_per_s;
    });
    std::sort(from, to,
              [](const Acceleration& a, const Acceleration& b) { return a.normal_N < b.normal_N; });
    double lightest_N = 0.0;
    for (; from != to; ++from) {
      if (lightest_N == 0.0 || from->normal_N >= kForcesOfOneModel * lightest_N) {
        groups.emplace_back();
        lightest_N = from->normal_N;
      }
      groups.back().push_back(std::move(*from));
    }
  }
  return groups;
}

std::vector<std::vector<double>> segments_of(const std::vector<Acceleration>& group) {
  std::vector<std::vector<double>> segments{};
  for (const Acceleration& stroke : group) segments.push_back(stroke.samples_m_per_s2);
  return segments;
}

std::size_t samples_of_group(const std::vector<Acceleration>& group) {
  std::size_t count = 0;
  for (const Acceleration& stroke : group) count += stroke.samples_m_per_s2.size();
  return count;
}

std::size_t order_by_bic(const std::vector<std::vector<Acceleration>>& groups) {
  std::size_t best = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t order = 1; order <= kMostFittedOrder; ++order) {
    double sum = 0.0;
    for (const std::vector<Acceleration>& group : groups) {
      const auto count = static_cast<double>(samples_of_group(group));
      const double variance = burg_autoregression(segments_of(group), order).innovation_variance;
      sum += count * std::log(std::max(kLeastVariance, variance)) +
             static_cast<double>(order) * std::log(count);
    }
    if (!(sum < least)) continue;
    least = sum;
    best = order;
  }
  return best;
}

/// Each brings the poles closer to 0; coefficients that are numbers are stationary after a few.
constexpr int kMostShrinkings = 1000;

/// The process of variance 1 with the model's covariances; of a wave, kNoiseFloor of them are white noise.
Autoregression with_width(Autoregression model, const std::string& name) {
  std::optional<Predictors> predictors = stationary_predictors(model.coefficients);
  // A wave without noise has reflection coefficients that rounding may put at 1.
  bool is_wave = !predictors;
  for (int trial = 0; !predictors && trial < kMostShrinkings; ++trial) {
    shrink_poles(model, kStationaryRadius);
    predictors = stationary_predictors(model.coefficients);
  }
  if (!predictors) {
    throw std::invalid_argument(
        name + ": the coefficients of a fitted model are not numbers; record smaller forces");
  }
  for (std::size_t k = 1; k <= model.coefficients.size(); ++k) {
    is_wave = is_wave || std::abs(predictors->coefficients[k].back()) > kSharpest;
  }
  if (!is_wave) {
    return {.coefficients = std::move(model.coefficients),
            .innovation_variance = predictors->error_variance.back()};
  }
  std::vector<double> covariance{1.0};
  for (std::size_t k = 1; k <= model.coefficients.size(); ++k) {
    double sum = 0.0;
    for (std::size_t j = 1; j <= k; ++j) {
      sum += predictors->coefficients[k][j - 1] * covariance[k - j];
    }
    covariance.push_back(sum);
  }
  for (std::size_t k = 1; k < covariance.size(); ++k) covariance[k] /= 1.0 + kNoiseFloor;
  return autoregression_of_covariance(covariance);
}

void add_model(const std::vector<Acceleration>& group, const std::string& name, VibrationFit& fit) {
  VibrationModel model{};
  FittedStrokes fitted{.strokes = group.size(), .samples = samples_of_group(group)};
  double mean_square = 0.0;
  for (const Acceleration& stroke : group) {
    const auto count = static_cast<double>(stroke.samples_m_per_s2.size());
    const double weight = count / static_cast<double>(fitted.samples);
    model.speed_m_per_s += weight * stroke.speed_m_per_s;
    model.normal_N += weight * stroke.normal_N;
    for (const double sample : stroke.samples_m_per_s2) {
      mean_square += sample * sample / static_cast<double>(fitted.samples);
    }
  }
  fitted.rms_m_per_s2 = std::sqrt(mean_square);
  const Autoregression process =
      with_width(burg_autoregression(segments_of(group), fit.order), name);
  model.variance_m2_per_s4 = mean_square * process.innovation_variance;
  model.lines_rad = line_spectral_frequencies(process.coefficients);
  fit.set.models.push_back(std::move(model));
  fit.strokes.push_back(fitted);
}

}  // namespace

VibrationFit fitted_vibrations(const TextureRecording& recording, const std::string& name,
                               const VibrationFitSettings& settings) {
  require_strokes(recording, name);
  require_positive("VibrationFitSettings::effective_mass_kg", settings.effective_mass_kg);
  const BandLimitedInterpolation between{};
  std::vector<Acceleration> strokes{};
  for (std::size_t i = 0; i < recording.strokes.size(); ++i) {
    const std::string which = name + ": stroke " + std::to_string(i + 1);
    strokes.push_back(
        acceleration_of(recording.strokes[i], settings.effective_mass_kg, between, which));
    const std::vector<double>& samples = strokes.back().samples_m_per_s2;
    if (settings.order && samples.size() <= 2 * *settings.order) {
      throw std::invalid_argument(which + " has " + counted(samples.size(), "sample", "samples") +
                                  " at 1 kHz, too few for the order " +
                                  std::to_string(*settings.order) + "; choose a lower order");
    }
    if (std::none_of(samples.begin(), samples.end(),
                     [](double sample) { return std::abs(sample) > kSilence_m_per_s2; })) {
      throw PhrasedRefusal(
          phrase("Models", "%1: stroke %2 has no vibration; leave it out of the recording")
              .with(name, std::to_string(i + 1)));
    }
  }
  const std::vector<std::vector<Acceleration>> groups = groups_of(std::move(strokes));
  VibrationFit fit{.order = settings.order ? *settings.order : order_by_bic(groups)};
  for (const std::vector<Acceleration>& group : groups) add_model(group, name, fit);
  require_models(fit.set, name);
  return fit;
}

}  // namespace asperity

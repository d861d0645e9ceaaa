// How well the detector of buzz separates strokes with a planted oscillation from strokes without one, and its cost.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/evidence/evidence.h"
#include "tests/renderers/planted_strokes.h"

namespace asperity {
namespace {

constexpr double kLeastPlanted_N = 0.020;
constexpr std::array kAmplitudes{0.25, 0.5, 1.0};  // relative to the texture force
constexpr double kChosenLimit = 0.4;               // docs/instability.md

/// A stroke that cannot be judged counts as one without a vibration.
double ratio_of(const PerceivedInstability& judged) {
  return judged.buzz ? judged.buzz->ratio : 0.0;
}

struct SeriesOfModel {
  std::vector<double> clean{};
  std::array<std::vector<double>, kAmplitudes.size()> planted{};
  std::vector<double> texture_N{};
  std::map<std::string, double> greatest_clean{};  ///< by device
  int not_judged = 0;
  double cost_s = 0.0;
};

/// All models, those of a point ("point"), or the one with this id.
std::vector<ForceModel> chosen_models(const std::string& chosen) {
  const ModelRegistry registry = built_in_models();
  std::vector<ForceModel> models = registry.models();
  std::erase_if(models, [&chosen](const ForceModel& model) {
    if (chosen == "point") return model.declaration.needs_bodies;
    return !chosen.empty() && model.declaration.id != chosen;
  });
  return models;
}

void add_clean(SeriesOfModel& series, const SeriesStroke& each) {
  const auto records = planted_stroke(*each.model, each.inputs, each.stroke);
  const auto began = std::chrono::steady_clock::now();
  const RecordedTexture texture = texture_in(*each.model, each.inputs, records);
  const auto judged = perceived_instability(*each.model, each.inputs, texture);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  series.cost_s += took.count();
  if (!judged.buzz) ++series.not_judged;
  series.clean.push_back(ratio_of(judged));
  double& greatest = series.greatest_clean[each.stroke.device];
  greatest = std::max(greatest, ratio_of(judged));
  series.texture_N.push_back(recorded_texture_force_rms_N(texture, {}).value_or(0.0));
}

void add_planted(SeriesOfModel& series, SeriesStroke each, std::uint64_t number,
                 std::uint64_t seed) {
  const auto clean = planted_stroke(*each.model, each.inputs, each.stroke);
  const double texture_N =
      recorded_texture_force_rms_N(texture_in(*each.model, each.inputs, clean), {}).value_or(0.0);
  for (std::size_t i = 0; i < kAmplitudes.size(); ++i) {
    each.stroke.planted =
        oscillation_of_series(number, seed, std::max(kLeastPlanted_N, kAmplitudes[i] * texture_N));
    const auto records = planted_stroke(*each.model, each.inputs, each.stroke);
    series.planted[i].push_back(ratio_of(judged_stroke(*each.model, each.inputs, records)));
  }
}

std::size_t above(const std::vector<double>& ratios, double threshold) {
  return static_cast<std::size_t>(std::count_if(
      ratios.begin(), ratios.end(), [threshold](double ratio) { return ratio > threshold; }));
}

double greatest_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

double least_of(const std::vector<double>& values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : *std::min_element(values.begin(), values.end());
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_models(const std::map<std::string, SeriesOfModel>& all) {
  std::printf(
      "model\tclean\tgreatest\tflagged at %.2f\tplanted\tleast at 0.50\tmissed at %.2f\t"
      "not judged\ttexture force (median, N)\tcost of a stroke (ms)\tgreatest by device\n",
      kChosenLimit, kChosenLimit);
  for (const auto& [model, series] : all) {
    const std::vector<double>& half = series.planted[1];
    std::printf(
        "%s\t%zu\t%.3f\t%zu\t%zu\t%.3f\t%zu\t%d\t%.3f\t%.1f\t", model.c_str(), series.clean.size(),
        greatest_of(series.clean), above(series.clean, kChosenLimit), half.size(), least_of(half),
        half.size() - above(half, kChosenLimit), series.not_judged, median_of(series.texture_N),
        1e3 * series.cost_s / static_cast<double>(std::max<std::size_t>(1, series.clean.size())));
    for (const auto& [device, greatest] : series.greatest_clean) {
      std::printf("%s %.3f ", device.c_str(), greatest);
    }
    std::printf("\n");
  }
}

/// Over all models together.
void print_roc(const std::map<std::string, SeriesOfModel>& all) {
  std::printf("threshold\tclean flagged");
  for (const double amplitude : kAmplitudes) std::printf("\tmissed at %.2f", amplitude);
  std::printf("\n");
  for (double threshold = 0.10; threshold < 0.805; threshold += 0.05) {
    std::size_t flagged = 0;
    std::array<std::size_t, kAmplitudes.size()> missed{};
    for (const auto& [model, series] : all) {
      flagged += above(series.clean, threshold);
      for (std::size_t i = 0; i < kAmplitudes.size(); ++i) {
        missed[i] += series.planted[i].size() - above(series.planted[i], threshold);
      }
    }
    std::printf("%.2f\t%zu", threshold, flagged);
    for (const std::size_t count : missed) std::printf("\t%zu", count);
    std::printf("\n");
  }
}

}  // namespace

void print_perceived_instability(const DetectionSeries& order) {
  const std::vector<ForceModel> models = chosen_models(order.model);
  if (models.empty()) {
    throw std::invalid_argument("there is no force model \"" + order.model +
                                "\"; name one of those of asperity models");
  }
  std::map<std::string, SeriesOfModel> all{};
  for (std::uint64_t i = 0; i < order.clean; ++i) {
    const SeriesStroke each = stroke_of_series(models, i, order.seed);
    add_clean(all[each.model->declaration.id], each);
  }
  for (std::uint64_t i = 0; i < order.planted; ++i) {
    const SeriesStroke each = stroke_of_series(models, i, order.seed + 1);
    add_planted(all[each.model->declaration.id], each, i, order.seed + 1);
  }
  print_models(all);
  print_roc(all);
}

}  // namespace asperity

// How well the detector of buzz separates strokes with a planted oscillation from strokes without one, and its cost.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "tests/renderers/planted_strokes.h"

namespace asperity {
namespace {

constexpr double kLeastPlanted_N = 0.020;

/// A stroke that cannot be judged counts as one without a vibration.
double ratio_of(const PerceivedInstability& judged) {
  return judged.buzz ? judged.buzz->ratio : 0.0;
}

double buzz_in(const SeriesStroke& each) {
  const auto records = planted_stroke(*each.model, each.inputs, each.stroke);
  return ratio_of(judged_stroke(*each.model, each.inputs, records));
}

struct Judged {
  std::string label{};
  double ratio = 0.0;
};

std::vector<double> ratios_of(const std::vector<Judged>& all) {
  std::vector<double> ratios{};
  for (const Judged& each : all) ratios.push_back(each.ratio);
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

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

int run(std::uint64_t clean_strokes, std::uint64_t planted_strokes, std::uint64_t seed,
        const std::string& chosen) {
  const std::vector<ForceModel> models = chosen_models(chosen);
  std::vector<Judged> clean{};
  int not_judged = 0;
  std::map<std::string, double> worst{};
  std::map<std::string, std::pair<double, int>> cost_s{};
  for (std::uint64_t i = 0; i < clean_strokes; ++i) {
    const SeriesStroke each = stroke_of_series(models, i, seed);
    const auto records = planted_stroke(*each.model, each.inputs, each.stroke);
    const auto began = std::chrono::steady_clock::now();
    const auto judged = judged_stroke(*each.model, each.inputs, records);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    const std::string label = each.model->declaration.id + " on " + each.stroke.device;
    auto& cost = cost_s[each.model->declaration.id];
    cost.first += took.count();
    ++cost.second;
    if (!judged.buzz) ++not_judged;
    clean.push_back({label, ratio_of(judged)});
    worst[label] = std::max(worst[label], ratio_of(judged));
  }
  std::printf("clean strokes: %zu, of which not judged: %d\n", clean.size(), not_judged);
  for (const auto& [label, ratio] : worst)
    std::printf("  greatest %-40s %.3f\n", label.c_str(), ratio);
  for (const auto& [model, cost] : cost_s) {
    std::printf("  cost of 4 s of records, %-20s %.1f ms\n", model.c_str(),
                1e3 * cost.first / cost.second);
  }
  const std::vector<double> clean_ratios = ratios_of(clean);
  std::map<double, std::vector<double>> planted{};
  std::map<std::string, double> least{};
  for (std::uint64_t i = 0; i < planted_strokes; ++i) {
    SeriesStroke each = stroke_of_series(models, i, seed + 1);
    const auto records = planted_stroke(*each.model, each.inputs, each.stroke);
    const double texture_N =
        recorded_texture_force_rms_N(texture_in(*each.model, each.inputs, records), {})
            .value_or(0.0);
    for (const double amplitude : {0.25, 0.5, 1.0}) {
      each.stroke.planted =
          oscillation_of_series(i, seed + 1, std::max(kLeastPlanted_N, amplitude * texture_N));
      const double ratio = buzz_in(each);
      planted[amplitude].push_back(ratio);
      if (amplitude == 0.5) {
        const std::string label = each.model->declaration.id + " on " + each.stroke.device;
        const auto [place, is_new] = least.emplace(label, ratio);
        if (!is_new) place->second = std::min(place->second, ratio);
      }
    }
  }
  for (const auto& [label, ratio] : least) {
    std::printf("  least planted 0.5 %-40s %.3f\n", label.c_str(), ratio);
  }
  std::printf("threshold\tclean flagged");
  for (const auto& [amplitude, ratios] : planted) std::printf("\tmissed at %.2f", amplitude);
  std::printf("\n");
  for (double threshold = 0.10; threshold < 0.805; threshold += 0.05) {
    const auto above = std::count_if(clean_ratios.begin(), clean_ratios.end(),
                                     [&](double ratio) { return ratio > threshold; });
    std::printf("%.2f\t%ld", threshold, static_cast<long>(above));
    for (const auto& [amplitude, ratios] : planted) {
      std::printf("\t%ld",
                  static_cast<long>(std::count_if(ratios.begin(), ratios.end(), [&](double ratio) {
                    return ratio <= threshold;
                  })));
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  const auto number = [&](int index, std::uint64_t otherwise) {
    return index < argc ? std::strtoull(argv[index], nullptr, 10) : otherwise;
  };
  return asperity::run(number(1, 2000), number(2, 500), number(3, 1), argc > 4 ? argv[4] : "");
}

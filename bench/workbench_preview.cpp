// What one changed parameter costs the workbench: heights from a photograph and pictures of them.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/gui/workbench/texture_preview.h"
#include "device/machine.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/preview.h"
#include "stimuli/photographs/synthetic_photograph.h"
#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {
namespace {

constexpr int kWarmUp = 5;
constexpr int kCounted = 100;
constexpr std::size_t kThumbnailSide = 160;

struct Costs {
  std::string name{};
  std::vector<double> sorted_ms{};
};

Costs measure(const std::string& name, const std::function<double()>& work, double& used) {
  Costs costs{.name = name};
  for (int i = 0; i < kWarmUp + kCounted; ++i) {
    const auto started = std::chrono::steady_clock::now();
    used += work();
    const std::chrono::duration<double, std::milli> took =
        std::chrono::steady_clock::now() - started;
    if (i >= kWarmUp) costs.sorted_ms.push_back(took.count());
  }
  std::sort(costs.sorted_ms.begin(), costs.sorted_ms.end());
  return costs;
}

double quantile_ms(const Costs& costs, double fraction) {
  const auto last = static_cast<double>(costs.sorted_ms.size() - 1);
  return costs.sorted_ms[static_cast<std::size_t>(std::llround(fraction * last))];
}

double thumbnails(const PhotographTexture& texture) {
  double sum = 0.0;
  for (const GreyImage* step : {&texture.grey, &texture.evened, &texture.low_pass}) {
    sum += static_cast<double>(stretched(scaled_to_fit(*step, kThumbnailSide)).values.front());
  }
  const HeightField::Grid& grid = texture.field.grid();
  const GreyImage heights{grid.rows, grid.columns, texture.field.heights_m()};
  return sum +
         static_cast<double>(stretched(scaled_to_fit(heights, kThumbnailSide)).values.front());
}

/// What the window shows: a recipe from nothing, and one that differs from the last in one field.
void measure_window(const GreyImage& photograph, const GreyImage& coarse, std::vector<Costs>& all,
                    double& used) {
  const auto shown = [](const TexturePreview& preview) {
    return preview.field->rms_m() + preview.fine->exaggeration;
  };
  all.push_back(measure(
      "window/1024/from nothing",
      [&] { return shown(PhotographPreviews(photograph, "photograph").under({})); }, used));
  struct Change {
    const char* name = nullptr;
    double TextureRecipe::*field = nullptr;
  };
  constexpr std::array<Change, 5> kChanges{
      {{"rms_m", &TextureRecipe::rms_m},
       {"gaussian_wavelength_m", &TextureRecipe::gaussian_wavelength_m},
       {"gamma_high", &TextureRecipe::gamma_high},
       {"homomorphic_wavelength_m", &TextureRecipe::homomorphic_wavelength_m},
       {"width_m", &TextureRecipe::width_m}}};
  for (const auto& [side, picture] : {std::pair{"1024", &photograph}, std::pair{"384", &coarse}}) {
    for (const Change& change : kChanges) {
      PhotographPreviews previews(*picture, "photograph");
      TextureRecipe recipe{};
      used += shown(previews.under(recipe));
      all.push_back(measure(
          std::string("window/") + side + "/" + change.name,
          [&] {
            recipe.*change.field *= 1.001;  // another one every time
            return shown(previews.under(recipe));
          },
          used));
    }
  }
}

/// What follows a preview on the screen: the relief as it moves, and as it rests.
void measure_drawing(const GreyImage& photograph, std::vector<Costs>& all, double& used) {
  const TexturePreview preview = PhotographPreviews(photograph, "photograph").under({});
  constexpr QSize kView{800, 500};
  const auto drawn = [](const ReliefMesh& mesh, const QSize& size) {
    return static_cast<double>(draw_relief(mesh, {}, size).pixel(size.width() / 2, 0));
  };
  all.push_back(measure(
      "relief/moving", [&] { return drawn(*preview.coarse, kView); }, used));
  all.push_back(measure(
      "relief/resting", [&] { return drawn(*preview.fine, 2 * kView); }, used));
}

void print_json(const std::vector<Costs>& all) {
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", ASPERITY_COMMIT},
                                  {"cases", nlohmann::ordered_json::array()}};
  for (const Costs& costs : all) {
    document["cases"].push_back({{"name", costs.name},
                                 {"unit", "ms"},
                                 {"p50", quantile_ms(costs, 0.5)},
                                 {"p99", quantile_ms(costs, 0.99)},
                                 {"count", costs.sorted_ms.size()}});
  }
  std::puts(document.dump(2).c_str());
}

void print_table(const std::vector<Costs>& all) {
  std::printf("%-36s %8s %8s %6s\n", "case (ms)", "p50", "p99", "count");
  for (const Costs& costs : all) {
    std::printf("%-36s %8.1f %8.1f %6zu\n", costs.name.c_str(), quantile_ms(costs, 0.5),
                quantile_ms(costs, 0.99), costs.sorted_ms.size());
  }
}

int run(bool as_json) {
  const HeightField surface =
      make_surface("brick", {}, {.width_m = 0.10, .pixels = kPreviewSide, .seed = 1});
  const GreyImage photograph = synthetic_photograph(surface, PhotographSettings{});
  const GreyImage coarse = scaled_to_fit(photograph, kDraggedSide);
  const TextureRecipe recipe{};
  const PhotographTexture texture = texture_from_photograph(photograph, recipe, "photograph");
  const auto texture_of = [&recipe](const GreyImage& picture) {
    return texture_from_photograph(picture, recipe, "photograph").field.rms_m();
  };
  double used = 0.0;  // so that no work can be left out
  std::vector<Costs> all;
  all.push_back(measure(
      "texture/1024", [&] { return texture_of(photograph); }, used));
  all.push_back(measure(
      "texture/384", [&] { return texture_of(coarse); }, used));
  all.push_back(measure(
      "thumbnails/1024", [&] { return thumbnails(texture); }, used));
  all.push_back(measure(
      "shaded_relief/1024",
      [&] { return static_cast<double>(shaded_relief(texture.field).values.front()); }, used));
  all.push_back(measure(
      "preview/1024",
      [&] { return thumbnails(texture_from_photograph(photograph, recipe, "photograph")); }, used));
  measure_window(photograph, coarse, all, used);
  measure_drawing(photograph, all, used);
  as_json ? print_json(all) : print_table(all);
  return std::isfinite(used) ? 0 : 1;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  if (argc > 2 || (argc == 2 && std::strcmp(argv[1], "--json") != 0)) {
    std::fprintf(stderr, "usage: %s [--json]\n", argv[0]);
    return 2;
  }
  return asperity::run(argc == 2);
}

// Implements the choice of windows and the checks of their sampling.

#include "renderers/pd_gradient/sampling/window_samplers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"

namespace asperity {
namespace {

constexpr int kSamplesPerStep = 32;  // the sampler's number of samples is a multiple of it
constexpr double kWholeCell = 1e-6;  // tolerance for a whole number of cells
constexpr std::array kStepsInCells{1, 2, 4, 8};  // whole numbers also after doubling the cells
constexpr std::size_t kMostPlaces = 12;  // ten contacts, and two whose heights are being sampled
constexpr std::size_t kMostCoarsePlaces = 3;

/// The step of the hard maximum in cells; 1 for the smooth one, which has no step. nullopt if it is not a number of
/// cells that a window can have.
std::optional<int> cells_per_step(const WindowSampling& sampling) {
  const auto* hard = std::get_if<HardMaximum>(&sampling.law);
  if (hard == nullptr) return 1;
  const double cells = hard->step_m / sampling.cell_m;
  for (const int whole : kStepsInCells) {
    if (std::abs(cells - whole) < kWholeCell) return whole;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ParameterConflict> conflict_in(const WindowSampling& sampling) {
  if (!(sampling.cell_m > 0.0) || !std::isfinite(sampling.cell_m)) {
    throw std::invalid_argument("cell_m is " + number_text(sampling.cell_m) +
                                "; it must be positive.");
  }
  require_sound(sampling.law);
  const std::optional<int> cells = cells_per_step(sampling);
  if (!cells) {
    const auto steps_m = [&sampling](std::size_t i) {
      return number_text(kStepsInCells[i] * sampling.cell_m);
    };
    return ParameterConflict{
        .parameters = {"step_m", "cell_m"},
        .message = phrase("Protocols",
                          "step_m is %1 and cell_m %2; step_m must be 1, 2, 4 or 8 times cell_m, "
                          "here %2, %3, %4 or %5.")
                       .with(number_text(std::get<HardMaximum>(sampling.law).step_m), steps_m(0),
                             steps_m(1), steps_m(2), steps_m(3))};
  }
  const int least = kSamplesPerStep * *cells;
  if (sampling.most_samples >= least) return std::nullopt;
  const Phrase sentence =
      *cells == 1 ? phrase("Protocols",
                           "most_samples is %1; with a step of %2 cell it must be at least %3.")
                  : phrase("Protocols",
                           "most_samples is %1; with a step of %2 cells it must be at least %3.");
  return ParameterConflict{.parameters = {"most_samples", "step_m", "cell_m"},
                           .message = sentence.with(std::to_string(sampling.most_samples),
                                                    std::to_string(*cells), std::to_string(least))};
}

WindowSamplers::WindowSamplers(const WindowSampling& sampling, double widest_m,
                               std::size_t most_triangles, InstructionSet instructions) {
  if (const auto conflict = conflict_in(sampling)) throw PhrasedRefusal(conflict->message);
  const int declared = cells_per_step(sampling).value();
  const bool keeps = sampling.heights == Heights::kept;
  double cell_m = sampling.cell_m;
  double reached_m = 0.0;
  for (int doubled = 0; reached_m < widest_m; ++doubled, cell_m *= 2.0) {
    const int step_cells = std::max(1, declared >> doubled);
    MaximumLaw law = sampling.law;
    bool is_coarse = doubled > 0;
    if (auto* hard = std::get_if<HardMaximum>(&law)) {
      hard->step_m = step_cells * cell_m;
      is_coarse = declared >> doubled == 0;
    }
    const int multiple = kSamplesPerStep * step_cells;
    for (int samples = multiple; samples <= sampling.most_samples && reached_m < widest_m;
         samples += multiple) {
      const double width_m = samples * cell_m;
      if (width_m <= reached_m) continue;
      const auto with = [&](int halvings, std::size_t most_places) {
        return CachedPenetration(
            {.sampler = {.grid = {.width_m = width_m, .samples = samples << halvings},
                         .law = law,
                         .most_triangles = most_triangles,
                         .instructions = instructions},
             .most_places = keeps ? most_places : 0});
      };
      Window window{.sampler = with(0, is_coarse ? kMostCoarsePlaces : kMostPlaces),
                    .law = law,
                    .is_coarse = is_coarse};
      const bool has_finer = keeps && std::holds_alternative<HardMaximum>(law);
      for (int k = 1; has_finer && k <= sampling.most_halvings; ++k) {
        const bool is_fine = std::ldexp(cell_m, 1 - k) <= sampling.fine_enough_m;
        const int across = samples << k;
        if (is_fine || across > sampling.most_samples || step_cells << k > kStepsInCells.back())
          break;
        // As many contacts as may have these cells in a tick (TexturedContacts), and two whose heights are being sampled.
        const auto contacts = static_cast<std::size_t>(sampling.most_samples / across);
        window.finer.push_back(with(k, std::min(kMostPlaces, contacts * contacts + 2)));
      }
      windows_.push_back(std::move(window));
      reached_m = width_m;
    }
  }
}

WindowSamplers::Window& WindowSamplers::window_for(double width_m) noexcept {
  const auto found = std::find_if(
      windows_.begin(), windows_.end(),
      [width_m](const Window& window) { return window.sampler.grid().width_m >= width_m; });
  return found == windows_.end() ? windows_.back() : *found;
}

std::size_t WindowSamplers::bytes() const noexcept {
  std::size_t bytes = 0;
  for (const Window& window : windows_) {
    bytes += window.sampler.bytes();
    for (const CachedPenetration& finer : window.finer) bytes += finer.bytes();
  }
  return bytes;
}

void WindowSamplers::reset() noexcept {
  for (Window& window : windows_) {
    window.sampler.reset();
    for (CachedPenetration& finer : window.finer) finer.reset();
  }
}

}  // namespace asperity

// Implements the shape of lattices and the limits of motion.

#include "renderers/pd_gradient/sampling/kept_place.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderers/pd_gradient/sampling/sampled_triangles.h"

namespace asperity {
namespace {

constexpr double kMostTilt = 0.03;  // sines: heights off the lattice's plane shift by this
constexpr double kMostAwayFromN = 0.06;
// Permitted displacement of the box's ends, relative to its half height. With 1 the force of a ball through two thin
// sheets is off by 0.15 N of 1.1; with 0.5 a small contact is sampled so often that the work of a closed path of the
// smooth maximum is 8e-5 of the gross work instead of 2e-5.
constexpr double kMostOfBox = 0.75;
constexpr double kMostOtherLeaning = 0.05;  // of the cosine from which faces sink, at most 0.5
constexpr double kMostTurnOfLanes = 2.0 / (kMostLanes - 1);  // 3 rows contain a row of lanes
constexpr int kStepOfWindow = 4;                             // cells: a whole number of kBoundRows

// Of a window along one axis; it is at most half a tile off.
double most_aside_cells(int margin) noexcept { return margin - kStepOfWindow; }

std::size_t samples_of(const KeptLattice& lattice) noexcept {
  return static_cast<std::size_t>(lattice.grid.samples * lattice.stride + kMostLanes);
}

std::size_t bounds_of(const KeptLattice& lattice) noexcept {
  return static_cast<std::size_t>(lattice.grid.samples / kBoundRows * lattice.stride);
}

KeptHeights kept(BodyHeights& heights, const KeptLattice& lattice, int span) noexcept {
  return {.height_m = heights.height_m.data(),
          .samples = lattice.grid.samples,
          .stride = lattice.stride,
          .most_m = heights.most_m.data(),
          .span = span};
}

}  // namespace

KeptLattice kept_lattice(const SamplingGrid& window, const MaximumLaw& law) {
  KeptLattice lattice{.window = window, .step_cells = kSlopeApron};
  if (const auto* hard = std::get_if<HardMaximum>(&law)) {
    lattice.step_cells = static_cast<int>(std::lround(hard->step_m / window.spacing_m()));
    lattice.steps = difference_steps(window, hard->step_m);
  }
  lattice.margin = rounded_up(window.samples / 4 + lattice.step_cells + 5, kStepOfWindow);
  lattice.grid.samples = window.samples + 2 * lattice.margin;
  lattice.grid.width_m = lattice.grid.samples * window.spacing_m();
  const double most_aside_m = most_aside_cells(lattice.margin) * window.spacing_m();
  constexpr double kRounding = 1.001;
  lattice.most_away_m =
      kRounding * glm::length(glm::dvec3{most_aside_m, most_aside_m, 0.5 * window.width_m});
  lattice.stride = stride_of_samples(lattice.grid.samples);
  // The reach of find_bounds along a row, with a margin for lattices that are not parallel.
  const double around = 1.05 * lattice.step_cells;
  const double reach = 1.02 * (0.5 * (kMostLanes - 1) + around) +
                       kMostTurnOfLanes * (0.5 * (kBlockRows - 1) + around) + 1.2;
  lattice.span_of_a = static_cast<int>(2.0 * reach) + 2;
  return lattice;
}

std::size_t bytes_of_place(const KeptLattice& lattice) noexcept {
  return 2 * sizeof(float) * (samples_of(lattice) + bounds_of(lattice));
}

KeptPlace empty_place(const KeptLattice& lattice) {
  KeptPlace place;
  for (BodyHeights* heights : {&place.a, &place.b}) {
    heights->height_m.assign(samples_of(lattice), kNoSurface_m);
    heights->most_m.assign(bounds_of(lattice), kNoSurface_m);
  }
  return place;
}

KeptHeights kept_a(KeptPlace& place, const KeptLattice& lattice) noexcept {
  return kept(place.a, lattice, lattice.span_of_a);
}

KeptHeights kept_b(KeptPlace& place, const KeptLattice& lattice) noexcept {
  return kept(place.b, lattice, kMostLanes);
}

KeptPositions places_in_a(const Pose& X_LM, const KeptLattice& lattice, const glm::dvec2& first,
                          double turn_rad) noexcept {
  const double cosine = std::cos(turn_rad);
  const double sine = std::sin(turn_rad);
  const glm::dmat3& r = X_LM.rotation;  // r[column][row]
  // q = R₂ₓ₂·p + shift, all relative to the lattice's middle
  const glm::dmat2 ahead(r[0].x, r[0].y, r[1].x, r[1].y);
  const double z_m = -X_LM.position_m.z;
  const double per_m = 1.0 / lattice.grid.spacing_m();
  const glm::dvec2 shift = per_m * (glm::dvec2{X_LM.position_m} + z_m * glm::dvec2{r[2]});
  const double middle = 0.5 * (lattice.grid.samples - 1);
  const glm::dvec2 centre = first + 0.5 * (lattice.window.samples - 1) - middle;
  // Turned: q = T·(R₂ₓ₂·p + shift − centre) + centre
  const glm::dmat2 turn(cosine, sine, -sine, cosine);
  const glm::dmat2 back = glm::inverse(turn * ahead);
  const glm::dvec2 start = back * (first - middle - centre - turn * (shift - centre)) + middle;
  return {.x = static_cast<float>(start.x),
          .y = static_cast<float>(start.y),
          .x_per_column = static_cast<float>(back[0].x),
          .x_per_row = static_cast<float>(back[1].x),
          .y_per_column = static_cast<float>(back[0].y),
          .y_per_row = static_cast<float>(back[1].y)};
}

KeptLift lift_of_a(const Pose& X_LM, const KeptLattice& lattice) noexcept {
  const glm::dmat3& r = X_LM.rotation;
  const double cell_m = lattice.grid.spacing_m();
  const double middle_m = 0.5 * (lattice.grid.samples - 1) * cell_m;
  return {.per_m = static_cast<float>(r[2].z),
          .per_x_m = static_cast<float>(-r[0].z * cell_m),
          .per_y_m = static_cast<float>(-r[1].z * cell_m),
          .shift_m = static_cast<float>((r[0].z + r[1].z) * middle_m - X_LM.position_m.z)};
}

std::optional<PlaceFit> fit_of(const KeptPlace& place, const KeptLattice& lattice,
                               const PackedPatch& a, const PackedPatch& b,
                               const ContactFrame& frame) noexcept {
  if (place.surface_a != &a.surface || place.surface_b != &b.surface) return std::nullopt;
  // Most places belong to other contacts.
  const glm::dvec3 middle_m = b.pose * place.X_BL.position_m;
  if (glm::distance(middle_m, frame.origin_m) > lattice.most_away_m) return std::nullopt;
  PlaceFit found{.X_WL = b.pose * place.X_BL};
  const Pose X_LW = inverse(found.X_WL);
  found.X_LM = X_LW * (a.pose * place.X_AL);
  const glm::dvec3 origin_m = X_LW * frame.origin_m;
  const glm::dvec3 n = X_LW.rotation * frame.n;
  const int samples = lattice.window.samples;
  const double cell_m = lattice.grid.spacing_m();
  const double most_aside = most_aside_cells(lattice.margin);
  const glm::dvec2 aside = glm::dvec2{origin_m} / cell_m;
  const glm::dmat3& r = found.X_LM.rotation;

  const double turn = std::max(std::abs(r[0].y), std::abs(r[1].x));
  const double tilt = std::max(std::abs(r[0].z), std::abs(r[1].z));
  bool fits = n.z > 0.0 && r[2].z > 0.0;
  const auto strained = [&](double share) {
    fits = fits && share < 1.0;  // false also for NaN
    found.strain = std::max(found.strain, share);
  };
  strained(std::abs(aside.x) / most_aside);
  strained(std::abs(aside.y) / most_aside);
  strained(std::abs(origin_m.z) / (0.5 * lattice.window.width_m));
  // The content of a different box is unknown.
  const double half_m = a.half_height_m;
  strained((std::abs(origin_m.z) + std::abs(half_m - place.half_height_m)) /
           (kMostOfBox * std::min(half_m, place.half_height_m)));
  strained(std::abs(a.leaning_cosine - place.leaning_a) / kMostOtherLeaning);
  strained(std::abs(b.leaning_cosine - place.leaning_b) / kMostOtherLeaning);
  strained(glm::length(glm::dvec2{n}) / kMostAwayFromN);
  strained(tilt / kMostTilt);
  strained(turn / (kMostTurnOfLanes - lattice.steps.turn_rad));
  if (!fits) return std::nullopt;
  const auto first = [&](double from_middle) {
    return lattice.margin +
           kStepOfWindow * static_cast<int>(std::lround(from_middle / kStepOfWindow));
  };
  found.column = first(aside.x);
  found.row = first(aside.y);
  // A's heights under the requested origin, and the greatest distance from there that is used. The window's middle is at
  // most half a tile off; with its own place, the strain would jump with every step of the window.
  const KeptPositions places =
      places_in_a(found.X_LM, lattice, static_cast<double>(lattice.margin) + aside, 0.0);
  const double half = 0.5 * (samples - 1);
  const double middle = 0.5 * (lattice.grid.samples - 1);
  const double x = places.x + half * (double{places.x_per_column} + double{places.x_per_row});
  const double y = places.y + half * (double{places.y_per_column} + double{places.y_per_row});
  const double reach =
      (half + 0.5 * kStepOfWindow + lattice.step_cells) * (1.0 + turn) / (1.0 - tilt) +
      3.0;  // rows between rows
  strained(std::abs(x - middle) / (middle - reach));
  strained(std::abs(y - middle) / (middle - reach));
  return fits ? std::optional(found) : std::nullopt;
}

}  // namespace asperity

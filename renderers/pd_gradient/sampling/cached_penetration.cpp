// Implements the choice of kept heights and their evaluation after motion.

#include "renderers/pd_gradient/sampling/cached_penetration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

#include <glm/geometric.hpp>

#include "renderers/pd_gradient/sampling/found_gradient.h"

namespace asperity {
namespace {

constexpr double kSoftStrain = 0.5;
constexpr double kLeastFall = 0.8;             // at this angle, of a surface that is 73° from n
constexpr double kHurryWithoutHeights = 0.15;  // of the work: sampling anew costs as much
constexpr double kHurryOfKept = 0.08;          // of evaluate_kept: all of it in about 16 calls

std::size_t number_of_places(const CachedSettings& settings, const KeptLattice& lattice) {
  if (settings.most_places == 0) return 0;
  return std::clamp(settings.most_bytes / bytes_of_place(lattice), std::size_t{2},
                    settings.most_places);
}

// Converts to another frame: along an n other than the kept one, δ decreases by less than a metre per metre. It
// decreases by less than kLeastFall, or not at all, only where the surface is steeper than any for which n is a contact
// direction.
Penetration in_frame(const Penetration& found, const ContactFrame& kept,
                     const ContactFrame& asked) {
  const glm::dvec3 gradient = kept.to_world({found.slope, -1.0});
  const glm::dvec3 lever_m =
      kept.to_world(found.lever_m) + glm::cross(kept.origin_m - asked.origin_m, gradient);
  const double per_fall = 1.0 / std::max(kLeastFall, -glm::dot(gradient, asked.n));
  Penetration result = found;
  result.depth_m = found.depth_m * per_fall;
  result.slope = per_fall * glm::dvec2{asked.to_frame(gradient)};
  result.lever_m = per_fall * asked.to_frame(lever_m);
  result.deepest_m =
      asked.to_frame(kept.origin_m + kept.to_world(found.deepest_m) - asked.origin_m);
  return result;
}

}  // namespace

CachedPenetration::CachedPenetration(const CachedSettings& settings)
    : sampler_(settings.sampler),
      law_(settings.sampler.law),
      pruning_(settings.pruning),
      loops_(&loops_of(settings.sampler.instructions)),
      lattice_(kept_lattice(settings.sampler.grid, settings.sampler.law)),
      sampling_(lattice_, settings.sampler.most_triangles, settings.rows_in_a_call, *loops_) {
  if (settings.most_places == 1) {
    throw std::invalid_argument(
        "CachedPenetration: most_places is 1; it must be 0 or at least 2, because one place is "
        "used while another is sampled.");
  }
  const SamplingGrid& grid = sampler_.grid();
  patch_width_m_ = settings.most_places > 0
                       ? lattice_.grid.width_m
                       : grid.width_m + 2 * lattice_.step_cells * grid.spacing_m();
  places_.assign(number_of_places(settings, lattice_), empty_place(lattice_));
  const auto blocks =
      static_cast<std::size_t>(grid.samples / kMostLanes * (grid.samples / kBlockRows));
  bound_m_.assign(blocks, 0.0F);
  block_most_m_.assign(blocks * kMostLanes, 0.0F);
}

std::size_t CachedPenetration::bytes() const noexcept {
  return places_.size() * bytes_of_place(lattice_) + sampler_.bytes() + sampling_.bytes();
}

void CachedPenetration::reset() noexcept {
  for (KeptPlace& place : places_) {
    place.is_whole = false;
    place.last_used = 0;
  }
  sampling_.reset();
  calls_ = 0;
  kept_answers_ = 0;
  sampled_answers_ = 0;
}

CachedPenetration::Choice CachedPenetration::choose(const PackedPatch& a, const PackedPatch& b,
                                                    const ContactFrame& frame) const noexcept {
  Choice choice{.fit = {.strain = 1.0}};
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const bool is_in_work = !sampling_.is_idle() && in_work_ == i;
    if (!places_[i].is_whole && !is_in_work) continue;
    const std::optional<PlaceFit> found = fit_of(places_[i], lattice_, a, b, frame);
    if (!found) continue;
    if (is_in_work) {
      choice.is_coming = true;
    } else if (found->strain < choice.fit.strain) {
      choice.place = i;
      choice.fit = *found;
    }
  }
  choice.begins = !places_.empty() && choice.fit.strain > kSoftStrain && !choice.is_coming &&
                  sampling_.is_idle();
  return choice;
}

std::optional<Penetration> CachedPenetration::evaluate(const Choice& choice, const PackedPatch& a,
                                                       const PackedPatch& b,
                                                       const ContactFrame& frame) noexcept {
  note(choice, a, b, frame);
  const bool serves_until_then = choice.place && (choice.begins || choice.is_coming);
  const double part = serves_until_then ? sampling_.hurry(choice.fit.strain)
                      : choice.place    ? 0.0
                                        : kHurryWithoutHeights;
  if (!sampling_.is_idle()) sampling_.resume(places_[in_work_], part);
  if (!choice.place) {
    ++sampled_answers_;
    return sampler_.evaluate(a, b, frame);
  }
  ++kept_answers_;
  return from_place(places_[*choice.place], choice.fit, frame);
}

std::optional<Penetration> CachedPenetration::evaluate_kept(const Choice& choice,
                                                            const PackedPatch& a,
                                                            const PackedPatch& b,
                                                            const ContactFrame& frame) noexcept {
  note(choice, a, b, frame);
  if (!sampling_.is_idle()) sampling_.resume(places_[in_work_], kHurryOfKept);
  if (!choice.place) return std::nullopt;
  ++kept_answers_;
  return from_place(places_[*choice.place], choice.fit, frame);
}

// Records which heights are used, and begins new ones in the place that has not been used for the longest time.
void CachedPenetration::note(const Choice& choice, const PackedPatch& a, const PackedPatch& b,
                             const ContactFrame& frame) noexcept {
  ++calls_;
  if (choice.place) places_[*choice.place].last_used = calls_;
  if (!choice.begins) return;
  const auto least_used = std::min_element(
      places_.begin(), places_.end(),
      [](const KeptPlace& p, const KeptPlace& q) { return p.last_used < q.last_used; });
  in_work_ = static_cast<std::size_t>(least_used - places_.begin());
  least_used->last_used = calls_;
  sampling_.begin(*least_used, a, b, frame, choice.fit.strain);
}

std::optional<Penetration> CachedPenetration::from_place(KeptPlace& place, const PlaceFit& fit,
                                                         const ContactFrame& frame) noexcept {
  const int samples = grid().samples;
  const double cell_m = lattice_.grid.spacing_m();
  const glm::dvec2 first{fit.column, fit.row};
  const auto turned = [&](double turn_rad) {
    return places_in_a(fit.X_LM, lattice_, first, turn_rad);
  };
  KeptTask task{.a = kept_a(place, lattice_),
                .b = kept_b(place, lattice_),
                .samples = samples,
                .b_column = fit.column,
                .b_row = fit.row,
                .here = turned(0.0),
                .lift = lift_of_a(fit.X_LM, lattice_),
                .step_cells = lattice_.step_cells,
                .prune = pruning_ == Pruning::on,
                .first_block = place.deepest_block,
                .bound_m = bound_m_.data(),
                .block_most_m = block_most_m_.data()};
  // The window's middle, the reference of positions and levers.
  const glm::dvec2 aside = (first - static_cast<double>(lattice_.margin)) * cell_m;
  ContactFrame kept_frame{
      .u = fit.X_WL.rotation[0], .v = fit.X_WL.rotation[1], .n = fit.X_WL.rotation[2]};
  kept_frame.origin_m = fit.X_WL.position_m + kept_frame.to_world({aside, 0.0});

  const auto deepest_m = [&](int row, int column, float here_m) {
    const auto at =
        static_cast<std::size_t>((fit.row + row) * lattice_.stride + fit.column + column);
    return glm::dvec3{grid().place_m(column), grid().place_m(row),
                      double{place.b.height_m[at]} - double{here_m}};
  };
  Penetration result;
  if (const auto* smooth = std::get_if<SmoothMaximum>(&law_)) {
    task.per_tau_per_m = static_cast<float>(1.0 / smooth->tau_m);
    WeightedSums sums;
    loops_->weigh_kept(task, sums);
    if (!(sums.here_m > kNothing_m)) return std::nullopt;
    result = gradient_of(sums, *smooth, cell_m, deepest_m(sums.row, sums.column, sums.here_m));
    result.at_border = at_border(task, sums.row, sums.column);
    result.at_window = grid().is_outermost(sums.row, sums.column);
  } else {
    task.forth = turned(lattice_.steps.turn_rad);
    task.back = turned(-lattice_.steps.turn_rad);
    task.tilt_rise_m = static_cast<float>(lattice_.steps.tilt_rad * cell_m);
    ElevenMaxima maxima;
    loops_->compare_kept(task, maxima);
    if (!(maxima.here_m > kNothing_m)) return std::nullopt;
    result =
        gradient_of(maxima, lattice_.steps, deepest_m(maxima.row, maxima.column, maxima.here_m));
    result.at_border = at_border(task, maxima.row, maxima.column);
    result.at_window = grid().is_outermost(maxima.row, maxima.column);
  }
  const auto& at_m = result.deepest_m;
  const auto cell = [&](double from_middle_m) {
    return static_cast<int>(std::lround(from_middle_m / cell_m + 0.5 * (samples - 1)));
  };
  place.deepest_block =
      cell(at_m.y) / kBlockRows * (samples / kMostLanes) + cell(at_m.x) / kMostLanes;
  result.covered = place.covered;
  result.folded = place.folded;
  return in_frame(result, kept_frame, frame);
}

// Whether the window, or a surface next to the sample, ends there.
bool CachedPenetration::at_border(const KeptTask& task, int row, int column) const noexcept {
  if (grid().is_outermost(row, column)) return true;
  const auto missing = [](const KeptHeights& of, int r, int c) {
    return of.height_m[r * of.stride + c] < kNothing_m;
  };
  const int b_row = task.b_row + row;
  const int b_column = task.b_column + column;
  if (missing(task.b, b_row - 1, b_column) || missing(task.b, b_row + 1, b_column) ||
      missing(task.b, b_row, b_column - 1) || missing(task.b, b_row, b_column + 1)) {
    return true;
  }
  const auto along = static_cast<float>(column);
  const auto across = static_cast<float>(row);
  const KeptPositions& here = task.here;
  const int x = static_cast<int>(here.x + here.x_per_column * along + here.x_per_row * across);
  const int y = static_cast<int>(here.y + here.y_per_column * along + here.y_per_row * across);
  for (int r = y - 1; r <= y + 2; ++r) {
    for (int c = x - 1; c <= x + 2; ++c) {
      if (missing(task.a, r, c)) return true;
    }
  }
  return false;
}

}  // namespace asperity

// Implements the storage of heights, their evaluation after motion, and their renewal a few rows at a time.

#include "renderers/pd_gradient/sampling/cached_penetration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderers/pd_gradient/sampling/found_gradient.h"
#include "renderers/pd_gradient/sampling/sampled_triangles.h"

namespace asperity {
namespace {

constexpr double kSoftStrain = 0.5;
constexpr double kMostTilt = 0.03;  // sines: heights off the lattice's plane shift by this
constexpr double kMostAwayFromN = 0.06;
constexpr double kLeastFall = 0.8;  // at this angle, of a surface that is 73° from n
// Permitted displacement of the box's ends, relative to its half height. With 1 the force of a ball through two thin
// sheets is off by 0.15 N of 1.1; with 0.5 a small contact is sampled so often that the work of a closed path of the
// smooth maximum is 8e-5 of the gross work instead of 2e-5.
constexpr double kMostOfBox = 0.75;
constexpr double kMostOtherLeaning = 0.05;  // of the cosine from which faces sink, at most 0.5
constexpr double kMostTurnOfLanes = 2.0 / (kMostLanes - 1);  // 3 rows contain a row of lanes
constexpr int kStepOfWindow = 4;                             // cells: a whole number of kBoundRows
constexpr double kHurryWithoutHeights = 0.15;  // of the work: sampling anew costs as much
constexpr double kHurryOfKept = 0.08;          // of evaluate_kept: all of it in about 16 calls
constexpr double kLittle = 1e-9;
constexpr double kNewestGrowth = 0.25;  // the weight of a call in the mean growth of the strain
constexpr int kTrianglesInACall = 12;

Pose pose_of(const ContactFrame& frame) noexcept {
  return {.rotation = glm::dmat3(frame.u, frame.v, frame.n), .position_m = frame.origin_m};
}

// Of a window along one axis; it is at most half a tile off.
double most_aside_cells(int margin) noexcept { return margin - kStepOfWindow; }

int rounded_up(int value, int multiple) { return (value + multiple - 1) / multiple * multiple; }

// The positions in A's heights for the window whose first sample is at (column, row) of B's lattice, with A turned
// about the window's middle by `turn_rad`. In cells.
KeptPlaces places_of(const Pose& motion, const SamplingGrid& lattice, int samples,
                     const glm::dvec2& first, double turn_rad) {
  const double cosine = std::cos(turn_rad);
  const double sine = std::sin(turn_rad);
  const glm::dmat3& r = motion.rotation;  // r[column][row]
  // q = R₂ₓ₂·p + shift, all relative to the lattice's middle
  const glm::dmat2 ahead(r[0].x, r[0].y, r[1].x, r[1].y);
  const double z_m = -motion.position_m.z;
  const double per_m = 1.0 / lattice.spacing_m();
  const glm::dvec2 shift = per_m * (glm::dvec2{motion.position_m} + z_m * glm::dvec2{r[2]});
  const double middle = 0.5 * (lattice.samples - 1);
  const glm::dvec2 centre = first + 0.5 * (samples - 1) - middle;
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

// A's heights are measured against n: a point at (x, y, −a) is now at a' against n.
KeptLift lift_of(const Pose& motion, const SamplingGrid& lattice) {
  const glm::dmat3& r = motion.rotation;
  const double middle_m = 0.5 * (lattice.samples - 1) * lattice.spacing_m();
  return {.per_m = static_cast<float>(r[2].z),
          .per_x_m = static_cast<float>(-r[0].z * lattice.spacing_m()),
          .per_y_m = static_cast<float>(-r[1].z * lattice.spacing_m()),
          .shift_m = static_cast<float>((r[0].z + r[1].z) * middle_m - motion.position_m.z)};
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
      rows_in_a_call_(settings.rows_in_a_call),
      pruning_(settings.pruning),
      loops_(&loops_of(settings.sampler.instructions)) {
  if (settings.most_places == 1) {
    throw std::invalid_argument(
        "CachedPenetration: most_places is 1; it must be 0 or at least 2, because one place is "
        "used while another is sampled.");
  }
  if (rows_in_a_call_ <= 0 || rows_in_a_call_ % kBoundRows != 0) {
    throw std::invalid_argument(
        "CachedPenetration: rows_in_a_call is " + std::to_string(rows_in_a_call_) +
        "; it must be a positive multiple of " + std::to_string(kBoundRows) + ".");
  }
  const SamplingGrid& grid = sampler_.grid();
  step_cells_ = kSlopeApron;
  if (const auto* hard = std::get_if<HardMaximum>(&law_)) {
    step_cells_ = static_cast<int>(std::lround(hard->step_m / grid.spacing_m()));
    steps_ = difference_steps(grid, hard->step_m);
  }
  margin_ = rounded_up(grid.samples / 4 + step_cells_ + 5, kStepOfWindow);
  lattice_.samples = grid.samples + 2 * margin_;
  lattice_.width_m = lattice_.samples * grid.spacing_m();
  const double most_aside_m = most_aside_cells(margin_) * grid.spacing_m();
  constexpr double kRounding = 1.001;
  most_away_m_ =
      kRounding * glm::length(glm::dvec3{most_aside_m, most_aside_m, 0.5 * grid.width_m});
  stride_ = stride_of_samples(lattice_.samples);
  // The reach of find_bounds along a row, with a margin for lattices that are not parallel.
  const double around = 1.05 * step_cells_;
  const double reach = 1.02 * (0.5 * (kMostLanes - 1) + around) +
                       kMostTurnOfLanes * (0.5 * (kBlockRows - 1) + around) + 1.2;
  span_of_a_ = static_cast<int>(2.0 * reach) + 2;

  const auto area = static_cast<std::size_t>(lattice_.samples * stride_ + kMostLanes);
  const auto bounds = static_cast<std::size_t>(lattice_.samples / kBoundRows * stride_);
  const std::size_t place_bytes = 2 * sizeof(float) * (area + bounds);
  patch_width_m_ = settings.most_places > 0 ? lattice_.width_m
                                            : grid.width_m + 2 * step_cells_ * grid.spacing_m();
  if (settings.most_places > 0) {
    places_.resize(
        std::clamp(settings.most_bytes / place_bytes, std::size_t{2}, settings.most_places));
  }
  for (Place& place : places_) {
    for (BodyHeights* heights : {&place.a, &place.b}) {
      heights->height_m.assign(area, kNoSurface_m);
      heights->most_m.assign(bounds, kNoSurface_m);
    }
  }
  work_.triangles_a.reserve(settings.sampler.most_triangles);
  work_.triangles_b.reserve(settings.sampler.most_triangles);
  triangles_.resize(settings.sampler.most_triangles);
  room_.assign(4 * static_cast<std::size_t>(kBandRows * stride_ + kMostLanes), 0.0F);  // a BandRoom
  const auto blocks =
      static_cast<std::size_t>(grid.samples / kMostLanes * (grid.samples / kBlockRows));
  bound_m_.assign(blocks, 0.0F);
  block_most_m_.assign(blocks * kMostLanes, 0.0F);
}

std::size_t CachedPenetration::bytes() const noexcept {
  if (places_.empty()) return 0;
  const BodyHeights& heights = places_.front().a;
  return 2 * places_.size() * sizeof(float) * (heights.height_m.size() + heights.most_m.size());
}

void CachedPenetration::reset() noexcept {
  for (Place& place : places_) {
    place.is_whole = false;
    place.last_used = 0;
  }
  work_.step = Step::idle;
  calls_ = 0;
  kept_answers_ = 0;
  sampled_answers_ = 0;
}

// nullopt for a place of other bodies, or one that is too far from the current poses.
std::optional<CachedPenetration::Fit> CachedPenetration::fit(
    const Place& place, const PackedPatch& a, const PackedPatch& b,
    const ContactFrame& frame) const noexcept {
  if (place.surface_a != &a.surface || place.surface_b != &b.surface) return std::nullopt;
  // Most places belong to other contacts.
  const glm::dvec3 middle_m = b.pose * place.X_BL.position_m;
  if (glm::distance(middle_m, frame.origin_m) > most_away_m_) return std::nullopt;
  Fit found{.X_WL = b.pose * place.X_BL};
  const Pose X_LW = inverse(found.X_WL);
  found.X_LM = X_LW * (a.pose * place.X_AL);
  const glm::dvec3 origin_m = X_LW * frame.origin_m;
  const glm::dvec3 n = X_LW.rotation * frame.n;
  const int samples = grid().samples;
  const double cell_m = lattice_.spacing_m();
  const double most_aside = most_aside_cells(margin_);
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
  strained(std::abs(origin_m.z) / (0.5 * grid().width_m));
  // The content of a different box is unknown.
  const double half_m = a.half_height_m;
  strained((std::abs(origin_m.z) + std::abs(half_m - place.half_height_m)) /
           (kMostOfBox * std::min(half_m, place.half_height_m)));
  strained(std::abs(a.leaning_cosine - place.leaning_a) / kMostOtherLeaning);
  strained(std::abs(b.leaning_cosine - place.leaning_b) / kMostOtherLeaning);
  strained(glm::length(glm::dvec2{n}) / kMostAwayFromN);
  strained(tilt / kMostTilt);
  strained(turn / (kMostTurnOfLanes - steps_.turn_rad));
  if (!fits) return std::nullopt;
  const auto first = [&](double from_middle) {
    return margin_ + kStepOfWindow * static_cast<int>(std::lround(from_middle / kStepOfWindow));
  };
  found.column = first(aside.x);
  found.row = first(aside.y);
  // A's heights under the requested origin, and the greatest distance from there that is used. The window's middle is at most half
  // a tile off; with its own place, the strain would jump with every step of the window.
  const KeptPlaces places =
      places_of(found.X_LM, lattice_, samples, static_cast<double>(margin_) + aside, 0.0);
  const double half = 0.5 * (samples - 1);
  const double middle = 0.5 * (lattice_.samples - 1);
  const double x = places.x + half * (double{places.x_per_column} + double{places.x_per_row});
  const double y = places.y + half * (double{places.y_per_column} + double{places.y_per_row});
  const double reach = (half + 0.5 * kStepOfWindow + step_cells_) * (1.0 + turn) / (1.0 - tilt) +
                       3.0;  // rows between rows
  strained(std::abs(x - middle) / (middle - reach));
  strained(std::abs(y - middle) / (middle - reach));
  return fits ? std::optional(found) : std::nullopt;
}

CachedPenetration::Choice CachedPenetration::choose(const PackedPatch& a, const PackedPatch& b,
                                                    const ContactFrame& frame) const noexcept {
  Choice choice{.fit = {.strain = 1.0}};
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const bool is_work = work_.step != Step::idle && work_.place == i;
    if (!places_[i].is_whole && !is_work) continue;
    const std::optional<Fit> found = fit(places_[i], a, b, frame);
    if (!found) continue;
    if (is_work) {
      choice.is_coming = true;
    } else if (found->strain < choice.fit.strain) {
      choice.place = i;
      choice.fit = *found;
    }
  }
  choice.begins = !places_.empty() && choice.fit.strain > kSoftStrain && !choice.is_coming &&
                  work_.step == Step::idle;
  return choice;
}

std::optional<Penetration> CachedPenetration::evaluate(const Choice& choice, const PackedPatch& a,
                                                       const PackedPatch& b,
                                                       const ContactFrame& frame) noexcept {
  note(choice, a, b, frame);
  const bool serves_until_then = choice.place && (choice.begins || choice.is_coming);
  continue_work(serves_until_then ? hurry(choice.fit.strain)
                : choice.place    ? 0.0
                                  : kHurryWithoutHeights);
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
  continue_work(kHurryOfKept);
  if (!choice.place) return std::nullopt;
  ++kept_answers_;
  return from_place(places_[*choice.place], choice.fit, frame);
}

// Records which heights are used, and begins new ones.
void CachedPenetration::note(const Choice& choice, const PackedPatch& a, const PackedPatch& b,
                             const ContactFrame& frame) noexcept {
  ++calls_;
  if (choice.place) places_[*choice.place].last_used = calls_;
  if (!choice.begins) return;
  begin(a, b, frame);
  work_.strain_before = choice.fit.strain;
}

KeptHeights CachedPenetration::kept(BodyHeights& heights, int span) const noexcept {
  return {.height_m = heights.height_m.data(),
          .samples = lattice_.samples,
          .stride = stride_,
          .most_m = heights.most_m.data(),
          .span = span};
}

std::optional<Penetration> CachedPenetration::from_place(Place& place, const Fit& fit,
                                                         const ContactFrame& frame) noexcept {
  const int samples = grid().samples;
  const double cell_m = lattice_.spacing_m();
  const glm::dvec2 first{fit.column, fit.row};
  const auto turned = [&](double turn_rad) {
    return places_of(fit.X_LM, lattice_, samples, first, turn_rad);
  };
  KeptTask task{.a = kept(place.a, span_of_a_),
                .b = kept(place.b, kMostLanes),
                .samples = samples,
                .b_column = fit.column,
                .b_row = fit.row,
                .here = turned(0.0),
                .lift = lift_of(fit.X_LM, lattice_),
                .step_cells = step_cells_,
                .prune = pruning_ == Pruning::on,
                .first_block = place.deepest_block,
                .bound_m = bound_m_.data(),
                .block_most_m = block_most_m_.data()};
  // The window's middle, the reference of positions and levers.
  const glm::dvec2 aside = (first - static_cast<double>(margin_)) * cell_m;
  ContactFrame kept_frame{
      .u = fit.X_WL.rotation[0], .v = fit.X_WL.rotation[1], .n = fit.X_WL.rotation[2]};
  kept_frame.origin_m = fit.X_WL.position_m + kept_frame.to_world({aside, 0.0});

  const auto deepest_m = [&](int row, int column, float here_m) {
    const auto at = static_cast<std::size_t>((fit.row + row) * stride_ + fit.column + column);
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
    task.forth = turned(steps_.turn_rad);
    task.back = turned(-steps_.turn_rad);
    task.tilt_rise_m = static_cast<float>(steps_.tilt_rad * cell_m);
    ElevenMaxima maxima;
    loops_->compare_kept(task, maxima);
    if (!(maxima.here_m > kNothing_m)) return std::nullopt;
    result = gradient_of(maxima, steps_, deepest_m(maxima.row, maxima.column, maxima.here_m));
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

void CachedPenetration::begin(const PackedPatch& a, const PackedPatch& b,
                              const ContactFrame& frame) noexcept {
  assert(std::max(a.triangles.size(), b.triangles.size()) <= triangles_.size());
  const auto least_used =
      std::min_element(places_.begin(), places_.end(),
                       [](const Place& p, const Place& q) { return p.last_used < q.last_used; });
  Place& place = *least_used;
  const Pose X_WL = pose_of(frame);
  place.is_whole = false;
  place.surface_a = &a.surface;
  place.surface_b = &b.surface;
  place.X_AL = inverse(a.pose) * X_WL;
  place.X_BL = inverse(b.pose) * X_WL;
  place.half_height_m = a.half_height_m;
  place.leaning_a = a.leaning_cosine;
  place.leaning_b = b.leaning_cosine;
  place.covered = 0;
  place.folded = 0;
  place.deepest_block = 0;
  place.last_used = calls_;
  work_.step = Step::triangles_of_a;
  work_.place = static_cast<std::size_t>(least_used - places_.begin());
  work_.pose_a = a.pose;
  work_.pose_b = b.pose;
  work_.frame = frame;
  work_.triangles_a.assign(a.triangles.begin(), a.triangles.end());
  work_.triangles_b.assign(b.triangles.begin(), b.triangles.end());
  work_.next_triangle = 0;
  work_.growth = 0.0;
  triangle_count_ = 0;
}

// The fraction of the work that has to be done now: if the bodies continue their motion, the kept heights become
// invalid before all of it would be done. The growth is a mean over some calls: the frame of a contact can jump in one.
double CachedPenetration::hurry(double strain) noexcept {
  const double grown = std::max(0.0, strain - work_.strain_before);
  work_.strain_before = strain;
  work_.growth += kNewestGrowth * (grown - work_.growth);
  return std::min(1.0, 2.0 * work_.growth / std::max(1.0 - strain, work_.growth + kLittle));
}

// Continues with some triangles or some rows, more if `hurry` requires it.
void CachedPenetration::continue_work(double hurry) noexcept {
  if (work_.step == Step::idle) return;
  Place& place = places_[work_.place];
  const auto share = [hurry](int usual, int all) {
    return std::max(usual, static_cast<int>(std::ceil(hurry * all)));
  };
  switch (work_.step) {
    case Step::idle:
      return;
    case Step::triangles_of_a:
      prepare_triangles(
          *place.surface_a, work_.triangles_a, work_.pose_a, -1.0, place.leaning_a, Step::rows_of_a,
          share(kTrianglesInACall,
                2 * static_cast<int>(work_.triangles_a.size() + work_.triangles_b.size())));
      return;
    case Step::triangles_of_b:
      prepare_triangles(
          *place.surface_b, work_.triangles_b, work_.pose_b, 1.0, place.leaning_b, Step::rows_of_b,
          share(kTrianglesInACall,
                2 * static_cast<int>(work_.triangles_a.size() + work_.triangles_b.size())));
      return;
    case Step::rows_of_a:
      sample_rows(*place.surface_a, kept(place.a, span_of_a_),
                  share(rows_in_a_call_, 2 * lattice_.samples));
      if (work_.next_row < lattice_.samples) return;
      work_.step = Step::triangles_of_b;
      work_.next_triangle = 0;
      triangle_count_ = 0;
      return;
    case Step::rows_of_b:
      sample_rows(*place.surface_b, kept(place.b, kMostLanes),
                  share(rows_in_a_call_, 2 * lattice_.samples));
      if (work_.next_row < lattice_.samples) return;
      work_.step = Step::idle;
      // For a place without a surface the next call checks again whether there is one.
      place.is_whole = place.covered > 0;
      return;
  }
}

void CachedPenetration::prepare_triangles(const PackedSurface& surface,
                                          const std::vector<std::uint32_t>& triangles,
                                          const Pose& pose, double outwards, double leaning_cosine,
                                          Step next, int most) noexcept {
  const ToWindow window = to_window(pose, work_.frame, lattice_, outwards);
  const FieldEnds ends{.first = 0, .end = lattice_.samples};
  const std::size_t end =
      std::min(triangles.size(), work_.next_triangle + static_cast<std::size_t>(most));
  for (; work_.next_triangle < end; ++work_.next_triangle) {
    const auto triangle =
        sampled_triangle(surface.triangles()[triangles[work_.next_triangle]], window, ends,
                         {.cosine = leaning_cosine, .window_m = grid().width_m}, surface.step_m());
    if (triangle) triangles_[triangle_count_++] = *triangle;
  }
  if (work_.next_triangle < triangles.size()) return;
  work_.step = next;
  work_.next_row = 0;
}

void CachedPenetration::sample_rows(const PackedSurface& surface, const KeptHeights& heights,
                                    int rows) noexcept {
  Place& place = places_[work_.place];
  const int first = work_.next_row;
  const int end = std::min(lattice_.samples, first + rounded_up(rows, kBoundRows));
  const std::size_t band = room_.size() / 4;
  place.folded += loops_->sample_surface({.triangles = triangles_.data(),
                                          .count = static_cast<std::int32_t>(triangle_count_),
                                          .texels = surface.texels(),
                                          .field = {.height_m = heights.height_m,
                                                    .samples = lattice_.samples,
                                                    .apron = 0,
                                                    .stride = stride_},
                                          .room = {.place_x = room_.data(),
                                                   .place_y = room_.data() + band,
                                                   .height_m = room_.data() + 2 * band,
                                                   .lift_m = room_.data() + 3 * band},
                                          .first_row = first,
                                          .end_row = end});
  loops_->bound_rows(
      {.field = heights, .first_row = first, .end_row = end, .room_m = room_.data()});
  work_.next_row = end;
  if (work_.step == Step::rows_of_b) count_covered(place, first, end);
}

// For the window in the lattice's middle.
void CachedPenetration::count_covered(Place& place, int first_row, int end_row) noexcept {
  const int end = std::min(end_row, margin_ + grid().samples);
  for (int row = std::max(first_row, margin_); row < end; ++row) {
    const auto from = static_cast<std::size_t>(row * stride_ + margin_);
    for (std::size_t i = from; i < from + static_cast<std::size_t>(grid().samples); ++i) {
      place.covered += place.a.height_m[i] + place.b.height_m[i] > kNothing_m ? 1 : 0;
    }
  }
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
  const KeptPlaces& here = task.here;
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

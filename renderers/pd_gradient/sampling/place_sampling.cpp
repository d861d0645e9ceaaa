// Implements the steps of sampling a place.

#include "renderers/pd_gradient/sampling/place_sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "renderers/pd_gradient/sampling/sampled_triangles.h"

namespace asperity {
namespace {

constexpr double kLittle = 1e-9;
constexpr double kNewestGrowth = 0.25;  // the weight of a call in the mean growth of the strain
constexpr int kTrianglesInACall = 12;

}  // namespace

PlaceSampling::PlaceSampling(const KeptLattice& lattice, std::size_t most_triangles,
                             int rows_in_a_call, const SampleLoops& loops)
    : lattice_(lattice), rows_in_a_call_(rows_in_a_call), loops_(&loops) {
  if (rows_in_a_call <= 0 || rows_in_a_call % kBoundRows != 0) {
    throw std::invalid_argument(
        "PlaceSampling: rows_in_a_call is " + std::to_string(rows_in_a_call) +
        "; it must be a positive multiple of " + std::to_string(kBoundRows) + ".");
  }
  triangles_a_.reserve(most_triangles);
  triangles_b_.reserve(most_triangles);
  prepared_.resize(most_triangles);
  room_.assign(4 * static_cast<std::size_t>(kBandRows * lattice.stride + kMostLanes),
               0.0F);  // a BandRoom
}

std::size_t PlaceSampling::bytes() const noexcept {
  return std::as_bytes(std::span(prepared_)).size() +
         (triangles_a_.capacity() + triangles_b_.capacity()) * sizeof(std::uint32_t);
}

void PlaceSampling::begin(KeptPlace& place, const PackedPatch& a, const PackedPatch& b,
                          const ContactFrame& frame, double strain) noexcept {
  assert(std::max(a.triangles.size(), b.triangles.size()) <= prepared_.size());
  const Pose X_WL{.rotation = glm::dmat3(frame.u, frame.v, frame.n), .position_m = frame.origin_m};
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
  step_ = Step::triangles_of_a;
  pose_a_ = a.pose;
  pose_b_ = b.pose;
  frame_ = frame;
  triangles_a_.assign(a.triangles.begin(), a.triangles.end());
  triangles_b_.assign(b.triangles.begin(), b.triangles.end());
  next_triangle_ = 0;
  prepared_count_ = 0;
  strain_before_ = strain;
  growth_ = 0.0;
}

double PlaceSampling::hurry(double strain) noexcept {
  const double grown = std::max(0.0, strain - strain_before_);
  strain_before_ = strain;
  growth_ += kNewestGrowth * (grown - growth_);
  return std::min(1.0, 2.0 * growth_ / std::max(1.0 - strain, growth_ + kLittle));
}

void PlaceSampling::resume(KeptPlace& place, double hurry) noexcept {
  const auto share = [hurry](int usual, int all) {
    return std::max(usual, static_cast<int>(std::ceil(hurry * all)));
  };
  const int triangles =
      share(kTrianglesInACall, 2 * static_cast<int>(triangles_a_.size() + triangles_b_.size()));
  const int rows = share(rows_in_a_call_, 2 * lattice_.grid.samples);
  switch (step_) {
    case Step::idle:
      return;
    case Step::triangles_of_a:
      prepare_triangles({*place.surface_a, triangles_a_, pose_a_, -1.0, place.leaning_a},
                        Step::rows_of_a, triangles);
      return;
    case Step::triangles_of_b:
      prepare_triangles({*place.surface_b, triangles_b_, pose_b_, 1.0, place.leaning_b},
                        Step::rows_of_b, triangles);
      return;
    case Step::rows_of_a:
      sample_rows(place, *place.surface_a, kept_a(place, lattice_), rows);
      if (next_row_ < lattice_.grid.samples) return;
      step_ = Step::triangles_of_b;
      next_triangle_ = 0;
      prepared_count_ = 0;
      return;
    case Step::rows_of_b:
      sample_rows(place, *place.surface_b, kept_b(place, lattice_), rows);
      if (next_row_ < lattice_.grid.samples) return;
      step_ = Step::idle;
      // For a place without a surface the next call checks again whether there is one.
      place.is_whole = place.covered > 0;
      return;
  }
}

void PlaceSampling::prepare_triangles(const Part& part, Step next, int most) noexcept {
  const ToWindow window = to_window(part.pose, frame_, lattice_.grid, part.outwards);
  const FieldEnds ends{.first = 0, .end = lattice_.grid.samples};
  const std::size_t end =
      std::min(part.triangles.size(), next_triangle_ + static_cast<std::size_t>(most));
  for (; next_triangle_ < end; ++next_triangle_) {
    const auto triangle =
        sampled_triangle(part.surface.triangles()[part.triangles[next_triangle_]], window, ends,
                         {.cosine = part.leaning_cosine, .window_m = lattice_.window.width_m},
                         part.surface.step_m());
    if (triangle) prepared_[prepared_count_++] = *triangle;
  }
  if (next_triangle_ < part.triangles.size()) return;
  step_ = next;
  next_row_ = 0;
}

void PlaceSampling::sample_rows(KeptPlace& place, const PackedSurface& surface,
                                const KeptHeights& heights, int rows) noexcept {
  const int first = next_row_;
  const int end = std::min(lattice_.grid.samples, first + rounded_up(rows, kBoundRows));
  const std::size_t band = room_.size() / 4;
  place.folded += loops_->sample_surface({.triangles = prepared_.data(),
                                          .count = static_cast<std::int32_t>(prepared_count_),
                                          .texels = surface.texels(),
                                          .field = {.height_m = heights.height_m,
                                                    .samples = lattice_.grid.samples,
                                                    .apron = 0,
                                                    .stride = lattice_.stride},
                                          .room = {.place_x = room_.data(),
                                                   .place_y = room_.data() + band,
                                                   .height_m = room_.data() + 2 * band,
                                                   .lift_m = room_.data() + 3 * band},
                                          .first_row = first,
                                          .end_row = end});
  loops_->bound_rows(
      {.field = heights, .first_row = first, .end_row = end, .room_m = room_.data()});
  next_row_ = end;
  if (step_ == Step::rows_of_b) count_covered(place, first, end);
}

// For the window in the lattice's middle.
void PlaceSampling::count_covered(KeptPlace& place, int first_row, int end_row) const noexcept {
  const int end = std::min(end_row, lattice_.margin + lattice_.window.samples);
  const int across = lattice_.window.samples;
  std::int32_t covered = 0;
  for (int row = std::max(first_row, lattice_.margin); row < end; ++row) {
    const auto from = static_cast<std::size_t>(row * lattice_.stride + lattice_.margin);
    // Pointers: the elements of a vector are checked, which takes longer than the comparison.
    const float* const a = place.a.height_m.data() + from;
    const float* const b = place.b.height_m.data() + from;
    for (int i = 0; i < across; ++i) covered += static_cast<std::int32_t>(a[i] + b[i] > kNothing_m);
  }
  place.covered += covered;
}

}  // namespace asperity

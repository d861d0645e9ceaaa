// Declares the sampling of a place's heights in parts, one part in each call.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderers/pd_gradient/sampling/kept_place.h"

namespace asperity {

/// Samples the heights of one place at a time: the triangles of A, rows of A, the triangles of B, rows of B, at the poses
/// and in the frame at which it began. The place is whole after the last row, if both bodies cover a sample of the window
/// in the lattice's middle.
///
/// Errors: the constructor throws std::invalid_argument for rows that are not a positive multiple of 2.
///
/// Real-time: no function except the constructor allocates, locks or throws.
class PlaceSampling final {
 public:
  /// `rows_in_a_call`: at least, a positive multiple of kBoundRows.
  PlaceSampling(const KeptLattice& lattice, std::size_t most_triangles, int rows_in_a_call,
                const SampleLoops& loops);

  void reset() noexcept { step_ = Step::idle; }

  /// Of the triangles of a place.
  std::size_t bytes() const noexcept;

  bool is_idle() const noexcept { return step_ == Step::idle; }

  /// Begins with a place; `strain` is that of the heights that are used meanwhile. Copies the triangles.
  void begin(KeptPlace& place, const PackedPatch& a, const PackedPatch& b,
             const ContactFrame& frame, double strain) noexcept;

  /// The fraction of the work that has to be done now: if the bodies continue their motion, the heights with this strain
  /// become invalid before all of it would be done. The growth of the strain is a mean over some calls: the frame of a
  /// contact can jump in one.
  double hurry(double strain) noexcept;

  /// Continues, in the place with which it began, with some triangles or some rows, more if the fraction `hurry` of the work
  /// requires it.
  void resume(KeptPlace& place, double hurry) noexcept;

 private:
  enum class Step { idle, triangles_of_a, rows_of_a, triangles_of_b, rows_of_b };
  /// The part of a body in the place.
  struct Part {
    const PackedSurface& surface;
    const std::vector<std::uint32_t>& triangles;
    const Pose& pose;
    double outwards = 1.0;
    double leaning_cosine = 0.0;
  };

  void prepare_triangles(const Part& part, Step next, int most) noexcept;
  void sample_rows(KeptPlace& place, const PackedSurface& surface, const KeptHeights& heights,
                   int rows) noexcept;
  void count_covered(KeptPlace& place, int first_row, int end_row) const noexcept;

  KeptLattice lattice_{};
  int rows_in_a_call_ = 0;
  const SampleLoops* loops_ = nullptr;
  Step step_ = Step::idle;
  Pose pose_a_{};
  Pose pose_b_{};
  ContactFrame frame_{};
  std::vector<std::uint32_t> triangles_a_{};
  std::vector<std::uint32_t> triangles_b_{};
  std::vector<SampledTriangle> prepared_{};
  std::size_t prepared_count_ = 0;
  std::vector<float> room_{};
  std::size_t next_triangle_ = 0;
  int next_row_ = 0;
  double strain_before_ = 0.0;
  double growth_ = 0.0;  // of the strain per call, a mean
};

}  // namespace asperity

// The evaluation of contacts from heights that are kept while the bodies move little.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/sampling/penetration_sampler.h"

namespace asperity {

enum class Pruning { off, on };

struct CachedSettings {
  SamplerSettings sampler{};
  /// Places at which bodies can be known at a time: two more than contacts at a time. 0: heights are
  /// sampled anew in every call.
  std::size_t most_places = 12;
  /// Fewer places, down to two, where they would take more.
  std::size_t most_bytes = std::size_t{8} << 20;
  /// Of a body's surface, at most so many in a call; more where a contact moves so fast that its
  /// heights would come too late. A multiple of 4.
  int rows_in_a_call = 4;
  /// `off` is for tests: the answers are the same to the bit.
  Pruning pruning = Pruning::on;
};

/// δ and ∇δ as PenetrationSampler finds them, mostly without looking at a triangle or a texture.
///
/// Around a contact both surfaces are sampled once, on a lattice wider than the window. The lattice of
/// B stays with B, and so do n and the axes: they are those asked for when the heights were sampled.
/// In a tick A's heights are read between its samples at where A is now,
///
///   h'(q) = R₃₃·h(p) + R₃₁·x + R₃₂·y + t₃      p = (x, y): q = R₂ₓ₂·p + t₁₂ + (R₁₃, R₂₃)·z
///
/// with R, t A's motion relative to B since then and z where A meets the lattice's plane. The window
/// is laid on B's samples, in steps of four, so that it holds the asked origin in its middle. A sum of
/// the highest of A and of B thereabouts bounds what a block of 16 × 8 samples can hold; blocks that
/// can hold none of the eleven maxima are passed over. The rest is as in PenetrationSampler, but that
/// A turned about n is found between samples once and not twice.
///
/// The answer is for the asked frame: the gradient is turned into its axes and divided by how little δ
/// falls along its n, δ with it (the direction of δ·∇δ stays). By 0.8 at least: less is that of a surface
/// more than 73° from n, and of one at 86.6° the division would have no end.
///
/// Heights are sampled anew, some rows in a call, when the bodies have moved half as far as they may:
/// a quarter of the window along it, 0.03 rad of tilt, 0.13 rad of turning less the step of the
/// differences, 0.06 rad between the asked n and the kept one, by 0.05 for the cosines from which faces sink
/// (PackedPatch::leaning_cosine), and by 0.75 of its half height for either end of the box in which
/// triangles are looked for (PackedPatch::half_height_m, the same for both): what was outside of it then is
/// not in the heights. Until they are there the kept ones serve; where none serve, PenetrationSampler does.
/// A place that no contact comes back to is the first to be given up.
///
/// Reading between samples shaves peaks. Bodies that have drifted as far as they may, against
/// PenetrationSampler: at 8 samples a wavelength 4 to 11 % of the RMS of ∂δ/∂u, at 16 half of that.
/// It is also what the answer jumps by where other heights take over: on a slide of the tests at 8
/// samples a wavelength the force was never further from the sampler's than 0.16 of its RMS.
///
/// What is found depends on the calls since `reset` and on nothing else. A place beside one without a
/// surface has none here. `covered` and `folded` are of when the heights were sampled; where nothing was
/// covered, none are kept.
///
/// Every instruction set gives the same bits.
///
/// Errors: those of PenetrationSampler; a single place, since one serves while another one is
/// sampled; rows that are no positive multiple of 4.
///
/// Real-time: `evaluate` and `reset` do not allocate, lock or throw. One object serves one thread.
class CachedPenetration final {
 public:
  explicit CachedPenetration(const CachedSettings& settings);

  /// Forgets all heights.
  void reset() noexcept;

  /// Whether `evaluate` will look at triangles. Where it will not, patches may come without any.
  bool needs_triangles(const PackedPatch& a, const PackedPatch& b,
                       const ContactFrame& frame) const noexcept;

  /// As PenetrationSampler::evaluate. The triangles have to fill a square of `patch_width_m()` around
  /// the frame's origin, and the surfaces have to last until the next `reset`.
  std::optional<Penetration> evaluate(const PackedPatch& a, const PackedPatch& b,
                                      const ContactFrame& frame) noexcept;

  const SamplingGrid& grid() const noexcept { return sampler_.grid(); }
  double patch_width_m() const noexcept { return patch_width_m_; }
  std::size_t bytes() const noexcept;
  /// Since `reset`: answers from kept heights, and those for which there were none.
  std::uint64_t kept_answers() const noexcept { return kept_answers_; }
  std::uint64_t sampled_answers() const noexcept { return sampled_answers_; }

 private:
  struct BodyHeights {
    std::vector<float> height_m{};
    std::vector<float> most_m{};
  };
  // What is known of both bodies where they meet.
  struct Place {
    bool is_whole = false;
    const PackedSurface* surface_a = nullptr;
    const PackedSurface* surface_b = nullptr;
    Pose lattice_in_a{};  // axes u, v, n and the middle, in the mesh's frame
    Pose lattice_in_b{};
    double half_height_m = 0.0;  // of the box that its triangles were chosen by
    double leaning_a = 0.0;      // the cosines of the patches
    double leaning_b = 0.0;
    BodyHeights a{};
    BodyHeights b{};
    int covered = 0;
    int folded = 0;
    int deepest_block = 0;  // in the last answer
    std::uint64_t last_used = 0;
  };
  // How a place fits what is asked.
  struct Fit {
    double strain = 0.0;  // 1: as far as it may be
    Pose lattice{};       // in the world
    Pose motion{};        // of A relative to it
    int column = 0;       // of the window's first sample in B's lattice
    int row = 0;
  };
  // What an answer comes from, and what is being sampled for it.
  struct Choice {
    std::optional<std::size_t> place{};
    Fit fit{};
    bool is_coming = false;
    bool begins = false;
  };
  enum class Step { idle, triangles_of_a, rows_of_a, triangles_of_b, rows_of_b };
  // The place that is being sampled.
  struct Work {
    Step step = Step::idle;
    std::size_t place = 0;
    Pose pose_a{};
    Pose pose_b{};
    ContactFrame frame{};
    std::vector<std::uint32_t> triangles_a{};
    std::vector<std::uint32_t> triangles_b{};
    std::size_t next_triangle = 0;
    int next_row = 0;
    double strain_before = 0.0;
  };

  std::optional<Fit> fit(const Place& place, const PackedPatch& a, const PackedPatch& b,
                         const ContactFrame& frame) const noexcept;
  Choice choose(const PackedPatch& a, const PackedPatch& b,
                const ContactFrame& frame) const noexcept;
  std::optional<Penetration> from_place(Place& place, const Fit& fit,
                                        const ContactFrame& frame) noexcept;
  KeptHeights kept(BodyHeights& heights, int span) const noexcept;
  bool at_border(const KeptTask& task, int row, int column) const noexcept;
  void begin(const PackedPatch& a, const PackedPatch& b, const ContactFrame& frame) noexcept;
  double hurry(double strain) noexcept;
  void continue_work(double hurry) noexcept;
  void prepare_triangles(const PackedSurface& surface, const std::vector<std::uint32_t>& triangles,
                         const Pose& pose, double outwards, double leaning_cosine, Step next,
                         int most) noexcept;
  void sample_rows(const PackedSurface& surface, const KeptHeights& heights, int rows) noexcept;
  void count_covered(Place& place, int first_row, int end_row) noexcept;

  PenetrationSampler sampler_;
  MaximumLaw law_{};
  DifferenceSteps steps_{};
  int step_cells_ = 0;
  int margin_ = 0;  // samples of the lattice around a window in its middle
  SamplingGrid lattice_{};
  double patch_width_m_ = 0.0;
  int stride_ = 0;
  int span_of_a_ = 0;
  int rows_in_a_call_ = 0;
  Pruning pruning_ = Pruning::on;
  const SampleLoops* loops_ = nullptr;
  std::vector<Place> places_{};
  Work work_{};
  std::vector<SampledTriangle> triangles_{};
  std::size_t triangle_count_ = 0;
  std::vector<float> room_{};
  std::vector<float> bound_m_{};
  std::vector<float> block_most_m_{};
  std::uint64_t calls_ = 0;
  std::uint64_t kept_answers_ = 0;
  std::uint64_t sampled_answers_ = 0;
};

}  // namespace asperity

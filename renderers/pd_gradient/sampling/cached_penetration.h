// Declares the evaluation of contacts from heights that are kept during small motions of the bodies.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/sampling/kept_place.h"
#include "renderers/pd_gradient/sampling/penetration_sampler.h"
#include "renderers/pd_gradient/sampling/place_sampling.h"

namespace asperity {

enum class Pruning { off, on };

struct CachedSettings {
  SamplerSettings sampler{};
  /// The maximum number of places whose heights are kept: two more than simultaneous contacts. 0: heights are sampled
  /// anew in every call.
  std::size_t most_places = 12;
  /// The number of places is reduced, down to two, if they would need more.
  std::size_t most_bytes = std::size_t{8} << 20;
  /// The number of rows of a body's surface per call; more if a contact moves so fast that its heights would be late. A
  /// multiple of 2.
  int rows_in_a_call = 2;
  /// `off` is for tests: the results are identical to the bit.
  Pruning pruning = Pruning::on;
};

/// Computes δ and ∇δ as PenetrationSampler does, usually without reading triangles or textures.
///
/// Around a contact both surfaces are sampled once, on a lattice wider than the window. The lattice of B is fixed to B;
/// n and the axes are those of the frame for which the heights were sampled. In a tick A's heights are interpolated
/// between its samples at A's current pose,
///
///   h'(q) = R₃₃·h(p) + R₃₁·x + R₃₂·y + t₃      p = (x, y): q = R₂ₓ₂·p + t₁₂ + (R₁₃, R₂₃)·z
///
/// R, t is A's motion relative to B since then and z the height at which A meets the lattice's plane. The window is
/// placed on B's samples, in steps of four, with the requested origin in its middle. The sum of the local maxima of A
/// and of B is an upper bound for a block of 16 × 8 samples; blocks that cannot contain any of the eleven maxima are
/// skipped. The rest is as in PenetrationSampler, except that A turned about n is interpolated once and not twice.
///
/// The result is converted to the requested frame: the gradient is rotated to its axes and divided by the decrease of δ
/// along its n, and so is δ (the direction of δ·∇δ is unchanged). The divisor is at least 0.8: a smaller value would
/// belong to a surface more than 73° from n, and at 86.6° the quotient would be unbounded.
///
/// Heights are sampled anew, some rows per call, when the bodies have moved half of the permitted distance (fit_of). Until
/// the new heights are complete the kept ones are used; without usable heights, PenetrationSampler is used. A place to
/// which no contact returns is the first to be replaced.
///
/// Interpolation between samples lowers peaks. For bodies at the limits of motion, the error relative to
/// PenetrationSampler is 4 to 11 % of the RMS of ∂δ/∂u at 8 samples per wavelength, and half of that at 16. This is
/// also the jump of the result when new heights replace the kept ones: in a slide of the tests at 8 samples per
/// wavelength the force never differed from the sampler's by more than 0.16 of its RMS.
///
/// The result depends only on the calls since `reset`. A position next to one without a surface counts as having none.
/// `covered` and `folded` are those of the time of sampling; where nothing was covered, no heights are kept.
///
/// All instruction sets give the same bits.
///
/// Errors: those of PenetrationSampler; a number of places of 1, since one is used while another one is sampled; rows
/// that are not a positive multiple of 2.
///
/// Real-time: `evaluate` and `reset` do not allocate, lock or throw. An object may be used by one thread only.
class CachedPenetration final {
 public:
  explicit CachedPenetration(const CachedSettings& settings);

  /// Clears all heights.
  void reset() noexcept;

  /// The place whose heights give the result, and whether others are, or will be, sampled for it.
  struct Choice {
    std::optional<std::size_t> place{};
    PlaceFit fit{};
    bool is_coming = false;
    bool begins = false;

    /// Whether `evaluate` will read triangles. If not, the patches may be passed without any.
    bool needs_triangles() const noexcept { return begins || !place; }
  };
  /// Does not read triangles; valid until the next `evaluate`.
  Choice choose(const PackedPatch& a, const PackedPatch& b,
                const ContactFrame& frame) const noexcept;

  /// As PenetrationSampler::evaluate, with the choice for this request. The triangles have to cover a square of
  /// `patch_width_m()` around the frame's origin, and the surfaces have to live until the next `reset`.
  std::optional<Penetration> evaluate(const Choice& choice, const PackedPatch& a,
                                      const PackedPatch& b, const ContactFrame& frame) noexcept;
  std::optional<Penetration> evaluate(const PackedPatch& a, const PackedPatch& b,
                                      const ContactFrame& frame) noexcept {
    return evaluate(choose(a, b, frame), a, b, frame);
  }

  /// Evaluates from kept heights only: the result is nullopt while `choice.place` is empty. Samples the same small part of
  /// new heights in every call, so that there are no usable heights for some calls if the bodies move fast. Requires
  /// triangles only if the choice `begins`.
  std::optional<Penetration> evaluate_kept(const Choice& choice, const PackedPatch& a,
                                           const PackedPatch& b,
                                           const ContactFrame& frame) noexcept;

  const SamplingGrid& grid() const noexcept { return sampler_.grid(); }
  double patch_width_m() const noexcept { return patch_width_m_; }
  /// Without rooms that are small next to the heights of the places.
  std::size_t bytes() const noexcept;
  /// Since `reset`: results from kept heights, and those without kept heights.
  std::uint64_t kept_answers() const noexcept { return kept_answers_; }
  std::uint64_t sampled_answers() const noexcept { return sampled_answers_; }

 private:
  std::optional<Penetration> from_place(KeptPlace& place, const PlaceFit& fit,
                                        const ContactFrame& frame) noexcept;
  bool at_border(const KeptTask& task, int row, int column) const noexcept;
  void note(const Choice& choice, const PackedPatch& a, const PackedPatch& b,
            const ContactFrame& frame) noexcept;

  PenetrationSampler sampler_;
  MaximumLaw law_{};
  Pruning pruning_ = Pruning::on;
  const SampleLoops* loops_ = nullptr;
  KeptLattice lattice_{};
  std::vector<KeptPlace> places_{};
  PlaceSampling sampling_;
  std::size_t in_work_ = 0;  // the place that is being sampled
  double patch_width_m_ = 0.0;
  std::vector<float> bound_m_{};
  std::vector<float> block_most_m_{};
  std::uint64_t calls_ = 0;
  std::uint64_t kept_answers_ = 0;
  std::uint64_t sampled_answers_ = 0;
};

}  // namespace asperity

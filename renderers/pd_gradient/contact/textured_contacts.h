// Finds all contacts of two textured bodies in their poses, with depths and gradients.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/contact/body_motion.h"
#include "renderers/pd_gradient/contact/computed_contacts.h"
#include "renderers/pd_gradient/contact/contact_shares.h"
#include "renderers/pd_gradient/contact/held_point.h"
#include "renderers/pd_gradient/contact/textured_body.h"
#include "renderers/pd_gradient/contact/textured_contact.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/contact_regions.h"
#include "renderers/pd_gradient/geometry/mesh_query.h"
#include "renderers/pd_gradient/sampling/penetration.h"
#include "renderers/pd_gradient/sampling/spare_samplers.h"
#include "renderers/pd_gradient/sampling/window_samplers.h"

namespace asperity {

/// Counts of everything that exceeded a limit in a tick.
struct LeftOut {
  std::size_t pairs = 0;      ///< of triangles, beyond TexturedContacts::kMostPairs
  std::size_t regions = 0;    ///< beyond kMostContacts, also fading ones, or without a direction
  std::size_t triangles = 0;  ///< of windows, beyond kMostTriangles
  std::size_t depths = 0;     ///< that were doubtful
  /// The compute device had no answer within its deadline, and the processor evaluated the contacts.
  bool is_computed_here = false;
};

/// The contacts of a tool A and a surface B, from their poses. All steps from meshes to depths:
///
///   pairs of triangles of the two hulls (MeshQuery) → regions with n and a window (ContactRegions)
///   → triangles of the textured bodies in the window → δ and ∇δ (CachedPenetration, or ComputedContacts)
///
/// The triangles of a contact face the correct direction, those of A against n and those of B along n, and
/// touch a box. Across n it is as wide as the window; along n its height to either side of the origin is half the width
/// of the region plus twice the previous depth plus the textures. Another sheet
/// further away (the far side of a ring, a shelf above) is therefore excluded.
///
/// A depth beyond that box belongs to another place of the bodies along the same n, as where corners
/// intersect next to a large contact. It is doubtful and not rendered until the contact has existed
/// long enough for `kReachGrowth_m_per_s` to reach it. The box grows at the same rate while it is empty, for instance for
/// a needle that enters faster than its thickness.
///
/// A depth along n assumes that the surfaces of a contact are height fields along n, the near
/// sides of two solids [Otaduy 2004]. In thin or folded bodies the place on A may have left the far side of B, be below a
/// sheet of B that A is not in, or be at the foot of a wall of B, and the depth then includes what does not belong to the
/// contact. At the deepest place the depth is therefore limited to the median of three lengths:
///
///   δ ≤ median of  t_A, from the place on A along n to the end of A,
///                  t_B, from the surface of B above that place against n to the end of B,
///                  w,   the extent of the curve from its middle along u or v: half its window
///
/// each plus the textures. A needle in a block may be deeper than wide, because t_A and t_B permit it.
/// A ball through a sheet is rendered up to its radius, two plates through each other up to the thicker one.
/// If the place on A is inside B and that on B is not inside A, or vice versa, δ is also limited by the distance from that
/// place to the outside: the sheet that it is in, not the one above. A kept contact has no curve, so that
/// the limit is the larger one of t_A and t_B.
///
/// Faces that lean more than 60° from n are not described by a depth along n: along the n of a floor a ball at the foot of
/// a wall is as deep as the wall is high. Faces that lean further than that, and further than the average along
/// the curve (all faces of a needle do), therefore sink, and are excluded at half of that cosine
/// (sunk_m). A wall that is touched has a curve, and a contact along a separate n. If ∇δ across n is still
/// longer than tan 60°, as next to a wall of a texture, the slopes are scaled down to that; the depth is not.
///
/// A deeper contact `is_bounded`: it has the limit as its depth, and slopes reduced by the same factor
/// (pressed_to), so that the steepness of a wall does not multiply it. Thickness is that of the meshes,
/// and 0 where a line does not meet them, next to a rim or in a hole. The bound is computed from the
/// samples and does not change contacts within it. The force is continuous where the bound begins. Beyond,
/// the bound changes when the deepest place jumps: it may fall at once, while the previous contact fades
/// (ContactShares), but rises by at most `kReachGrowth_m_per_s`. Whether a depth is doubtful is decided before it is bounded.
///
/// One place is rendered once. A region in the window of a longer one whose n is within 60° is part of
/// it, for instance the inner curve of a rim that is pressed into a plate; of two with equally wide windows, the one that
/// was rendered counts as longer. Windows are
/// wider than regions: of contacts whose deepest samples are within 1.5 cells of each other and whose n
/// is within 60°, the one that was rendered there continues, otherwise the deepest; the others are excluded. So
/// is one whose deepest sample is outside the square around its own curve and inside that around another
/// one, as where a window shows a part of a broad flat top next to it, which has the same depth everywhere.
///
/// A body that is pressed completely into the other has no curve. While there is no region and
/// one body contains the other, the contacts of the previous tick are therefore kept: n
/// moves with B, the origin with A, and the window remains, until δ is no longer positive. Limits:
/// n is the previous one, and the deepest place of a body that is wider than the last window may
/// be outside it; of a body with several parts only all can be kept. A body that is completely inside
/// without earlier contact has no n and makes no contact; `is_inside` reports this.
///
/// When contacts divide, merge or are replaced, the change of the force is limited (ContactShares).
///
/// Where many crests touch, the samples determine which of several almost equally deep crests is the deepest, and with
/// which lever. Between samples at a distance c a crest of curvature κ is missed by at most ε = κ·c²/4 (by c/2 in both
/// directions), so that a difference of two maxima over ±step is wrong by at most ε/(2·step) in slope, and in levers by
/// that times the distance. With the hard maximum the cells of such a contact are therefore halved, at most
/// `WindowSampling::most_halvings` times, until this bound is at most 0.2 %; κ is the sum for both textures
/// (FineWaves). A contact is on many crests for `kRefined_s` after the deepest places under opposite tilts were further
/// apart than a quarter of the finest wave (Penetration::spread_m). On one crest they are close together, and the
/// declared cells are accurate. The samples of all contacts of a tick are together at most those of one window with
/// `most_samples`. Finer cells are used only while their heights are kept. These are sampled in parts, and the declared
/// cells are used until they are complete, and where the bodies move so fast that new heights are late. Step, window and
/// law remain; depth and slopes change within the bounds, and the force as described there where the motion does
/// not explain this. The smooth maximum is not refined: it is a mean over all crests, and sums over samples are accurate
/// for a weight exp(−κx²/2τ) while c is shorter than √(τ/κ).
///
/// If the window ends before the bodies do, as for a tilted pen that is pressed deeper than its
/// radius, the deepest sample is at the border of the window and δ is a lower bound
/// (Penetration::at_window).
///
/// Frame and units: SI, the world of the poses.
///
/// Errors: the constructor throws the std::invalid_argument of WindowSamplers.
///
/// Real-time: `find` and `touch` do not allocate, lock or throw. One object serves one thread.
class TexturedContacts final {
 public:
  static constexpr std::size_t kMostPairs = 4096;
  static constexpr std::size_t kMostComputed =
      2 * kMostContacts;  ///< of ComputedContacts: also those of the last tick
  static constexpr std::size_t kMostTriangles = 8192;  ///< of a body in one window
  static constexpr double kReachGrowth_m_per_s = 0.1;
  static constexpr double kRefined_s =
      0.050;  ///< a wave of 2 mm at 40 mm/s: between crests a tool may be on one

  /// With `computed`, made for the same bodies, contacts are evaluated there; where it has no answer, as without it.
  /// `spare`: where samplers are taken from, used by the constructor only; null to make them for this object.
  TexturedContacts(TexturedBody a, TexturedBody b, const WindowSampling& sampling,
                   InstructionSet instructions, std::unique_ptr<ComputedContacts> computed = {},
                   SpareSamplers* spare = nullptr);

  /// Discards the previous tick.
  void reset() noexcept;

  /// All contacts, including those that are not deep yet (δ ≤ 0) or doubtful; valid until the next call. Empty if a pose is
  /// not finite. `dt_s`: the time since the last call, positive.
  std::span<const TexturedContact> find(const Pose& X_WA, const Pose& X_WB, double dt_s) noexcept;

  /// Of the last `find`.
  const LeftOut& left_out() const noexcept { return left_out_; }

  /// Whether in the last `find` one body was completely inside the other, without an intersection or a kept contact. It
  /// is determined only when it can have begun: in the first call after `reset`, and when A has moved since the previous
  /// call by more than the thickness of a body (TexturedBody::thickness_m, an upper limit, so that a step
  /// between it and the real thickness is not detected); from then on until it ends.
  bool is_inside() const noexcept { return is_inside_; }

  /// Whether the hulls intersect or one contains the other. Does not change the contacts.
  bool touch(const Pose& X_WA, const Pose& X_WB) noexcept;

  const TexturedBody& a() const noexcept { return a_; }
  const TexturedBody& b() const noexcept { return b_; }

 private:
  void compute(std::span<const ContactRegion* const> regions, const Pose& X_WA,
               const Pose& X_WB) noexcept;
  void add(TexturedContact contact, const Pose& X_WA, const Pose& X_WB) noexcept;
  TexturedContact contact_of(const ContactRegion& region) const noexcept;
  void set_reach(TexturedContact& contact) const noexcept;
  static WindowSampling refinable(WindowSampling sampling, const TexturedBody& a,
                                  const TexturedBody& b) noexcept;
  void plan_refinement(std::span<const ContactRegion* const> regions) noexcept;
  void keep_refined(TexturedContact& contact) const noexcept;
  /// Also sets the grid with which it was evaluated.
  std::optional<Penetration> evaluated(TexturedContact& contact, WindowSamplers::Window& window,
                                       const Pose& X_WA, const Pose& X_WB) noexcept;
  double half_height_m(double width_m, double last_depth_m) const noexcept;
  double most_depth_m(const TexturedContact& contact, const Pose& X_WA,
                      const Pose& X_WB) const noexcept;
  bool goes_before(const ContactRegion& one, const ContactRegion& longer) const noexcept;
  double most_after_m(const TexturedContact& contact) const noexcept;
  double depth_before_m(const ContactRegion& region) const noexcept;
  bool hold_each_other(const Pose& X_WA, const Pose& X_WB) noexcept;
  void look_inside(const Pose& X_WA, const Pose& X_WB) noexcept;
  void keep_buried(const Pose& X_WA, const Pose& X_WB) noexcept;
  TexturedContact continued(const TexturedContact& last) const noexcept;
  std::span<const TexturedContact> felt_once() noexcept;
  std::span<const std::uint32_t> triangles_in(const TexturedBody& body, const Pose& pose,
                                              const ContactFrame& frame, double outwards,
                                              const WindowBox& box,
                                              std::vector<std::uint32_t>& room) noexcept;

  TexturedBody a_;
  TexturedBody b_;
  MeshQuery query_;
  ContactRegions regions_;
  std::shared_ptr<WindowSamplers> samplers_;
  std::vector<std::uint32_t> triangles_a_{};
  std::vector<std::uint32_t> triangles_b_{};
  std::unique_ptr<ComputedContacts> computed_{};  ///< null without a compute device
  std::vector<TexturedContact> contacts_{};
  std::vector<TexturedContact> before_{};
  BodyMotion motion_{};
  ContactShares shares_{};
  HeldPoint a_in_b_{};
  HeldPoint b_in_a_{};
  LeftOut left_out_{};
  long most_samples_ = 0;   // of all contacts of a tick with halved cells
  double crests_m_ = 0.0;   // the spread above which a contact is on several crests
  double dt_s_ = 0.0;       // of this call
  double thinner_m_ = 0.0;  // the thickness of the thinner body
  glm::dvec3 a_in_b_before_m_{0.0};
  bool is_first_ = true;
  bool is_inside_ = false;
};

}  // namespace asperity

// Two textured bodies in their poses: every contact between them, how deep, and the gradient.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/contact/held_point.h"
#include "renderers/pd_gradient/contact/textured_body.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/geometry/contact_regions.h"
#include "renderers/pd_gradient/geometry/mesh_query.h"
#include "renderers/pd_gradient/sampling/penetration.h"
#include "renderers/pd_gradient/sampling/window_samplers.h"

namespace asperity {

/// One contact of a tick.
struct TexturedContact {
  std::uint64_t id = 0;          ///< the same from tick to tick while it is the same contact
  ContactFrame frame{};          ///< in the world
  double width_m = 0.0;          ///< of the region
  SamplingGrid grid{};           ///< the window that was sampled, as wide or wider
  Penetration penetration{};     ///< of no more depth than the bound (TexturedContacts)
  double sampled_depth_m = 0.0;  ///< before it was bounded
  double half_extent_m = 0.0;    ///< how far the curve reaches along u or v
  bool is_bounded = false;       ///< deeper than the bodies are thick there
  double share = 1.0;            ///< of its force that is felt; less while contacts part or join
  bool is_fading = false;        ///< another contact took its place; its share falls to 0
  bool is_kept = false;          ///< its curve is gone; the frame goes on from the tick before
  bool is_coarse = false;        ///< sampled with a step that is longer than the declared one
  double half_height_m = 0.0;    ///< of the box that its triangles touch
  double reach_m = 0.0;          ///< as deep as it can be by now
  bool is_doubtful = false;      ///< deeper than that: not to be felt
  double leaning_a = 0.0;        ///< the cosines from which A's and B's faces sink (sunk_m)
  double leaning_b = 0.0;
  glm::dvec3 origin_in_a_m{0.0};  ///< where the frame's origin is on A, in A's own frame
};

inline bool is_felt(const TexturedContact& contact) noexcept {
  return contact.penetration.depth_m > 0.0 && !contact.is_doubtful;
}

/// What did not fit in a tick.
struct LeftOut {
  std::size_t pairs = 0;      ///< of triangles, beyond TexturedContacts::kMostPairs
  std::size_t regions = 0;    ///< beyond kMostContacts, also fading ones, or without a direction
  std::size_t triangles = 0;  ///< of windows, beyond kMostTriangles
  std::size_t depths = 0;     ///< that were doubtful
};

/// The contacts of a tool A and a surface B, from their poses: the whole way from meshes to depths.
///
///   pairs of triangles of the two hulls (MeshQuery) → regions with n and a window (ContactRegions)
///   → triangles of the textured bodies in the window → δ and ∇δ (CachedPenetration)
///
/// The triangles of a contact are those that look the right way, A's against n and B's along n, and
/// touch a box across n as wide as the window and along n, from the origin either way, half as high as
/// the region is wide, plus twice the depth of the tick before, plus the textures: another sheet
/// further away (the far side of a ring, a shelf above) is no part of it.
///
/// A depth beyond that box is one that the bodies have elsewhere along the same n, as where a corner
/// cuts a corner beside a large contact. It is doubtful and not felt, until the contact has been there
/// long enough for `kReachGrowth_m_per_s` to have reached it. The box grows likewise while there is
/// nothing in it: of a needle that went in faster than it is thick.
///
/// Depth along n takes for granted that the surfaces of a contact are height fields along n, the near
/// sides of two solids [Otaduy 2004]. A thin or folded body is more than that: A's place may have come
/// out of B's far side, be under a sheet of B that A is not in, or stand at the foot of a wall of B, and
/// the depth then runs through what does not belong to it. At the deepest place it therefore counts as
/// far as two of three bear it out:
///
///   δ ≤ median of  t_A, from A's place along n to where A ends,
///                  t_B, from B's surface over that place against n to where B ends,
///                  w,   how far the curve reaches from its middle along u or v: half its window
///
/// each plus the textures. A needle in a block may be deeper than wide: it is in the block, and the
/// block's surface is in it. A ball that goes through a sheet is felt up to its radius, two plates that go
/// through each other as deep as the thicker one. If A's place is in B and B's is not in A, or the other
/// way round, δ goes no further than that place's own way out either: the sheet that it is in, not the
/// one above. A contact that is kept has no curve: t_A or t_B, whichever is larger.
///
/// Nor is n a direction of a face that leans more than 60° from it: along the n of a floor a ball at the foot of
/// a wall is as deep as the wall is high. Faces that lean further than that, and further than those along
/// the curve do on average, as all of a needle do, therefore sink, and are left out at half of that cosine
/// (sunk_m). A wall that is touched has a curve, and a contact along an n of its own. Where ∇δ across n is still
/// longer than tan 60°, as beside a wall of a texture, slopes shrink until it is not; depth does not.
///
/// A contact that was deeper `is_bounded`: it has that depth, and slopes that are less by the same part
/// (pressed_to), so that a wall's steepness is not multiplied with it. Thickness is that of the meshes,
/// and none where a line meets nothing, beside a rim or in a hole. The bound is computed from what was
/// sampled and changes no contact that keeps it. The force is continuous where the bound sets in. Beyond,
/// the bound is another one where the deepest place jumps: it may fall at once, and what was felt fades
/// (below), but rises by `kReachGrowth_m_per_s` at most. A doubtful depth is doubted before it is bounded.
///
/// One place is felt once: a region in the window of a longer one whose n is within 60° is part of
/// it; of two whose windows are as wide, the one that was felt stays the longer one. So are the inner
/// curve and the outer one of a rim that is pressed into a plate. Windows are
/// wider than regions: of contacts whose deepest samples are within 1.5 cells of each other and whose n
/// is within 60°, the one that was felt there goes on, or else the deepest; the others are left out. So
/// is one whose deepest sample lies outside the square around its own curve and in that around another
/// one's, as where a window shows a part of a broad flat top beside it, which is as deep everywhere.
///
/// A body that is pressed wholly into the other cuts no curve any more. While no region is left and
/// one body holds the other, the contacts that were deep in the tick before are therefore kept: n
/// stays with B, the origin goes on with A, the window stays, until δ is not positive any more. Limits:
/// n is the one from before, and the deepest place of a body that is wider than the last window may
/// lie outside it; of a body in several parts only all can be kept. A body that is wholly inside
/// without having been felt on the way has no n and makes no contact; `is_inside` says so.
///
/// Where one contact becomes two, or two one, the sum of their forces would jump: each has a depth of
/// its own. So a contact's force counts by its `share`, which rises from 0 to 1 or falls within
/// `kBlend_s`, however long a tick is: of contacts that become one, that goes on whose deepest place is the new one's and the others fade,
/// each with its own window, or, where that shows what another one feels, from its own place along its
/// gradient; of a contact that parts, the one that holds its deepest place goes on and the others rise.
/// A contact goes on under another name, or with another bound, only where it pushes as the one before
/// would, to a tenth of its force and what depth is believed in the time; else the old one fades and the new
/// one rises.
/// What was doubtful and is believed rises; a contact that is felt fades where it becomes doubtful or its
/// curve is gone while the bodies cut or hold each other, as of one ball of two that goes wholly in.
/// What a wider window holds beside what was felt rises likewise. So does a contact that is new and, as its
/// deepest place has moved since, would have been felt in the tick before: that comes out of the other body
/// where it was not felt. One that begins is felt wholly at once, from the depth of its first tick on.
/// The sum of the shares is never above the number of contacts on either side, and at one place not above
/// one, but while a share is fading there. For that time the force
/// depends on time too: it lags, and takes energy from a hand that presses contacts together and lifts
/// them apart. On every path that was measured where no depth was bounded, energy was taken and none given
/// by that. A bounded depth is no potential: what falls at once and rises slowly takes energy on the way in
/// and out, half of the gross work in 0.4 s, and of blocks that lean gives up to 27 % of it or takes
/// more where they go slowly (docs/models.md, textured_contacts_test.cpp).
///
/// Where the window ends before the bodies do, as of a pen that leans and is pressed deeper than its
/// own radius, the deepest sample lies at the window's border and δ is a lower bound
/// (Penetration::at_window).
///
/// Frame and units: SI, the world in which the poses are.
///
/// Errors: the constructor throws std::invalid_argument as WindowSamplers do.
///
/// Real-time: `find` and `touch` do not allocate, lock or throw. One object serves one thread.
class TexturedContacts final {
 public:
  static constexpr std::size_t kMostPairs = 4096;
  static constexpr std::size_t kMostContacts = 16;
  static constexpr std::size_t kMostTriangles = 8192;  ///< of a body in one window
  static constexpr double kReachGrowth_m_per_s = 0.1;
  static constexpr double kBlend_s = 0.010;  ///< too short to be waited for, too long to be a knock

  TexturedContacts(TexturedBody a, TexturedBody b, const WindowSampling& sampling,
                   InstructionSet instructions);

  /// Forgets the tick before.
  void reset() noexcept;

  /// All contacts, also those that are not deep yet (δ ≤ 0) or doubtful; valid until the next call. None where a pose is not finite.
  /// `dt_s`: the time since the last call, positive.
  std::span<const TexturedContact> find(const Pose& a, const Pose& b, double dt_s) noexcept;

  /// Of the last `find`.
  const LeftOut& left_out() const noexcept { return left_out_; }

  /// Of the last `find`: one body was wholly in the other, nothing was cut and no contact was kept. It
  /// is looked for where it can have come about: in the first call after `reset`, where A has moved
  /// further since the call before than a body is thick (TexturedBody::thickness_m, which may be more than
  /// it is: a step between the two goes unnoticed), and from then on until it is over.
  bool is_inside() const noexcept { return is_inside_; }

  /// Whether the hulls cut each other or one is in the other. Leaves the contacts alone.
  bool touch(const Pose& a, const Pose& b) noexcept;

  const TexturedBody& a() const noexcept { return a_; }
  const TexturedBody& b() const noexcept { return b_; }

 private:
  /// For each contact, whether its share has just begun to rise.
  using Begun = std::array<bool, kMostContacts>;

  void add(TexturedContact contact, const Pose& a, const Pose& b) noexcept;
  double half_height_m(double width_m, double last_depth_m) const noexcept;
  double most_depth_m(const TexturedContact& contact, const Pose& a, const Pose& b) const noexcept;
  bool goes_before(const ContactRegion& one, const ContactRegion& longer) const noexcept;
  double most_after_m(const TexturedContact& contact) const noexcept;
  double depth_before_m(const ContactRegion& region) const noexcept;
  bool hold_each_other(const Pose& a, const Pose& b) noexcept;
  void look_inside(const Pose& a, const Pose& b) noexcept;
  void keep_buried(const Pose& a, const Pose& b) noexcept;
  TexturedContact gone_on(const TexturedContact& last, const Pose& a, const Pose& b) const noexcept;
  std::span<const TexturedContact> felt_once() noexcept;
  void blend(const Pose& a, const Pose& b, bool are_apart) noexcept;
  void fade(const TexturedContact& last, const Pose& a, const Pose& b) noexcept;
  bool lead_on(TexturedContact& contact, const TexturedContact& last, const Pose& a,
               const Pose& b) const noexcept;
  /// Of each contact of the tick before, which of the present ones has its place.
  using Successors = std::array<std::size_t, kMostContacts>;
  std::size_t successor_of(const TexturedContact& last) const noexcept;
  std::size_t heir_of(std::size_t contact, const Successors& successors, const Pose& a,
                      const Pose& b) const noexcept;
  bool is_felt_on(const TexturedContact& last, const TexturedContact& now, const Pose& a,
                  const Pose& b) const noexcept;
  bool is_cut_off(const TexturedContact& last, const TexturedContact& now, const Pose& a,
                  const Pose& b) const noexcept;
  double share_before(const TexturedContact& contact) const noexcept;
  Successors owners() const noexcept;
  bool was_deep(const TexturedContact& contact, const Pose& a, const Pose& b) const noexcept;
  void part(const TexturedContact& last, std::size_t heir, const Pose& a, const Pose& b,
            Begun& begun) noexcept;
  std::span<const std::uint32_t> triangles_in(const TexturedBody& body, const Pose& pose,
                                              const ContactFrame& frame, double outwards,
                                              const WindowBox& box,
                                              std::vector<std::uint32_t>& room) noexcept;

  TexturedBody a_;
  TexturedBody b_;
  MeshQuery query_;
  ContactRegions regions_;
  WindowSamplers samplers_;
  std::vector<std::uint32_t> triangles_a_{};
  std::vector<std::uint32_t> triangles_b_{};
  std::vector<TexturedContact> contacts_{};
  std::vector<TexturedContact> before_{};
  Pose a_before_{};
  Pose b_before_{};
  HeldPoint a_in_b_{};
  HeldPoint b_in_a_{};
  LeftOut left_out_{};
  double dt_s_ = 0.0;       // of this call
  double rise_ = 0.0;       // of a share, in it
  double thinner_m_ = 0.0;  // the thickness of the thinner body
  glm::dvec3 a_in_b_before_m_{0.0};
  bool is_first_ = true;
  bool is_inside_ = false;
};

}  // namespace asperity

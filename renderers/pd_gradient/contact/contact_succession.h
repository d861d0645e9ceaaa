// Declares which contact of a tick continues which one of the previous tick.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "renderers/pd_gradient/contact/body_motion.h"
#include "renderers/pd_gradient/contact/textured_contact.h"

namespace asperity {

/// What ContactSuccession compares.
struct SuccessiveContacts {
  std::span<const TexturedContact> now{};     ///< at most kMostContacts, none of which fades
  std::span<const TexturedContact> before{};  ///< at most kMostContacts
  const BodyMotion& motion;
  double alike_m =
      0.0;  ///< the largest change of a force that counts as the same one, for a stiffness of 1 N/m
  bool is_first = false;  ///< without a previous tick
};

/// Finds which contact of a tick continues which one of the previous tick, and which contact renders a place.
///
/// One place is rendered by one contact, its owner. Of contacts with the same deepest place the owner is the one that was
/// rendered there before, otherwise the deepest. The owner of a contact whose deepest place is outside the square around its
/// own curve and inside that of another contact is the owner of that other one.
///
/// - When contacts merge, the one whose deepest place is that of the new one continues.
/// - When a contact divides, the part with its deepest place continues.
/// - A contact continues, under the same or another id, only if its deepest place was in the window of the previous one,
///   and if its force is the previous one moved along its gradient, to within `alike_m`, or surfaces of at most 60°
///   permit the changes of depth and slopes by the motion: |Δδ| ≤ tan 60°·|Δx|, |Δ∇δ| ≤ tan 60°·|Δx| / step.
///   Usually this is not so where n or the bound changes, and at a step of the surface: its upper side is in the window
///   and within the step of the differences before the tool is at it.
/// - A contact without predecessor begins with its whole force, unless a contact was there before or it would have been
///   rendered in the previous tick, given the motion of its deepest place (`rises`).
///
/// Frame and units: SI, the world. Real-time: does not allocate, lock or throw.
class ContactSuccession final {
 public:
  explicit ContactSuccession(const SuccessiveContacts& in) noexcept;

  /// Whether the contact renders its place.
  bool is_owner(std::size_t contact) const noexcept { return owners_[contact] == contact; }
  /// The contact of the previous tick that continues as this one.
  std::optional<std::size_t> predecessor(std::size_t contact) const noexcept;
  /// Whether its share rises from 0.
  bool rises(std::size_t contact) const noexcept { return rises_[contact]; }
  /// Whether a contact of the previous tick continues.
  bool continues(std::size_t last) const noexcept;

 private:
  using Indices = std::array<std::size_t, kMostContacts>;

  void find_owners(const SuccessiveContacts& in) noexcept;
  void find_predecessors(const SuccessiveContacts& in) noexcept;
  void divide(std::size_t contact, const SuccessiveContacts& in) noexcept;

  Indices owners_{};
  Indices predecessors_{};  // kMostContacts: none
  std::array<bool, kMostContacts> rises_{};
};

}  // namespace asperity

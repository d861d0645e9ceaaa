// Declares which contact of a tick continues which one of the previous tick.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "renderers/pd_gradient/contact/body_motion.h"
#include "renderers/pd_gradient/contact/textured_contact.h"

namespace asperity {

/// One place is rendered by one contact, its owner: of contacts with the same deepest place, and of one whose deepest place
/// is outside the square around its own curve and inside that around another one, the one that was rendered there before,
/// otherwise the deepest.
///
/// - When contacts merge, the one whose deepest place is that of the new one continues.
/// - When a contact divides, the part with its deepest place continues.
/// - A contact continues only if its force is the previous one moved along its gradient, to within `alike_m`; or if
///   surfaces of at most 60° permit the changes of depth and slopes by the motion: |Δδ| ≤ tan 60°·|Δx|,
///   |Δ∇δ| ≤ tan 60°·|Δx| / step.
///   This is not so where a contact has another id, n or bound, and at a step of the surface: its upper side is in the
///   window and within the step of the differences before the tool is at it.
/// - A contact without predecessor begins with its whole force, unless a contact was there before or it would have been
///   rendered in the previous tick, given the motion of its deepest place (`rises`).
///
/// Real-time: does not allocate, lock or throw. Refers to its arguments.
class ContactSuccession final {
 public:
  /// `alike_m`: the change of a force that is no other contact, for a stiffness of 1 N/m. `is_first`: without a previous
  /// tick.
  ContactSuccession(std::span<const TexturedContact> now, std::span<const TexturedContact> before,
                    const BodyMotion& motion, double alike_m, bool is_first) noexcept;

  /// Whether the contact renders its place.
  bool is_owner(std::size_t contact) const noexcept { return owners_[contact] == contact; }
  /// The contact of the previous tick that continues as this one.
  std::optional<std::size_t> predecessor(std::size_t contact) const noexcept;
  /// Whether its share rises from 0.
  bool rises(std::size_t contact) const noexcept { return rises_[contact]; }
  /// Whether a contact of the previous tick continues.
  bool continues(std::size_t last) const noexcept;

 private:
  using Places = std::array<std::size_t, kMostContacts>;

  void find_owners() noexcept;
  void find_predecessors() noexcept;
  void divide(std::size_t contact) noexcept;
  std::size_t successor_of(const TexturedContact& last) const noexcept;
  std::size_t predecessor_of(std::size_t contact, const Places& successors) const noexcept;
  bool had_any(std::size_t contact, const Places& successors) const noexcept;
  bool was_deep(const TexturedContact& contact) const noexcept;
  double share_before(const TexturedContact& contact) const noexcept;
  double farthest_way_m(const TexturedContact& contact) const noexcept;
  bool is_due_to_motion(const TexturedContact& last, const TexturedContact& contact) const noexcept;
  bool is_felt_on(const TexturedContact& last, const TexturedContact& contact) const noexcept;

  std::span<const TexturedContact> now_;
  std::span<const TexturedContact> before_;
  const BodyMotion& motion_;
  double alike_m_ = 0.0;
  bool is_first_ = false;
  Places owners_{};
  Places predecessors_{};  // kMostContacts: none
  std::array<bool, kMostContacts> rises_{};
};

}  // namespace asperity

// Declares how the forces of contacts begin, continue and end.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderers/pd_gradient/contact/body_motion.h"
#include "renderers/pd_gradient/contact/contact_succession.h"
#include "renderers/pd_gradient/contact/textured_contact.h"

namespace asperity {

/// Sets the fraction of the force with which each contact is rendered, so that changes of contacts do not jolt the hand.
///
/// When one contact divides into two, or two merge into one, the sum of their forces would jump, because each has a
/// separate depth. The force of a contact is therefore multiplied by its `share`, which rises from 0 to 1 or falls, in
/// no less than `kBlend_s`. All shares together change the force by at most the fraction `kMostChange` of the current
/// force in a millisecond, and by `kLeastChange_m` times the stiffness where it is small:
///
///   |Σ Δs_i·F_i| ≤ max(0.04·|Σ s_i·F_i|, 4.2 µm·k)      in a tick of 1 ms or longer; proportionally less in a shorter one
///
/// Where contacts oppose each other, as those of the two sides of a sheet or of a tooth between two ribs, little of their
/// forces is left, and what is left changes no faster, which can take 0.5 s for 2 N.
///
/// - A contact that continues one of the previous tick (ContactSuccession, with a quarter of the permitted change as
///   `alike_m`) keeps its share. A contact that does not continue fades, and the one in its place rises.
/// - A contact that fades moves with A along its gradient, and never becomes deeper: it takes energy and gives none. Two
///   that fade under one id are one with the sum of their forces.
/// - A doubtful contact that becomes credible rises; a rendered contact fades when it becomes doubtful or loses its
///   curve while the bodies intersect or contain each other, as one ball of two that enters completely.
/// - Places that a wider window adds rise, and also a new contact that would have been rendered in the previous tick,
///   given the motion of its deepest place: it comes out of the other body, where it was not rendered.
/// - A contact that begins has its whole force at once, from the depth of its first tick.
/// - Bodies that are apart have no force from the next tick on, also where the tool leaves the surface over an edge.
/// The sum of the shares never exceeds the number of contacts before or after, nor 1 at one place, except while a share
/// is fading there. During that time the force also depends on time: it lags, and takes energy from a hand that presses
/// contacts together and lifts them apart. On the measured paths without bounded depths it gave at most 0.6 % of the gross
/// work. A bounded depth has no potential: it falls at once and rises slowly, and the small force between opposing contacts
/// rises slowly as well. Both take energy on the way in and out, two thirds of the gross work or more in 0.4 and 1.6 s, and
/// up to 78 % in 6.4 s (docs/models/pd_gradient.md, scripts/evidence pd_continuity).
///
/// Frame and units: SI, the world. Real-time: does not allocate while the contacts have room for `kMostContacts`, and does
/// not lock or throw.
class ContactShares final {
 public:
  static constexpr double kBlend_s =
      0.010;  ///< too short to be perceived as a delay, too long to be perceived as an impact
  /// Of the force, in a tick of 1 ms: less than the differences in force that people perceive, 7 to 10 %.
  static constexpr double kMostChange = 0.04;
  static constexpr double kLeastChange_m =
      4.2e-6;  ///< the same for small forces, times the stiffness

  /// A tick of length `dt_s`.
  struct Tick {
    const BodyMotion& motion;
    double dt_s = 0.0;
    bool is_first = false;   ///< without a previous tick
    bool are_apart = false;  ///< the bodies: nothing fades
  };

  /// Discards the force of the previous tick.
  void reset() noexcept { force_m_ = 0.0; }

  /// Sets `share` and `force_id` of the contacts of a tick, and appends those of the previous tick that fade. Returns the
  /// number of those for which there is no room.
  std::size_t update(std::vector<TexturedContact>& contacts,
                     std::span<const TexturedContact> before, const Tick& tick) noexcept;

 private:
  double permitted_change_m(double force_m) const noexcept;
  void begin(TexturedContact& contact, std::size_t index, const ContactSuccession& succession,
             std::span<const TexturedContact> before) noexcept;
  void change(std::vector<TexturedContact>& contacts, const ContactSuccession& succession,
              std::size_t rendered) noexcept;

  double dt_s_ = 0.0;                // of this tick
  double force_m_ = 0.0;             // of all contacts together, for a stiffness of 1 N/m
  std::uint64_t next_force_id_ = 0;  // not reset: unique as long as the object exists
};

}  // namespace asperity

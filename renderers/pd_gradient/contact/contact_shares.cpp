// Implements the limit of the change of the force, and contacts that fade.

#include "renderers/pd_gradient/contact/contact_shares.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace asperity {
namespace {

constexpr double kAlike = 0.25;       // of the permitted change of the force
constexpr double kLeastShare = 1e-9;  // smaller shares are rounding
constexpr double kTick_s = 0.001;     // for which the largest changes are declared

// Two fading contacts as one with the sum of their forces and torques, in the frame of the first; false if their sum is
// not along its n.
bool join(TexturedContact& one, const TexturedContact& other) noexcept {
  const double share = one.share + other.share;
  const Wrench own = contact_wrench(one.penetration, one.frame, one.share / share);
  const Wrench added = contact_wrench(other.penetration, other.frame, other.share / share);
  const glm::dvec3 force = one.frame.to_frame(own.force_N + added.force_N);
  const glm::dvec3 torque =
      one.frame.to_frame(own.torque_N_m + added.torque_N_m +
                         glm::cross(other.frame.origin_m - one.frame.origin_m, added.force_N));
  if (!(force.z > kAgreement * glm::length(force))) return false;
  if (other.share * other.penetration.depth_m > one.share * one.penetration.depth_m) {
    one.penetration.deepest_m = one.frame.to_frame(deepest_m(other) - one.frame.origin_m);
  }
  one.penetration.depth_m = force.z;
  one.penetration.slope = -glm::dvec2(force) / force.z;
  one.penetration.lever_m = -torque / force.z;
  one.sampled_depth_m = std::max(one.sampled_depth_m, other.sampled_depth_m);
  one.is_bounded = one.is_bounded || other.is_bounded;
  one.share = share;
  one.force_id = std::max(one.force_id, other.force_id);
  return true;
}

// A fading contact continues as if its deepest place moved with A along the gradient: its window may show the place of
// another contact or another bound. It never becomes deeper, so that it does not push back more than it was pressed.
// nullopt if nothing is left of it, or if it has moved so far that it is another place.
std::optional<TexturedContact> faded(const TexturedContact& last,
                                     const BodyMotion& motion) noexcept {
  if (last.share <= kLeastShare) return std::nullopt;
  TexturedContact fading = last;
  fading.frame = motion.continued(last);
  fading.is_fading = true;
  fading.is_kept = false;
  const glm::dvec3 place_m = motion.now_on_a_m(deepest_m(last));
  const glm::dvec3 way_m = fading.frame.to_frame(motion.way_m(place_m));
  if (glm::length(way_m) > 0.5 * last.grid.width_m) return std::nullopt;
  fading.penetration.depth_m +=
      std::min(0.0, glm::dot(glm::dvec3{last.penetration.slope, -1.0}, way_m));
  fading.penetration.deepest_m = fading.frame.to_frame(place_m - fading.frame.origin_m);
  return is_felt(fading) ? std::optional(fading) : std::nullopt;
}

}  // namespace

std::size_t ContactShares::update(std::vector<TexturedContact>& contacts,
                                  std::span<const TexturedContact> before,
                                  const Tick& tick) noexcept {
  dt_s_ = tick.dt_s;
  const std::size_t rendered = contacts.size();
  const ContactSuccession succession({.now = contacts,
                                      .before = before,
                                      .motion = tick.motion,
                                      .alike_m = kAlike * permitted_change_m(force_m_),
                                      .is_first = tick.is_first});
  for (std::size_t i = 0; i < rendered; ++i) begin(contacts[i], i, succession, before);
  std::size_t left_out = 0;
  for (std::size_t i = 0; !tick.are_apart && i < before.size(); ++i) {
    if (succession.continues(i) || !is_felt(before[i])) continue;
    const std::optional<TexturedContact> fading = faded(before[i], tick.motion);
    if (!fading) continue;
    const bool is_joined =
        std::any_of(contacts.begin(), contacts.end(), [&fading](TexturedContact& other) {
          return other.is_fading && other.id == fading->id && join(other, *fading);
        });
    if (is_joined) continue;
    if (contacts.size() == kMostContacts) {
      ++left_out;
    } else {
      contacts.push_back(*fading);
    }
  }
  change(contacts, succession, rendered);
  return left_out;
}

// The share and the identity of the force with which a contact enters the tick.
void ContactShares::begin(TexturedContact& contact, std::size_t index,
                          const ContactSuccession& succession,
                          std::span<const TexturedContact> before) noexcept {
  contact.force_id = next_force_id_++;
  if (const std::optional<std::size_t> last = succession.predecessor(index)) {
    contact.share = before[*last].share;
    contact.force_id = before[*last].force_id;
  } else if (!succession.is_owner(index) || succession.rises(index)) {
    contact.share = 0.0;
  }
}

// The largest change of a force in this tick that a change of contacts may cause, for a stiffness of 1 N/m.
double ContactShares::permitted_change_m(double force_m) const noexcept {
  const double ticks = std::min(1.0, dt_s_ / kTick_s);
  return ticks * std::max(kMostChange * force_m, kLeastChange_m);
}

// The first contacts are rendered and rise, the others fade and fall, all by the same amount: at most in kBlend_s, and by
// so little that together they change the force by no more than is permitted.
void ContactShares::change(std::vector<TexturedContact>& contacts,
                           const ContactSuccession& succession, std::size_t rendered) noexcept {
  const double most = std::min(1.0, dt_s_ / kBlend_s);
  glm::dvec3 sum_m{0.0};
  glm::dvec3 change_m{0.0};
  const auto rises_by = [&](std::size_t i) {
    const TexturedContact& contact = contacts[i];
    if (i >= rendered) return -std::min(contact.share, most);
    return succession.is_owner(i) && is_felt(contact) ? std::min(1.0 - contact.share, most) : 0.0;
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!is_felt(contacts[i])) continue;
    sum_m += contacts[i].share * force_m(contacts[i]);
    change_m += rises_by(i) * force_m(contacts[i]);
  }
  const double most_m = permitted_change_m(glm::length(sum_m));
  const double part = std::min(1.0, most_m / std::max(glm::length(change_m), 1e-300));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    contacts[i].share += part * rises_by(i);
    if (i < rendered && 1.0 - contacts[i].share < kLeastShare) contacts[i].share = 1.0;
  }
  force_m_ = glm::length(sum_m + part * change_m);
  std::erase_if(contacts, [](const TexturedContact& contact) {
    return contact.is_fading && contact.share <= kLeastShare;
  });
}

}  // namespace asperity

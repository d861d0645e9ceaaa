// How the shares of contacts rise and fall, and how contacts fade.

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "renderers/pd_gradient/contact/textured_contacts.h"

namespace asperity {
namespace {

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

}  // namespace

// The largest change of a force in this tick that a change of contacts may cause, for a stiffness of 1 N/m.
double TexturedContacts::permitted_change_m(double force_m) const noexcept {
  const double ticks = std::min(1.0, dt_s_ / kTick_s);
  return ticks * std::max(kMostChange * force_m, kLeastChange_m);
}

// Rendered contacts rise, fading ones fall, all by the same amount: at most by `rise_`, and by so little that together they
// change the force by no more than is permitted.
void TexturedContacts::change_shares(std::span<const std::size_t> owner) noexcept {
  glm::dvec3 sum_m{0.0};
  glm::dvec3 change_m{0.0};
  const auto rises_by = [&](std::size_t i) {
    const TexturedContact& contact = contacts_[i];
    if (i >= owner.size()) return -std::min(contact.share, rise_);
    return owner[i] == i && is_felt(contact) ? std::min(1.0 - contact.share, rise_) : 0.0;
  };
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (!is_felt(contacts_[i])) continue;
    sum_m += contacts_[i].share * force_m(contacts_[i]);
    change_m += rises_by(i) * force_m(contacts_[i]);
  }
  const double most_m = permitted_change_m(glm::length(sum_m));
  const double part = std::min(1.0, most_m / std::max(glm::length(change_m), 1e-300));
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    contacts_[i].share += part * rises_by(i);
    if (i < owner.size() && 1.0 - contacts_[i].share < kLeastShare) contacts_[i].share = 1.0;
  }
  force_m_ = glm::length(sum_m + part * change_m);
  std::erase_if(contacts_, [](const TexturedContact& contact) {
    return contact.is_fading && contact.share <= kLeastShare;
  });
}

// A fading contact continues as if its deepest place moved with A along the gradient: its window may show the place of
// another contact or another bound. It never becomes deeper, so that it does not push back more than it was pressed.
void TexturedContacts::fade(const TexturedContact& last, const Pose& X_WA,
                            const Pose& X_WB) noexcept {
  if (last.share <= kLeastShare) return;
  TexturedContact fading = last;
  fading.frame = continued(last, X_WA, X_WB).frame;
  fading.is_fading = true;
  fading.is_kept = false;
  const glm::dvec3 place_m = now_on_a_m(deepest_m(last), X_WA);
  const glm::dvec3 way_m = fading.frame.to_frame(way_since_m(place_m, X_WA, X_WB));
  if (glm::length(way_m) > 0.5 * last.grid.width_m) return;  // moved too far to be the same place
  fading.penetration.depth_m +=
      std::min(0.0, glm::dot(glm::dvec3{last.penetration.slope, -1.0}, way_m));
  fading.penetration.deepest_m = fading.frame.to_frame(place_m - fading.frame.origin_m);
  if (!is_felt(fading)) return;
  for (TexturedContact& other : contacts_) {
    if (other.is_fading && other.id == fading.id && join(other, fading)) return;
  }
  if (contacts_.size() == kMostContacts) {
    ++left_out_.regions;
    return;
  }
  contacts_.push_back(fading);
}

}  // namespace asperity

// Implements the comparison of contacts with those of the previous tick.

#include "renderers/pd_gradient/contact/contact_succession.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace asperity {
namespace {

constexpr double kSteepest = 1.7320508075688772;  // tan 60°, of the surfaces of a contact

double apart_m(const TexturedContact& one, const TexturedContact& other) noexcept {
  return glm::distance(deepest_m(one), deepest_m(other));
}

glm::dvec3 gradient_of(const TexturedContact& contact) noexcept {
  return contact.frame.to_world({contact.penetration.slope, -1.0});
}

}  // namespace

ContactSuccession::ContactSuccession(std::span<const TexturedContact> now,
                                     std::span<const TexturedContact> before,
                                     const BodyMotion& motion, double alike_m,
                                     bool is_first) noexcept
    : now_(now), before_(before), motion_(motion), alike_m_(alike_m), is_first_(is_first) {
  find_owners();
  find_predecessors();
}

std::optional<std::size_t> ContactSuccession::predecessor(std::size_t contact) const noexcept {
  if (predecessors_[contact] == kMostContacts) return std::nullopt;
  return predecessors_[contact];
}

bool ContactSuccession::continues(std::size_t last) const noexcept {
  return std::find(predecessors_.begin(), predecessors_.end(), last) != predecessors_.end();
}

double ContactSuccession::share_before(const TexturedContact& contact) const noexcept {
  const std::size_t last = place_of(contact.id, before_);
  return last < before_.size() && is_felt(before_[last]) ? before_[last].share : 0.0;
}

void ContactSuccession::find_owners() noexcept {
  const auto goes_before = [this](std::size_t one, std::size_t other) {
    const auto rank = [this](std::size_t i) {
      return std::pair{share_before(now_[i]), now_[i].penetration.depth_m};
    };
    return rank(one) != rank(other) ? rank(one) > rank(other) : one < other;
  };
  for (std::size_t i = 0; i < now_.size(); ++i) {
    owners_[i] = i;
    for (std::size_t j = 0; j < now_.size(); ++j) {
      if (j == i || !are_at_one_place(now_[i], now_[j])) continue;
      if (goes_before(j, owners_[i])) owners_[i] = j;
    }
  }
  const auto first_of = [this](std::size_t i) {
    while (owners_[i] != i) i = owners_[i];
    return i;
  };
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (!is_beside_curve(now_[i])) continue;
    for (std::size_t j = 0; owners_[i] == i && j < now_.size(); ++j) {
      if (shows_place_of(now_[i], now_[j])) owners_[i] = first_of(j);
    }
  }
  for (std::size_t i = 0; i < now_.size(); ++i) owners_[i] = first_of(i);
}

void ContactSuccession::find_predecessors() noexcept {
  predecessors_.fill(kMostContacts);
  Places successors{};  // of each contact of the previous tick, the present one at its place
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const bool counts = is_felt(before_[i]) && before_[i].share > 0.0;
    const std::size_t successor = counts ? successor_of(before_[i]) : now_.size();
    successors[i] = successor < now_.size() ? owners_[successor] : now_.size();
  }
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (!now_[i].is_doubtful) predecessors_[i] = predecessor_of(i, successors);
    if (!is_owner(i) || predecessors_[i] < kMostContacts) continue;
    rises_[i] = had_any(i, successors) || was_deep(now_[i]);
  }
  const Places undivided = predecessors_;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (undivided[i] < kMostContacts) divide(i);
  }
}

// The contact with the same id; otherwise, of those in whose window it was, the one with the nearest deepest place.
// now_.size() if there is none.
std::size_t ContactSuccession::successor_of(const TexturedContact& last) const noexcept {
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (now_[i].id == last.id) return i;
  }
  std::size_t nearest = now_.size();
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (!is_part_of(last.frame, now_[i])) continue;
    if (nearest == now_.size() || apart_m(now_[i], last) < apart_m(now_[nearest], last)) {
      nearest = i;
    }
  }
  return nearest;
}

// The contact of the previous tick that continues as this one, among those whose successor it is. If others merged with
// it, that is the one with the nearest deepest place. There is none (kMostContacts) if the deepest place was in no window
// before, or if the force under another id would differ.
std::size_t ContactSuccession::predecessor_of(std::size_t contact,
                                              const Places& successors) const noexcept {
  const TexturedContact& now = now_[contact];
  std::size_t predecessor = kMostContacts;
  std::size_t nearest = kMostContacts;
  bool others_joined = false;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    if (successors[i] != contact) continue;
    const bool is_same = before_[i].id == now.id;
    others_joined = others_joined || (!is_same && !before_[i].is_fading);
    if (is_same && !before_[i].is_fading) predecessor = i;
    if (nearest == kMostContacts || apart_m(before_[i], now) < apart_m(before_[nearest], now)) {
      nearest = i;
    }
  }
  if (predecessor == kMostContacts || others_joined) predecessor = nearest;
  if (predecessor == kMostContacts) return predecessor;
  const TexturedContact& last = before_[predecessor];
  const glm::dvec3 way_m = last.frame.to_frame(deepest_m(now) - last.frame.origin_m);
  const bool was_seen = std::max(std::abs(way_m.x), std::abs(way_m.y)) <= 0.5 * last.grid.width_m;
  if (!was_seen) return kMostContacts;
  return is_due_to_motion(last, now) || is_felt_on(last, now) ? predecessor : kMostContacts;
}

// Whether a contact was there in the previous tick, or this one is doubtful.
bool ContactSuccession::had_any(std::size_t contact, const Places& successors) const noexcept {
  const TexturedContact& now = now_[contact];
  bool had = now.is_doubtful;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const TexturedContact& last = before_[i];
    const bool is_same = last.id == now.id && (is_felt(last) || last.is_doubtful);
    had = had || successors[i] == contact || is_same ||
          (is_felt(last) && is_part_of(now.frame, last));
  }
  return had;
}

// The farthest that A has moved since the previous tick relative to B, at the deepest place and at the window's border.
double ContactSuccession::farthest_way_m(const TexturedContact& contact) const noexcept {
  const ContactFrame& frame = contact.frame;
  const double half_m = 0.5 * contact.grid.width_m;
  double farthest_m = glm::length(motion_.way_m(deepest_m(contact)));
  for (const glm::dvec3& aside : {frame.u, -frame.u, frame.v, -frame.v}) {
    farthest_m = std::max(farthest_m, glm::length(motion_.way_m(frame.origin_m + half_m * aside)));
  }
  return farthest_m;
}

// Whether surfaces of at most 60° permit the change of the force. At a low step they do not: its upper side is in the
// window, and in the displaced configurations of the differences, before the edge of A has come up to it.
bool ContactSuccession::is_due_to_motion(const TexturedContact& last,
                                         const TexturedContact& contact) const noexcept {
  const double way_m = kSteepest * farthest_way_m(contact);
  const double depth_m = contact.penetration.depth_m;
  if (std::abs(depth_m - last.penetration.depth_m) > way_m + alike_m_) return false;
  const double most_m = depth_m * way_m / contact.filter_m + alike_m_;
  return depth_m * glm::distance(gradient_of(contact), gradient_of(last)) <= most_m;
}

// Whether a contact exerts the force of the previous one, extrapolated: its deepest place moves with A relative to B by
// Δx, so that the depth becomes δ + ∇δ·Δx.
bool ContactSuccession::is_felt_on(const TexturedContact& last,
                                   const TexturedContact& contact) const noexcept {
  const ContactFrame frame = motion_.continued(last);
  const glm::dvec3 way_m = motion_.way_m(motion_.now_on_a_m(deepest_m(last)));
  const glm::dvec3 gradient = frame.to_world({last.penetration.slope, -1.0});
  const double depth_m = last.penetration.depth_m + glm::dot(gradient, way_m);
  return glm::distance(contact.penetration.depth_m * gradient_of(contact), depth_m * gradient) <=
         alike_m_;
}

// After a contact has divided: the part that is nearest to its deepest place and exerts its force continues it.
void ContactSuccession::divide(std::size_t contact) noexcept {
  const TexturedContact& last = before_[predecessors_[contact]];
  std::size_t nearest = contact;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (!rises_[i] || !is_felt(now_[i])) continue;
    if (!is_part_of(now_[i].frame, last) || !is_felt_on(last, now_[i])) continue;
    if (apart_m(now_[i], last) < apart_m(now_[nearest], last)) nearest = i;
  }
  std::swap(predecessors_[nearest], predecessors_[contact]);
  std::swap(rises_[nearest], rises_[contact]);
}

// Whether it would have been rendered in the previous tick, to first order. False if it has moved by more than half a
// window since, because then it cannot be identified.
bool ContactSuccession::was_deep(const TexturedContact& contact) const noexcept {
  if (is_first_ || !is_felt(contact)) return false;
  const glm::dvec3 way_m = contact.frame.to_frame(motion_.way_m(deepest_m(contact)));
  if (glm::length(way_m) > 0.5 * contact.grid.width_m) return false;
  const glm::dvec3 gradient{contact.penetration.slope, -1.0};
  return contact.penetration.depth_m - glm::dot(gradient, way_m) > 0.0;
}

}  // namespace asperity

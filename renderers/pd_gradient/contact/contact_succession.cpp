// Implements the comparison of contacts with those of the previous tick.

#include "renderers/pd_gradient/contact/contact_succession.h"

#include <algorithm>
#include <cassert>
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

using Indices = std::array<std::size_t, kMostContacts>;

double share_before(const TexturedContact& contact, const SuccessiveContacts& in) noexcept {
  const auto last = index_of(contact.id, in.before);
  return last && is_felt(in.before[*last]) ? in.before[*last].share : 0.0;
}

// The contact with the same id; otherwise, of those in whose window it was, the one with the nearest deepest place.
// in.now.size() if there is none.
std::size_t successor_of(const TexturedContact& last, const SuccessiveContacts& in) noexcept {
  for (std::size_t i = 0; i < in.now.size(); ++i) {
    if (in.now[i].id == last.id) return i;
  }
  std::size_t nearest = in.now.size();
  for (std::size_t i = 0; i < in.now.size(); ++i) {
    if (!is_part_of(last.frame, in.now[i])) continue;
    if (nearest == in.now.size() || apart_m(in.now[i], last) < apart_m(in.now[nearest], last)) {
      nearest = i;
    }
  }
  return nearest;
}

// The farthest that A has moved since the previous tick relative to B, at the deepest place and at the window's border.
double farthest_way_m(const TexturedContact& contact, const SuccessiveContacts& in) noexcept {
  const ContactFrame& frame = contact.frame;
  const double half_m = 0.5 * contact.grid.width_m;
  double farthest_m = glm::length(in.motion.way_m(deepest_m(contact)));
  for (const glm::dvec3& aside : {frame.u, -frame.u, frame.v, -frame.v}) {
    farthest_m =
        std::max(farthest_m, glm::length(in.motion.way_m(frame.origin_m + half_m * aside)));
  }
  return farthest_m;
}

// Whether surfaces of at most 60° permit the change of the force. At a low step they do not: its upper side is in the
// window, and in the displaced configurations of the differences, before the edge of A has come up to it.
bool is_due_to_motion(const TexturedContact& last, const TexturedContact& contact,
                      const SuccessiveContacts& in) noexcept {
  const double way_m = kSteepest * farthest_way_m(contact, in);
  const double depth_m = contact.penetration.depth_m;
  if (std::abs(depth_m - last.penetration.depth_m) > way_m + in.alike_m) return false;
  const double most_m = depth_m * way_m / contact.filter_m + in.alike_m;
  return depth_m * glm::distance(gradient_of(contact), gradient_of(last)) <= most_m;
}

// Whether a contact exerts the force of the previous one, extrapolated: its deepest place moves with A relative to B by
// Δx, so that the depth becomes δ + ∇δ·Δx.
bool is_felt_on(const TexturedContact& last, const TexturedContact& contact,
                const SuccessiveContacts& in) noexcept {
  const ContactFrame frame = in.motion.continued(last);
  const glm::dvec3 way_m = in.motion.way_m(in.motion.now_on_a_m(deepest_m(last)));
  const glm::dvec3 gradient = frame.to_world({last.penetration.slope, -1.0});
  const double depth_m = last.penetration.depth_m + glm::dot(gradient, way_m);
  return glm::distance(contact.penetration.depth_m * gradient_of(contact), depth_m * gradient) <=
         in.alike_m;
}

// The contact of the previous tick that continues as this one, among those whose successor it is. If others merged with
// it, that is the one with the nearest deepest place. There is none (kMostContacts) if the deepest place was not in its window
// before, or if the force would be another one.
std::size_t predecessor_of(std::size_t contact, const Indices& successors,
                           const SuccessiveContacts& in) noexcept {
  const TexturedContact& now = in.now[contact];
  std::size_t predecessor = kMostContacts;
  std::size_t nearest = kMostContacts;
  bool others_joined = false;
  for (std::size_t i = 0; i < in.before.size(); ++i) {
    if (successors[i] != contact) continue;
    const bool is_same = in.before[i].id == now.id;
    others_joined = others_joined || (!is_same && !in.before[i].is_fading);
    if (is_same && !in.before[i].is_fading) predecessor = i;
    if (nearest == kMostContacts || apart_m(in.before[i], now) < apart_m(in.before[nearest], now)) {
      nearest = i;
    }
  }
  if (predecessor == kMostContacts || others_joined) predecessor = nearest;
  if (predecessor == kMostContacts) return predecessor;
  const TexturedContact& last = in.before[predecessor];
  const glm::dvec3 way_m = last.frame.to_frame(deepest_m(now) - last.frame.origin_m);
  const bool was_seen = std::max(std::abs(way_m.x), std::abs(way_m.y)) <= 0.5 * last.grid.width_m;
  if (!was_seen) return kMostContacts;
  return is_due_to_motion(last, now, in) || is_felt_on(last, now, in) ? predecessor : kMostContacts;
}

// Whether a contact was there in the previous tick, or this one is doubtful.
bool had_any(std::size_t contact, const Indices& successors,
             const SuccessiveContacts& in) noexcept {
  const TexturedContact& now = in.now[contact];
  bool had = now.is_doubtful;
  for (std::size_t i = 0; i < in.before.size(); ++i) {
    const TexturedContact& last = in.before[i];
    const bool is_same = last.id == now.id && (is_felt(last) || last.is_doubtful);
    had = had || successors[i] == contact || is_same ||
          (is_felt(last) && is_part_of(now.frame, last));
  }
  return had;
}

// Whether it would have been rendered in the previous tick, to first order. False if it has moved by more than half a
// window since, because then it cannot be identified.
bool was_deep(const TexturedContact& contact, const SuccessiveContacts& in) noexcept {
  if (in.is_first || !is_felt(contact)) return false;
  const glm::dvec3 way_m = contact.frame.to_frame(in.motion.way_m(deepest_m(contact)));
  if (glm::length(way_m) > 0.5 * contact.grid.width_m) return false;
  const glm::dvec3 gradient{contact.penetration.slope, -1.0};
  return contact.penetration.depth_m - glm::dot(gradient, way_m) > 0.0;
}

}  // namespace

ContactSuccession::ContactSuccession(const SuccessiveContacts& in) noexcept {
  assert(std::max(in.now.size(), in.before.size()) <= kMostContacts);
  find_owners(in);
  find_predecessors(in);
}

std::optional<std::size_t> ContactSuccession::predecessor(std::size_t contact) const noexcept {
  if (predecessors_[contact] == kMostContacts) return std::nullopt;
  return predecessors_[contact];
}

bool ContactSuccession::continues(std::size_t last) const noexcept {
  return std::find(predecessors_.begin(), predecessors_.end(), last) != predecessors_.end();
}

void ContactSuccession::find_owners(const SuccessiveContacts& in) noexcept {
  const auto goes_before = [&in](std::size_t one, std::size_t other) {
    const auto rank = [&in](std::size_t i) {
      return std::pair{share_before(in.now[i], in), in.now[i].penetration.depth_m};
    };
    return rank(one) != rank(other) ? rank(one) > rank(other) : one < other;
  };
  for (std::size_t i = 0; i < in.now.size(); ++i) {
    owners_[i] = i;
    for (std::size_t j = 0; j < in.now.size(); ++j) {
      if (j == i || !are_at_one_place(in.now[i], in.now[j])) continue;
      if (goes_before(j, owners_[i])) owners_[i] = j;
    }
  }
  const auto first_of = [this](std::size_t i) {
    while (owners_[i] != i) i = owners_[i];
    return i;
  };
  for (std::size_t i = 0; i < in.now.size(); ++i) {
    if (!is_beside_curve(in.now[i])) continue;
    for (std::size_t j = 0; owners_[i] == i && j < in.now.size(); ++j) {
      if (shows_place_of(in.now[i], in.now[j])) owners_[i] = first_of(j);
    }
  }
  for (std::size_t i = 0; i < in.now.size(); ++i) owners_[i] = first_of(i);
}

void ContactSuccession::find_predecessors(const SuccessiveContacts& in) noexcept {
  predecessors_.fill(kMostContacts);
  Indices successors{};  // of each contact of the previous tick, the present one at its place
  for (std::size_t i = 0; i < in.before.size(); ++i) {
    const bool counts = is_felt(in.before[i]) && in.before[i].share > 0.0;
    const std::size_t successor = counts ? successor_of(in.before[i], in) : in.now.size();
    successors[i] = successor < in.now.size() ? owners_[successor] : in.now.size();
  }
  for (std::size_t i = 0; i < in.now.size(); ++i) {
    if (!in.now[i].is_doubtful) predecessors_[i] = predecessor_of(i, successors, in);
    if (!is_owner(i) || predecessors_[i] < kMostContacts) continue;
    rises_[i] = had_any(i, successors, in) || was_deep(in.now[i], in);
  }
  const Indices undivided = predecessors_;
  for (std::size_t i = 0; i < in.now.size(); ++i) {
    if (undivided[i] < kMostContacts) divide(i, in);
  }
}

// After a contact has divided: the part that is nearest to its deepest place and exerts its force continues it.
void ContactSuccession::divide(std::size_t contact, const SuccessiveContacts& in) noexcept {
  const TexturedContact& last = in.before[predecessors_[contact]];
  std::size_t nearest = contact;
  for (std::size_t i = 0; i < in.now.size(); ++i) {
    if (!rises_[i] || !is_felt(in.now[i])) continue;
    if (!is_part_of(in.now[i].frame, last) || !is_felt_on(last, in.now[i], in)) continue;
    if (apart_m(in.now[i], last) < apart_m(in.now[nearest], last)) nearest = i;
  }
  std::swap(predecessors_[nearest], predecessors_[contact]);
  std::swap(rises_[nearest], rises_[contact]);
}

}  // namespace asperity

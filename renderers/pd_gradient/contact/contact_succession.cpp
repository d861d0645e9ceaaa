// Which contact of a tick continues which one of the previous tick, and how their shares rise and fall.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "renderers/pd_gradient/contact/textured_contacts.h"

namespace asperity {
namespace {

constexpr double kAlike = 0.25;                   // of the permitted change of the force
constexpr double kSteepest = 1.7320508075688772;  // tan 60°, of the surfaces of a contact

}  // namespace

// The contact with the same id; otherwise, of those in whose window it was, the one with the nearest deepest place.
// contacts_.size() if there is none.
std::size_t TexturedContacts::successor_of(const TexturedContact& last) const noexcept {
  std::size_t nearest = contacts_.size();
  const auto away_m = [&](std::size_t i) {
    return glm::distance(deepest_m(contacts_[i]), deepest_m(last));
  };
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (contacts_[i].id == last.id) return i;
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (!is_part_of(last.frame, contacts_[i])) continue;
    if (nearest == contacts_.size() || away_m(i) < away_m(nearest)) nearest = i;
  }
  return nearest;
}

// The contact of the previous tick that continues as this one, among those whose successor it is. If others merged with
// it, that is the one with the nearest deepest place. There is none (kMostContacts) if the deepest place was in no window
// before, or if the force under another id would differ.
std::size_t TexturedContacts::predecessor_of(std::size_t contact, const Successors& successors,
                                             const Pose& X_WA, const Pose& X_WB) const noexcept {
  const TexturedContact& now = contacts_[contact];
  std::size_t predecessor = kMostContacts;
  std::size_t nearest = kMostContacts;
  bool others_joined = false;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    if (successors[i] != contact) continue;
    const bool is_same = before_[i].id == now.id;
    others_joined = others_joined || (!is_same && !before_[i].is_fading);
    if (is_same && !before_[i].is_fading) predecessor = i;
    const auto away_m = [&](std::size_t last) {
      return glm::distance(deepest_m(before_[last]), deepest_m(now));
    };
    if (nearest == kMostContacts || away_m(i) < away_m(nearest)) nearest = i;
  }
  if (predecessor == kMostContacts || others_joined) predecessor = nearest;
  if (predecessor == kMostContacts) return predecessor;
  const TexturedContact& last = before_[predecessor];
  const glm::dvec3 way_m = last.frame.to_frame(deepest_m(now) - last.frame.origin_m);
  const bool was_seen = std::max(std::abs(way_m.x), std::abs(way_m.y)) <= 0.5 * last.grid.width_m;
  if (!was_seen) return kMostContacts;
  const bool continues =
      is_due_to_motion(last, now, X_WA, X_WB) || is_felt_on(last, now, X_WA, X_WB);
  return continues ? predecessor : kMostContacts;
}

// How far A has moved at a place of the world since the previous tick, relative to B.
glm::dvec3 TexturedContacts::way_since_m(const glm::dvec3& now_m, const Pose& X_WA,
                                         const Pose& X_WB) const noexcept {
  const glm::dvec3 before_m = X_WA_before_ * in_body(X_WA, now_m);
  return now_m - X_WB * in_body(X_WB_before_, before_m);
}

// Where a place of A is now that was there in the previous tick.
glm::dvec3 TexturedContacts::now_on_a_m(const glm::dvec3& before_m,
                                        const Pose& X_WA) const noexcept {
  return X_WA * in_body(X_WA_before_, before_m);
}

// The farthest that A has moved since the previous tick relative to B, at the deepest place and at the window's border.
double TexturedContacts::farthest_way_m(const TexturedContact& contact, const Pose& X_WA,
                                        const Pose& X_WB) const noexcept {
  const ContactFrame& frame = contact.frame;
  const double half_m = 0.5 * contact.grid.width_m;
  double farthest_m = glm::length(way_since_m(deepest_m(contact), X_WA, X_WB));
  for (const glm::dvec3& aside : {frame.u, -frame.u, frame.v, -frame.v}) {
    farthest_m =
        std::max(farthest_m, glm::length(way_since_m(frame.origin_m + half_m * aside, X_WA, X_WB)));
  }
  return farthest_m;
}

// The change of a force in this tick that is no other contact, for a stiffness of 1 N/m.
double TexturedContacts::alike_m() const noexcept { return kAlike * permitted_change_m(force_m_); }

// Whether surfaces of at most 60° permit the change of the force. At a low step they do not: its upper side is in the
// window, and in the displaced configurations of the differences, before the edge of A has come up to it.
bool TexturedContacts::is_due_to_motion(const TexturedContact& last, const TexturedContact& now,
                                        const Pose& X_WA, const Pose& X_WB) const noexcept {
  const double way_m = kSteepest * farthest_way_m(now, X_WA, X_WB);
  const double depth_m = now.penetration.depth_m;
  if (std::abs(depth_m - last.penetration.depth_m) > way_m + alike_m()) return false;
  const glm::dvec3 gradient_before = last.frame.to_world({last.penetration.slope, -1.0});
  const glm::dvec3 gradient = now.frame.to_world({now.penetration.slope, -1.0});
  const double most_m = depth_m * way_m / now.filter_m + alike_m();
  return depth_m * glm::distance(gradient, gradient_before) <= most_m;
}

// Whether a contact exerts the force of the previous one, extrapolated: its deepest place moves with A relative to B by
// Δx, so that the depth becomes δ + ∇δ·Δx.
bool TexturedContacts::is_felt_on(const TexturedContact& last, const TexturedContact& now,
                                  const Pose& X_WA, const Pose& X_WB) const noexcept {
  const ContactFrame frame = continued(last, X_WA, X_WB).frame;
  const glm::dvec3 way_m = way_since_m(now_on_a_m(deepest_m(last), X_WA), X_WA, X_WB);
  const glm::dvec3 gradient = frame.to_world({last.penetration.slope, -1.0});
  const double depth_m = last.penetration.depth_m + glm::dot(gradient, way_m);
  const glm::dvec3 gradient_now = now.frame.to_world({now.penetration.slope, -1.0});
  return glm::distance(now.penetration.depth_m * gradient_now, depth_m * gradient) <= alike_m();
}

// After a contact has divided: the part that is nearest to its deepest place and exerts its force inherits its share.
void TexturedContacts::divide(const TexturedContact& last, std::size_t predecessor,
                              const Pose& X_WA, const Pose& X_WB, Begun& begun) noexcept {
  std::size_t nearest = predecessor;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const TexturedContact& contact = contacts_[i];
    if (!begun[i] || i == predecessor || !is_felt(contact)) continue;
    if (!is_part_of(contact.frame, last) || !is_felt_on(last, contact, X_WA, X_WB)) continue;
    if (glm::distance(deepest_m(contact), deepest_m(last)) <
        glm::distance(deepest_m(contacts_[nearest]), deepest_m(last))) {
      nearest = i;
    }
  }
  std::swap(contacts_[nearest].share, contacts_[predecessor].share);
  std::swap(contacts_[nearest].force_id, contacts_[predecessor].force_id);
  std::swap(begun[nearest], begun[predecessor]);
}

// Whether it would have been rendered in the previous tick, to first order. False if it has moved by more than half a
// window since, because then it cannot be identified.
bool TexturedContacts::was_deep(const TexturedContact& contact, const Pose& X_WA,
                                const Pose& X_WB) const noexcept {
  if (is_first_ || !is_felt(contact)) return false;
  const glm::dvec3 way_m = contact.frame.to_frame(way_since_m(deepest_m(contact), X_WA, X_WB));
  if (glm::length(way_m) > 0.5 * contact.grid.width_m) return false;
  const glm::dvec3 gradient{contact.penetration.slope, -1.0};
  return contact.penetration.depth_m - glm::dot(gradient, way_m) > 0.0;
}

double TexturedContacts::share_before(const TexturedContact& contact) const noexcept {
  const std::size_t last = place_before(contact.id);
  return last < before_.size() && is_felt(before_[last]) ? before_[last].share : 0.0;
}

// The contact that renders the place of each contact: of those at one place the one that did before, otherwise the
// deepest.
TexturedContacts::Successors TexturedContacts::owners() const noexcept {
  const auto goes_before = [this](std::size_t one, std::size_t other) {
    const auto rank = [this](std::size_t i) {
      return std::pair{share_before(contacts_[i]), contacts_[i].penetration.depth_m};
    };
    return rank(one) != rank(other) ? rank(one) > rank(other) : one < other;
  };
  Successors owners{};
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    owners[i] = i;
    for (std::size_t j = 0; j < contacts_.size(); ++j) {
      if (j == i || !are_at_one_place(contacts_[i], contacts_[j])) continue;
      if (goes_before(j, owners[i])) owners[i] = j;
    }
  }
  const auto first_of = [&owners](std::size_t i) {
    while (owners[i] != i) i = owners[i];
    return i;
  };
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (!is_beside_curve(contacts_[i])) continue;
    for (std::size_t j = 0; owners[i] == i && j < contacts_.size(); ++j) {
      if (shows_place_of(contacts_[i], contacts_[j])) owners[i] = first_of(j);
    }
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) owners[i] = first_of(i);
  return owners;
}

void TexturedContacts::blend(const Pose& X_WA, const Pose& X_WB, bool are_apart) noexcept {
  const std::size_t now = contacts_.size();
  const Successors owner = owners();
  Successors successors{};
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const bool counts = is_felt(before_[i]) && before_[i].share > 0.0;
    const std::size_t successor = counts ? successor_of(before_[i]) : now;
    successors[i] = successor < now ? owner[successor] : now;
  }
  std::array<std::size_t, kMostContacts> predecessors{};
  Begun begun{};
  bool parts = false;
  for (std::size_t i = 0; i < now; ++i) {
    TexturedContact& contact = contacts_[i];
    predecessors[i] =
        contact.is_doubtful ? kMostContacts : predecessor_of(i, successors, X_WA, X_WB);
    bool had_any = contact.is_doubtful;
    for (std::size_t j = 0; j < before_.size(); ++j) {
      const TexturedContact& last = before_[j];
      const bool is_same = last.id == contact.id && (is_felt(last) || last.is_doubtful);
      had_any = had_any || successors[j] == i || is_same ||
                (is_felt(last) && is_part_of(contact.frame, last));
    }
    contact.force_id = next_force_id_++;
    if (owner[i] != i) {
      contact.share = 0.0;
    } else if (predecessors[i] < kMostContacts) {
      contact.share = before_[predecessors[i]].share;
      contact.force_id = before_[predecessors[i]].force_id;
    } else if (had_any || was_deep(contact, X_WA, X_WB)) {
      contact.share = 0.0;
      begun[i] = true;
      parts = true;
    }
  }
  for (std::size_t i = 0; parts && i < now; ++i) {
    if (predecessors[i] < kMostContacts) divide(before_[predecessors[i]], i, X_WA, X_WB, begun);
  }
  for (std::size_t i = 0; !are_apart && i < before_.size(); ++i) {
    const TexturedContact& last = before_[i];
    const bool continues = successors[i] < now && predecessors[successors[i]] == i;
    if (!continues && is_felt(last)) fade(last, X_WA, X_WB);
  }
  change_shares(std::span(owner).first(now));
}

}  // namespace asperity

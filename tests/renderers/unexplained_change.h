// The change of the force in a tick that the motion does not explain.

#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <numbers>
#include <span>

#include <glm/geometric.hpp>

#include "renderers/pd_gradient/contact/textured_contact.h"
#include "tests/renderers/pd_gradient_surfaces.h"

namespace asperity {

/// Divides the change of the force in a tick into the part that the motion explains and the rest.
///
/// The force on A is F = Σ s_i·F_i with F_i = −k·δ·g, g = ∇δ = (h_u, h_v, −1) in the contact's frame, and the share s_i. If a contact
/// continues, its force changes by
///
///   ΔF_i = −k·(Δδ·g + δ·Δg)
///
/// δ is the largest difference of the heights of B and A in the window. Let every place of A in the window move by at most Δx
/// relative to B. Surfaces that lean by at most 60° from n change in height by at most tan 60°·|Δx| where they move along each
/// other, and by |Δx| along n. A maximum changes by no more than the largest change of the quantities it is taken of:
///
///   |Δδ| ≤ tan 60°·|Δx|
///
/// A slope is (δ₊ − δ₋)/(2·step), from the depths at positions displaced by ±step. The limit of |Δδ| applies to both depths, so that
/// |Δg| ≤ tan 60°·|Δx|/step. (The smooth maximum has its exact gradient; its weights, and with them g, change within τ instead.)
/// With both,
///
///   |ΔF_i| ≤ k·tan 60°·|Δx|·(|g| + δ/step)
///
/// The explained change is Σ min(s_i before, s_i now)·ΔF_i, each ΔF_i shortened to this bound. The bound has the constants of the
/// model's own decision whether a contact continues (TexturedContacts), and the exact limits are somewhat larger: 2·|Δx| for a motion
/// across and along n at once, √2 times as much for both slopes at once, and places between those for which Δx is computed.
/// Therefore no change is called explained that the motion cannot cause. A change within the bound may still have another cause: for
/// δ = 10·step and Δx = step/20 the bound is 10 % of the force. The whole change is therefore reported as well.
///
/// A contact continues under the id of its force, which is new where another contact replaces it under its own id. If a contact
/// begins to fade under the id of one that fades already, both continue as one with the sum of their forces.
///
/// Unexplained are therefore all changes of shares, the forces of contacts in their first tick and after their last one, also where
/// bodies meet or separate, and what exceeds the bound. B does not move.
class UnexplainedChange final {
 public:
  struct Tick {
    double unexplained_N = 0.0;
    double whole_N = 0.0;
    double current_N = 0.0;     ///< the larger force of this tick and the previous one
    double magnitudes_N = 0.0;  ///< the same of Σ s_i·|F_i|, to which opposing contacts add

    /// Relative to the current force, or to `least_N` where it is small.
    double part(double least_N) const { return unexplained_N / std::max(current_N, least_N); }
    double part_of_magnitudes(double least_N) const {
      return unexplained_N / std::max(magnitudes_N, least_N);
    }
  };

  /// The contacts of the next tick, and the pose of A; nothing has changed in the first.
  Tick add(std::span<const TexturedContact> found, const Pose& a) {
    glm::dvec3 force_N{0.0};
    double magnitudes_N = 0.0;
    Contacts now;
    for (const TexturedContact& contact : found) {
      if (!is_felt(contact)) continue;
      force_N += contact.share * kStiffness_N_per_m * force_m(contact);
      magnitudes_N += contact.share * kStiffness_N_per_m * glm::length(force_m(contact));
      now.emplace(contact.force_id, contact);
    }
    const glm::dvec3 change_N = is_first_ ? glm::dvec3{0.0} : force_N - force_before_N_;
    glm::dvec3 explained_N{0.0};
    for (const auto& [force_id, contact] : now) explained_N += explained_change_N(contact, now, a);
    const Tick tick{.unexplained_N = is_first_ ? 0.0 : glm::distance(change_N, explained_N),
                    .whole_N = glm::length(change_N),
                    .current_N = std::max(glm::length(force_N), glm::length(force_before_N_)),
                    .magnitudes_N = std::max(magnitudes_N, magnitudes_before_N_)};
    is_first_ = false;
    before_ = std::move(now);
    force_before_N_ = force_N;
    magnitudes_before_N_ = magnitudes_N;
    a_before_ = a;
    return tick;
  }

 private:
  using Contacts = std::map<std::uint64_t, TexturedContact>;  // by the ids of their forces

  // The contacts of the previous tick that continue as this one, with the sum of their forces and shares: itself, and those that
  // were added to it because it fades under their id (TexturedContacts).
  struct Last {
    double share = 0.0;
    glm::dvec3 force_N{0.0};

    void add(const TexturedContact& contact) {
      share += contact.share;
      force_N += contact.share * kStiffness_N_per_m * force_m(contact);
    }
  };
  Last last_of(const TexturedContact& contact, const Contacts& now) const {
    Last last;
    for (const auto& [force_id, other] : before_) {
      const bool was_added = other.is_fading && other.id == contact.id && !now.contains(force_id) &&
                             is_newest_to_fade(contact, now);
      if (force_id == contact.force_id || was_added) last.add(other);
    }
    return last;
  }
  static bool is_newest_to_fade(const TexturedContact& contact, const Contacts& now) {
    return contact.is_fading && std::none_of(now.begin(), now.end(), [&](const auto& other) {
             return other.second.is_fading && other.second.id == contact.id &&
                    other.second.force_id > contact.force_id;
           });
  }

  glm::dvec3 explained_change_N(const TexturedContact& now, const Contacts& all_now,
                                const Pose& a) const {
    const Last last = last_of(now, all_now);
    if (last.share == 0.0) return {};
    const double half_m = 0.5 * now.grid.width_m;
    double way_m = 0.0;
    for (const glm::dvec3& place_m :
         {deepest_m(now), now.frame.origin_m + half_m * now.frame.u,
          now.frame.origin_m - half_m * now.frame.u, now.frame.origin_m + half_m * now.frame.v,
          now.frame.origin_m - half_m * now.frame.v}) {
      const glm::dvec3 then_m = a_before_.rotation * in_body(a, place_m) + a_before_.position_m;
      way_m = std::max(way_m, glm::distance(place_m, then_m));
    }
    const double slope = glm::length(glm::dvec3(now.penetration.slope, 1.0));
    const double most_N = kStiffness_N_per_m * std::numbers::sqrt3 * way_m *
                          (slope + now.penetration.depth_m / now.filter_m);
    const glm::dvec3 change_N = kStiffness_N_per_m * force_m(now) - last.force_N / last.share;
    return std::min(now.share, last.share) *
           std::min(1.0, most_N / std::max(1e-12, glm::length(change_N))) * change_N;
  }

  Contacts before_{};
  glm::dvec3 force_before_N_{0.0};
  double magnitudes_before_N_ = 0.0;
  Pose a_before_{};
  bool is_first_ = true;
};

}  // namespace asperity

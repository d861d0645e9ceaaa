// Declares the wall at the border of a patch.

#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace asperity {

/// Pushes a probe back inside the border of a patch while it is in contact with the surface.
///
///   F = −k·(e − o)                          e the distance beyond the border along an axis [m], with its sign; 0 inside
///   o = e                                   in the first tick of a contact
///   o ← clamp(o, min(0, e), max(0, e))      in every further one
///
/// k the stiffness of the wall [N/m], o where it stands. A contact that begins inside has o = 0: the wall is the border. One
/// that begins beyond the border, where the hand was in the air, has its wall at the probe; from there the wall follows the
/// hand inwards, and stays at the border once the hand has been inside. |o| is the least |e| since contact began.
///
/// Without a step: |F⁺ − F| ≤ k·|e⁺ − e|. If o stays, the two sides are equal. If e⁺ lies between 0 and o, the force becomes
/// 0 and was k·|e − o| ≤ k·|e − e⁺|, because o lies between e⁺ and e. If e⁺ has the other sign, o becomes 0 and |e⁺| + |e − o| ≤
/// |e⁺ − e|. In the first tick F = 0.
///
/// Passive: with U = ½·k·(e − o)² the force is −dU/de while o stays, and 0 while o moves, so that the wall does the work −U
/// on a hand since contact began. Contact that ends beyond the border removes U.
///
/// Limits: a hand that loses contact beyond the border, also on a crest for a tick, finds the wall where it touches again.
///
/// Real-time: no allocation, no exceptions.
class BorderWall final {
 public:
  /// Where contact is lost, and at the start of a presentation.
  void release() noexcept { in_contact_ = false; }

  /// Of a tick in contact.
  glm::dvec2 force_N(const glm::dvec2& beyond_m, double stiffness_N_per_m) noexcept {
    if (!in_contact_) place_m_ = beyond_m;
    in_contact_ = true;
    const glm::dvec2 border(0.0);
    place_m_ = glm::clamp(place_m_, glm::min(border, beyond_m), glm::max(border, beyond_m));
    return -stiffness_N_per_m * (beyond_m - place_m_);
  }

 private:
  bool in_contact_ = false;
  glm::dvec2 place_m_{0.0};  ///< o
};

}  // namespace asperity

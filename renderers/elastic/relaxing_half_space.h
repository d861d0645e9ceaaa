// Declares a half-space that relaxes under a rigid body.

#pragma once

#include <glm/vec2.hpp>

#include "renderers/elastic/cell_field.h"
#include "renderers/elastic/half_space_contact.h"

namespace asperity {

/// Moves a rigid body over a half-space whose material is a standard linear solid, tick by tick.
///
/// Law: E(t) = E∞·(1 + (ρ − 1)·e^(−t/τ)) after a step of strain, ρ = E₀/E∞, with a constant Poisson ratio. The displacement of
/// a point of the surface is then that of the elastic half-space with the creep compliance, of one delayed term:
///
///   u = (1/ρ)·K·s + v,   ρτ·dv/dt = (1 − 1/ρ)·K·s − v
///
/// with s the load for the modulus E∞ (half_space_displacement.h). v belongs to the material: it stays where the surface was
/// loaded, and moves through the window of a body that slides. Over a step T in which K·s changes linearly, v is exact
///
///   v⁺ = e·v + (1 − 1/ρ)·(w₀·K·s + w₁·K·s⁺),   e = e^(−T/ρτ),   w₁ = 1 − (1 − e)·ρτ/T,   w₀ = (1 − e)·ρτ/T − e
///
/// so that every tick is an elastic contact with κ·K·s⁺ = overlap − d, with κ = 1/ρ + (1 − 1/ρ)·w₁ and d the dent that earlier
/// loads leave. For a punch, or a ball at a constant depth, the force relaxes as E(t).
///
/// Limits: what has left the window is forgotten. v is moved by bilinear interpolation, which smooths it by less than half a
/// cell per tick.
///
/// Real-time: `advance` and `reset` do not allocate, lock or throw. Threads: one at a time.
class RelaxingHalfSpace final {
 public:
  struct Material {
    double ratio = 1.2;    ///< ρ, at least 1; 1: elastic
    double time_s = 0.02;  ///< τ
  };

  explicit RelaxingHalfSpace(const Material& material) noexcept : material_(material) {}

  /// Removes loads and dents.
  void reset() noexcept;

  /// Solves the contact after a step of `dt_s` in which the window moved by `moved` cells over the surface. Returns the
  /// residual (HalfSpaceContact::solve).
  double advance(const CellField& overlap_m, const glm::dvec2& moved, double dt_s,
                 const HalfSpaceContact::Effort& effort) noexcept;

  /// s, for the modulus E∞: a cell of side c has the force E*∞·c·s.
  const CellField& load_m() const noexcept { return load_m_; }
  /// d, the depth of the surface below its undeformed position that earlier loads leave.
  const CellField& dent_m() const noexcept { return dent_m_; }
  bool is_loaded() const noexcept { return is_loaded_; }
  bool has_dent() const noexcept { return has_dent_; }
  /// u, in the window of the last step.
  CellField displacement_m() const noexcept;

 private:
  void move(CellField& field, const glm::dvec2& moved) noexcept;

  Material material_{};
  HalfSpaceContact contact_{};
  CellField load_m_{};
  CellField dent_m_{};
  CellField delayed_m_{};    ///< v
  CellField displaced_m_{};  ///< K·s of the last tick
  CellField effective_m_{};  ///< overlap − d
  CellField moved_m_{};
  bool is_loaded_ = false;
  bool has_dent_ = false;
};

}  // namespace asperity

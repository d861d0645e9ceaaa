// Declares the mechanical properties of a surface other than its texture.

#pragma once

namespace asperity {

/// The bulk properties of a surface: a spring normal to it and Coulomb friction along it.
///
/// Models that are compared share one Material, so that they differ only in texture.
struct Material {
  double stiffness_N_per_m = 500.0;
  double friction = 0.2;  ///< Coulomb coefficient: tangential over normal force
};

}  // namespace asperity

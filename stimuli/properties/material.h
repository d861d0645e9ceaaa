// How a surface yields to the probe, apart from its texture.

#pragma once

namespace asperity {

/// The bulk of a surface: a spring normal to it and dry friction along it.
///
/// Models that are compared with each other share one Material, so that what differs is the
/// texture.
struct Material {
  double stiffness_N_per_m = 500.0;
  double friction = 0.2;  ///< Coulomb coefficient, tangential over normal force
};

}  // namespace asperity

// The psi procedure.

#pragma once

#include <vector>

#include "protocols/procedures/posterior_track.h"

namespace asperity {

struct Procedure;

/// The level with the least expected entropy of the marginal distribution of the parameters of interest [Kontsevich 1999],
/// nuisance parameters being marginalised [Prins 2013]. The threshold is always of interest; without nuisance parameters
/// the slope and the lapse rate are as well, and trials are spent on them.
///
/// [Kontsevich 1999] Kontsevich, Tyler: Bayesian adaptive estimation of psychometric slope and threshold.
/// [Prins 2013] Prins: The psi-marginal adaptive method.
struct Psi {
  PosteriorTrack track{};
  std::vector<NuisanceParameter> marginalised{NuisanceParameter::slope, NuisanceParameter::lapse};

  bool operator==(const Psi&) const = default;
};

const Procedure& psi();

}  // namespace asperity

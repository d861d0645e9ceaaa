// Declares the interface of renderers whose surface is not a spring.

#pragma once

#include <optional>

#include "analysis/words/phrase.h"

namespace asperity {

/// Implemented by a renderer (ForceRenderer) whose surface without texture resists the hand by a law of its own, and not by the
/// spring of the Material.
///
/// Threads: both functions depend only on the constructor's arguments.
class IndentationLaw {
 public:
  virtual ~IndentationLaw() = default;
  IndentationLaw(const IndentationLaw&) = delete;
  IndentationLaw& operator=(const IndentationLaw&) = delete;

  /// The greatest dF/dδ of the surface without texture under a normal force.
  virtual double indentation_stiffness_N_per_m(double force_N) const = 0;
  /// The assumption of the law that a normal force violates, with a correction; nullopt if there is none.
  virtual std::optional<Phrase> indentation_problem(double force_N) const = 0;

 protected:
  IndentationLaw() = default;
};

}  // namespace asperity

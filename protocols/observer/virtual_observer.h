// A participant made of arithmetic: judges what was felt against what is expected.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/force_features.h"
#include "analysis/random.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// What an observer expects of textures, by name.
using Expectations = std::map<std::string, ForceFeatures, std::less<>>;

/// How a person uses numbers.
struct NumberHabit {
  double modulus = 10.0;  ///< what a force as large as the mean normal force, or 1 m/s², is called
  int digits = 2;         ///< significant ones
};
/// From somebody who counts to ten to somebody who counts to a thousand.
NumberHabit number_habit_of(Random person);

/// Judges from ForceFeatures of what the hand felt and of what is expected, and knows nothing else:
/// no names, no models, no positions but the order in which things come.
///
/// Evidence for "felt i is expected j" is −½·|φ_i + ε − μ_j|², with φ and μ the scaled features and
/// ε ~ N(0, feature_noise²) drawn once per felt surface; the first of what is chosen among (the
/// first surface felt in a selection, the first picture in a recognition, the pair of firsts in a
/// match) gains `position_bias`. Equal evidence is decided by chance.
/// With probability `lapse` (always, when deaf) the answer is uniform over the open options.
/// With noise, bias and lapse at zero the observer is an ideal judge of these features.
///
/// Errors: std::invalid_argument for numbers of surfaces or options that make no question.
///
/// A number for how rough a surface feels is m·exp(n·(r + ε)), with n the declared exponent and m the
/// person's own modulus; rounded to the digits that the person says. r is the natural logarithm of the
/// felt force over the mean normal force (ForceFeatures::roughness of the lateral force, ::size of the
/// normal one), or of √(a² + a₀²/2) over 1 m/s², a being the acceleration of a held tool
/// (ForceFeatures::shaking_m_per_s2) and a₀ the amplitude from which on it is felt (kHeldTool). A
/// share of the normal force cannot show what pressing harder does; an acceleration does. A lapse, and
/// whoever is deaf, says m times the exponential of a normal number.
///
/// What is expected may be limited to the band that a photograph keeps, by declaration
/// (ObserverDeclaration::gaussian_wavelength_m); nothing else of how a texture came about is known
/// to the observer.
///
/// Virtual answers exercise the machinery of a study. They say nothing about what people feel, nor
/// about which model they prefer.
class VirtualObserver final {
 public:
  VirtualObserver(const ObserverDeclaration& declaration, Random random);

  /// Which of the felt surfaces is the closest to what is expected. Index into `felt`.
  std::size_t select(std::span<const ForceFeatures> felt, const ForceFeatures& expected);
  /// Which expectation the felt surface is the closest to. Index into `expected`.
  std::size_t recognise(const ForceFeatures& felt, std::span<const ForceFeatures> expected);
  /// The assignment of felt surfaces to expectations with the greatest evidence, each expectation
  /// used once. Element i is the index into `expected` for felt i. Sizes are equal and at most 8.
  std::vector<std::size_t> match(std::span<const ForceFeatures> felt,
                                 std::span<const ForceFeatures> expected);
  /// A number above 0 for what was felt.
  double estimate(const ForceFeatures& felt, const NumberHabit& habit);
  /// A guess among `options`, for where nothing is expected.
  std::size_t guess(std::size_t options);
  /// Seconds from question to answer.
  double response_time_s();

 private:
  bool lapses();
  ForceFeatures perceived(const ForceFeatures& felt);
  /// r + ε
  double log_magnitude(const ForceFeatures& felt);
  std::size_t best_of(std::span<const double> evidences);

  ObserverDeclaration declaration_{};
  Random random_;
};

}  // namespace asperity

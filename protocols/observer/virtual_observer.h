// Declares the virtual observer, a simulated participant that judges force features against expectations.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/random.h"
#include "analysis/signals/force_features.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The expected features of textures, by name.
using Expectations = std::map<std::string, ForceFeatures, std::less<>>;

/// A participant's use of numbers in magnitude estimation.
struct NumberHabit {
  double modulus =
      10.0;        ///< the estimate for a force of the mean normal force, for 1 m/s² or 1 mm/N
  int digits = 2;  ///< significant digits
};
/// A participant's use of lines (LineForm) in magnitude estimation.
struct LineHabit {
  /// The line for a force of the mean normal force, for 1 m/s² or 1 mm/N, over the longest one.
  double modulus = 1.0;
};
/// A random habit, from participants who use half of the longest line to those who would exceed it.
LineHabit line_habit_of(Random person);

/// A random habit, from participants who use a scale up to ten to those who use one up to a thousand.
NumberHabit number_habit_of(Random person);

/// The natural logarithm of the magnitude that an observer judges of a surface, without noise.
double judged_magnitude(const ForceFeatures& felt, ObserverDeclaration::MagnitudeOf what);

/// The proportion of comparisons (VirtualObserver::compare without a least difference) in which an observer without position
/// bias chooses the surface whose magnitude r is greater by `difference`, from 0. Both magnitudes have the noise
/// ε ~ N(0, σ²), so that their difference has the standard deviation √2·σ; in a lapse, with probability λ, half of the
/// guesses are this surface:
///
///   P = λ/2 + (1 − λ)·Φ(difference / (√2·σ))
///
/// Without noise P is 1 − λ/2 for every difference above 0. 0.5 for a deaf observer.
double distinguished_proportion(const ObserverDeclaration& observer, double difference);
/// The same of the correct choices in a design: of the greatest of three magnitudes by `ForcedChoice`, of the odd one by
/// `Oddity`, with d′ = difference/σ and a guess rate γ in lapses,
///
///   P = λ·γ + (1 − λ)·P(d′)
///
/// and `distinguished_proportion` in all other designs.
double correct_proportion(const ObserverDeclaration& observer, double difference,
                          const DiscriminationDesign& design);

/// Judges from the ForceFeatures of the felt surfaces and of the expectations only: names and models are unknown to it,
/// and positions only as the order of presentation.
///
/// Evidence for "felt i is expected j" is −½·|φ_i + ε − μ_j|², with φ and μ the scaled features and ε ~ N(0,
/// feature_noise²) drawn once per felt surface. `position_bias` is added for the first alternative (the first felt
/// surface in a selection, the first picture in a recognition, the pair of firsts in a match). Ties are broken at
/// random. With probability `lapse` (always, if deaf) the response is uniform over the open options. With noise, bias
/// and lapse at zero the observer is an ideal judge of these features.
///
/// Errors: std::invalid_argument for numbers of surfaces or options that do not form a question.
///
/// An estimate of the roughness of a surface is m·exp(n·(r + ε)), with n the declared exponent and m the participant's
/// modulus, rounded to the participant's number of digits. r is the natural logarithm of the force over the mean normal
/// force (ForceFeatures::roughness of the lateral force, ::size of the normal one), or of √(a² + a₀²/2) over 1 m/s², a
/// being the acceleration of a held tool (ForceFeatures::shaking_m_per_s2) and a₀ its detection threshold as an
/// amplitude (kHeldTool), or of the depth of the probe over the normal force over 1 mm/N (ForceFeatures::compliance_m_per_N). A ratio
/// to the normal force cannot show the effect of pressing harder; an acceleration can.
/// In a lapse, and if deaf, the estimate is m times the exponential of a normal number. Where a standard with the number m
/// was felt before, r + ε of the standard is subtracted, and m is that number. A drawn line has the length of the estimate,
/// rounded to its steps and limited to the longest line.
///
/// Expectations may be limited to the band that a photograph preserves, by declaration
/// (ObserverDeclaration::gaussian_wavelength_m); the observer has no other information on the origin of a texture.
///
/// Virtual responses test the processing of a study. They are not evidence about human perception or about which model
/// participants prefer.
class VirtualObserver final {
 public:
  VirtualObserver(const ObserverDeclaration& declaration, Random random);

  /// Selects the felt surface that is closest to the expectation. Index into `felt`.
  std::size_t select(std::span<const ForceFeatures> felt, const ForceFeatures& expected);
  /// Recognises the expectation that is closest to the felt surface. Index into `expected`.
  std::size_t recognise(const ForceFeatures& felt, std::span<const ForceFeatures> expected);
  /// The assignment of felt surfaces to expectations with the greatest evidence, each expectation used once. Element i
  /// is the index into `expected` for felt i. Both sizes are equal and at most 8.
  std::vector<std::size_t> match(std::span<const ForceFeatures> felt,
                                 std::span<const ForceFeatures> expected);
  /// The surface with the greater magnitude (`estimate`), or the smaller one where the declared effect is a decrease: 0 or 1, or nothing where the natural logarithms r + ε of the
  /// two differ by less than `least_difference`. `position_bias` is added for the first.
  std::optional<std::size_t> compare(const ForceFeatures& first, const ForceFeatures& second,
                                     double least_difference);
  /// The surface with the greatest magnitude of several, judged as by `compare`, or with the smallest one: the decision of an
  /// observer who picks the largest of m impressions (ForcedChoice). `position_bias` is added to the evidence for the first.
  enum class Extreme { greatest, smallest };
  std::size_t most_extreme(std::span<const ForceFeatures> felt, Extreme which);
  /// The surface whose r + ε is farthest from the mean of all: the differencing rule of an oddity task (Oddity).
  /// `position_bias` is added to the distance of the first.
  std::size_t odd_one(std::span<const ForceFeatures> felt);
  /// Whether the natural logarithm r + ε of the magnitude is above a criterion.
  bool exceeds(const ForceFeatures& felt, double log_criterion);
  /// Whether the natural logarithms r + ε of two magnitudes differ by `least_difference` or more.
  bool differ(const ForceFeatures& first, const ForceFeatures& second, double least_difference);
  /// The certainty of the last decision by `compare`, `exceeds` or `differ`, from 0 to 1: nothing in a lapse, and if deaf.
  ///
  ///   q = 2·Φ(|x − c|/s) − 1
  ///
  /// with the decision variable x, its standard deviation s and the criterion c, that is r₁ + ε₁ − r₂ − ε₂ (plus
  /// `position_bias`), √2·σ and 0 of `compare`; r + ε, σ and `log_criterion` of `exceeds`; |r₁ + ε₁ − r₂ − ε₂|, √2·σ and
  /// `least_difference` of `differ`. q is uniform on [0, 1] where x is normal with mean c. Without noise it is 1, and 0 at
  /// the criterion.
  std::optional<double> certainty() const noexcept { return certainty_; }
  /// The distance of the perceived features of two surfaces, √squared_distance(φ₁ + ε₁, φ₂ + ε₂); nothing in a lapse, and
  /// if deaf. Without noise it is 0 for two surfaces of the same features alone.
  std::optional<double> difference(const ForceFeatures& first, const ForceFeatures& second);
  /// A magnitude estimate, greater than 0, for the felt surface.
  double estimate(const ForceFeatures& felt, const NumberHabit& habit);
  /// An estimate relative to a standard, which was felt before and has the number `habit.modulus`.
  double estimate(const ForceFeatures& felt, const ForceFeatures& standard,
                  const NumberHabit& habit);
  /// The step, from 1 to `steps`, of the line that is drawn for the felt surface.
  int draw_line(const ForceFeatures& felt, const LineHabit& habit, int steps);
  /// A guess among `options`, for questions without an expectation.
  std::size_t guess(std::size_t options);
  /// The response time, in seconds from the question.
  double response_time_s();

 private:
  bool lapses();
  /// Whether the next decision is a lapse; it has no certainty until `decide`.
  bool lapses_in_decision();
  /// Sets the certainty of a decision from |x − c|, x being a sum or a difference of so many magnitudes.
  void decide(double distance, int magnitudes);
  /// e to the power of the exponent times `judged`, without the modulus; a guess in a lapse.
  double relative_estimate(double judged);
  ForceFeatures perceived(const ForceFeatures& felt);
  /// r + ε
  double log_magnitude(const ForceFeatures& felt);
  std::size_t best_of(std::span<const double> evidences);

  ObserverDeclaration declaration_{};
  Random random_;
  std::optional<double> certainty_{};
};

}  // namespace asperity

// Compares the proportion of significant studies with the level, within three standard errors.

#include "app/power/curve/true_size.h"

#include <cmath>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/study_test.h"

namespace asperity {

namespace {

constexpr double kErrors = 3.0;

std::string percent_text(double proportion) { return fixed(100.0 * proportion, 1); }

}  // namespace

std::string true_size_text(const PowerCurve& curve, const TestAtSize& without_effect) {
  constexpr double kLevel = StudyTest::kLevel;
  const PowerOfSize& found = without_effect.power;
  const double error =
      std::sqrt(kLevel * (1.0 - kLevel) / static_cast<double>(without_effect.studies));
  if (std::abs(found.power - kLevel) <= kErrors * error) return {};
  return "without an effect, " +
         (curve.test.empty() ? "the family " + curve.family : "the test " + curve.test) +
         " is significant in " + percent_text(found.power) + " % of the studies with " +
         std::to_string(found.participants) + " participants, 95 % Monte-Carlo CI [" +
         percent_text(found.interval.low) + ", " + percent_text(found.interval.high) +
         "]: its true size " + (found.power > kLevel ? "exceeds" : "is below") +
         " the level of significance";
}

}  // namespace asperity

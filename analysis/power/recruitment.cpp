// Ceilings of quotients, and the tail of a binomial distribution.

#include "analysis/power/recruitment.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/proportion.h"

namespace asperity {

namespace {

constexpr double kRounding = 1e-9;  // of a quotient that is a whole number

std::size_t ceiling(double number) {
  return static_cast<std::size_t>(std::ceil(number - kRounding));
}

void require_rate(double rate, const char* name) {
  if (rate >= 0.0 && rate < 1.0) return;
  throw std::invalid_argument(std::string(name) + " is " + number_text(rate) +
                              "; it must be at least 0 and below 1");
}

}  // namespace

std::size_t rounded_up_to_multiple(double participants, std::size_t multiple) {
  if (!(participants > 0.0 && std::isfinite(participants)) || multiple == 0) {
    throw std::invalid_argument("the number of participants is " + number_text(participants) +
                                " and the multiple " + std::to_string(multiple) +
                                "; both must be above 0");
  }
  return multiple * std::max<std::size_t>(1, ceiling(participants / static_cast<double>(multiple)));
}

Recruitment recruitment(std::size_t needed, const Attrition& attrition, double assurance) {
  require_rate(attrition.dropout, "dropout");
  require_rate(attrition.exclusion, "exclusion");
  if (needed == 0) throw std::invalid_argument("no participant is needed; at least one must be");
  if (!(assurance > 0.0 && assurance < 1.0)) {
    throw std::invalid_argument("assurance is " + number_text(assurance) +
                                "; it must lie between 0 and 1");
  }
  Recruitment answer{.retained = (1.0 - attrition.dropout) * (1.0 - attrition.exclusion)};
  answer.on_average = ceiling(static_cast<double>(needed) / answer.retained);
  // With N the probability of at least `needed` grows: double the number until it is enough, then halve the distance.
  const auto is_enough = [&](std::size_t recruited) {
    return binomial_upper_tail({.hits = needed, .trials = recruited}, answer.retained) >= assurance;
  };
  std::size_t enough = needed;
  std::size_t too_few = needed - 1;
  while (!is_enough(enough)) {
    too_few = enough;
    enough *= 2;
  }
  while (enough - too_few > 1) {
    const std::size_t middle = too_few + (enough - too_few) / 2;
    (is_enough(middle) ? enough : too_few) = middle;
  }
  answer.assured = enough;
  return answer;
}

}  // namespace asperity

// Updates the moments of estimates one by one, and takes power from the tally of `asperity power`.

#include "app/power/curve/precision.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numbers/tail_probabilities.h"

namespace asperity {

namespace {

constexpr double kNormalQuantile = 1.959963984540054;  // of 97.5 %
constexpr std::uint64_t kFewestNumbers = 10;
constexpr std::uint64_t kFewestEstimates = 50;

/// The order of a single effect and number of participants.
PowerOrder order_of_precision(int participants, std::uint64_t seed) {
  PowerOrder order{.effects = {"stated"}, .participants = {participants}, .seed = seed};
  require_order(order);
  return order;
}

PrecisionFigure quantile_figure(PrecisionFigure::What what, const PositiveQuantiles& widths,
                                double p) {
  PrecisionFigure figure{.what = what};
  if (widths.count() < kFewestNumbers) return figure;
  figure.interval = interval_of_quantile(widths, p);
  if (figure.interval) figure.value = widths.quantile(p);
  return figure;
}

/// The variance of estimates has about a χ² distribution, with the degrees of freedom that follow from its Monte-Carlo error ε,
/// which the fourth moment gives: Var(s²) = 2σ⁴/df and Var(s²) = (2σε)², so that df = σ²/(2ε²). They are n − 1 for normally
/// distributed estimates, and not more than that. The interval covers 95 % of them from two estimates on, and with 50 estimates 92 %
/// of those with the tails of a t distribution with 8 degrees of freedom (500: 94 %); symmetric intervals would cover 91 and 88 %.
PrecisionFigure error_figure(const EstimateSpread& estimates) {
  PrecisionFigure figure{.what = PrecisionFigure::What::standard_error};
  if (estimates.count() < kFewestEstimates) return figure;
  const double error = estimates.standard_error();
  const double monte_carlo = estimates.error_of_standard_error();
  const double df = std::min(static_cast<double>(estimates.count() - 1),
                             error * error / (2.0 * monte_carlo * monte_carlo));
  if (!(df > 0.0)) return figure;  // estimates that are all equal
  constexpr double kTail = 0.025;
  figure.value = error;
  figure.interval = ConfidenceInterval{
      .low = error * std::sqrt(df / exceeded_by(ChiSquaredTail{.tail = kTail, .df = df})),
      .high = error * std::sqrt(df / exceeded_by(ChiSquaredTail{.tail = 1.0 - kTail, .df = df}))};
  return figure;
}

}  // namespace

std::vector<std::string> names_without_value(std::span<const Assumption> assumptions) {
  std::vector<std::string> names{};
  for (const Assumption& one : assumptions) {
    if (!one.value) names.push_back(one.name);
  }
  return names;
}

std::vector<Assumption> with_stated(std::vector<Assumption> assumptions,
                                    const std::map<std::string, double>& stated,
                                    const std::string& source) {
  for (Assumption& one : assumptions) {
    const auto found = stated.find(one.name);
    if (found == stated.end()) continue;
    one.value = found->second;
    one.source = source;
  }
  return assumptions;
}

// Pébay 2008, "Formulas for robust, one-pass parallel computation of covariances and arbitrary-order statistical moments".
void EstimateSpread::add(double estimate) {
  const auto before = static_cast<double>(count_);
  const double n = before + 1.0;
  ++count_;
  const double deviation = estimate - mean_;
  const double step = deviation / n;
  const double term = deviation * step * before;
  mean_ += step;
  fourth_ += term * step * step * (n * n - 3.0 * n + 3.0) + 6.0 * step * step * second_ -
             4.0 * step * third_;
  third_ += term * step * (n - 2.0) - 3.0 * step * second_;
  second_ += term;
}

double EstimateSpread::standard_error() const {
  return count_ < 2 ? 0.0 : std::sqrt(second_ / static_cast<double>(count_ - 1));
}

double EstimateSpread::error_of_standard_error() const {
  const double error = standard_error();
  if (count_ < 4 || error == 0.0) return 0.0;
  const auto n = static_cast<double>(count_);
  const double variance = error * error;
  const double of_variance = (fourth_ / n - variance * variance * (n - 3.0) / (n - 1.0)) / n;
  return std::sqrt(std::max(0.0, of_variance)) / (2.0 * error);
}

std::optional<ConfidenceInterval> interval_of_quantile(const PositiveQuantiles& numbers, double p) {
  const auto n = static_cast<double>(numbers.count());
  const double half = kNormalQuantile * std::sqrt(n * p * (1.0 - p));
  const double low = std::floor(n * p - half);
  const double high = std::ceil(n * p + half) + 1.0;
  if (low < 1.0 || high > n) return {};
  // Between two ranks: ⌈rank − ½⌉ is the rank, whatever the rounding of the quotient.
  return ConfidenceInterval{.low = numbers.quantile((low - 0.5) / n).value(),
                            .high = numbers.quantile((high - 0.5) / n).value()};
}

PrecisionStudies::PrecisionStudies(PowerModel model, int participants, std::uint64_t seed)
    : model_(std::move(model)),
      participants_(participants),
      seed_(seed),
      tally_(order_of_precision(participants, seed)) {}

void PrecisionStudies::simulate(std::int64_t count, const std::function<bool()>& is_over) {
  for (std::int64_t i = 0; i < count; ++i) {
    add(simulate_and_recover(model_, participants_, seed_, studies_));
    ++studies_;
    if (is_over && is_over()) return;
  }
}

void PrecisionStudies::add(const SimulatedStudyResults& study) {
  tally_.add({.run = studies_}, study.outcomes);
  for (const SimulatedOutcome& outcome : study.outcomes) {
    OfTest& test = tests_[{outcome.family, outcome.test}];
    if (outcome.estimate && std::isfinite(*outcome.estimate)) {
      test.estimates.add(*outcome.estimate);
      test.measure = outcome.measure;
    }
    if (!outcome.lower || !outcome.upper) continue;
    const double width = *outcome.upper - *outcome.lower;
    if (width >= 0.0) test.widths.add(width);  // not of NaN
  }
  for (const RecoveredNumber& number : study.recovered) {
    auto found = std::find_if(recovered_.begin(), recovered_.end(),
                              [&number](const auto& one) { return one.first == number.name; });
    if (found == recovered_.end()) {
      found = recovered_.emplace(recovered_.end(), number.name, EstimateSpread{});
    }
    found->second.add(number.value);
  }
}

PrecisionOf PrecisionStudies::result_of(const PowerCurve& curve) const {
  const TestAtSize& counts = curve.sizes.front();
  const OfTest& test = tests_.at({curve.family, curve.test});
  PrecisionOf result{.family = curve.family,
                     .name = curve.test,
                     .measure = test.measure,
                     .figures = {{.what = PrecisionFigure::What::power,
                                  .value = counts.power.power,
                                  .interval = counts.power.interval}},
                     .statuses = curve.statuses,
                     .without_p = counts.without_p};
  if (test.widths.count() > 0) {
    result.figures.push_back(
        quantile_figure(PrecisionFigure::What::median_width, test.widths, 0.5));
    result.figures.push_back(quantile_figure(PrecisionFigure::What::p90_width, test.widths, 0.9));
  }
  if (test.estimates.count() > 0) result.figures.push_back(error_figure(test.estimates));
  return result;
}

std::vector<PrecisionOf> PrecisionStudies::results() const {
  const std::vector<PowerCurve> curves = tally_.curves();
  std::vector<PrecisionOf> results{};
  for (const PowerCurve& curve : curves) {
    const auto tests = std::count_if(curves.begin(), curves.end(), [&curve](const auto& other) {
      return other.family == curve.family && !other.test.empty();
    });
    if (!curve.test.empty() || tests > 1) results.push_back(result_of(curve));
  }
  for (const auto& [name, estimates] : recovered_) {
    results.push_back({.name = name, .figures = {error_figure(estimates)}});
  }
  return results;
}

}  // namespace asperity

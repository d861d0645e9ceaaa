// Counts what simulated studies with one number of participants show: power, widths of intervals and standard errors, each with
// its Monte-Carlo error.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "analysis/power/positive_quantiles.h"
#include "app/power/assumption.h"
#include "app/power/curve/power_tally.h"
#include "app/power/power_model.h"

namespace asperity {

/// The names of the assumptions that have to be stated before studies can be simulated.
std::vector<std::string> names_without_value(std::span<const Assumption> assumptions);

/// The assumptions with stated values and `source` in their place. Stated names that the protocol does not have are left out.
std::vector<Assumption> with_stated(std::vector<Assumption> assumptions,
                                    const std::map<std::string, double>& stated,
                                    const std::string& source);

/// The mean and the standard deviation of estimates over simulated studies: the latter is the standard error of one study.
class EstimateSpread final {
 public:
  void add(double estimate);
  std::uint64_t count() const noexcept { return count_; }
  double mean() const noexcept { return mean_; }
  /// With two estimates or more.
  double standard_error() const;
  /// The Monte-Carlo standard error of `standard_error`, √((μ₄ − σ⁴·(n − 3)/(n − 1))/n)/(2σ): by the fourth moment, without an
  /// assumption about the form of the distribution.
  double error_of_standard_error() const;

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0;
  double second_ = 0.0;  ///< sums of powers of the deviations from the mean
  double third_ = 0.0;
  double fourth_ = 0.0;
};

/// The 95 % Monte-Carlo interval of a quantile, whatever the distribution: the numbers whose ranks are 1.96 standard deviations of
/// a binomial number from p·n, rounded outwards. Nothing where a rank is beyond the first or the last number.
std::optional<ConfidenceInterval> interval_of_quantile(const PositiveQuantiles& numbers, double p);

/// One figure of precision. A value has a Monte-Carlo interval; without one there is neither.
struct PrecisionFigure {
  enum class What { power, median_width, p90_width, standard_error };
  What what = What::power;
  std::optional<double> value{};
  std::optional<ConfidenceInterval> interval{};  ///< 95 %
};

/// The figures of one test, of a family of several tests, or of a number of the response tables.
struct PrecisionOf {
  std::string family{};   ///< empty of a number of the response tables
  std::string name{};     ///< of the test with its subject, or of the assumption; empty of a family
  std::string measure{};  ///< SimulatedOutcome::measure
  std::vector<PrecisionFigure> figures{};
  std::vector<std::string> statuses{};  ///< why analyses gave no p
  std::uint64_t without_p = 0;          ///< studies whose analysis gave no p
};

/// Simulated studies of a protocol, and their figures. A copy is independent of the other.
class PrecisionStudies final {
 public:
  /// Errors: std::invalid_argument for fewer than one participant.
  PrecisionStudies(PowerModel model, int participants, std::uint64_t seed);

  /// Simulates the next `count` studies, runs 0, 1, … of the seed. After each of them `is_over` ends the simulation early.
  /// Deterministic: the figures depend on the model, the participants, the seed and the number of studies.
  void simulate(std::int64_t count, const std::function<bool()>& is_over);
  std::int64_t studies() const noexcept { return studies_; }

  /// Tests in the order of the analysis, then numbers of the response tables. A family with a single test has no row. Figures with
  /// fewer than 10 numbers, standard errors with fewer than 50, have no value; those that no study has are left out.
  std::vector<PrecisionOf> results() const;

 private:
  using Test = std::pair<std::string, std::string>;  // family and test
  struct OfTest {
    std::string measure{};
    PositiveQuantiles widths{};
    EstimateSpread estimates{};
  };

  void add(const SimulatedStudyResults& study);
  PrecisionOf result_of(const PowerCurve& curve) const;

  PowerModel model_;
  int participants_ = 0;
  std::uint64_t seed_ = 1;
  std::int64_t studies_ = 0;
  PowerTally tally_;
  std::map<Test, OfTest> tests_{};
  std::vector<std::pair<std::string, EstimateSpread>> recovered_{};  ///< in the order of appearance
};

}  // namespace asperity

// Counts the significant studies of every test, effect and number of participants.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/power/positive_quantiles.h"
#include "analysis/power/smallest_sample.h"
#include "app/power/curve/power_order.h"
#include "app/power/simulated_run.h"

namespace asperity {

/// Of one test with one number of participants.
struct TestAtSize {
  PowerOfSize power{};  ///< of all studies: one without a p is not significant
  std::uint64_t studies = 0;
  std::uint64_t significant = 0;
  std::uint64_t without_p = 0;  ///< the analysis gave a status
  /// Of the confidence interval of the effect, over the studies that have one; nothing without any.
  std::optional<double> median_width{};
  std::optional<double> p90_width{};
};

/// The power of a test, or of the tests of a family together, over the numbers of participants.
struct PowerCurve {
  std::string effect{};
  std::string family{};
  std::string test{};  ///< empty: at least one test of the family is significant
  /// Codes of the statistical tests that the analyses made (TestMethod::code), sorted: one, unless the analysis depends on the
  /// responses; none of a family, and where no analysis made one.
  std::vector<std::string> methods{};
  /// Why analyses gave no p (SimulatedOutcome::status), sorted; empty where all gave one.
  std::vector<std::string> statuses{};
  std::vector<TestAtSize> sizes{};
};

/// Whether a study is significant: its p is below StudyTest::kLevel after the correction of the family; without a correction
/// the p itself.
bool is_significant(const SimulatedOutcome& outcome) noexcept;

/// Memory: a count and the quantiles of widths for each test, effect and number of participants, whatever the number of runs.
class PowerTally final {
 public:
  explicit PowerTally(PowerOrder order);

  /// Studies by ascending place: tests are listed in the order in which they appear first.
  void add(const StudyPlace& place, std::span<const SimulatedOutcome> outcomes);

  /// By effect, then test; a size without studies is left out, and an effect without any. A row that stands in some studies in place of
  /// several tests of one name, because none of them could be made, has no curve.
  std::vector<PowerCurve> curves() const;

 private:
  struct Counts {
    std::uint64_t significant = 0;
    std::uint64_t with_p = 0;
    PositiveQuantiles widths{};
  };
  using Test = std::pair<std::string, std::string>;  // family and test

  std::size_t test_of(const SimulatedOutcome& outcome);
  /// Whether it only states that "peaks" could not be made in some studies, where others have "peaks smooth|rough": it is not a
  /// further test, and these studies count for each of those as studies without a p.
  bool is_without_subjects(std::size_t test) const;

  PowerOrder order_;
  std::map<Test, std::size_t> places_{};
  std::vector<Test> tests_{};
  std::vector<std::uint64_t> studies_{};          ///< by effect and size
  std::vector<std::vector<Counts>> counts_{};     ///< by test; by effect and size
  std::vector<std::set<std::string>> methods_{};  ///< by test
  std::map<std::pair<std::size_t, std::size_t>, std::set<std::string>>
      statuses_{};  ///< by test and effect, of studies without a p
};

}  // namespace asperity

// Every reference case of our own, through the same way as `analyze --case`.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "app/findings/tidy/reference_case.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/tables/table.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using Name = std::pair<std::string, std::string>;  // quantity, key

std::filesystem::path all_cases() {
  return std::filesystem::path(ASPERITY_SOURCE_DIR) / "tests/analysis/reference";
}

std::vector<std::string> cases() {
  std::vector<std::string> folders{};
  for (const auto& entry : std::filesystem::directory_iterator(all_cases())) {
    if (std::filesystem::exists(entry.path() / "case.json"))
      folders.push_back(entry.path().filename());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// What `case_csv_of` wrote; NA stands for a missing cell as well.
std::map<Name, std::string> results_in(const std::string& text) {
  const TidyTable table(text, "results");
  const auto quantities = table.texts("quantity");
  const auto keys = table.texts("key");
  const auto values = table.texts("value");
  std::map<Name, std::string> results{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string value = values[row].empty() ? "NA" : std::string(values[row]);
    const bool first = results.emplace(Name{quantities[row], keys[row]}, value).second;
    EXPECT_TRUE(first) << quantities[row] << ' ' << keys[row] << " occurs twice";
  }
  return results;
}

class ReferenceCases : public testing::TestWithParam<std::string> {};

TEST_P(ReferenceCases, GiveTheNumbersOfR) {
  const std::filesystem::path folder = all_cases() / GetParam();
  const ReferenceCase read = read_reference_case(folder);
  const std::map<Name, std::string> got =
      results_in(case_csv_of(tidy_family(read.family).findings(read.input)));
  const TidyTable expected(read_file(folder / "expected.csv"), "expected.csv");
  const auto quantities = expected.texts("quantity");
  const auto keys = expected.texts("key");
  const auto values = expected.texts("value");
  const auto relative = expected.all_numbers("rtol");
  const auto absolute = expected.texts("atol");  // smaller than what can be analysed
  ASSERT_GT(expected.rows(), 0U);
  for (std::size_t row = 0; row < expected.rows(); ++row) {
    const std::string value = values[row].empty() ? "NA" : std::string(values[row]);
    const auto found = got.find({std::string(quantities[row]), std::string(keys[row])});
    if (found == got.end()) {
      ADD_FAILURE() << quantities[row] << ' ' << keys[row] << " is missing";
      continue;
    }
    const std::optional<double> is = number_in(found->second);
    const std::optional<double> should_be = number_in(value);
    if (is && should_be && std::isfinite(*should_be)) {
      EXPECT_NEAR(*is, *should_be,
                  std::max(number_in(absolute[row]).value(), relative[row] * std::abs(*should_be)))
          << quantities[row] << ' ' << keys[row];
    } else {
      EXPECT_EQ(found->second, value) << quantities[row] << ' ' << keys[row];
    }
  }
}

// An interval is about the number next to it.
TEST_P(ReferenceCases, HaveNoIntervalThatExcludesItsEstimate) {
  const ReferenceCase read = read_reference_case(all_cases() / GetParam());
  for (const Finding& finding : tidy_family(read.family).findings(read.input)) {
    if (!finding.value || !finding.low || !finding.high) continue;
    const double rounding = 1e-9 * std::max(1.0, std::abs(*finding.value));
    EXPECT_LE(*finding.low, *finding.value + rounding) << finding.quantity << ' ' << finding.key;
    EXPECT_GE(*finding.high, *finding.value - rounding) << finding.quantity << ' ' << finding.key;
  }
}

// Ten items on eight scales by seven participants, whose deviations make the first proportion of every bootstrap draw too small.
TEST(Components, HaveNoIntervalThatExcludesItsEstimate) {
  Random random(61);
  std::array<double, 10> common{};
  for (double& one : common) one = random.normal();
  std::string rows = "subject,item,scale,score\n";
  for (int person = 0; person < 7; ++person) {
    for (std::size_t item = 0; item < common.size(); ++item) {
      for (int scale = 0; scale < 8; ++scale) {
        rows += std::to_string(person) + ',' + std::to_string(item) + ',' + std::to_string(scale) +
                ',' + number_text(common[item] + random.normal()) + '\n';
      }
    }
  }
  TidyInput input{};
  input.tables.emplace_back(rows, "scores.csv");
  std::size_t intervals = 0;
  for (const Finding& finding : components_findings(input)) {
    if (!finding.low || !finding.high) continue;
    ++intervals;
    EXPECT_LE(*finding.low, finding.value.value()) << finding.quantity << ' ' << finding.key;
    EXPECT_GE(*finding.high, finding.value.value()) << finding.quantity << ' ' << finding.key;
  }
  EXPECT_EQ(intervals, 2U);
}

INSTANTIATE_TEST_SUITE_P(All, ReferenceCases, testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param; });

TEST(ReferenceCase, NamesTheFamiliesThatThereAreForAnUnknownOne) {
  EXPECT_THAT(refusal_of<std::runtime_error>([] { tidy_family("telepathy"); }),
              testing::AllOf(testing::StartsWith(
                                 "there is no family of analyses \"telepathy\"; choose one of: "),
                             testing::HasSubstr("proportion")));
}

TEST(ReferenceCase, WritesWordsInThePlaceOfNumbersAndQuotesNames) {
  Finding number{};
  number.quantity = "p";
  number.key = "a,b";
  number.value = 0.1;
  Finding word{};
  word.quantity = "d";
  word.word = "-Inf";
  const std::vector<Finding> findings{number, word};
  EXPECT_EQ(case_csv_of(findings), "quantity,key,value\np,\"a,b\",0.1\nd,,-Inf\n");
}

}  // namespace
}  // namespace asperity

// Magnitude estimations: peaks, exponents and their tests.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/chapter_studies.h"

namespace asperity {
namespace {

using testing::HasSubstr;

constexpr std::array<double, 5> kSpacings_m{0.0005, 0.001, 0.002, 0.004, 0.008};
constexpr const char* kEstimation = R"({
  "estimation": {"spacing": "texture", "condition": "tip"},
  "factors": {"texture": {"levels": ["s1", "s2", "s3", "s4", "s5"]}, "tip": {"levels": ["small", "large"]}},
  "textures": {"s1": {"spacing_m": 0.0005}, "s2": {"spacing_m": 0.001}, "s3": {"spacing_m": 0.002},
               "s4": {"spacing_m": 0.004}, "s5": {"spacing_m": 0.008}},
  "analysis": {"family": ["spacing", "interaction", "peaks"]}
})";

/// `log_of`: the decimal logarithm of the number that a person gives to a level under a tip.
AnalysisOutcome analyze_logarithms(
    int people, const std::function<double(int person, std::size_t level, bool is_small)>& log_of) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("rough", "magnitude", kEstimation);
  for (int i = 0; i < people; ++i) {
    made.add_person(person(i), "F");
    std::vector<MadeUpTrial> trials{};
    for (const std::string tip : {"small", "large"}) {
      for (int level = -1; level < 5; ++level) {  // −1: the anchor
        const std::size_t at = level < 0 ? 2U : static_cast<std::size_t>(level);
        const double number = std::pow(10.0, log_of(i, at, tip == "small"));
        MadeUpTrial trial{};
        trial.surfaces = {surface_of("s", "pd_gradient", "s")};
        trial.factors_json =
            R"({"texture": "s)" + std::to_string(at + 1) + R"(", "tip": ")" + tip + "\"}";
        trial.answers = {text_of_number(level < 0 ? 1e6 : number)};
        trial.repetition = level < 0 ? 0 : 1;
        trials.push_back(trial);
      }
    }
    made.add_session(person(i), protocol, trials);
  }
  return analyze_study(made.study()).at(0);
}

/// Numbers on parabolas of the logarithms, roughest at 1 mm with the small tip and at 2 mm with the
/// large one, a little more or less for each of six people, who all have a scale of their own.
AnalysisOutcome analyze_numbers(int people = 6, double disagreement = 1.0) {
  return analyze_logarithms(people, [disagreement](int i, std::size_t level, bool is_small) {
    // The other way with the other tip, and half as far: people differ in how the tips differ and in
    // the curve over both.
    const double own = disagreement * (is_small ? 0.02 : -0.01) * (i - 2.5);
    const double away = std::log10(kSpacings_m.at(level) / (is_small ? 0.001 : 0.002)) - own;
    return 0.3 * i - away * away;
  });
}

TEST(Magnitudes, PeakWhereTheyWereMadeToPeak) {
  const AnalysisOutcome outcome = analyze_numbers();
  EXPECT_EQ(outcome.answers, 60U);
  EXPECT_EQ(outcome.count.anchors, 12U);
  EXPECT_EQ(outcome.count.planned_trials, 60U);
  const Table& peaks = table_of(outcome, "peaks").table;
  const auto peak_m = [&peaks](const char* tip) {
    return std::get<double>(row_of(peaks, {tip})[2]);
  };
  EXPECT_NEAR(peak_m("small"), 0.001, 1e-9);
  EXPECT_NEAR(peak_m("large"), 0.002, 1e-9);
  EXPECT_EQ(row_of(peaks, {"small"})[1], Cell{});
  EXPECT_EQ(row_of(peaks, {"small"})[9], Cell{std::int64_t{6}});  // inverted U, for everybody
  const auto asked = std::find_if(outcome.questions.begin(), outcome.questions.end(),
                                  [](const AnsweredQuestion& one) { return one.name == "peaks"; });
  ASSERT_NE(asked, outcome.questions.end());
  EXPECT_EQ(asked->table, "peaks");
  EXPECT_EQ(question_of(outcome, "peak_ratios").table, "peak_ratios");
  EXPECT_THAT(asked->answer, says("Peaks of the curves: small at 1 mm (95 % CI "));
  EXPECT_THAT(asked->answer,
              says("test for an interior maximum p < .001; R² of the mean parabola 1.00"));
  const std::string text = estimate_sentence(outcome).text;
  EXPECT_THAT(text, HasSubstr("at 1 mm, 95 % CI ["));
  EXPECT_THAT(text, HasSubstr("(small)"));
  EXPECT_THAT(text, HasSubstr("these curves are not power functions."));
  EXPECT_THAT(text, testing::Not(HasSubstr("exponent")));
}

TEST(Magnitudes, LoseEachParticipantsScaleAndKeepTheRawNumbersBeside) {
  const AnalysisOutcome outcome = analyze_numbers();
  const Table& estimates = table_of(outcome, "estimates").table;
  ASSERT_EQ(estimates.rows.size(), 60U);
  // Whoever says numbers 10^0.3 times as large: the same shape, but for a peak a little elsewhere.
  const std::vector<Cell>& first = row_of(estimates, {person(0), "small"});
  const std::vector<Cell>& second = row_of(estimates, {person(1), "small"});
  EXPECT_NEAR(std::get<double>(second[4]) / std::get<double>(first[4]), std::pow(10.0, 0.3), 0.15);
  EXPECT_NEAR(std::get<double>(second[5]) / std::get<double>(first[5]), 1.0, 0.08);
  EXPECT_EQ(table_of(outcome, "roughness").table.rows.size(), 10U);
}

// With the large tip the parabola of the means has its maximum near the smallest spacing (0.3 decades below 1 mm), and
// three people's slopes there do not differ significantly from 0.
TEST(Magnitudes, ReportNoMaximumThatTheTestOfAnInteriorOneDoesNotShow) {
  const AnalysisOutcome outcome =
      analyze_logarithms(3, [](int i, std::size_t level, bool is_small) {
        const double x = std::log10(kSpacings_m.at(level) / 0.001);
        const double away = x - 0.05 * (i - 1) + (is_small ? 0.0 : 0.25);
        return -away * away;
      });
  const Table& peaks = table_of(outcome, "peaks").table;
  EXPECT_EQ(row_of(peaks, {"large"})[1], Cell{"no_interior_maximum"});
  EXPECT_EQ(row_of(peaks, {"large"})[2], Cell{});
  EXPECT_GT(number(peaks, {"large"}, "p_interior"), 0.05);
  EXPECT_GT(number(peaks, {"large"}, "r_squared"), 0.9);
  EXPECT_THAT(question_of(outcome, "peaks").answer.english(),
              HasSubstr("large without a significant interior maximum (p = "));
  EXPECT_THAT(table_of(outcome, "tests").table.rows.back().back(),
              Cell{"at least one condition has no interior maximum"});
}

// The parabola of the large tip opens upwards, so that it has no peak and the peaks have no ratio. The pair remains in the family:
// which curves have a maximum must not determine how many tests are corrected together.
TEST(Magnitudes, KeepAPairWithoutAPeakInTheFamily) {
  const AnalysisOutcome outcome =
      analyze_logarithms(4, [](int i, std::size_t level, bool is_small) {
        const double away = std::log10(kSpacings_m.at(level) / 0.002) - 0.02 * (i - 1.5);
        return (is_small ? -1.0 : 1.0) * away * away;
      });
  const Table& tests = table_of(outcome, "tests").table;
  EXPECT_EQ(cell_named(tests, {"peaks"}, "first"), Cell{"small"});
  EXPECT_EQ(cell_named(tests, {"peaks"}, "second"), Cell{"large"});
  EXPECT_EQ(cell_named(tests, {"peaks"}, "status"),
            Cell{"at least one condition has no interior maximum"});
}

// Their peaks are 0.15 decades apart, which t of one degree of freedom makes an interval of nearly two:
// wider than the spacings.
TEST(Magnitudes, OfTwoPeopleAreTooFewToSayWhereItPeaks) {
  const AnalysisOutcome outcome = analyze_numbers(2, 15.0);
  const std::vector<Cell>& peak = row_of(table_of(outcome, "peaks").table, {"large"});
  EXPECT_EQ(peak[1], Cell{"too_few_to_say"});
  EXPECT_EQ(peak[2], Cell{});
  EXPECT_EQ(peak[3], Cell{});
  const auto asked = std::find_if(outcome.questions.begin(), outcome.questions.end(),
                                  [](const AnsweredQuestion& one) { return one.name == "peaks"; });
  ASSERT_NE(asked, outcome.questions.end());
  EXPECT_THAT(asked->answer, says("large cannot be determined, because with 2 participants"));
}

// Neither by name nor as anybody met them.
TEST(Magnitudes, StandInTheOrderOfConditionsThatTheProtocolLists) {
  const AnalysisOutcome outcome = analyze_numbers();
  const Table& roughness = table_of(outcome, "roughness").table;
  ASSERT_EQ(roughness.rows.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(roughness.rows[i][0], Cell{i < 5 ? "small" : "large"});
  }
  EXPECT_EQ(table_of(outcome, "peaks").table.rows.at(0)[0], Cell{"small"});
  const std::vector<Cell>& ratio = table_of(outcome, "peak_ratios").table.rows.at(0);
  EXPECT_EQ(ratio[0], Cell{"small"});
  EXPECT_EQ(ratio[1], Cell{"large"});
  const auto curve =
      std::find_if(outcome.findings.begin(), outcome.findings.end(),
                   [](const Finding& finding) { return finding.quantity == "geomean"; });
  ASSERT_NE(curve, outcome.findings.end());
  EXPECT_EQ(curve->key[0], "small");
}

TEST(Magnitudes, AreTestedInTheDeclaredFamily) {
  const AnalysisOutcome outcome = analyze_numbers();
  const Table& tests = table_of(outcome, "tests").table;
  for (const char* name : {"spacing", "interaction"}) {
    EXPECT_LT(number(tests, {name}, "p_holm"), 0.05) << name;
  }
  EXPECT_EQ(cell_named(tests, {"condition"}, "p_holm"), Cell{});
  ASSERT_FALSE(outcome.questions.empty());
  EXPECT_EQ(outcome.questions[0].name, "spacing");
  // Degrees of freedom, size and direction beside F: a reader of the sentence needs no table.
  EXPECT_THAT(outcome.questions[0].answer.english(),
              testing::ContainsRegex("Yes: F\\([0-9.]+, [0-9.]+\\) = [0-9.]+, ε = [01]?\\.[0-9]+, "
                                     "partial η² = [01]?\\.[0-9]+, p .*; .* mm was roughest and .* "
                                     "mm least rough .ratio of geometric means: [0-9.]+.\\."));
  EXPECT_THAT(question_of(outcome, "condition").answer.english(),
              testing::ContainsRegex("F\\(1, [0-9]+\\) = .*; .* was rougher than .* by a factor of "
                                     "[0-9.]+ \\(95 % CI \\[[0-9.]+, [0-9.]+\\]\\)\\."));
  EXPECT_THAT(outcome.remarks, testing::Contains(says("Estimates of anchors")));
}

// Five people who disagree wholly about five spacings, but for a hundredth of a decade from one to the
// next: the last one is the greatest in the mean, and that says nothing.
TEST(Magnitudes, HaveNoRoughestSpacingWhereTheTestShowsNone) {
  const AnalysisOutcome outcome =
      analyze_logarithms(5, [](int i, std::size_t level, bool is_small) {
        const int place = i + static_cast<int>(level) * (is_small ? 1 : 2);
        return 0.1 * (place % 5) + 0.01 * static_cast<double>(level) + (is_small ? 0.02 : 0.0);
      });
  const std::string said = question_of(outcome, "spacing").answer.english();
  // p is that of the corrected degrees of freedom, which therefore stand with F.
  const Table& tests = table_of(outcome, "tests").table;
  const double epsilon = number(tests, {"spacing"}, "epsilon");
  EXPECT_LT(epsilon, 1.0);
  EXPECT_EQ(number(tests, {"spacing"}, "df1"), 4.0);
  EXPECT_THAT(said, testing::StartsWith("Not significantly: F(" + fixed(4.0 * epsilon, 2) + ", " +
                                        fixed(16.0 * epsilon, 2) + ") = "));
  EXPECT_THAT(said, HasSubstr(", ε = " + display_bounded(epsilon) + ", "));
  EXPECT_THAT(said, testing::Not(HasSubstr("rough")));
}

}  // namespace
}  // namespace asperity

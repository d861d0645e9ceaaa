// The table of tests: every kind of study fills it, and its numbers can be worked out on paper.

#include "app/findings/outcome/study_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/test_methods.h"
#include "app/report/text/report_sexes.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using testing::HasSubstr;

const StoredTable& tests_of(const AnalysisOutcome& outcome) {
  return table_of(outcome, StudyTests::kTable);
}

/// A row by its test and what it is about.
struct TestedRow {
  const Table& table;
  const std::vector<Cell>& cells;

  const Cell& operator[](const std::string& column) const {
    return cells.at(column_of(table, column).value());
  }
  double number(const std::string& column) const { return number_of((*this)[column]).value(); }
  std::string text(const std::string& column) const {
    return std::get<std::string>((*this)[column]);
  }
};

TestedRow row_of(const Table& table, const std::string& test, const TestSubject& about = {}) {
  for (const std::vector<Cell>& row : table.rows) {
    const TestedRow found{.table = table, .cells = row};
    if (!column_of(table, "about")) {  // as it is shown
      if (found["test"] == Cell{words_of_test(test, about).english()}) return found;
      continue;
    }
    const auto has = [&found](const char* column, const std::string& name) {
      return found[column] == (name.empty() ? Cell{} : Cell{name});
    };
    if (has("test", test) && has("about", about.of) && has("first", about.first) &&
        has("second", about.second)) {
      return found;
    }
  }
  throw std::runtime_error("no test " + test);
}

MadeUpTrial choice(const std::vector<std::string>& offered, const std::string& chosen,
                   const std::string& texture) {
  MadeUpTrial trial{};
  for (const std::string& model : offered) {
    trial.surfaces.push_back(surface_of(model, model, texture));
  }
  trial.answers = {chosen};
  trial.options = offered;
  return trial;
}

MadeUpTrial recognition_of(const std::string& felt, const std::string& answer) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(felt, "height_map", felt)};
  trial.answers = {answer};
  trial.right = {felt};
  trial.options = {"brick", "metal", "stone", "wood"};
  return trial;
}

MadeUpTrial matching_of(const std::vector<std::string>& answers) {
  MadeUpTrial trial{};
  trial.right = {"brick", "metal", "stone", "wood"};
  for (const std::string& felt : trial.right) {
    trial.surfaces.push_back(surface_of(felt, "height_map", felt));
  }
  trial.answers = answers;
  trial.options = trial.right;
  return trial;
}

MadeUpTrial estimate_of(const std::string& texture, const std::string& tip, double number) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("s", "pd_gradient", "s")};
  trial.factors_json = R"({"texture": ")" + texture + R"(", "tip": ")" + tip + "\"}";
  trial.answers = {std::to_string(number)};
  trial.number = number;
  return trial;
}

/// Women first.
AnalysisOutcome tested(const std::string& kind, const std::string& source, int people,
                       const TrialsOfParticipant& trials_of) {
  return analysed(kind, source, {.number = people, .first = 0, .of_both = true}, trials_of);
}

/// Six people choose between two models, four times each: 4, 4, 3, 3, 2 and 4 times the first.
AnalysisOutcome selection_of_six() {
  constexpr std::array kFirsts{4, 4, 3, 3, 2, 4};
  return tested(
      "selection", R"({"analysis": {"target": "new", "family": ["target_pairs"]}})", 6, [&](int i) {
        std::vector<MadeUpTrial> trials{};
        for (int trial = 0; trial < 4; ++trial) {
          const bool is_new = trial < kFirsts.at(static_cast<std::size_t>(i));
          trials.push_back(
              choice({"new", "old"}, is_new ? "new" : "old", trial % 2 == 0 ? "wood" : "metal"));
        }
        return trials;
      });
}

/// Each pair of three models in both orders; participants with even numbers prefer the first of each.
AnalysisOutcome paired_selection_of_four() {
  return tested("selection", "{}", 4, [](int i) {
    std::vector<MadeUpTrial> trials{};
    for (const auto& [a, b] : {std::pair{"a", "b"}, std::pair{"a", "c"}, std::pair{"b", "c"}}) {
      const std::string chosen = i % 2 == 0 ? a : b;
      trials.push_back(choice({a, b}, chosen, "wood"));
      trials.push_back(choice({b, a}, chosen, "wood"));
    }
    return trials;
  });
}

/// Three people recognise 4, 3 and 3 of four textures.
AnalysisOutcome recognition_of_three() {
  return tested("recognition", "{}", 3, [](int i) {
    return std::vector{recognition_of("brick", "brick"), recognition_of("metal", "metal"),
                       recognition_of("stone", "stone"),
                       recognition_of("wood", i == 0 ? "wood" : "stone")};
  });
}

/// Four people match four textures twice: all right, then two.
AnalysisOutcome matching_of_four() {
  return tested("matching", "{}", 4, [](int i) {
    std::vector<MadeUpTrial> trials{matching_of({"brick", "metal", "stone", "wood"})};
    if (i > 0) trials.push_back(matching_of({"metal", "brick", "stone", "wood"}));
    return trials;
  });
}

AnalysisOutcome magnitude_of_five() {
  constexpr const char* kSource = R"({
    "estimation": {"spacing": "texture", "condition": "tip"},
    "factors": {"texture": {"levels": ["a", "b", "c", "d"]}, "tip": {"levels": ["small", "large"]}},
    "textures": {"a": {"spacing_m": 0.001}, "b": {"spacing_m": 0.002}, "c": {"spacing_m": 0.004},
                 "d": {"spacing_m": 0.008}},
    "analysis": {"family": ["spacing", "peaks"]}})";
  return tested("magnitude", kSource, 5, [](int i) {
    std::vector<MadeUpTrial> trials{};
    const std::vector<std::string> textures{"a", "b", "c", "d"};
    for (const std::string tip : {"small", "large"}) {
      for (std::size_t level = 0; level < textures.size(); ++level) {
        const double from_peak = static_cast<double>(level) - (tip == "small" ? 1.2 : 1.8);
        const double noise = 0.05 * std::sin(3.0 * i + 7.0 * static_cast<double>(level) +
                                             (tip == "small" ? 0.0 : 2.0));
        trials.push_back(estimate_of(textures[level], tip,
                                     std::pow(10.0, 1.0 - 0.1 * from_peak * from_peak + noise)));
      }
    }
    return trials;
  });
}

TEST(TestMethods, HaveOneNameForEachCode) {
  std::set<std::string_view> quantities{};
  for (const TestMethod& method : test_methods()) {
    EXPECT_TRUE(quantities.insert(method.p).second) << method.p;
    EXPECT_EQ(test_method_name(method.code), method.name) << method.p;
    EXPECT_FALSE(method.name.empty()) << method.p;
    EXPECT_FALSE(method.symbol.empty() || method.statistic.empty() || method.unit.empty())
        << method.p;
    EXPECT_EQ(method.effect.empty(), method.effect_symbol.empty()) << method.p;
  }
}

// The sides in a name are those of the test, and no test of a direction is without them.
TEST(TestMethods, NameTheirSides) {
  for (const TestMethod& method : test_methods()) {
    const std::string name = method.name.english();
    const std::string text = text_with_sides(method);
    const bool is_one_sided = method.sides == TestSides::one_sided;
    EXPECT_EQ(name.ends_with("one-sided"), is_one_sided) << method.p;
    EXPECT_EQ(text.ends_with("one-sided"), is_one_sided) << text;
    EXPECT_EQ(text.ends_with("two-sided"), method.sides == TestSides::two_sided) << text;
    EXPECT_EQ(text.ends_with("non-directional"), method.sides == TestSides::undirected) << text;
    EXPECT_EQ(text.find("sided"), text.rfind("sided")) << text;
    // The quantities of directed tests state it.
    if (method.p.ends_with(".p.two")) {
      EXPECT_EQ(method.sides, TestSides::two_sided) << method.p;
    }
    if (method.p.ends_with("greater")) {
      EXPECT_EQ(method.sides, TestSides::one_sided) << method.p;
    }
    EXPECT_EQ(text_with_sides(method.code), text) << method.code;
  }
  EXPECT_EQ(text_with_sides("paired_t"), "paired t test, two-sided");
  EXPECT_EQ(text_with_sides("exponent_t"), "t test of the exponent against 0, two-sided");
  EXPECT_EQ(text_with_sides("rm_anova"), "repeated-measures ANOVA, non-directional");
}

// A stroke separates items in keys, never in what people read.
TEST(TablesOfAStudy, ShowNoStrokesAndNoCodesOfReasons) {
  for (const AnalysisOutcome& outcome :
       {selection_of_six(), paired_selection_of_four(), recognition_of_three(), matching_of_four(),
        magnitude_of_five()}) {
    for (const ResultTable& table : outcome.tables) {
      const DisplayedTable shown = displayed(table, Reader::window);
      for (const std::vector<Phrase>& row : shown.rows) {
        ASSERT_EQ(row.size(), shown.columns.size()) << table.name;
        for (const Phrase& cell : row) {
          EXPECT_THAT(cell.english(), testing::Not(HasSubstr("|"))) << table.name;
          EXPECT_THAT(cell.english(), testing::Not(testing::MatchesRegex("[a-z]+_[a-z_]+")))
              << table.name;
        }
      }
      for (const DisplayedColumn& column : shown.columns) {
        EXPECT_FALSE(column.heading.empty()) << table.name;
      }
    }
  }
}

// What a results section needs, whatever the kind of study: a test with its statistic and its n.
TEST(TestsOfAStudy, NameTheirTestAndStatisticInEveryKind) {
  for (const AnalysisOutcome& outcome :
       {selection_of_six(), paired_selection_of_four(), recognition_of_three(), matching_of_four(),
        magnitude_of_five()}) {
    const Table& tests = tests_of(outcome).table;
    const bool is_declared =
        tests_of(outcome).note.english().find("declares no family") == std::string::npos;
    std::size_t made = 0;
    for (const std::vector<Cell>& cells : tests.rows) {
      const TestedRow row{.table = tests, .cells = cells};
      const std::string name = outcome.kind + ' ' + row.text("test");
      if (row["p"] == Cell{}) {
        EXPECT_FALSE(row.text("status").empty()) << name;
        EXPECT_EQ(row["value"], Cell{}) << name;
        EXPECT_EQ(row["effect"], Cell{}) << name;
        continue;
      }
      ++made;
      EXPECT_EQ(row["status"], Cell{}) << name;
      EXPECT_FALSE(test_method_name(row.text("method")).empty()) << name;
      EXPECT_FALSE(row.text("statistic").empty()) << name;
      EXPECT_TRUE(std::isfinite(row.number("value"))) << name;
      EXPECT_GT(row.number("n"), 0) << name;
      const bool is_confirmatory = is_declared && row["family"] != Cell{};
      EXPECT_EQ(row.text("role"), is_confirmatory ? "confirmatory" : "exploratory") << name;
    }
    EXPECT_GE(made, 2U) << outcome.kind;
  }
}

// Differences 4, 4, 2, 2, 0 and 4: their sum 16, mean 8/3 and variance 8/3. The limits were computed by
// integrating the noncentral t distribution numerically.
TEST(TestsOfAStudy, ReportSignFlipsWithTheirSumAndDz) {
  const AnalysisOutcome outcome = selection_of_six();
  const TestedRow row = row_of(tests_of(outcome).table, "target_pairs", {"new", "old"});
  EXPECT_EQ(row.text("method"), "sign_flip");
  EXPECT_EQ(row.text("statistic"), "D");
  EXPECT_EQ(row.number("value"), 16.0);
  EXPECT_EQ(row["df1"], Cell{});
  EXPECT_EQ(row.text("permutations"), "exact");
  EXPECT_EQ(row.text("effect_size"), "d_z");
  EXPECT_NEAR(row.number("effect"), std::sqrt(8.0 / 3.0), 1e-12);
  EXPECT_NEAR(row.number("effect_low"), 0.339264, 1e-5);
  EXPECT_NEAR(row.number("effect_high"), 2.871810, 1e-5);
  EXPECT_EQ(row.text("role"), "confirmatory");
  EXPECT_EQ(row_of(tests_of(outcome).table, "preference").text("role"), "exploratory");
}

// Proportions 1, 3/4 and 3/4 against 1/4: t = 7 with two degrees of freedom, d = 7/√3.
TEST(TestsOfAStudy, ReportTWithItsDegreesOfFreedomAndD) {
  const AnalysisOutcome outcome = recognition_of_three();
  const TestedRow row = row_of(tests_of(outcome).table, "right");
  EXPECT_EQ(row.text("method"), "one_sample_t");
  EXPECT_NEAR(row.number("value"), 7.0, 1e-12);
  EXPECT_EQ(row.number("df1"), 2.0);
  EXPECT_EQ(row["permutations"], Cell{});
  EXPECT_NEAR(row.number("effect"), 7.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(row.number("effect_low"), 0.379785, 1e-5);
  EXPECT_NEAR(row.number("effect_high"), 7.897525, 1e-5);
}

// Three of three: h is π − 2·asin(1/2), its upper limit the same, its lower that of Wilson, 3/(3 + z²).
TEST(TestsOfAStudy, ReportBinomialTestsWithTheirCountAndH) {
  const AnalysisOutcome outcome = recognition_of_three();
  const TestedRow row = row_of(tests_of(outcome).table, "textures", "brick");
  EXPECT_EQ(row.text("method"), "binomial");
  EXPECT_EQ(row.number("value"), 3.0);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(row.number("effect"), pi - 2.0 * std::asin(0.5), 1e-12);
  constexpr double kZ = 1.959963984540054;
  EXPECT_NEAR(row.number("effect_low"),
              2.0 * std::asin(std::sqrt(3.0 / (3.0 + kZ * kZ))) - 2.0 * std::asin(0.5), 1e-9);
  EXPECT_NEAR(row.number("effect_high"), row.number("effect"), 1e-12);
}

TEST(TestsOfAStudy, AreReadWithStatisticAndEffectInOneCellEach) {
  const AnalysisOutcome outcome = recognition_of_three();
  const Table reading = shown_table(outcome, StudyTests::kTable);
  const TestedRow right = row_of(reading, "right");
  EXPECT_EQ(right.text("statistic"), "t(2) = 7.00");
  EXPECT_THAT(right.text("effect_size"), HasSubstr("d = 4.04 ["));
  EXPECT_EQ(right.text("method"), "one-sample t test");
  EXPECT_EQ(right.text("n"), "3 participants");
  const TestedRow brick = row_of(reading, "textures", "brick");
  EXPECT_EQ(brick.text("statistic"), "k = 3");
  EXPECT_EQ(brick.text("test"), "textures: brick");
  EXPECT_FALSE(column_of(reading, "status"));  // every test was made
  const AnalysisOutcome of_pairs = selection_of_six();
  const Table pairs = shown_table(of_pairs, StudyTests::kTable);
  EXPECT_EQ(row_of(pairs, "target_pairs", {"new", "old"}).text("method"),
            "sign-flip (randomisation) test, exact");
  EXPECT_THAT(tests_of(of_pairs).note.english(),
              HasSubstr("D: difference in the number of choices; d_z: Cohen’s d of paired"));
}

// Two tests of .0625 at least are .125 in a family of two: neither can show anything.
TEST(TestsOfAStudy, CorrectTheSmallestAttainablePAsP) {
  const AnalysisOutcome outcome = tested(
      "selection", R"({"analysis": {"target": "a", "family": ["target_pairs"]}})", 5, [](int) {
        return std::vector{choice({"a", "b", "c"}, "a", "wood"),
                           choice({"a", "b", "c"}, "a", "wood")};
      });
  for (const char* const pair : {"b", "c"}) {
    const TestedRow row = row_of(tests_of(outcome).table, "target_pairs", {"a", pair});
    EXPECT_DOUBLE_EQ(row.number("p"), 0.0625) << pair;
    EXPECT_DOUBLE_EQ(row.number("p_holm"), 0.125) << pair;
    EXPECT_DOUBLE_EQ(row.number("p_smallest"), 0.125) << pair;
  }
}

// An effect size of trials has no interval with one participant, and is named in the note with several.
TEST(TestsOfAStudy, StateWhichEffectSizesTakeTrialsAsIndependent) {
  const AnalysisOutcome four = matching_of_four();
  EXPECT_TRUE(std::holds_alternative<double>(row_of(tests_of(four).table, "items")["effect_low"]));
  EXPECT_THAT(tests_of(four).note.english(),
              HasSubstr("Estimated from trials as if they were independent: θ"));
  const AnalysisOutcome one = tested("matching", "{}", 1, [](int) {
    return std::vector(3, matching_of({"brick", "metal", "wood", "stone"}));
  });
  const TestedRow items = row_of(tests_of(one).table, "items");
  EXPECT_EQ(items.text("effect_size"), "θ");
  EXPECT_EQ(items["effect_low"], Cell{});
}

// A report compares women and men only where the protocol declares it.
TEST(ReportedSexes, AreLeftOutUnlessTheProtocolDeclaresThem) {
  const AnalysisOutcome analysed_all = matching_of_four();
  EXPECT_FALSE(analysed_all.declares_sexes);
  EXPECT_NO_THROW(row_of(tests_of(analysed_all).table, "sexes", {"F", "M"}));
  const AnalysisOutcome left = without_sexes(analysed_all);
  EXPECT_THROW(row_of(tests_of(left).table, "sexes", {"F", "M"}), std::runtime_error);
  EXPECT_NO_THROW(row_of(tests_of(left).table, "items"));
  for (const AnsweredQuestion& question : left.questions) {
    EXPECT_FALSE(question.name.starts_with("sexes")) << question.name;
  }
  for (const Finding& finding : left.findings) {
    EXPECT_FALSE(finding.analysis.starts_with("sexes")) << finding.analysis;
    EXPECT_THAT(finding.key.text(), testing::Not(HasSubstr("Female")));
  }
  std::size_t rows_of_everyone = 0;
  for (const ResultTable& each : left.tables) {
    const StoredTable named = stored(each);
    const std::optional<std::size_t> person = column_of(named.table, "person");
    if (!person) continue;
    for (const std::vector<Cell>& row : named.table.rows) {
      EXPECT_EQ(row[*person], Cell{"Total"}) << named.name;
      ++rows_of_everyone;
    }
  }
  EXPECT_GT(rows_of_everyone, 1U);
}

TEST(ReportedSexes, ComeLastWhereTheProtocolDeclaresThem) {
  const AnalysisOutcome outcome =
      tested("recognition", R"({"analysis": {"family": ["sexes", "right"]}})", 4, [](int i) {
        return std::vector{recognition_of("brick", "brick"),
                           recognition_of("wood", i % 2 == 0 ? "wood" : "stone")};
      });
  EXPECT_TRUE(outcome.declares_sexes);
  ASSERT_GT(outcome.questions.size(), 2U);
  EXPECT_EQ(outcome.questions.rbegin()[1].name, "sexes");
  EXPECT_EQ(outcome.questions.back().name, "sexes_equivalence");
  EXPECT_EQ(std::get<std::string>(tests_of(outcome).table.rows.back()[0]), "sexes");
}

// Of three people one never chose the target, so that nothing of theirs can be exchanged.
TEST(TestsOfAStudy, CountWhoContributesAndWhoIsLeftOut) {
  const AnalysisOutcome outcome =
      tested("selection", R"({"analysis": {"target": "new"}})", 3, [](int i) {
        return std::vector{choice({"new", "old"}, i < 2 ? "new" : "old", "wood"),
                           choice({"new", "old"}, i < 1 ? "new" : "old", "metal")};
      });
  const TestedRow row = row_of(tests_of(outcome).table, "textures");
  EXPECT_EQ(row.number("n"), 2.0);
  EXPECT_EQ(row.number("left_out"), 1.0);
  EXPECT_THAT(tests_of(outcome).note.english(), HasSubstr("not counted in its n: 1 of 3."));
}

// One participant: the p of a permutation test could only be 1. No number is left of it.
TEST(TestsOfAStudy, HaveNoNumbersOfOneParticipant) {
  const AnalysisOutcome outcome = tested("selection", "{}", 1, [](int) {
    return std::vector{choice({"new", "old"}, "new", "wood"),
                       choice({"new", "old"}, "old", "metal")};
  });
  for (const char* const test : {"preference", "position"}) {
    const TestedRow row = row_of(tests_of(outcome).table, test);
    for (const char* const column :
         {"method", "value", "permutations", "effect", "p", "p_smallest"}) {
      EXPECT_EQ(row[column], Cell{}) << test << ' ' << column;
    }
    EXPECT_EQ(row.text("status"), StudyTests::kOneParticipantAlone);
  }
}

TEST(TestsOfAStudy, StateThatNobodyChoseTheTarget) {
  const AnalysisOutcome outcome =
      tested("selection", R"({"analysis": {"target": "new", "family": ["textures"]}})", 3, [](int) {
        return std::vector{choice({"new", "old"}, "old", "wood"),
                           choice({"new", "old"}, "old", "metal")};
      });
  const TestedRow row = row_of(tests_of(outcome).table, "textures");
  EXPECT_EQ(row["p"], Cell{});
  EXPECT_EQ(row.number("n"), 0.0);
  EXPECT_EQ(row.text("status"), "target_never_chosen");
  EXPECT_EQ(words_of_status(row.text("status")).english(), "no participant ever chose the target");
}

}  // namespace
}  // namespace asperity

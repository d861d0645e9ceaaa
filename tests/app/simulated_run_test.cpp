// Studies simulated from response tables: what they depend on, that their tests are those of an analysis, and what they find.

#include "app/power/simulated_run.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/outcome/figures_of.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/study_tests.h"
#include "app/power/power_model.h"
#include "app/power/simulated_study.h"
#include "app/words/text_parts.h"
#include "protocols/file/protocol_reader.h"
#include "tests/app/analysed_study.h"
#include "tests/protocols/protocol_files.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Throws;
using testing::ThrowsMessage;

using StatedValues = std::map<std::string, double>;

Protocol library_protocol(const std::string& name) {
  return read_protocol(test::library_text(name), name, test::models_of_library());
}

/// With these values; effects that are not stated are null, and their standard deviations 0.1.
PowerModel model_of(const Protocol& protocol, const StatedValues& stated) {
  std::vector<Assumption> assumptions = assumptions_of(protocol);
  for (const auto& [name, value] : stated) set_assumption(assumptions, name, value, "the test");
  for (Assumption& assumption : assumptions) {
    if (assumption.value) continue;
    assumption.value = assumption.part == Assumption::Part::effect ? assumption.null_value : 0.1;
    assumption.source = "the test";
  }
  return {protocol, assumptions};
}

PowerModel model_of(const std::string& name, const StatedValues& stated) {
  return model_of(library_protocol(name), stated);
}

/// Of the tests, without the families.
std::vector<double> p_values(const std::vector<SimulatedOutcome>& outcomes) {
  std::vector<double> values{};
  for (const SimulatedOutcome& outcome : outcomes) {
    if (outcome.p) values.push_back(*outcome.p);
  }
  return values;
}

bool is_equal(const SimulatedOutcome& one, const SimulatedOutcome& other) {
  return one.family == other.family && one.test == other.test && one.p == other.p &&
         one.corrected_p == other.corrected_p && one.estimate == other.estimate &&
         one.lower == other.lower && one.upper == other.upper && one.status == other.status;
}

bool are_equal(const std::vector<SimulatedOutcome>& one,
               const std::vector<SimulatedOutcome>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), is_equal);
}

TEST(SimulatedRun, DependsOnSeedAndRunAlone) {
  const PowerModel model =
      model_of("roughness_of_photographs", {{"difference", 8.0}, {"difference_sd", 10.0}});
  const auto alone = simulate_and_analyse(model, 5, 7, 3);
  for (std::int64_t run = 0; run < 3; ++run) simulate_and_analyse(model, 5, 7, run);
  EXPECT_TRUE(are_equal(simulate_and_analyse(model, 5, 7, 3), alone));
  const PowerModel again =
      model_of("roughness_of_photographs", {{"difference", 8.0}, {"difference_sd", 10.0}});
  EXPECT_TRUE(are_equal(simulate_and_analyse(again, 5, 7, 3), alone));
  EXPECT_FALSE(are_equal(simulate_and_analyse(model, 5, 7, 4), alone));
  EXPECT_FALSE(are_equal(simulate_and_analyse(model, 5, 8, 3), alone));
}

// Larger studies have the same first participants.
TEST(SimulatedRun, AddsParticipantsToThoseOfSmallerStudies) {
  const PowerModel model = model_of("roughness_of_photographs", {{"difference_sd", 10.0}});
  const auto of_two = simulated_study(model.tables(), 2, Random(1));
  const auto of_three = simulated_study(model.tables(), 3, Random(1));
  ASSERT_EQ(of_two.size(), 1U);
  ASSERT_GT(of_three.front().replies.size(), of_two.front().replies.size());
  for (std::size_t i = 0; i < of_two.front().replies.size(); ++i) {
    EXPECT_EQ(of_two.front().replies[i].number, of_three.front().replies[i].number);
  }
}

/// Of names with a comma and a space between them.
bool is_sorted_list(const std::string& text) {
  std::vector<std::string> names = parts_of(text, ',');
  for (std::string& name : names) name.erase(0, name.find_first_not_of(' '));
  return std::is_sorted(names.begin(), names.end());
}

// Library protocols of every kind, with their own procedures. Psi, and the scaling of permuted ratings, would take seconds.
TEST(SimulatedRun, AnalysesTheFamilyOfEveryLibraryProtocol) {
  for (const LibraryProtocol& each : library_protocols()) {
    const std::string name(each.name);
    if (name == "map_of_renderings" || name == "map_of_textures" || name == "amplitude_jnd_psi" ||
        name == "softness_jnd") {
      continue;
    }
    SCOPED_TRACE(name);
    const PowerModel model = model_of(name, {});
    const auto outcomes = simulate_and_analyse(model, 4, 1, 0);
    // Without conditions the default family of a design in which no surface is chosen has no test.
    if (name == "amplitude_same_different") {
      EXPECT_TRUE(outcomes.empty());
      continue;
    }
    ASSERT_GE(outcomes.size(), 2U);
    EXPECT_EQ(outcomes.back().test, "");
    for (const SimulatedOutcome& outcome : outcomes) {
      SCOPED_TRACE(outcome.test);
      EXPECT_FALSE(outcome.family.empty());
      EXPECT_TRUE(is_sorted_list(outcome.family)) << outcome.family;
      if (outcome.test.empty()) continue;
      EXPECT_EQ(outcome.p.has_value(), outcome.status.empty());
      EXPECT_EQ(outcome.p.has_value(), outcome.corrected_p.has_value());
      if (!outcome.p) continue;
      EXPECT_GE(*outcome.p, 0.0);
      EXPECT_LE(*outcome.p, *outcome.corrected_p);
      EXPECT_LE(*outcome.corrected_p, 1.0);
    }
  }
}

std::optional<double> cell_number(const StoredTable& table, const std::vector<Cell>& row,
                                  const std::string& column) {
  return number_of(row[column_of(table.table, column).value()]);
}

std::string cell_text(const StoredTable& table, const std::vector<Cell>& row,
                      const std::string& column) {
  const Cell& cell = row[column_of(table.table, column).value()];
  const auto* const text = std::get_if<std::string>(&cell);
  return text == nullptr ? std::string() : *text;
}

/// A figure whose question the outcome does not ask would stand among the further tables.
void expect_asked_questions(const AnalysisOutcome& outcome) {
  std::set<std::string> questions{""};
  for (const AnsweredQuestion& asked : outcome.questions) questions.insert(asked.name);
  for (const Figure& figure : figures_of(outcome)) {
    EXPECT_TRUE(questions.contains(figure.question)) << figure.name << ": " << figure.question;
  }
}

/// The tests of a family have the p values of the complete analysis.
void expect_same_tests(const std::string& name, const StatedValues& stated, int participants) {
  SCOPED_TRACE(name);
  const PowerModel model = model_of(name, stated);
  std::size_t compared = 0;
  for (const GatheredAnswers& gathered : simulated_study(model.tables(), participants, Random(2))) {
    const StudyAnalysis& analysis = *find_analysis(gathered.kind);
    AnalysisOutcome outcome{};
    outcome.kind = gathered.kind;
    analysis.analyze(gathered, outcome);
    expect_asked_questions(outcome);
    const StoredTable& table = table_of(outcome, StudyTests::kTable);
    const std::vector<StudyTest> tests = analysis.test_family(gathered);
    std::size_t next = 0;
    for (const std::vector<Cell>& row : table.table.rows) {
      if (cell_text(table, row, "family").empty()) continue;
      ASSERT_LT(next, tests.size());
      const StudyTest& test = tests[next++];
      EXPECT_EQ(test.name, cell_text(table, row, "test"));
      EXPECT_EQ(test.about,
                (TestSubject{cell_text(table, row, "first"), cell_text(table, row, "second"),
                             cell_text(table, row, "about")}));
      EXPECT_EQ(test.p, cell_number(table, row, "p")) << test.name << ' ' << test.about.text();
      EXPECT_EQ(test.adjusted, cell_number(table, row, "p_holm"));
      ++compared;
    }
    EXPECT_EQ(next, tests.size());
  }
  EXPECT_GT(compared, 0U);
}

TEST(SimulatedRun, HasThePValuesOfTheCompleteAnalysis) {
  expect_same_tests("attributes_of_textures", {{"difference", 1.0}, {"sensitivity", 1.0}}, 5);
  expect_same_tests("improved_matching", {{"sensitivity", 0.5}}, 4);
  expect_same_tests("improved_selection", {{"target", 0.5}, {"target_sd", 0.5}}, 6);
  expect_same_tests("roughness_in_pairs", {{"difference", 0.5}, {"difference_sd", 0.5}}, 5);
  expect_same_tests("roughness_force",
                    {{"exponent", 0.1}, {"curvature", 1.0}, {"condition.peak_ratio", 1.5}}, 6);
}

TEST(SimulatedRun, HasThePValuesOfTheCompleteAnalysisOfStaircases) {
  expect_same_tests("amplitude_jnd", {{"order", 0.5}, {"order_sd", 0.5}}, 3);
}

/// Every test of the family with its p.
void expect_all_found(const std::string& name, const StatedValues& stated) {
  SCOPED_TRACE(name);
  const auto outcomes = simulate_and_analyse(model_of(name, stated), 24, 1, 0);
  for (const SimulatedOutcome& outcome : outcomes) {
    SCOPED_TRACE(outcome.test + outcome.status);
    ASSERT_TRUE(outcome.corrected_p.has_value());
    EXPECT_LT(*outcome.corrected_p, 0.01);
  }
}

TEST(SimulatedRun, FindsHugeEffectsWithManyParticipants) {
  expect_all_found("roughness_of_photographs", {{"difference", 60.0}});
  expect_all_found("improved_recognition", {{"sensitivity", 3.0}});
  expect_all_found("improved_matching", {{"sensitivity", 3.0}});
  expect_all_found("improved_selection", {{"target", 3.0}});
  expect_all_found("roughness_in_pairs", {{"difference", 9.0}});
  expect_all_found("amplitude_jnd", {{"order", 2.0}});
}

TEST(SimulatedRun, FindsAPowerFunctionAndItsDependenceOnTheCondition) {
  const PowerModel model =
      model_of("roughness_force", {{"exponent", 0.8}, {"condition.exponent", 1.0}});
  for (const SimulatedOutcome& outcome : simulate_and_analyse(model, 12, 1, 0)) {
    if (outcome.test != "spacing" && outcome.test != "interaction") continue;
    ASSERT_TRUE(outcome.p.has_value()) << outcome.test << outcome.status;
    EXPECT_LT(*outcome.p, 0.001) << outcome.test;
  }
}

// Friedman's test of four items whose ratings differ between participants and not on average: of 40 studies a binomial number
// has p < .5. Outside 8 to 32 it is with a probability of 10⁻⁴.
TEST(SimulatedRun, SpreadsPWithoutAnEffect) {
  const PowerModel model = model_of("roughness_of_photographs", {{"difference_sd", 15.0}});
  int below_half = 0;
  int significant = 0;
  constexpr int kRuns = 40;
  for (std::int64_t run = 0; run < kRuns; ++run) {
    const std::vector<double> p = p_values(simulate_and_analyse(model, 8, 11, run));
    ASSERT_EQ(p.size(), 1U);
    below_half += p.front() < 0.5 ? 1 : 0;
    significant += p.front() < 0.05 ? 1 : 0;
  }
  EXPECT_GE(below_half, 8);
  EXPECT_LE(below_half, 32);
  EXPECT_LE(significant, 8);
}

TEST(PowerModel, NamesEffectsAndStandardDeviationsWithoutAValue) {
  const Protocol protocol = library_protocol("amplitude_jnd");
  EXPECT_THAT([&protocol] { PowerModel(protocol, assumptions_of(protocol)); },
              ThrowsMessage<std::runtime_error>(AllOf(
                  HasSubstr("comparisons.rougher.order has no value"),
                  HasSubstr("comparisons.rougher.order_sd has no value"), HasSubstr("--effect"))));
}

TEST(PowerModel, RejectsValuesOutOfRange) {
  EXPECT_THAT(
      [] {
        model_of("amplitude_jnd", {{"lapse", 1.5}});
      },
      ThrowsMessage<std::runtime_error>(
          HasSubstr("comparisons.rougher.lapse is 1.5, and must be from 0 to 1")));
  EXPECT_THAT(
      [] {
        model_of("amplitude_jnd", {{"order_sd", -1.0}});
      },
      Throws<std::runtime_error>());
}

TEST(PowerModel, RefusesAPredictorThatIsMeasuredOnRenderedSurfaces) {
  nlohmann::json file = test::library_file("roughness_force");
  file["estimation"] = {{"factor", "texture"}, {"condition", "force"}, {"predictor", "force_N"}};
  file["analysis"]["family"] = {"exponent"};
  const Protocol protocol =
      read_protocol(file.dump(), "roughness_force", test::models_of_library());
  EXPECT_THAT([&] { assumptions_of(protocol); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("\"main\""), HasSubstr("force_N"), HasSubstr("--physics"))));
}

TEST(PowerModel, KeepsStandardDeviationsWithoutEffects) {
  const PowerModel model = model_of("amplitude_jnd", {{"order", 1.0}, {"order_sd", 0.7}}).at_null();
  std::map<std::string, std::optional<double>> values{};
  for (const Assumption& each : model.assumptions()) values[each.name] = each.value;
  EXPECT_EQ(values.at("comparisons.rougher.order"), 0.0);
  EXPECT_EQ(values.at("comparisons.rougher.order_sd"), 0.7);
}

TEST(Assumptions, AreReadAsTheyAreWritten) {
  const TemporaryFolder folder{};
  const std::filesystem::path file = folder / "assumptions.json";
  const Protocol protocol = library_protocol("amplitude_jnd");
  std::vector<Assumption> written = assumptions_of(protocol);
  set_assumption(written, "order", 0.25, "Author 2020, table 2");
  std::ofstream(file) << json_of(written);
  const std::vector<Assumption> read =
      with_assumptions_of_file(assumptions_of(protocol), file.string());
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].name, written[i].name);
    EXPECT_EQ(read[i].value, written[i].value) << read[i].name;
    EXPECT_EQ(read[i].source, written[i].source) << read[i].name;
  }
}

TEST(Assumptions, OfAFileAreNamedWhereTheyAreWrong) {
  const TemporaryFolder folder{};
  const std::filesystem::path file = folder / "assumptions.json";
  const Protocol protocol = library_protocol("amplitude_jnd");
  const auto reading = [&](const std::string& text) {
    std::ofstream(file) << text;
    return [&] { with_assumptions_of_file(assumptions_of(protocol), file.string()); };
  };
  EXPECT_THAT(
      reading(R"([{"name": "ordre", "value": 1, "source": "assumed"}])"),
      ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("entry 1"), HasSubstr("\"ordre\""))));
  EXPECT_THAT(reading(R"([{"name": "order", "value": 1}])"),
              ThrowsMessage<std::runtime_error>(HasSubstr("\"source\"")));
  EXPECT_THAT(reading(R"([{"name": "order", "value": "1", "source": "assumed"}])"),
              ThrowsMessage<std::runtime_error>(HasSubstr("no number")));
  EXPECT_THAT(reading(R"([{"name": "threshold", "value": 1, "unit": "mm", "source": "x"}])"),
              ThrowsMessage<std::runtime_error>(HasSubstr("unit is \"m\"")));
  EXPECT_THAT(reading("{}"), ThrowsMessage<std::runtime_error>(HasSubstr("JSON array")));
}

}  // namespace
}  // namespace asperity

// Selections whose trials present two of several models, and whose counts are equal.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/cell_words.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string answer_of(const AnalysisOutcome& outcome, const std::string& name) {
  return question_of(outcome, name).answer.english();
}

/// Everything that is said: questions with their answers, remarks, notes.
std::string words_of(const AnalysisOutcome& outcome) {
  std::string words{};
  for (const AnsweredQuestion& question : outcome.questions) {
    words += question.question.english() + ' ' + question.answer.english() + '\n';
  }
  words += remarks_of(outcome);
  for (const ResultTable& table : outcome.tables) words += table.note.english() + '\n';
  return words;
}

MadeUpTrial trial_of(const std::vector<std::string>& offered, const std::string& chosen) {
  MadeUpTrial trial{};
  trial.options = offered;
  for (const std::string& model : offered) {
    trial.surfaces.push_back(surface_of(model, model, "wood"));
  }
  trial.answers = {chosen};
  return trial;
}

AnalysisOutcome analysed_selection(int people, const std::string& source,
                                   const TrialsOfParticipant& trials_of) {
  return analysed("selection", source, {.number = people, .first = 100, .sex = "F"}, trials_of);
}

const std::vector<std::string> kFour{"a", "b", "c", "d"};

/// Everybody prefers a to b, both times; of every other pair half of the people prefer the one and half the other.
std::vector<MadeUpTrial> all_pairs_of(int person) {
  std::vector<MadeUpTrial> trials{};
  for (std::size_t i = 0; i < kFour.size(); ++i) {
    for (std::size_t j = i + 1; j < kFour.size(); ++j) {
      const bool first = (i == 0 && j == 1) || person % 2 == 0;
      const std::string& chosen = first ? kFour[i] : kFour[j];
      trials.push_back(trial_of({kFour[i], kFour[j]}, chosen));
      trials.push_back(trial_of({kFour[j], kFour[i]}, chosen));
    }
  }
  return trials;
}

const AnalysisOutcome& all_pairs() {
  static const AnalysisOutcome kOutcome = analysed_selection(10, "{}", all_pairs_of);
  return kOutcome;
}

// Ten people of one mind: 2 of 1024 patterns of signs. Holm over six pairs.
TEST(PairedSelection, TestsEachPairOnTheTrialsThatPresentedBoth) {
  const Table& tests = table_of(all_pairs(), "tests").table;
  const auto cell = [&tests](const std::vector<Cell>& row, const char* column) {
    return row.at(column_of(tests, column).value());
  };
  std::vector<std::string> abouts{};
  for (const std::vector<Cell>& row : tests.rows) {
    if (row[0] != Cell{"pairs"}) continue;
    abouts.push_back(std::get<std::string>(cell(row, "first")) + '|' +
                     std::get<std::string>(cell(row, "second")));
    EXPECT_EQ(cell(row, "n"), Cell{std::int64_t{10}});
    EXPECT_EQ(cell(row, "unit"), Cell{"participants"});
    EXPECT_EQ(cell(row, "family"), Cell{"pairs"});
    const bool is_of_one_mind = abouts.back() == "a|b";
    EXPECT_DOUBLE_EQ(std::get<double>(cell(row, "p")), is_of_one_mind ? 2.0 / 1024.0 : 1.0);
    EXPECT_DOUBLE_EQ(std::get<double>(cell(row, "p_holm")), is_of_one_mind ? 12.0 / 1024.0 : 1.0);
  }
  EXPECT_THAT(abouts, ElementsAre("a|b", "a|c", "a|d", "b|c", "b|d", "c|d"));
  EXPECT_THAT(table_of(all_pairs(), "tests").note.english(),
              HasSubstr("declares no family of tests, so that no test is confirmatory. p, Holm: "
                        "Holm-corrected over the 6 tests of the default family"));
}

// Five models in a fixed order of preference: ten pairs, all of them significant.
TEST(PairedSelection, CountsTheSignificantPairsWhereTheyAreMany) {
  const std::vector<std::string> models{"a", "b", "c", "d", "e"};
  const char* const declared = R"({"analysis": {"family": ["pairs"]}})";
  const AnalysisOutcome outcome = analysed_selection(12, declared, [&models](int person) {
    std::vector<MadeUpTrial> trials{};
    for (std::size_t i = 0; i < models.size(); ++i) {
      for (std::size_t j = i + 1; j < models.size(); ++j) {
        // The last pair is undecided.
        const std::string& chosen = i == 3 && person % 2 == 0 ? models[j] : models[i];
        trials.push_back(trial_of({models[i], models[j]}, chosen));
        trials.push_back(trial_of({models[j], models[i]}, chosen));
      }
    }
    return trials;
  });
  // 2 of 4096 patterns of signs, times ten at first, and nine times for the last of the nine: Holm keeps the order.
  EXPECT_EQ(answer_of(outcome, "pairs"),
            "9 of the 10 pairs differ significantly (largest of these p values, Holm-corrected: "
            ".005); the table of tests contains them. Not significantly different: d / e.");
}

TEST(PairedSelection, AnswersByItsPairsThenItsScaleThenTheOrder) {
  std::vector<std::string> names{};
  for (const AnsweredQuestion& question : all_pairs().questions) names.push_back(question.name);
  EXPECT_THAT(names, ElementsAre("pairs", "preference", "position"));
  EXPECT_EQ(
      answer_of(all_pairs(), "pairs"),
      "Among all pairs, the smallest p is that of a / b (p = .012, Holm-corrected). This test "
      "is exploratory.");
  const std::string confirmatory = answer_of(
      analysed_selection(10, R"({"analysis": {"family": ["pairs"]}})", all_pairs_of), "pairs");
  EXPECT_THAT(confirmatory, StartsWith("Chosen more often: a over b (in 100 % of a participant's "
                                       "choices on average, 95 % CI "));
  EXPECT_THAT(confirmatory, HasSubstr(" %, 100 %]; p = .012, Holm-corrected"));
  EXPECT_THAT(answer_of(all_pairs(), "preference"),
              AllOf(StartsWith("Log-worths, in decreasing order: a "), HasSubstr("95 % CI [")));
  EXPECT_EQ(all_pairs().questions[1].finding.quantity, "bt.ability.sumzero.cluster");
  // Each of the two orders of a pair was chosen from once.
  EXPECT_THAT(answer_of(all_pairs(), "position"),
              HasSubstr("all positions were chosen equally often, each in 50 %"));
}

TEST(PairedSelection, StatesNothingThatOnlyACompleteDesignCouldLack) {
  const std::string words = words_of(all_pairs());
  EXPECT_THAT(words, Not(HasSubstr("no choices in which two models could be compared")));
  EXPECT_THAT(words, Not(HasSubstr("compare nothing")));
  EXPECT_THAT(words, Not(HasSubstr("1/2 of the choices for each model")));
  EXPECT_THAT(words, Not(HasSubstr("single test")));
  EXPECT_EQ(find_table(all_pairs(), "persons"), nullptr);
  const Table& persons = table_of(all_pairs(), "persons_by_pair").table;
  ASSERT_EQ(persons.rows.size(), 6U);
  EXPECT_EQ(persons.rows[0][0], Cell{"a"});
  EXPECT_EQ(persons.rows[0][1], Cell{"b"});
  EXPECT_EQ(persons.rows[0][3], Cell{1.0});
  EXPECT_EQ(persons.rows[1][3], Cell{0.5});
}

// A declared test that needs every model in every trial keeps its place in the family, with the reason.
TEST(PairedSelection, ExplainsADeclaredTestThatItCannotMake) {
  const AnalysisOutcome outcome =
      analysed_selection(2, R"({"analysis": {"family": ["pairs", "preference"]}})", all_pairs_of);
  const StoredTable& tests = table_of(outcome, "tests");
  EXPECT_THAT(tests.note.english(), HasSubstr("over the 7 confirmatory tests"));
  const auto row = std::find_if(tests.table.rows.begin(), tests.table.rows.end(),
                                [](const auto& each) { return each[0] == Cell{"preference"}; });
  ASSERT_NE(row, tests.table.rows.end());
  EXPECT_EQ(row->back(), Cell{"not every model is presented in every trial"});
}

// Of three the third does not matter to the pair: it was chosen, and neither of the two.
TEST(PairedSelection, LeavesOutTheChoiceOfAThirdModel) {
  const AnalysisOutcome outcome = analysed_selection(6, "{}", [](int) {
    return std::vector<MadeUpTrial>{trial_of({"a", "b", "c"}, "a"), trial_of({"a", "b", "d"}, "d"),
                                    trial_of({"b", "c", "d"}, "c")};
  });
  std::map<std::string, double> differences{};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis == "choice" && finding.quantity == "signflip.diff") {
      differences[finding.key.text()] = finding.value.value();
    }
  }
  EXPECT_EQ(differences.at("a|b"), 6.0);
  EXPECT_EQ(differences.at("b|d"), -6.0);
}

TEST(ComparedLevels, AreChosenMoreOftenAndNotPreferred) {
  const AnalysisOutcome outcome =
      analysed_selection(3, R"({"kind": "selection",
      "stimuli": {"a": {"model": "m", "parameters": {"friction": 0.2}}, "b": {"model": "m"}},
      "blocks": {"main": {"presented": [{"stimulus": "a"}, {"stimulus": "b"}]}}})",
                         [](int) {
                           return std::vector<MadeUpTrial>{trial_of({"weak", "strong"}, "strong")};
                         });
  const std::string words = words_of(outcome);
  EXPECT_THAT(words, HasSubstr("Which level of friction is chosen most often?"));
  EXPECT_THAT(words, HasSubstr("do not show whether the levels can be discriminated"));
  EXPECT_THAT(words, Not(HasSubstr("realistic")));
  EXPECT_THAT(words, Not(HasSubstr("preferred")));
  EXPECT_EQ(table_of(outcome, "table_1").title.english(), "Choices (counts)");
}

// What a selection asks is stated in its own words, and neither as realism nor as a preference.
TEST(Selection, StatesTheQuestionThatWasAsked) {
  const AnalysisOutcome outcome =
      analysed_selection(3, R"({"kind": "selection", "blocks": {"only": {"phase": "main",
      "question": {"name": "softest", "prompt": "Which surface was the softest?"}}}})",
                         [](int) {
                           return std::vector<MadeUpTrial>{trial_of({"a", "b", "c"}, "a")};
                         });
  EXPECT_EQ(question_of(outcome, "preference").question.english(),
            "Which rendering is chosen most often? Participants were asked: “Which surface was the "
            "softest?”");
  EXPECT_THAT(words_of(outcome), Not(HasSubstr("realistic")));
}

TEST(SelectionTies, NameAllModelsThatWereChosenMostOften) {
  const std::vector<std::string> three{"a", "b", "c"};
  const AnalysisOutcome outcome = analysed_selection(2, "{}", [&](int person) {
    return std::vector<MadeUpTrial>{trial_of(three, person == 0 ? "c" : "b"),
                                    trial_of(three, person == 0 ? "b" : "c")};
  });
  EXPECT_THAT(answer_of(outcome, "preference"),
              StartsWith("b and c were chosen equally often, and most often: each in 50 % of"));
}

// Each person chooses once at every position: nothing was chosen most often.
TEST(SelectionTies, NameNoPositionWhereAllAreChosenEquallyOften) {
  const AnalysisOutcome outcome = analysed_selection(3, "{}", [](int) {
    return std::vector<MadeUpTrial>{trial_of({"a", "b", "c"}, "a"), trial_of({"b", "a", "c"}, "a"),
                                    trial_of({"b", "c", "a"}, "a")};
  });
  EXPECT_THAT(answer_of(outcome, "position"),
              AllOf(HasSubstr("all positions were chosen equally often, each in 33 %"),
                    Not(HasSubstr("most often"))));
}

// Two people choose what is first in two of three trials. The test decides, and the family holds it.
TEST(SelectionTies, AnswerWhetherThePositionMattersByTheTest) {
  const AnalysisOutcome outcome =
      analysed_selection(2, R"({"analysis": {"family": ["position"]}})", [](int) {
        return std::vector<MadeUpTrial>{trial_of({"a", "b"}, "a"), trial_of({"a", "b"}, "b"),
                                        trial_of({"b", "a"}, "b")};
      });
  EXPECT_THAT(answer_of(outcome, "position"),
              AllOf(StartsWith("The position has no significant effect (p "),
                    HasSubstr("the first position was chosen in 67 % of")));
}

TEST(SelectionTies, NameAllPairsWithTheSmallestP) {
  const AnalysisOutcome outcome = analysed_selection(2, "{}", [](int) { return all_pairs_of(0); });
  EXPECT_THAT(
      answer_of(outcome, "pairs"),
      StartsWith(
          "No pair could differ significantly in these data: the smallest p is shared by 6 pairs "
          "(each p"));
}

// Of 12 participants 8 choose each model once. The p of the other four is at least 2/2⁴ = .125; of six it is 2/2⁶ = .031.
TEST(SelectionTies, StateTheParticipantsWhoseDifferenceIsNotZero) {
  const AnalysisOutcome outcome = analysed_selection(12, "{}", [](int person) {
    return std::vector<MadeUpTrial>{trial_of({"a", "b"}, "a"),
                                    trial_of({"b", "a"}, person < 4 ? "a" : "b")};
  });
  EXPECT_THAT(answer_of(outcome, "pairs"),
              AllOf(StartsWith("a / b do not differ significantly (p = .125"),
                    HasSubstr("the smallest attainable p is .125, so that no result could be "
                              "significant with 4 participants whose difference is not zero; at "
                              "least 6 such participants are required"),
                    HasSubstr("Participants with a difference of zero, who do not affect p: 8 of "
                              "12.")));
  const Table& tests = table_of(outcome, "tests").table;
  const std::size_t method = column_of(tests, "method").value();
  const auto row = std::find_if(tests.rows.begin(), tests.rows.end(), [method](const auto& cells) {
    return cells[method] == Cell(std::string("sign_flip"));
  });
  ASSERT_NE(row, tests.rows.end());
  EXPECT_EQ((*row)[column_of(tests, "n").value()], Cell(std::int64_t{12}));
  EXPECT_EQ((*row)[column_of(tests, "left_out").value()], Cell(std::int64_t{0}));
  EXPECT_THAT(table_of(outcome, "tests").note.english(),
              HasSubstr("do not affect the p of sign-flip tests, although n counts them: "));
}

TEST(SelectionTies, AnswerOfTwoModelsAndOfTheirOnlyPairInTheSingular) {
  const AnalysisOutcome outcome = analysed_selection(2, "{}", [](int person) {
    return std::vector<MadeUpTrial>{trial_of({"a", "b"}, person == 0 ? "a" : "b")};
  });
  EXPECT_THAT(answer_of(outcome, "preference"),
              AllOf(StartsWith("Both were chosen equally often: each in 50 %"),
                    HasSubstr("compared with a chance level of 50 %")));
  EXPECT_THAT(answer_of(outcome, "pairs"), StartsWith("a / b do not differ significantly (p "));
}

constexpr const char* kTargetA = R"({"analysis": {"target": "a"}})";

/// Wood and brick once each; the participant chooses the same model both times.
std::vector<MadeUpTrial> two_textures(const std::string& chosen) {
  std::vector<MadeUpTrial> trials{};
  for (const char* const texture : {"wood", "brick"}) {
    MadeUpTrial trial{};
    trial.options = {"a", "b"};
    for (const std::string& model : trial.options) {
      trial.surfaces.push_back(surface_of(model, model, texture));
    }
    trial.answers = {chosen};
    trials.push_back(trial);
  }
  return trials;
}

TEST(SelectionTextures, AreNotTestedWhereNobodyEverChoseTheTarget) {
  const AnalysisOutcome outcome =
      analysed_selection(2, kTargetA, [](int) { return two_textures("b"); });
  EXPECT_EQ(answer_of(outcome, "textures"), "This cannot be tested: no participant ever chose a.");
}

TEST(SelectionTextures, CountTheParticipantsWhoNeverChoseTheTarget) {
  const AnalysisOutcome outcome = analysed_selection(
      3, kTargetA, [](int person) { return two_textures(person == 0 ? "b" : "a"); });
  EXPECT_THAT(answer_of(outcome, "textures"),
              HasSubstr("Participants who never chose a do not contribute: 1 of 3."));
}

TEST(Pilots, AreAnalysedApart) {
  MadeUpStudy made;
  made.add_person("p", "F");
  made.add_session("p", made.add_protocol("pairs", "selection"), {trial_of({"a", "b"}, "a")},
                   SessionMode::pilot);
  EXPECT_THAT(words_of(analyze_study(made.study()).at(0)),
              HasSubstr("These sessions are pilots: they are analysed separately from sessions of "
                        "mode \"run\"."));
}

constexpr const char* kNobodyFelt = "on a device on which no participant can feel the surfaces";

std::string words_about_device(const std::string& device_json, bool is_virtual) {
  MadeUpStudy made;
  made.set_device(device_json);
  if (is_virtual) {
    made.add_virtual("p", "F");
  } else {
    made.add_person("p", "F");
  }
  made.add_session("p", made.add_protocol("pairs", "selection"), {trial_of({"a", "b"}, "a")});
  return words_of(analyze_study(made.study()).at(0));
}

TEST(UnfeltSessions, AreCountedByTheDeviceThatIsRecorded) {
  const char* const kMouse = R"({"name": "mouse", "actuated_degrees_of_freedom": 0})";
  const char* const kSimulated = R"({"name": "simulated", "actuated_degrees_of_freedom": 3})";
  const char* const kFalcon = R"({"name": "falcon", "actuated_degrees_of_freedom": 3})";
  EXPECT_THAT(words_about_device(kMouse, false), HasSubstr(kNobodyFelt));
  EXPECT_THAT(words_about_device(kSimulated, false), HasSubstr(kNobodyFelt));
  EXPECT_THAT(words_about_device(kFalcon, false), Not(HasSubstr(kNobodyFelt)));
  EXPECT_THAT(words_about_device("{}", false), Not(HasSubstr(kNobodyFelt)));
  EXPECT_THAT(words_about_device(kSimulated, true), Not(HasSubstr(kNobodyFelt)));
}

TEST(WordsOfParameters, HaveNoUnit) {
  EXPECT_EQ(words_of_parameter("amplitude_m"), "amplitude");
  EXPECT_EQ(words_of_parameter("stiffness_N_per_m"), "stiffness");
  EXPECT_EQ(words_of_parameter("wave_speed_m_per_s"), "wave speed");
  EXPECT_EQ(words_of_parameter("youngs_modulus_Pa"), "Young’s modulus");
  EXPECT_EQ(words_of_parameter("coupling_angular_stiffness_N_m_per_rad"),
            "coupling angular stiffness");
  EXPECT_EQ(unit_of_parameter("coupling_angular_damping_N_m_s_per_rad"), "N m s/rad");
  EXPECT_EQ(unit_of_parameter("tool_inertia_kg_m2"), "kg m²");
  EXPECT_EQ(words_of_parameter("model"), "model");
}

TEST(WordsOfConditions, HaveTheUnitsOfTheirNumbers) {
  EXPECT_EQ(words_of_condition("wood"), "wood");
  EXPECT_EQ(words_of_condition("wavelength_m 0.0025"), "wavelength 2.5 mm");
  EXPECT_EQ(words_of_condition("strong, wave_speed_m_per_s 0.1, wavelength_m 0.002525"),
            "strong, wave speed 100 mm/s, wavelength 2.525 mm");
  EXPECT_EQ(words_of_condition("amplitude (wavelength_m 0.0025)"), "amplitude (wavelength 2.5 mm)");
  EXPECT_EQ(words_of_condition("grit 80"), "grit 80");
  EXPECT_EQ(words_of_condition("in_m of 2"), "in_m of 2");
  EXPECT_EQ(words_of_subject({"wavelength_m 0.001", "wavelength_m 0.002"}).english(),
            "wavelength 1 mm / wavelength 2 mm");
  EXPECT_EQ(words_of_condition_or_all("all").english(), "all trials");
}

}  // namespace
}  // namespace asperity

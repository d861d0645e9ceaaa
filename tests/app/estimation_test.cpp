// Magnitude estimates of any stimuli, with free modulus and with a standard: from rows of a study to exponents.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/analysed_study.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A stimulus with its predictor.
struct Planted {
  const char* name = "";
  double predictor = 0.0;
};
constexpr std::array kPlanted{Planted{"brick", 2.0}, Planted{"cork", 4.0}, Planted{"felt", 8.0},
                              Planted{"oak", 16.0}};
constexpr std::array kExponents{0.4, 0.5, 0.6};  // of the participants; the mean is 0.5

std::string protocol_with(const std::string& estimation, const std::string& analysis = "{}") {
  return R"({"kind": "magnitude", "estimation": )" + estimation +
         R"(, "factors": {"surface": {"levels": ["oak", "felt", "cork", "brick"]}},
            "blocks": {"only": {"question": {"name": "size", "prompt": "How strong?"}}},
            "analysis": )" +
         analysis + "}";
}

MadeUpTrial estimate_of(const Planted& stimulus, double number, bool with_standard) {
  MadeUpTrial trial{};
  if (with_standard) trial.surfaces.push_back(surface_of("brick", "height_map", "brick"));
  trial.surfaces.push_back(surface_of(stimulus.name, "height_map", stimulus.name));
  trial.surfaces.back().achieved_texture_force_N = 0.01 * stimulus.predictor;
  trial.factors_json = R"({"surface": ")" + std::string(stimulus.name) + "\"}";
  trial.answers = {std::to_string(number)};
  trial.number = number;
  return trial;
}

/// Estimates c·P^n, with the exponents n and the scales c of three participants.
AnalysisOutcome outcome_of(const std::string& source, const std::array<double, 3>& scales,
                           bool with_standard = false) {
  const auto trials_of = [&](int person) {
    const auto place = static_cast<std::size_t>(person);
    std::vector<MadeUpTrial> trials{};
    for (int repetition = 1; repetition <= 2; ++repetition) {
      for (const Planted& stimulus : kPlanted) {
        trials.push_back(estimate_of(
            stimulus, scales[place] * std::pow(stimulus.predictor / 2.0, kExponents[place]),
            with_standard));
        trials.back().repetition = repetition;
      }
    }
    return trials;
  };
  return analysed("magnitude", source, {.number = 3, .first = 0, .sex = "F"}, trials_of);
}

constexpr std::array kFreeScales{3.0, 40.0, 500.0};
constexpr std::array kSameScale{10.0, 10.0, 10.0};

double exponent_of(const AnalysisOutcome& outcome) {
  return FoundNumbers(outcome.findings).value("exponent.mean", "all").value();
}

const char* const kByValues = R"({"factor": "surface", "predictor": "values",
    "values": {"brick": 2, "cork": 4, "felt": 8, "oak": 16}, "unit": "µm"})";

// The exponents are planted: the mean of 0.4, 0.5 and 0.6 is 0.5, their standard error 0.1/√3, and t(2) = 8.66.
TEST(StimulusEstimates, FindTheExponentOverStatedValues) {
  const AnalysisOutcome outcome = outcome_of(protocol_with(kByValues), kFreeScales);
  const FoundNumbers found(outcome.findings);
  EXPECT_NEAR(exponent_of(outcome), 0.5, 1e-5);
  EXPECT_NEAR(found.value("exponent.t", "all").value(), 0.5 / (0.1 / std::sqrt(3.0)), 1e-3);
  EXPECT_EQ(found.value("exponent.df", "all"), 2.0);
  EXPECT_THAT(question_of(outcome, "exponent").answer.english(),
              HasSubstr("exponent 0.50 (95 % CI [0.25, 0.75]), t(2) = 8.66"));
  EXPECT_THAT(question_of(outcome, "exponent").question.english(), HasSubstr("surface (µm)"));
  const StoredTable& tests = table_of(outcome, StudyTests::kTable);
  EXPECT_EQ(tests.table.rows.at(0).at(0), Cell{std::string("stimuli")});
  EXPECT_EQ(tests.table.rows.at(1).at(0), Cell{std::string("exponent")});
}

// Figures draw lengths in millimetres: the unit is apart from the name.
TEST(StimulusEstimates, KeepTheUnitOfThePredictorApartFromItsName) {
  const AnalysisOutcome outcome =
      outcome_of(protocol_with(R"({"factor": "surface", "predictor": "values", "unit": "m",
          "values": {"brick": 2e-5, "cork": 4e-5, "felt": 8e-5, "oak": 16e-5}})"),
                 kFreeScales);
  EXPECT_THAT(question_of(outcome, "exponent").question.english(), HasSubstr("(surface (m))"));
  EXPECT_EQ(outcome.name_of_predictor.english(), "surface");
  EXPECT_EQ(outcome.unit_of_predictor, "m");
  const Table shown = shown_table(outcome, "stimulus_estimates");
  EXPECT_EQ(shown.rows.back().at(*column_of(shown, "predictor")), Cell{std::string("20 µm")});
  EXPECT_FALSE(column_of(shown, "predictor_unit"));
}

TEST(StimulusEstimates, TakeAMeasuredPropertyAsPredictor) {
  const AnalysisOutcome outcome = outcome_of(
      protocol_with(R"({"factor": "surface", "predictor": "texture_force_N"})"), kFreeScales);
  EXPECT_NEAR(exponent_of(outcome), 0.5, 1e-5);
  EXPECT_NEAR(FoundNumbers(outcome.findings).value("predictor", "oak").value(), 0.16, 1e-12);
  EXPECT_THAT(outcome.name_of_predictor.english(), HasSubstr("texture force"));
}

// The names of parameters and properties are those of programs.
TEST(StimulusEstimates, NameThePredictorInASentenceByWords) {
  const AnalysisOutcome outcome = outcome_of(
      protocol_with(R"({"factor": "surface", "predictor": "texture_force_N"})"), kFreeScales);
  std::string sentences{};
  for (const TestSentence& each : outcome.test_sentences) sentences += each.text + ' ';
  EXPECT_THAT(sentences, HasSubstr("xponent for RMS of the texture force was"));
  EXPECT_EQ(words_of_subject("amplitude_m").english(), "amplitude");
  EXPECT_EQ(words_of_factor("amplitude_m").english(), "amplitude");
}

TEST(StimulusEstimates, StateThatAPropertyWasNotMeasured) {
  const AnalysisOutcome outcome = outcome_of(
      protocol_with(R"({"factor": "surface", "predictor": "speed_m_per_s"})"), kFreeScales);
  EXPECT_EQ(find_table(outcome, "exponents"), nullptr);
  std::string remarks{};
  for (const Phrase& remark : outcome.remarks) remarks += remark.english();
  EXPECT_THAT(remarks,
              HasSubstr("unknown or not above 0 for these stimuli: oak, felt, cork, brick"));
}

TEST(StimulusEstimates, StateThatThePredictorRequiresRecordings) {
  const AnalysisOutcome outcome = outcome_of(
      protocol_with(R"({"factor": "surface", "predictor": "waves_1.25_to_2.5_mm"})"), kFreeScales);
  EXPECT_EQ(find_table(outcome, "exponents"), nullptr);
  std::string remarks{};
  for (const Phrase& remark : outcome.remarks) remarks += remark.english();
  EXPECT_THAT(remarks, HasSubstr("is computed from recordings, and none can be read"));
  EXPECT_THAT(remarks, HasSubstr("\"--recordings all\""));
  EXPECT_THAT(remarks, testing::Not(HasSubstr("for these stimuli"))) << "one cause";
}

TEST(StimulusEstimates, HaveMeansByStimulusWithoutAPredictor) {
  const AnalysisOutcome outcome =
      outcome_of(protocol_with(R"({"factor": "surface"})"), kFreeScales);
  EXPECT_EQ(find_table(outcome, "exponents"), nullptr);
  const StoredTable& means = table_of(outcome, kStimulusEstimates);
  ASSERT_EQ(means.table.rows.size(), 4U);
  EXPECT_EQ(means.table.rows.front().at(1), Cell{std::string("oak")});  // the protocol's order
  // The geometric mean of 3·8^0.4, 40·8^0.5 and 500·8^0.6.
  EXPECT_NEAR(std::get<double>(means.table.rows.front().at(8)),
              std::cbrt(3.0 * 40.0 * 500.0) * std::sqrt(8.0), 1e-3);
  EXPECT_THAT(question_of(outcome, "stimuli").answer.english(), HasSubstr("F("));
}

TEST(StimulusEstimates, AreNotNormalisedWithAStandard) {
  const std::string modulus =
      R"({"factor": "surface", "modulus": {"standard": "brick", "value": 10}})";
  const AnalysisOutcome outcome = outcome_of(protocol_with(modulus), kSameScale, true);
  const FoundNumbers found(outcome.findings);
  EXPECT_NEAR(found.value("norm.estimate", "p0|all|oak").value(), 10.0 * std::pow(8.0, 0.4), 1e-4);
  EXPECT_NEAR(found.value("geomean", "all|brick").value(), 10.0, 1e-9);
  EXPECT_THAT(table_of(outcome, kStimulusEstimates).note.english(),
              HasSubstr("Standard with modulus 10 (brick): the estimates are not normalised"));
}

// Every participant's estimate of the standard becomes 10, whatever number was given for it.
TEST(StimulusEstimates, AreDividedByTheStandardOnRequest) {
  const std::string modulus = R"({"factor": "surface", "normalisation": "standard",
      "modulus": {"standard": "brick", "value": 10}})";
  const AnalysisOutcome outcome = outcome_of(protocol_with(modulus), {8.0, 10.0, 14.0}, true);
  const FoundNumbers found(outcome.findings);
  for (const char* const person : {"p0", "p1", "p2"}) {
    EXPECT_NEAR(found.value("norm.estimate", std::string(person) + "|all|brick").value(), 10.0,
                1e-5);
  }
  EXPECT_NEAR(found.value("geomean", "all|oak").value(), 10.0 * std::sqrt(8.0), 1e-4);
  EXPECT_THAT(table_of(outcome, kStimulusEstimates).note.english(),
              HasSubstr("divided by the geometric mean of that participant's estimates of the "
                        "standard, and multiplied by the modulus"));
}

TEST(StimulusEstimates, StateThatTheStandardWasNotEstimated) {
  std::string source = protocol_with(R"({"factor": "surface", "normalisation": "standard",
      "modulus": {"standard": "slate", "value": 10}})");
  const std::string last = R"("brick"])";
  source.replace(source.find(last), last.size(), R"("brick", "slate"])");
  const AnalysisOutcome outcome = outcome_of(source, kSameScale, true);
  EXPECT_THAT(table_of(outcome, kStimulusEstimates).note.english(),
              HasSubstr("the estimates are not normalised, because there is no estimate"));
  EXPECT_TRUE(std::any_of(outcome.remarks.begin(), outcome.remarks.end(), [](const Phrase& remark) {
    return remark.english().starts_with("The estimates are not normalised by the standard");
  }));
  EXPECT_THAT(outcome.transformation, HasSubstr("They were not normalised"));
}

// With free modulus the participants choose their numbers: no effect size depends on which.
TEST(Estimation, HasEffectSizesThatDoNotDependOnTheModulus) {
  const auto generalised_eta = [](const std::array<double, 3>& scales) {
    const AnalysisOutcome outcome = outcome_of(protocol_with(kByValues), scales);
    return FoundNumbers(outcome.findings).value("ges", "stimulus").value();
  };
  const double same = generalised_eta(kSameScale);
  EXPECT_NEAR(generalised_eta(kFreeScales), same, 1e-6);
  // log₁₀ 2·i·n of stimulus i = 0 … 3 and exponent n: within participants around i = 1.5 the squares of the means are
  // 5·(log₁₀ 2·0.5)² for each of three participants, and those of the rest 5·(log₁₀ 2·0.1)² twice.
  EXPECT_NEAR(same, 3.0 * 0.25 / (3.0 * 0.25 + 2.0 * 0.01), 1e-3);
}

TEST(MagnitudeFamily, AsksForValuesOfThePredictorOfItems) {
  TidyInput input{};
  input.tables.emplace_back(
      "subject,probe,item,spacing,estimate\na,1,x,0.5,2\na,1,y,1,5\nb,1,x,0.5,20\nb,1,y,1,35\n",
      "estimates.csv");
  input.options.set("zero_rule", std::string("exclude"));
  input.options.set("normalisation", std::string("none"));
  const std::vector<Finding> findings = analysis_of("m", "magnitude", std::move(input));
  const Finding* const status = FoundNumbers(findings).find("status");
  ASSERT_NE(status, nullptr);
  EXPECT_THAT(status->status, HasSubstr("three different values of the predictor"));
}

// The same numbers by item and by spacing.
TEST(MagnitudeFamily, HasTheSameCurvesByItemAndBySpacing) {
  const char* const rows =
      "subject,probe,item,spacing,estimate\n"
      "a,1,x,0.5,2\na,1,y,1,5\na,1,z,2,9\nb,1,x,0.5,20\nb,1,y,1,35\nb,1,z,2,70\n";
  const char* const without_items =
      "subject,probe,spacing,estimate\n"
      "a,1,0.5,2\na,1,1,5\na,1,2,9\nb,1,0.5,20\nb,1,1,35\nb,1,2,70\n";
  const auto findings = [](const char* text, const char* normalisation) {
    TidyInput input{};
    input.tables.emplace_back(text, "estimates.csv");
    input.options.set("zero_rule", std::string("exclude"));
    input.options.set("normalisation", std::string(normalisation));
    return analysis_of("m", "magnitude", std::move(input));
  };
  for (const char* const normalisation : {"geomean", "none"}) {
    const std::vector<Finding> by_item = findings(rows, normalisation);
    const std::vector<Finding> by_spacing = findings(without_items, normalisation);
    const FoundNumbers items(by_item);
    const FoundNumbers spacings(by_spacing);
    EXPECT_EQ(items.value("exponent.mean", "1"), spacings.value("exponent.mean", "1"));
    EXPECT_EQ(items.value("geomean", "1|y"), spacings.value("geomean", "1|1"));
    EXPECT_EQ(items.value("norm.estimate", "b|1|z"), spacings.value("norm.estimate", "b|1|2"));
  }
  const std::vector<Finding> raw = findings(rows, "none");
  EXPECT_NEAR(FoundNumbers(raw).value("norm.estimate", "b|1|z").value(), 70.0, 1e-9);
}

/// Three amplitudes, each estimated once after the standard of 0.2 mm with the number 10, or by a line.
std::string amplitudes(const std::string& estimation, const std::string& presented,
                       const std::string& question) {
  return R"({
    "format": "asperity.protocol/1", "kind": "magnitude", "design": "improved", "name": "amplitudes",
    "version": "1.0.0", "title": "Amplitudes",
    "consent": {"version": "1.0", "statement": "I take part of my own free will."},
    "factors": {"amplitude": {"levels": [0.0001, 0.0002, 0.0004], "unit": "m"}},
    "stimuli": {"wave": {"model": "sinusoid", "parameters": {"amplitude_m": {"factor": "amplitude"}}}},
    "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
    "estimation": {"factor": "amplitude", "predictor": "level")" +
         estimation + R"(},
    "blocks": {"main": {"crossed": ["amplitude"], "order": "fixed", "presented": [)" +
         presented + R"({"role": "target", "stimulus": "wave"}],
      "exploration": "short", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {)" +
         question + R"("name": "size", "prompt": "How strong?"}}},
    "flow": [{"run": "main"}]})";
}

class EstimationSession : public ResumableSession {
 protected:
  static double amplitude_of(const Trial& trial) {
    return std::get<double>(trial.factors.at("amplitude"));
  }
};

TEST_F(EstimationSession, PresentsTheStandardInEveryTrialAlsoAfterAnInterruption) {
  begin(amplitudes(R"(, "modulus": {"standard": 0.0002, "value": 10})",
                   R"({"role": "standard", "stimulus": "wave", "with": {"amplitude": 0.0002}}, )",
                   ""));
  person_.at_question = [](int, const Trial& trial) {
    return Reply{.what = only_answer(GivenNumber{10.0 * std::sqrt(amplitude_of(trial) / 0.0002)})};
  };
  EXPECT_EQ(run_attempts(1).state, SessionState::stopped);
  const std::vector<std::string> plan = stored_plan();
  ASSERT_EQ(resume().state, SessionState::completed);
  EXPECT_EQ(stored_plan(), plan);
  ASSERT_EQ(attempts().size(), 3U);
  for (const AttemptRow& attempt : attempts()) {
    ASSERT_EQ(attempt.presentations.size(), 2U);
    EXPECT_EQ(attempt.presentations[0].role, "standard");
    EXPECT_EQ(attempt.presentations[0].item, "standard");
  }
  SessionTest::start("p2", 8);
  ASSERT_EQ(run_attempts().state, SessionState::completed);
  const AnalysisOutcome outcome = analyze_study(*study_).front();
  EXPECT_NEAR(exponent_of(outcome), 0.5, 1e-9);
  EXPECT_NEAR(FoundNumbers(outcome.findings).value("geomean", "all|2e-04").value(), 10.0, 1e-9);
}

TEST_F(EstimationSession, StoresTheLengthsOfLines) {
  begin(amplitudes("", "", R"("line": {"longest": 0.8}, )"));
  const auto draws = [](double per_m) {
    return [per_m](int, const Trial& trial) {
      return Reply{.what = only_answer(
                       DrawnLength{static_cast<int>(std::lround(per_m * amplitude_of(trial)))})};
    };
  };
  person_.at_question = draws(1e6);
  ASSERT_EQ(run_attempts().state, SessionState::completed);
  std::vector<double> lengths{};
  for (const AttemptRow& attempt : attempts()) {
    lengths.push_back(attempt.responses.front().answer_number.value());
  }
  EXPECT_THAT(lengths, ElementsAre(0.08, 0.16, 0.32));
  SessionTest::start("p2", 8);
  person_.at_question = draws(2e6);
  ASSERT_EQ(run_attempts().state, SessionState::completed);
  EXPECT_NEAR(exponent_of(analyze_study(*study_).front()), 1.0, 1e-9);
}

}  // namespace
}  // namespace asperity

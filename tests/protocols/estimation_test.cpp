// Magnitude estimation of any stimuli: what a protocol states, what its trials present, and what is refused.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/file/protocol_reader.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/observer/virtual_observer.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/example.h"

namespace asperity {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Three models are estimated, twice each.
struct EstimatedModels {
  std::string estimation = R"("factor": "model")";
  std::string presented = R"({"stimulus": "rendered"})";
  std::string block{};     ///< further keys, each followed by a comma
  std::string question{};  ///< the same of the question
  std::string factors = R"("model": {"levels": ["sinusoid", "stochastic", "height_map"]})";
  std::string crossed = "model";
  std::string stimulus = R"("model": {"factor": "model"}, "texture": "stone")";
  std::string analysis = R"({})";

  std::string text() const {
    return R"({"format": "asperity.protocol/1", "kind": "magnitude", "design": "improved",
      "name": "estimated", "version": "1.0.0", "title": "Estimates",
      "consent": {"version": "1", "statement": "I take part of my own free will."},
      "device": {"rate_Hz": 1000, "force_limit_N": 5},
      "textures": {"stone": {"height_field": "stimuli/stone.png"}},
      "factors": {)" +
           factors + R"(},
      "stimuli": {"rendered": {)" +
           stimulus + R"(}},
      "explorations": {"short": {"minimum_contact_s": 1, "maximum_contact_s": 5}},
      "estimation": {)" +
           estimation + R"(},
      "blocks": {"main": {)" +
           block + R"("crossed": [")" + crossed + R"("], "repetitions": 2,
        "presented": [)" +
           presented + R"(],
        "question": {)" +
           question + R"("name": "size", "prompt": "How strong?"},
        "exploration": "short"}},
      "analysis": )" +
           analysis + R"(,
      "flow": [{"run": "main"}]})";
  }
};

const char* const kStandardFirst =
    R"({"role": "standard", "stimulus": "rendered", "with": {"model": "stochastic"}},
       {"role": "target", "stimulus": "rendered"})";
const char* const kModulus =
    R"("factor": "model", "modulus": {"standard": "stochastic", "value": 10})";

std::vector<Diagnostic> problems_of_models(const EstimatedModels& models) {
  try {
    (void)read_protocol(models.text(), "estimated.json", test::example_models());
  } catch (const ProtocolError& error) {
    return error.diagnostics();
  }
  return {};
}

Protocol read_models(const EstimatedModels& models) {
  return read_protocol(models.text(), "estimated.json", test::example_models());
}

auto has_problem(const std::string& pointer, const std::string& part) {
  return Contains(testing::AllOf(
      Field(&Diagnostic::pointer, pointer),
      Field(&Diagnostic::message, testing::Property(&Phrase::english, HasSubstr(part)))));
}

TEST(Estimation, TakesStimuliThatHaveNoSpacing) {
  const Protocol protocol = read_models({});
  const std::vector<Trial> trials = possible_trials(protocol);
  std::vector<std::string> items{};
  for (const Trial& trial : trials) {
    ASSERT_EQ(trial.presentations.size(), 1U);
    items.push_back(trial.presentations.front().item);
  }
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  EXPECT_THAT(items, ElementsAre("height_map", "sinusoid", "stochastic"));
}

TEST(Estimation, HasAFreeModulusUnlessItStatesAStandard) {
  EXPECT_FALSE(read_models({}).estimation->modulus);
  EXPECT_FALSE(
      read_models({.estimation = R"("factor": "model", "modulus": "free")"}).estimation->modulus);
  EXPECT_EQ(read_models({}).estimation->normalisation(), EstimateNormalisation::geometric_mean);
  const Protocol with_standard = read_models({.estimation = kModulus, .presented = kStandardFirst});
  EXPECT_EQ(with_standard.estimation->modulus,
            (EstimationModulus{.standard = "stochastic", .value = 10.0}));
  EXPECT_EQ(with_standard.estimation->normalisation(), EstimateNormalisation::none);
}

TEST(Estimation, PresentsTheStandardFirstInEveryTrial) {
  const Protocol protocol = read_models({.estimation = kModulus, .presented = kStandardFirst});
  const std::vector<Trial> trials = possible_trials(protocol);
  ASSERT_FALSE(trials.empty());
  for (const Trial& trial : trials) {
    ASSERT_EQ(trial.presentations.size(), 2U);
    EXPECT_EQ(trial.presentations[0].role, "standard");
    EXPECT_EQ(trial.presentations[0].item, "standard");
    EXPECT_EQ(trial.presentations[0].stimulus.model, "stochastic");
    EXPECT_EQ(trial.presentations[1].role, "target");
    EXPECT_EQ(trial.presentations[1].item, text_of(trial.factors.at("model")));
  }
}

TEST(Estimation, ReadsThePredictorFromLevelsAndFromStatedValues) {
  const std::string numbers = R"("height": {"levels": [0.5, 1, 2], "unit": "mm"})";
  const std::string bound =
      R"("model": "height_map", "texture": "stone", "parameters": {"height_scale": {"factor": "height"}})";
  const Protocol by_level =
      read_models({.estimation = R"("factor": "height", "predictor": "level")",
                   .factors = numbers,
                   .crossed = "height",
                   .stimulus = bound});
  EXPECT_EQ(by_level.estimation->predictor_values.at("0.5"), 0.5);
  EXPECT_EQ(by_level.estimation->predictor_unit, "mm");
  const Protocol by_value =
      read_models({.estimation = R"("factor": "model", "predictor": "values", "unit": "µm",
         "values": {"sinusoid": 10, "stochastic": 20, "height_map": 40})"});
  EXPECT_EQ(by_value.estimation->predictor_values.at("height_map"), 40.0);
  EXPECT_EQ(by_value.estimation->predictor_unit, "µm");
}

TEST(Estimation, TakesStatedValuesOfNumericLevelsInAnyNotation) {
  const EstimatedModels numeric{
      .estimation = R"("factor": "height", "predictor": "values", "unit": "mm",
         "values": {"0.00005": 10, "1.0": 20, "2": 40})",
      .factors = R"("height": {"levels": [0.00005, 1, 2]})",
      .crossed = "height",
      .stimulus =
          R"("model": "height_map", "texture": "stone", "parameters": {"height_scale": {"factor": "height"}})"};
  EXPECT_THAT(problems_of_models(numeric), IsEmpty());
  const auto values = read_models(numeric).estimation->predictor_values;
  EXPECT_EQ(values.at("5e-05"), 10.0);
  EXPECT_EQ(values.at("1"), 20.0);
  EXPECT_EQ(values.size(), 3U);
}

TEST(Estimation, TakesAParameterThatItsBlocksVary) {
  const EstimatedModels varied{.estimation = R"("factor": "amplitude_m", "predictor": "level")",
                               .block = R"("vary": {"parameter": "amplitude_m", "of": "target",
                   "levels": [0.0001, 0.0002, 0.0004]}, )",
                               .factors = R"("tool": {"levels": ["one"]})",
                               .crossed = "tool",
                               .stimulus = R"("model": "sinusoid")"};
  EXPECT_THAT(problems_of_models(varied), IsEmpty());
}

TEST(Estimation, RefusesWhatItCannotAnalyse) {
  EXPECT_THAT(problems_of_models({.estimation = R"("condition": "model")"}),
              has_problem("/estimation", "exactly one of \"spacing\""));
  EXPECT_THAT(problems_of_models({.estimation = R"("modulus": "free")"}),
              Not(has_problem("/estimation/condition", "same factor")))
      << "none is stated";
  EXPECT_THAT(problems_of_models({.estimation = R"("factor": "modell")"}),
              has_problem("/estimation/factor", "did you mean \"model\""));
  EXPECT_THAT(problems_of_models({.estimation = R"("factor": "model", "predictor": "level")"}),
              has_problem("/factors/model/levels", "is not a number above 0"));
  EXPECT_THAT(
      problems_of_models({.estimation = R"("factor": "model", "predictor": "values",
                             "values": {"sinusoid": 1, "stochastic": 2, "plain": 0})"}),
      testing::AllOf(has_problem("/estimation/values", "\"height_map\" of the factor has no value"),
                     has_problem("/estimation/values/plain", "is not a level"),
                     has_problem("/estimation/values/plain", "must be above 0")));
  EXPECT_THAT(problems_of_models({.analysis = R"({"family": ["spacing"]})"}),
              has_problem("/analysis/family/0", "belongs to an estimation with \"spacing\""));
  EXPECT_THAT(problems_of_models({.analysis = R"({"family": ["exponent"]})"}),
              has_problem("/analysis/family/0", "without a predictor there is no exponent"));
}

TEST(Estimation, RefusesAStandardThatIsNotPresentedFirst) {
  EXPECT_THAT(problems_of_models({.estimation = kModulus}),
              has_problem("/blocks/main/presented", "the first one with the role \"standard\""));
  EXPECT_THAT(problems_of_models({.presented = kStandardFirst}),
              has_problem("/blocks/main/presented", "exactly one surface per trial"));
  EXPECT_THAT(problems_of_models({.estimation = kModulus,
                                  .presented = R"({"role": "standard", "stimulus": "rendered",
                             "with": {"model": "sinusoid"}}, {"role": "target", "stimulus": "rendered"})"}),
              has_problem("/blocks/main/presented/0", "the standard is the level \"stochastic\""));
  EXPECT_THAT(problems_of_models({.estimation = kModulus,
                                  .presented = kStandardFirst,
                                  .block = R"("positions": "shuffle", )"}),
              has_problem("/blocks/main/positions", "\"as_listed\""));
  EXPECT_THAT(problems_of_models({.estimation = kModulus,
                                  .presented = kStandardFirst,
                                  .block = R"("anchor": {"model": "sinusoid"}, )"}),
              has_problem("/blocks/main/anchor", "every trial begins with the standard"));
  EXPECT_THAT(
      problems_of_models(
          {.estimation = R"("factor": "model", "modulus": {"standard": "plain", "value": 10})",
           .presented = kStandardFirst}),
      has_problem("/estimation/modulus/standard", "is not a level of the factor \"model\""));
  EXPECT_THAT(problems_of_models({.estimation = R"("factor": "model", "normalisation": "none")"}),
              has_problem("/estimation/normalisation", "with free modulus"));
}

TEST(Estimation, TakesALineInPlaceOfANumber) {
  const Protocol protocol = read_models({.question = R"("line": {"longest": 0.6}, )"});
  const Trial trial = possible_trials(protocol).front();
  EXPECT_EQ(std::get<LineForm>(trial.questions.front().form).longest, 0.6);
  EXPECT_THAT(json_of(trial), HasSubstr(R"("longest":0.6)"));
  EXPECT_THAT(analysed_kinds_of(protocol), ElementsAre(find_kind("magnitude")));
  EXPECT_THAT(
      problems_of_models(
          {.estimation = kModulus, .presented = kStandardFirst, .question = R"("line": {}, )"}),
      has_problem("/blocks/main/question/line", "set /estimation/modulus to \"free\""));
  EXPECT_THAT(problems_of_models({.question = R"("line": {}, "scale": {}, )"}),
              has_problem("/blocks/main/question/line", "keep one of the two"));
}

TEST(LineForm, StoresALengthAsAProportionOfTheScreen) {
  Question question{};
  question.name = "size";
  question.form = LineForm{.longest = 0.8};
  const std::vector<AnsweredItem> stored = items_of(question, DrawnLength{250});
  ASSERT_EQ(stored.size(), 1U);
  EXPECT_EQ(stored.front().number, 0.2);
  EXPECT_EQ(stored.front().answer, "0.2");
  EXPECT_THAT(problems_with(question, stored), IsEmpty());
  const auto problems = [&question](const AnsweredItem& item) {
    return problems_with(question, std::vector{item});
  };
  EXPECT_THAT(problems({.answer = "0.9", .number = 0.9}), testing::SizeIs(1));
  EXPECT_THAT(problems({.answer = "0.2004", .number = 0.2004}), testing::SizeIs(1));
  EXPECT_THROW(items_of(question, DrawnLength{0}), std::out_of_range);
  EXPECT_THROW(items_of(question, DrawnLength{1001}), std::out_of_range);
}

ForceFeatures felt_of(double log_roughness) {
  ForceFeatures felt{};
  felt.roughness = log_roughness;
  return felt;
}

// 10·(f/f_s)^0.5, whatever the participant's own modulus would be.
TEST(EstimatingObserver, RelatesAnEstimateToTheStandard) {
  const ObserverDeclaration exact{
      .feature_noise = 0.0, .lapse = 0.0, .magnitude = {.exponent = 0.5}};
  VirtualObserver observer(exact, Random(1));
  const NumberHabit habit{.modulus = 10.0, .digits = 2};
  EXPECT_EQ(observer.estimate(felt_of(-2.0), felt_of(-2.0), habit), 10.0);
  EXPECT_EQ(observer.estimate(felt_of(-2.0 + std::log(4.0)), felt_of(-2.0), habit), 20.0);
  EXPECT_EQ(observer.estimate(felt_of(-2.0 - std::log(4.0)), felt_of(-2.0), habit), 5.0);
}

TEST(EstimatingObserver, DrawsLinesThatGrowByThePowerFunction) {
  const ObserverDeclaration exact{
      .feature_noise = 0.0, .lapse = 0.0, .magnitude = {.exponent = 0.5}};
  VirtualObserver observer(exact, Random(1));
  EXPECT_EQ(observer.draw_line(felt_of(-std::log(4.0)), {.modulus = 0.5}, 1000), 250);
  EXPECT_EQ(observer.draw_line(felt_of(0.0), {.modulus = 0.5}, 1000), 500);
  EXPECT_EQ(observer.draw_line(felt_of(5.0), {.modulus = 0.5}, 1000), 1000);  // the longest
  EXPECT_EQ(observer.draw_line(felt_of(-50.0), {.modulus = 0.5}, 1000), 1);   // the shortest
}

// The slope of least squares over 400 guesses about two surfaces: its standard error is 1/(Δ·√400) = 0.07.
TEST(EstimatingObserver, GuessesWithoutRegardToTheSurface) {
  ObserverDeclaration guessing{.feature_noise = 0.0};
  guessing.deaf = true;
  VirtualObserver observer(guessing, Random(3));
  const NumberHabit habit{.modulus = 10.0, .digits = 15};
  double difference = 0.0;
  for (int i = 0; i < 200; ++i) {
    difference += std::log(observer.estimate(felt_of(1.0), felt_of(0.0), habit)) -
                  std::log(observer.estimate(felt_of(0.0), felt_of(0.0), habit));
  }
  EXPECT_NEAR(difference / 200.0, 0.0, 3.0 * std::sqrt(2.0 / 200.0));
}

}  // namespace
}  // namespace asperity

// Responses that are drawn from response tables: their means, standard deviations and proportions are those of the model.

#include "protocols/kinds/response_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/choices/decision_rules.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/numbers/tail_probabilities.h"
#include "protocols/design/block_factors.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/course.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"
#include "tests/protocols/untranslated.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;
using Values = std::map<std::string, double>;

Protocol protocol_of(const nlohmann::json& file) {
  return read_protocol(file.dump(), "test", declarations_of(built_in_models()));
}

/// One question of a protocol, to which participants respond.
class Tabulated {
 public:
  Tabulated(Protocol protocol, const std::string& block, const std::string& question)
      : protocol_(std::make_unique<const Protocol>(std::move(protocol))),
        asked_(tabulated_question(*protocol_, protocol_->blocks.at(block),
                                  *question_named(protocol_->blocks.at(block), question),
                                  possible_trials(*protocol_))),
        table_(*kind_of_question(kind_of(asked_.block), asked_.question)->responses) {
    for (const Trial& trial : make_plan(*protocol_, {.seed = 1}).trials) {
      if (trial.block == block) trials_.push_back(trial);
    }
  }

  const TabulatedQuestion& asked() const { return asked_; }
  const std::vector<Trial>& trials() const { return trials_; }
  std::vector<ResponseParameter> parameters() const { return table_.parameters(asked_); }

  /// The first trial whose first surface counts as this item.
  const Trial& trial_with(const std::string& item) const {
    return *std::find_if(trials_.begin(), trials_.end(), [&item](const Trial& trial) {
      return trial.presentations.front().item == item;
    });
  }

  /// The items of the response of a participant in a trial. Values that are not stated are those that are usually assumed, and
  /// otherwise 0.
  std::vector<AnsweredItem> respond(const Trial& trial, const Values& stated,
                                    std::uint64_t participant, std::uint64_t attempt = 0) const {
    ResponseValues values{};
    for (const ResponseParameter& parameter : parameters()) {
      const auto own = stated.find(parameter.name);
      values.set(parameter.name, own == stated.end() ? parameter.value.value_or(0.0) : own->second);
    }
    const Question& question = *find_question(trial, asked_.question.name);
    return items_of(question,
                    table_.respond({.asked = asked_,
                                    .trial = trial,
                                    .question = question,
                                    .values = values,
                                    .of_study = Random(1).split("study"),
                                    .of_participant = Random(2).split(participant),
                                    .of_response = Random(3).split(participant).split(attempt)}));
  }

  /// The proportion of correct items in so many responses of different participants.
  double proportion_correct(const Trial& trial, const Values& values, std::uint64_t count) const {
    double correct = 0.0;
    double all = 0.0;
    for (std::uint64_t i = 0; i < count; ++i) {
      for (const AnsweredItem& item : respond(trial, values, i)) {
        correct += item.correct.value() ? 1.0 : 0.0;
        all += 1.0;
      }
    }
    return correct / all;
  }

 private:
  std::unique_ptr<const Protocol> protocol_;  ///< to which `asked_` refers
  TabulatedQuestion asked_;
  const ResponseTable& table_;
  std::vector<Trial> trials_{};
};

struct MeanAndSd {
  double mean = 0.0;
  double sd = 0.0;
};

MeanAndSd described(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

/// amplitude_jnd with another design, and with its trial at this difference from the standard.
struct AtDifference {
  Tabulated tabulated;
  Trial trial{};
};

AtDifference at_difference(const std::string& design, double difference_m) {
  nlohmann::json file = test::without_practice(test::library_file("amplitude_jnd"));
  if (!design.empty()) file["blocks"]["comparisons"]["design"] = design;
  AtDifference made{.tabulated = Tabulated(protocol_of(file), "comparisons", "rougher")};
  made.trial = made.tabulated.trials().back();
  const Dimension& varied = *made.tabulated.asked().block.vary;
  made.trial.factors[varied.factor] = *varied.standard + difference_m;
  return made;
}

constexpr std::uint64_t kResponses = 4000;
/// More than four standard errors of a proportion of so many responses.
constexpr double kTolerance = 0.032;

TEST(ResponseTable, ExistsForEveryKind) {
  for (const ExperimentKind* const kind : experiment_kinds()) {
    EXPECT_NE(kind->responses, nullptr) << kind->id;
  }
}

// Every library protocol: an effect of the declared family and its standard deviation have no value, everything else has one
// that is in its range, and every effect has a standard deviation.
TEST(ResponseTable, NeverAssumesAnEffectOfTheFamilyOrItsStandardDeviation) {
  using Part = ResponseParameter::Part;
  std::set<std::string> with_effect{};
  for (const LibraryProtocol& each : library_protocols()) {
    const Protocol protocol =
        read_protocol(each.text, std::string(each.name), declarations_of(built_in_models()));
    const std::vector<Trial> possible = possible_trials(protocol);
    for (const auto& [name, block] : protocol.blocks) {
      if (block.phase != Phase::main) continue;
      for (const auto& question : block.questions) {
        const ExperimentKind& kind = *kind_of_question(kind_of(block), question);
        if (kind.responses == nullptr) continue;
        SCOPED_TRACE(std::string(each.name) + ' ' + name + ' ' + question.name);
        const auto parameters =
            kind.responses->parameters(tabulated_question(protocol, block, question, possible));
        for (const ResponseParameter& parameter : parameters) {
          SCOPED_TRACE(parameter.name);
          EXPECT_EQ(parameter.part == Part::other, parameter.value.has_value());
          EXPECT_FALSE(parameter.meaning.empty());
          EXPECT_EQ(test::untranslated(parameter.meaning), "");
          // What a number is the difference of, with its direction, is not left to the order of a list.
          for (const char* const vague : {"last item", "first item", "last stimulus"}) {
            EXPECT_THAT(parameter.meaning.english(), Not(HasSubstr(vague)));
          }
          if (parameter.unit == kScaleUnits && parameter.part == Part::effect) {
            EXPECT_THAT(parameter.meaning.english(), HasSubstr("on the scale from "));
          }
          EXPECT_TRUE(!parameter.value || is_in_range(parameter.range, *parameter.value));
          if (parameter.part != Part::effect) continue;
          with_effect.insert(std::string(kind.id));
          EXPECT_FALSE(parameter.tests.empty());
          EXPECT_TRUE(is_in_range(parameter.range, parameter.null_value));
          EXPECT_TRUE(
              std::any_of(parameters.begin(), parameters.end(), [&parameter](const auto& other) {
                return other.name == parameter.name + "_sd" && other.part == Part::effect_sd;
              }));
        }
      }
    }
  }
  for (const ExperimentKind* const kind : experiment_kinds()) {
    EXPECT_TRUE(with_effect.contains(std::string(kind->id))) << kind->id;
  }
}

/// The meaning of a parameter of the first question with it in a library protocol.
std::string meaning_of(const std::string& protocol_name, const std::string& parameter) {
  const Protocol protocol = read_protocol(test::library_text(protocol_name), protocol_name,
                                          declarations_of(built_in_models()));
  const std::vector<Trial> possible = possible_trials(protocol);
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main) continue;
    for (const auto& question : block.questions) {
      const ResponseTable* const table = kind_of_question(kind_of(block), question)->responses;
      if (table == nullptr) continue;
      for (const ResponseParameter& each :
           table->parameters(tabulated_question(protocol, block, question, possible))) {
        if (each.name == parameter) return each.meaning.english();
      }
    }
  }
  return {};
}

// The direction, the two stimuli and the scale.
TEST(ResponseTable, StatesWhatADifferenceIsOf) {
  EXPECT_EQ(
      meaning_of("semantic_differential", "difference"),
      "mean rating of \"wood\" minus that of \"brick\", on the scale from -100 (\"smooth\") to 100 "
      "(\"rough\"); the items between them are equally spaced, in the order \"brick\", "
      "\"cones_05\", \"cones_07\", \"cones_14\", \"cones_20\", \"cones_28\", \"cones_35\", "
      "\"metal\", \"stone\", \"wood\"");
  EXPECT_EQ(
      meaning_of("roughness_in_pairs", "difference"),
      "natural log-odds of a choice of \"wood\" rather than \"brick\"; the items between them are "
      "equally spaced, in the order \"brick\", \"metal\", \"stone\", \"wood\"");
  EXPECT_EQ(
      meaning_of("chapter_selection", "target"),
      "natural log-odds that the target \"height_map\" is chosen rather than any one other item");
  EXPECT_EQ(meaning_of("roughness_speed", "exponent"),
            "exponent of the power function of the estimate over the spacing; above 0, the first "
            "grows with the second");
}

// The difference of two ratings has the variance 6² of the participants' differences and twice 4² of the noise; the
// level, which is that of the participant in both, cancels out.
TEST(ResponseTable, RatingsHaveTheStatedDifferenceAndItsStandardDeviation) {
  const Tabulated rating(protocol_of(test::library_file("roughness_of_photographs")), "ratings",
                         "rough");
  const Values values{{"level", 50.0},      {"level_sd", 5.0},      {"noise_sd", 4.0},
                      {"difference", 20.0}, {"difference_sd", 6.0}, {"lapse", 0.0}};
  const Trial& first = rating.trial_with("brick");
  const Trial& last = rating.trial_with("wood");
  std::vector<double> differences{};
  std::vector<double> levels{};
  for (std::uint64_t i = 0; i < kResponses; ++i) {
    const double of_first = rating.respond(first, values, i, 0).front().number.value();
    const double of_last = rating.respond(last, values, i, 1).front().number.value();
    differences.push_back(of_last - of_first);
    levels.push_back(0.5 * (of_first + of_last));
  }
  const MeanAndSd difference = described(differences);
  EXPECT_NEAR(difference.mean, 20.0, 0.6);
  EXPECT_NEAR(difference.sd, std::sqrt(6.0 * 6.0 + 2.0 * 4.0 * 4.0), 0.4);
  const MeanAndSd level = described(levels);
  EXPECT_NEAR(level.mean, 50.0, 0.5);
  // Half the variance of the noise, and of the participants' own items, is in the mean of two.
  EXPECT_NEAR(level.sd, std::sqrt(25.0 + 0.5 * 16.0 + 0.5 * 18.0), 0.4);
}

// One surface, rated at three amplitudes with either hand: the items are the amplitudes, and the hands are averaged.
TEST(ResponseTable, RatingsOfOneSurfaceDifferByTheFactorsOfTheSurface) {
  nlohmann::json file = test::library_file("roughness_of_photographs");
  file["factors"] = {{"amplitude", {{"levels", {2e-5, 4e-5, 8e-5}}}},
                     {"hand", {{"levels", {"left", "right"}}}}};
  file["counterbalance"] = "latin";
  file["stimuli"]["rendered"] = nlohmann::json::parse(R"({"model": "sinusoid", "parameters": {
    "amplitude_m": {"factor": "amplitude"}, "wavelength_m": 0.0025}})");
  file["blocks"].erase("range");
  file["blocks"]["ratings"].erase("minimum_distance");
  file["blocks"]["ratings"]["crossed"] = {"amplitude"};
  nlohmann::json flow = nlohmann::json::array();
  for (nlohmann::json step : file["flow"]) {
    if (step.value("run", std::string()) == "range") continue;
    if (step.contains("run")) step["for_each"] = "hand";
    flow.push_back(std::move(step));
  }
  file["flow"] = std::move(flow);
  const Tabulated rating(protocol_of(file), "ratings", "rough");
  const Values values{{"level", 50.0},      {"level_sd", 0.0},      {"noise_sd", 0.0},
                      {"difference", 20.0}, {"difference_sd", 0.0}, {"lapse", 0.0}};
  const std::map<double, double> expected{{2e-5, 40.0}, {4e-5, 50.0}, {8e-5, 60.0}};
  std::set<std::string> hands{};
  for (const Trial& trial : rating.trials()) {
    hands.insert(text_of(trial.factors.at("hand")));
    EXPECT_NEAR(rating.respond(trial, values, 1).front().number.value(),
                expected.at(std::get<double>(trial.factors.at("amplitude"))), 0.11);
  }
  EXPECT_EQ(hands.size(), 2U);
}

TEST(ResponseTable, ParticipantsKeepTheirOwnDeviationsInAllTrials) {
  const Tabulated rating(protocol_of(test::library_file("roughness_of_photographs")), "ratings",
                         "rough");
  const Values values{{"level", 50.0},     {"level_sd", 5.0},      {"noise_sd", 0.0},
                      {"difference", 0.0}, {"difference_sd", 6.0}, {"lapse", 0.0}};
  const Trial& trial = rating.trial_with("stone");
  const double of_one = rating.respond(trial, values, 1, 0).front().number.value();
  EXPECT_EQ(rating.respond(trial, values, 1, 7).front().number.value(), of_one);
  EXPECT_NE(rating.respond(trial, values, 2, 0).front().number.value(), of_one);
}

// At the threshold d′ is 1 in every design.
TEST(ResponseTable, ChoicesAtTheThresholdHaveTheProportionOfUnitSensitivity) {
  constexpr double kThreshold_m = 10e-6;
  const Values values{
      {"threshold", kThreshold_m}, {"threshold_sd", 0.0}, {"order", 0.0}, {"lapse", 0.0}};
  const AtDifference of_two = at_difference("", kThreshold_m);
  EXPECT_NEAR(of_two.tabulated.proportion_correct(of_two.trial, values, kResponses),
              normal_below(1.0 / std::sqrt(2.0)), kTolerance);
  const AtDifference of_three = at_difference("three_alternatives", kThreshold_m);
  EXPECT_NEAR(of_three.tabulated.proportion_correct(of_three.trial, values, kResponses),
              ForcedChoice{.alternatives = 3}.share(1.0), kTolerance);
  const AtDifference odd = at_difference("oddity", kThreshold_m);
  EXPECT_NEAR(odd.tabulated.proportion_correct(odd.trial, values, kResponses),
              Oddity{}.proportion(1.0), kTolerance);
}

TEST(ResponseTable, SlopeIsTheExponentOfSensitivity) {
  const AtDifference doubled = at_difference("", 20e-6);
  const Values values{
      {"threshold", 10e-6}, {"threshold_sd", 0.0}, {"order", 0.0}, {"lapse", 0.0}, {"slope", 2.0}};
  EXPECT_NEAR(doubled.tabulated.proportion_correct(doubled.trial, values, kResponses),
              normal_below(4.0 / std::sqrt(2.0)), kTolerance);
}

TEST(ResponseTable, LapsesAreGuesses) {
  const AtDifference far = at_difference("", 1e-3);
  const Values values{{"threshold", 10e-6}, {"threshold_sd", 0.0}, {"order", 0.0}, {"lapse", 0.4}};
  EXPECT_NEAR(far.tabulated.proportion_correct(far.trial, values, kResponses), 0.6 + 0.4 * 0.5,
              kTolerance);
}

// Without a difference the first surface is chosen as often as its advantage of one d′ makes it.
TEST(ResponseTable, OrderEffectFavoursTheFirstSurface) {
  const AtDifference equal = at_difference("", 0.0);
  const Values values{{"threshold", 10e-6}, {"threshold_sd", 0.0}, {"order", 1.0}, {"lapse", 0.0}};
  const std::string& first = equal.trial.presentations.front().item;
  double chosen = 0.0;
  for (std::uint64_t i = 0; i < kResponses; ++i) {
    chosen += equal.tabulated.respond(equal.trial, values, i).front().answer == first ? 1.0 : 0.0;
  }
  EXPECT_NEAR(chosen / kResponses, normal_below(1.0 / std::sqrt(2.0)), kTolerance);
}

TEST(ResponseTable, DifferencesAreReportedAboveTheCriterion) {
  const Tabulated pairs(protocol_of(test::library_file("amplitude_same_different")), "comparisons",
                        "different");
  const Dimension& varied = *pairs.asked().block.vary;
  constexpr double kThreshold_m = 10e-6;
  const Values values{{"threshold", kThreshold_m},
                      {"threshold_sd", 0.0},
                      {"criterion", 1.5},
                      {"criterion_sd", 0.0},
                      {"lapse", 0.0}};
  for (const bool is_signal : {true, false}) {
    const auto found =
        std::find_if(pairs.trials().begin(), pairs.trials().end(), [is_signal](const Trial& trial) {
          const auto& surfaces = trial.presentations;
          return (surfaces[0].role != surfaces[1].role) == is_signal;
        });
    ASSERT_NE(found, pairs.trials().end());
    Trial trial = *found;
    trial.factors[varied.factor] = *varied.standard + kThreshold_m;
    double different = 0.0;
    for (std::uint64_t i = 0; i < kResponses; ++i) {
      different += pairs.respond(trial, values, i).front().answer == "different" ? 1.0 : 0.0;
    }
    const double dprime = is_signal ? 1.0 : 0.0;
    EXPECT_NEAR(different / kResponses,
                normal_below((dprime - 1.5) / std::sqrt(2.0)) +
                    normal_below((-dprime - 1.5) / std::sqrt(2.0)),
                kTolerance)
        << is_signal;
  }
}

// Without sensitivity every participant guesses, whatever the standard deviations and preferences for pictures are.
TEST(ResponseTable, RecognitionsWithoutSensitivityAreGuesses) {
  const Tabulated recognition(protocol_of(test::library_file("improved_recognition")), "main",
                              "recognised");
  const Trial& trial = recognition.trial_with("stone");
  EXPECT_NEAR(
      recognition.proportion_correct(
          trial, {{"sensitivity", 0.0}, {"sensitivity_sd", 1.0}, {"lapse", 0.0}}, kResponses),
      1.0 / 6.0, kTolerance);
  const Values sensitive{{"sensitivity", 2.0},
                         {"sensitivity_sd", 0.0},
                         {"texture_sd", 0.0},
                         {"bias_sd", 0.0},
                         {"lapse", 0.0}};
  EXPECT_NEAR(recognition.proportion_correct(trial, sensitive, kResponses),
              ForcedChoice{.alternatives = 6}.share(2.0), kTolerance);
}

TEST(ResponseTable, MatchingsWithoutSensitivityAreRandomAssignments) {
  const Tabulated matching(protocol_of(test::library_file("improved_matching")), "main",
                           "assignment");
  const Trial& trial = matching.trials().front();
  EXPECT_NEAR(matching.proportion_correct(trial, {{"sensitivity", 0.0}, {"lapse", 0.0}}, 2000),
              0.25, kTolerance);
  EXPECT_NEAR(matching.proportion_correct(
                  trial, {{"sensitivity", 20.0}, {"texture_sd", 0.0}, {"lapse", 0.0}}, 50),
              1.0, 0.0);
}

// The target is chosen in proportion to the exponential of its log-odds, against two others.
TEST(ResponseTable, SelectionsFollowTheLogOddsOfTheTarget) {
  const Tabulated selection(protocol_of(test::library_file("improved_selection")), "main",
                            "most_realistic");
  const Trial& trial = selection.trials().front();
  const Values values{{"target", 1.5}, {"order_sd", 0.0}, {"lapse", 0.0}};
  double chosen = 0.0;
  for (std::uint64_t i = 0; i < kResponses; ++i) {
    chosen += selection.respond(trial, values, i).front().answer == "height_map" ? 1.0 : 0.0;
  }
  EXPECT_NEAR(chosen / kResponses, std::exp(1.5) / (std::exp(1.5) + 2.0), kTolerance);
}

// Of four equally spaced items, neighbours differ by a third of the log-odds between the extremes.
TEST(ResponseTable, PairsFollowEquallySpacedLogOdds) {
  const Tabulated pairs(protocol_of(test::library_file("roughness_in_pairs")), "comparisons",
                        "rougher");
  const auto pair = std::find_if(pairs.trials().begin(), pairs.trials().end(), [](const Trial& t) {
    return t.presentations[0].item == "brick" && t.presentations[1].item == "metal";
  });
  ASSERT_NE(pair, pairs.trials().end());
  const Values values{{"difference", 3.0}, {"order_sd", 0.0}, {"tie_within", 0.0}, {"lapse", 0.0}};
  double metal = 0.0;
  for (std::uint64_t i = 0; i < kResponses; ++i) {
    metal += pairs.respond(*pair, values, i).front().answer == "metal" ? 1.0 : 0.0;
  }
  EXPECT_NEAR(metal / kResponses, 1.0 / (1.0 + std::exp(-1.0)), kTolerance);
}

// Without noise the estimates of 3.5 mm and 0.5 mm have the ratio of the spacings to the power of the exponent, apart from
// the rounding to two digits.
TEST(ResponseTable, EstimatesFollowThePowerFunction) {
  const Tabulated roughness(protocol_of(test::library_file("roughness_force")), "main",
                            "roughness");
  const Values values{{"exponent", 0.5},           {"curvature", 0.0},
                      {"condition.ratio_sd", 0.0}, {"condition.peak_ratio", 1.0},
                      {"noise_sd", 0.0},           {"lapse", 0.0}};
  std::map<std::string, double> estimates{};
  for (const Trial& trial : roughness.trials()) {
    if (text_of(trial.factors.at("force")) != "medium" || trial.anchor) continue;
    const double number = roughness.respond(trial, values, 1).front().number.value();
    const auto [known, is_new] = estimates.emplace(text_of(trial.factors.at("texture")), number);
    EXPECT_EQ(known->second, number) << "a participant without noise repeats an estimate";
  }
  EXPECT_NEAR(std::log10(estimates.at("spacing_35") / estimates.at("spacing_05")),
              0.5 * std::log10(7.0), 0.045);
}

// The parabola has its maximum at 0.7 mm; an exponent of 2·k·log₁₀ 2 moves it to twice this spacing, so that the surfaces of 0.7
// and 2.8 mm, equally far from it, are equally rough.
TEST(ResponseTable, AnExponentMovesTheSpacingOfMaximumRoughness) {
  EXPECT_THAT(meaning_of("roughness_force", "peak"),
              HasSubstr("multiplied by 10^(exponent / (2 · curvature))"));
  const Tabulated roughness(protocol_of(test::library_file("roughness_force")), "main",
                            "roughness");
  const Values values{{"exponent", 2.0 * std::log10(2.0)},
                      {"curvature", 1.0},
                      {"peak", 0.0007},
                      {"peak_sd", 0.0},
                      {"noise_sd", 0.0},
                      {"condition.ratio_sd", 0.0},
                      {"condition.peak_ratio", 1.0},
                      {"lapse", 0.0}};
  std::map<std::string, double> estimates{};
  for (const Trial& trial : roughness.trials()) {
    if (text_of(trial.factors.at("force")) != "medium" || trial.anchor) continue;
    estimates[text_of(trial.factors.at("texture"))] =
        roughness.respond(trial, values, 1).front().number.value();
  }
  EXPECT_DOUBLE_EQ(estimates.at("spacing_07"), estimates.at("spacing_28"));
  for (const auto& [surface, estimate] : estimates) {
    EXPECT_LE(estimate, estimates.at("spacing_14")) << surface;
  }
}

// The standard of 1.4 mm is the number 10 in every condition; the estimates of all surfaces with the firmest touch are 4 times
// those with the lightest.
TEST(ResponseTable, EstimatesRelativeToAStandardHaveTheRatioOfTheConditions) {
  nlohmann::json file = test::without_practice(test::library_file("roughness_force"));
  file["estimation"]["modulus"] = {{"standard", "spacing_14"}, {"value", 10}};
  file["analysis"]["family"] = {"condition"};
  nlohmann::json& block = file["blocks"]["main"];
  block.erase("anchor");
  block["positions"] = "as_listed";
  block["presented"] = nlohmann::json::parse(R"([
    {"stimulus": "cones", "role": "standard", "with": {"texture": "spacing_14"}}, {"stimulus": "cones"}])");
  const Tabulated roughness(protocol_of(file), "main", "roughness");
  const Values values{{"exponent", 0.0},           {"exponent_sd", 0.0},
                      {"curvature", 0.0},          {"curvature_sd", 0.0},
                      {"condition.ratio", 4.0},    {"condition.ratio_sd", 0.0},
                      {"condition.exponent", 0.0}, {"condition.exponent_sd", 0.0},
                      {"noise_sd", 0.0},           {"lapse", 0.0}};
  const std::map<std::string, double> expected{{"light", 5.0}, {"medium", 10.0}, {"firm", 20.0}};
  std::set<std::string> conditions{};
  for (const Trial& trial : roughness.trials()) {
    const std::string force = text_of(trial.factors.at("force"));
    conditions.insert(force);
    EXPECT_NEAR(roughness.respond(trial, values, 1).front().number.value(), expected.at(force),
                1e-6);
  }
  EXPECT_EQ(conditions.size(), 3U);
}

/// A library protocol with two groups of participants, and with this family.
nlohmann::json in_groups(const std::string& name, std::vector<std::string> family) {
  nlohmann::json file = test::library_file(name);
  file["factors"]["training"] = {{"levels", {"none", "haptic"}}};
  file["groups"] = {{"factor", "training"}, {"assigned", "balanced"}};
  file["analysis"]["family"] = std::move(family);
  return file;
}

// d′ is 0.75 without training and 3 with it: the geometric mean is the median participant's 1.5.
TEST(ResponseTable, SensitivitiesOfGroupsHaveTheirRatio) {
  const Tabulated recognition(protocol_of(in_groups("improved_recognition", {"right", "groups"})),
                              "main", "recognised");
  const Values values{{"sensitivity", 1.5}, {"sensitivity_sd", 0.0}, {"training.ratio", 4.0},
                      {"texture_sd", 0.0},  {"bias_sd", 0.0},        {"lapse", 0.0}};
  Trial trial = recognition.trial_with("stone");
  for (const auto& [group, dprime] : {std::pair("none", 0.75), std::pair("haptic", 3.0)}) {
    trial.factors["training"] = std::string(group);
    EXPECT_NEAR(recognition.proportion_correct(trial, values, kResponses),
                ForcedChoice{.alternatives = 6}.share(dprime), kTolerance)
        << group;
  }
}

// The log-odds of the target are 0 without training and 2 with it.
TEST(ResponseTable, ChoicesOfGroupsDifferInTheLogOddsOfTheTarget) {
  const Tabulated selection(
      protocol_of(in_groups("improved_selection", {"target_pairs", "groups"})), "main",
      "most_realistic");
  const Values values{
      {"target", 1.0}, {"training.difference", 2.0}, {"order_sd", 0.0}, {"lapse", 0.0}};
  Trial trial = selection.trials().front();
  for (const auto& [group, log_odds] : {std::pair("none", 0.0), std::pair("haptic", 2.0)}) {
    trial.factors["training"] = std::string(group);
    double chosen = 0.0;
    for (std::uint64_t i = 0; i < kResponses; ++i) {
      chosen += selection.respond(trial, values, i).front().answer == "height_map" ? 1.0 : 0.0;
    }
    EXPECT_NEAR(chosen / kResponses, std::exp(log_odds) / (std::exp(log_odds) + 2.0), kTolerance)
        << group;
  }
}

// 10 µm is the threshold of half the groups' ratio each: 20 µm without training and 5 µm with it, whose d′ at 10 µm are 1/2 and 2.
TEST(ResponseTable, ThresholdsOfGroupsHaveTheirRatio) {
  nlohmann::json file = test::without_practice(in_groups("amplitude_jnd", {"groups"}));
  const Tabulated jnd(protocol_of(file), "comparisons", "rougher");
  const Values values{{"threshold", 10e-6}, {"threshold_sd", 0.0}, {"training.ratio", 0.25},
                      {"order", 0.0},       {"order_sd", 0.0},     {"lapse", 0.0}};
  Trial trial = jnd.trials().back();
  const Dimension& varied = *jnd.asked().block.vary;
  trial.factors[varied.factor] = *varied.standard + 10e-6;
  for (const auto& [group, dprime] : {std::pair("none", 0.5), std::pair("haptic", 2.0)}) {
    trial.factors["training"] = std::string(group);
    EXPECT_NEAR(jnd.proportion_correct(trial, values, kResponses),
                normal_below(dprime / std::sqrt(2.0)), kTolerance)
        << group;
  }
}

TEST(ResponseTable, RatingsOfGroupsDifferByTheirMean) {
  const Tabulated rating(protocol_of(in_groups("roughness_of_photographs", {"groups"})), "ratings",
                         "rough");
  const Values values{{"level", 50.0},   {"level_sd", 0.0}, {"training.difference", 20.0},
                      {"noise_sd", 1.0}, {"lapse", 0.0},    {"difference_sd", 0.0}};
  Trial trial = rating.trials().front();
  for (const auto& [group, mean] : {std::pair("none", 40.0), std::pair("haptic", 60.0)}) {
    trial.factors["training"] = std::string(group);
    std::vector<double> ratings{};
    for (std::uint64_t i = 0; i < kResponses; ++i) {
      ratings.push_back(rating.respond(trial, values, i).front().number.value());
    }
    EXPECT_NEAR(described(ratings).mean, mean, 0.2) << group;
  }
}

// A comparison of groups needs the sensitivity that differs between them, and how much it varies within them.
TEST(ResponseTable, NeverAssumesWhatGroupsAreComparedIn) {
  const Tabulated recognition(protocol_of(in_groups("improved_recognition", {"groups"})), "main",
                              "recognised");
  std::map<std::string, ResponseParameter> parameters{};
  for (const ResponseParameter& each : recognition.parameters()) parameters[each.name] = each;
  EXPECT_EQ(parameters.at("training.ratio").tests, "groups");
  EXPECT_EQ(parameters.at("training.ratio").null_value, 1.0);
  EXPECT_EQ(parameters.at("sensitivity").tests, "");
  for (const char* const name : {"training.ratio", "sensitivity", "sensitivity_sd"}) {
    EXPECT_FALSE(parameters.at(name).value) << name;
  }
  const auto sd_of = [](const Tabulated& tabulated, const std::string& name) {
    const std::vector<ResponseParameter> all = tabulated.parameters();
    return *std::find_if(all.begin(), all.end(),
                         [&name](const ResponseParameter& each) { return each.name == name; });
  };
  EXPECT_FALSE(sd_of(Tabulated(protocol_of(in_groups("amplitude_jnd", {"groups"})), "comparisons",
                               "rougher"),
                     "threshold_sd")
                   .value);
  EXPECT_FALSE(sd_of(Tabulated(protocol_of(in_groups("roughness_of_photographs", {"groups"})),
                               "ratings", "rough"),
                     "level_sd")
                   .value);
  EXPECT_TRUE(sd_of(Tabulated(protocol_of(in_groups("roughness_of_photographs", {"ratings"})),
                              "ratings", "rough"),
                    "level_sd")
                  .value);
}

// Ten items on one dimension: the most distant pair minus neighbours, and different minus identical pairs.
TEST(ResponseTable, DissimilaritiesGrowWithTheDistanceOfTheItems) {
  const Tabulated pairs(protocol_of(test::library_file("map_of_renderings")), "ratings",
                        "different");
  const std::vector<std::string>& items = pairs.asked().items;
  ASSERT_EQ(items.size(), 10U);
  const auto rating_of = [&](const std::string& one, const std::string& other) {
    const auto found =
        std::find_if(pairs.trials().begin(), pairs.trials().end(), [&](const Trial& trial) {
          const std::string& first = trial.presentations[0].item;
          const std::string& second = trial.presentations[1].item;
          return (first == one && second == other) || (first == other && second == one);
        });
    const Values values{{"structure", 40.0},  {"level", 50.0}, {"level_sd", 0.0},
                        {"noise_sd", 0.0},    {"lapse", 0.0},  {"identical", 45.0},
                        {"identical_sd", 0.0}};
    return pairs.respond(*found, values, 1).front().number.value();
  };
  EXPECT_NEAR(rating_of(items.front(), items.back()) - rating_of(items[0], items[1]), 40.0, 0.2);
  EXPECT_NEAR(rating_of(items[3], items[4]), 30.0, 0.1);
  EXPECT_NEAR(rating_of(items[2], items[2]), 5.0, 0.1);
}

TEST(ResponseTable, PlacesAreEquallySpaced) {
  EXPECT_EQ(place_among({"a", "b", "c"}, "a"), -0.5);
  EXPECT_EQ(place_among({"a", "b", "c"}, "b"), 0.0);
  EXPECT_EQ(place_among({"a", "b", "c"}, "c"), 0.5);
  EXPECT_EQ(place_among({"a"}, "a"), 0.0);
}

}  // namespace
}  // namespace asperity

// Models of equal roughness: the amplitudes that tracks determine, their effect on later blocks, and what a file cannot ask.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "analysis/numbers/tail_probabilities.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/course.h"
#include "protocols/plan/roughness_matching.h"
#include "protocols/warnings/plan_warnings.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using RoughnessJson = nlohmann::json;

RoughnessJson realism_of_models() { return test::library_file("realism_of_models"); }

Protocol valid_models(const RoughnessJson& file) {
  return test::valid(file, test::models_of_library());
}

// --- the estimate --------------------------------------------------------------------------------

/// Levels of -6, -3, 0, 3 and 6 dB.
Dimension five_levels() {
  return {.factor = "relative_amplitude",
          .parameter = "relative_amplitude",
          .role = "comparison",
          .standard_role = "standard",
          .measure = LevelMeasure::decibels,
          .grid = LevelGrid{.lowest = -6, .highest = 6, .step = 3},
          .standard = 1.0};
}

/// A track with these levels and answers: "6d 3d 0u" is rougher at 6 and 3 dB, and less rough at 0 dB.
AnsweredTrack answered(const std::vector<std::pair<double, bool>>& answers,
                       const std::string& model = "m") {
  AnsweredTrack track{.stimulus = "s", .model = model, .texture = "t"};
  track.settings = TransformedUpDown{{.grid = *five_levels().grid,
                                      .start = 6,
                                      .steps_up = {3},
                                      .steps_down = {3},
                                      .stop = {.trials = 20}}};
  for (const auto& [level, is_rougher] : answers)
    track.answers.push_back({level, forced_outcome(is_rougher)});
  return track;
}

RoughnessMatch match_of(const std::vector<AnsweredTrack>& tracks) {
  const std::vector<RoughnessMatch> matches = roughness_matches(five_levels(), tracks);
  EXPECT_EQ(matches.size(), 1U);
  return matches.empty() ? RoughnessMatch{} : matches.front();
}

TEST(RoughnessMatches, AreTheGeometricMeanOfTheReversalsOfEachTrack) {
  // The first track reverses at 0 and 3 dB: 1.5 dB on average. The second one reverses at 3, 0 and 3 dB: 2 dB. Together
  // 1.75 dB: a factor of 10^(1.75/20) = 1.2232.
  const RoughnessMatch match =
      match_of({answered({{6, true}, {3, true}, {0, false}, {3, true}}),
                answered({{-3, false}, {0, false}, {3, true}, {0, false}, {3, true}})});
  EXPECT_EQ(match.status, MatchStatus::matched);
  EXPECT_NEAR(match.relative_amplitude, std::pow(10.0, 1.75 / 20.0), 1e-11);
  EXPECT_EQ(match.reversals, 5);
  EXPECT_EQ(match.answers, 9);
}

TEST(RoughnessMatches, AreTheEndOfTheRangeWhereAllAnswersPointBeyondIt) {
  const RoughnessMatch below =
      match_of({answered({{6, true}, {3, true}, {0, true}, {-3, true}, {-6, true}}),
                answered({{-6, true}, {-6, true}})});
  EXPECT_EQ(below.status, MatchStatus::below_range);
  EXPECT_NEAR(below.relative_amplitude, std::pow(10.0, -6.0 / 20.0), 1e-11);
  const RoughnessMatch above = match_of(
      {answered({{6, false}, {6, false}}), answered({{3, false}, {6, false}, {6, false}})});
  EXPECT_EQ(above.status, MatchStatus::above_range);
  EXPECT_NEAR(above.relative_amplitude, std::pow(10.0, 6.0 / 20.0), 1e-11);
}

TEST(RoughnessMatches, AreMissingWhereTracksHaveTooFewReversalsOrContradictEachOther) {
  for (const std::vector<AnsweredTrack>& tracks : std::vector<std::vector<AnsweredTrack>>{
           {answered({}), answered({})},
           {answered({{6, true}, {3, true}, {0, false}})},  // one reversal
           {answered({{-6, true}}), answered({{6, false}})},
           {answered({{6, true}, {3, true}, {0, false}, {3, true}}), answered({{0, true}})}}) {
    const RoughnessMatch match = match_of(tracks);
    EXPECT_EQ(match.status, MatchStatus::unmatched);
    EXPECT_EQ(match.relative_amplitude, 1.0) << "the amplitude is unchanged";
  }
}

TEST(RoughnessMatches, BelongToOneStimulusEach) {
  const std::vector<RoughnessMatch> matches = roughness_matches(
      five_levels(), {answered({{6, true}, {3, true}, {0, false}, {3, true}}, "one"),
                      answered({{-6, true}}, "other")});
  ASSERT_EQ(matches.size(), 2U);
  EXPECT_EQ(matches[0].model, "one");
  EXPECT_EQ(matches[0].status, MatchStatus::matched);
  EXPECT_EQ(matches[1].status, MatchStatus::below_range);
}

/// The errors in docs/models/equal-roughness.md: of a judge whose differences have a standard deviation of 2.46 dB, a
/// feature_noise of 0.2 in both surfaces.
TEST(RoughnessMatches, RecoverThePointOfEqualityOfANoisyJudge) {
  const Protocol protocol = valid_models(realism_of_models());
  const Protocol::Block& block = protocol.blocks.at("matching");
  constexpr int kJudges = 500;
  constexpr double kNoise_dB = 2.46;
  for (const double place_dB : {-6.0, -2.0, 3.0, 7.0}) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint64_t judge = 0; judge < kJudges; ++judge) {
      Random random = Random(17).split(judge);
      const double equal_dB = place_dB + 3.0 * (random.uniform() - 0.5);
      std::vector<AnsweredTrack> tracks{};
      for (const ProcedureSettings& settings : block.procedure->tracks) {
        const auto rougher = [&](double level_dB) {
          return normal_below((level_dB - equal_dB) / kNoise_dB);
        };
        tracks.push_back({.settings = settings,
                          .answers = simulated_track(settings, rougher,
                                                     random.split("track").split(tracks.size()))});
      }
      const RoughnessMatch match = roughness_matches(*block.vary, tracks).front();
      EXPECT_NE(match.status, MatchStatus::reference);
      const double error_dB = 20.0 * std::log10(match.relative_amplitude) - equal_dB;
      sum += error_dB;
      squares += error_dB * error_dB;
    }
    const double bias_dB = sum / kJudges;
    const double sd_dB = std::sqrt(squares / kJudges - bias_dB * bias_dB);
    EXPECT_LT(std::abs(bias_dB), 0.25) << place_dB << " dB";  // the standard error is 0.06 dB
    EXPECT_LT(sd_dB, 1.6) << place_dB << " dB";
    EXPECT_GT(sd_dB, 1.0) << place_dB << " dB";
  }
}

TEST(RoughnessMatches, NameEveryStatus) {
  for (const MatchStatus status : match_statuses()) {
    EXPECT_EQ(match_status_named(text_of(status)), status);
    EXPECT_FALSE(meaning_of(status).empty());
  }
  EXPECT_FALSE(match_status_named("of a later version"));
}

// --- the course ----------------------------------------------------------------------------------

double relative_amplitude_of(const Trial& trial) {
  return std::get<double>(trial.factors.at("relative_amplitude"));
}

/// A participant without noise for whom each model is as rough as the reference at its own relative amplitude.
std::map<std::string, double> points_of_equality() {
  return {
      {"normal_map", 1.6}, {"lateral_gradient", 0.7}, {"filtered_noise", 0.45}, {"recorded", 2.3}};
}

TrialOutcome noiseless_outcome(const Trial& trial) {
  const double amplitude = relative_amplitude_of(trial);
  const double equal = points_of_equality().at(text_of(trial.factors.at("model")));
  return {.answer = TrialOutcome::Answer{.value = amplitude,
                                         .outcome = forced_outcome(amplitude > equal)}};
}

Course answered_models(const Protocol& protocol, std::uint64_t seed) {
  Course course(protocol, {.seed = seed});
  while (const Trial* const trial = course.awaited()) course.advance(noiseless_outcome(*trial));
  return course;
}

TEST(EqualRoughness, PresentsEveryModelAtItsPointOfEqualityInLaterBlocks) {
  const Protocol protocol = valid_models(realism_of_models());
  const Course course = answered_models(protocol, 5);
  std::map<std::string, int> presented{};
  for (const Trial& trial : course.plan().trials) {
    if (trial.block == "matching") continue;
    for (const PlannedPresentation& planned : trial.presentations) {
      const std::string& model = planned.stimulus.model;
      ++presented[model];
      ASSERT_TRUE(planned.stimulus.relative_amplitude) << model;
      if (model == "height_map") {
        EXPECT_EQ(planned.roughness_match, MatchStatus::reference);
        EXPECT_EQ(*planned.stimulus.relative_amplitude, 1.0);
        continue;
      }
      EXPECT_EQ(planned.roughness_match, MatchStatus::matched);
      const double step_dB = 20.0 * std::abs(std::log10(*planned.stimulus.relative_amplitude /
                                                        points_of_equality().at(model)));
      EXPECT_LT(step_dB, 2.0) << model;
    }
  }
  EXPECT_EQ(presented.size(), 5U);
  for (const auto& [model, count] : presented) EXPECT_GE(count, 24) << model;
}

TEST(EqualRoughness, IsAFunctionOfTheStoredAnswers) {
  const Protocol protocol = valid_models(realism_of_models());
  const Course first = answered_models(protocol, 8);
  const Course again = answered_models(protocol, 8);
  ASSERT_EQ(first.plan().trials.size(), again.plan().trials.size());
  for (std::size_t i = 0; i < first.plan().trials.size(); ++i) {
    EXPECT_EQ(json_of(first.plan().trials[i]), json_of(again.plan().trials[i]));
  }
  EXPECT_EQ(first.matches().at("matching").size(), 4U);
  EXPECT_EQ(first.matches(), again.matches());
  Course other(protocol, {.seed = 8});
  while (const Trial* const trial = other.awaited()) {
    TrialOutcome outcome = noiseless_outcome(*trial);
    if (trial->ordinal == 60) {
      outcome.answer->outcome = forced_outcome(outcome.answer->outcome != LevelOutcome::correct);
    }
    other.advance(outcome);
  }
  EXPECT_NE(first.matches(), other.matches()) << "one other answer";
}

TEST(EqualRoughness, IsStoredWithEveryPlannedSurfaceAndInNoOtherPlan) {
  const Protocol protocol = valid_models(realism_of_models());
  const Course course = answered_models(protocol, 2);
  const RoughnessJson last = RoughnessJson::parse(json_of(course.plan().trials.back()));
  for (const RoughnessJson& surface : last.at("presentations")) {
    EXPECT_TRUE(surface.at("relative_amplitude").is_number());
    EXPECT_TRUE(match_status_named(surface.at("roughness_match").get<std::string>()));
  }
  const RoughnessJson first = RoughnessJson::parse(json_of(course.plan().trials.front()));
  for (const RoughnessJson& surface : first.at("presentations")) {
    EXPECT_EQ(surface.contains("relative_amplitude"), surface.at("role") == "comparison");
    EXPECT_FALSE(surface.contains("roughness_match"));
  }
  RoughnessJson without = realism_of_models();
  for (auto& [name, block] : without["blocks"].items()) block.erase("equal_roughness");
  const Course unmatched = answered_models(valid_models(without), 2);
  EXPECT_EQ(json_of(unmatched.plan().trials.back()).find("relative"), std::string::npos);
}

TEST(EqualRoughness, IsNotMatchedByABlockThatNoOtherBlockNames) {
  RoughnessJson file = realism_of_models();
  for (auto& [name, block] : file["blocks"].items()) block.erase("equal_roughness");
  file["blocks"]["matching"]["procedure"]["stop"]["trials"] = 20;
  const Protocol protocol = valid_models(file);
  const Course course = answered_models(protocol, 2);
  EXPECT_TRUE(course.matches().empty());
  EXPECT_TRUE(course.plan().trials.front().standard_picture.has_value());
  EXPECT_TRUE(
      warnings_about_plan(protocol, "file.json", example_plan(protocol, {.seed = 1})).empty());
}

TEST(EqualRoughness, LeavesTheAmplitudeOfAParticipantWhoDoesNotAnswer) {
  const Protocol protocol = valid_models(realism_of_models());
  Course course(protocol, {.seed = 3});
  while (course.awaited() != nullptr) course.advance({});
  for (const PlannedPresentation& planned : course.plan().trials.back().presentations) {
    EXPECT_EQ(*planned.stimulus.relative_amplitude, 1.0);
    EXPECT_NE(planned.roughness_match, MatchStatus::matched);
  }
}

TEST(EqualRoughness, ShowsNoPictureWhileRoughnessIsMatched) {
  const Course course = answered_models(valid_models(realism_of_models()), 4);
  for (const Trial& trial : course.plan().trials) {
    EXPECT_EQ(trial.standard_picture.has_value(), trial.block != "matching");
  }
}

TEST(EqualRoughness, MatchesWithinTenMinutes) {
  const Protocol protocol = valid_models(realism_of_models());
  const Plan plan = example_plan(protocol, {.seed = 1});
  // With its breaks: from the first of its trials to the last.
  double since_first_s = 0.0;
  double matching_s = 0.0;
  for (const PlanStep& step : plan.steps) {
    const auto* const of_trial = std::get_if<TrialStep>(&step);
    const bool is_of_matching =
        of_trial != nullptr && plan.trials[of_trial->trial].block == "matching";
    if (!is_of_matching && since_first_s == 0.0) continue;
    since_first_s += cost_of(protocol, plan, step).total_s;
    if (is_of_matching) matching_s = since_first_s;
  }
  // As docs/methods.md states.
  EXPECT_EQ(cost_of(protocol, plan).trials, 135);
  EXPECT_NEAR(cost_of(protocol, plan).total_s / 60.0, 26.0, 0.5);
  EXPECT_GT(matching_s, 300.0);
  EXPECT_LE(matching_s, 600.0);
  EXPECT_TRUE(warnings_about_plan(protocol, "file.json", plan).empty());
  RoughnessJson longer = realism_of_models();
  longer["blocks"]["matching"]["procedure"]["stop"]["trials"] = 20;
  const Protocol slow = valid_models(longer);
  const std::vector<Diagnostic> warnings =
      warnings_about_plan(slow, "file.json", example_plan(slow, {.seed = 1}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().pointer, "/blocks/matching/procedure");
  EXPECT_THAT(warnings.front().message.english(), HasSubstr("10 min"));
}

// --- files ---------------------------------------------------------------------------------------

struct FaultOfMatching {
  const char* pointer = "";
  const char* message = "";
  std::function<void(RoughnessJson&)> change{};
};

TEST(EqualRoughness, RefusesFilesThatCannotMatch) {
  const std::vector<FaultOfMatching> faults{
      {"/blocks/comparisons/equal_roughness/matched_in", "matching",
       [](auto& p) { p["blocks"]["comparisons"]["equal_roughness"]["matched_in"] = "matchin"; }},
      {"/blocks/comparisons/equal_roughness/matched_in", "does not match roughness",
       [](auto& p) {
         p["blocks"]["comparisons"]["equal_roughness"]["matched_in"] = "familiarisation";
       }},
      {"/flow/5/run", "has not been run", [](auto& p) { std::swap(p["flow"][5], p["flow"][8]); }},
      {"/flow/6/run", "would match the same stimuli twice",
       [](auto& p) {
         const RoughnessJson run = p["flow"][5];
         p["flow"].insert(p["flow"].begin() + 6, run);
       }},
      {"/flow/5/for_each", "matches all stimuli in one run",
       [](auto& p) {
         p["blocks"]["matching"].erase("crossed");
         p["blocks"]["matching"].erase("exclude");
         p["flow"][5]["for_each"] = "model";
       }},
      {"/blocks/matching/procedure", "\"down\": 1",
       [](auto& p) { p["blocks"]["matching"]["procedure"]["down"] = 2; }},
      {"/blocks/matching/vary/levels", "above 0",
       [](auto& p) {
         auto& vary = p["blocks"]["matching"]["vary"];
         vary.erase("levels_decibels");
         vary["levels"] = {{"lowest", 0}, {"highest", 2}, {"step", 0.5}};
       }},
      {"/blocks/matching", "matched with itself",
       [](auto& p) { p["blocks"]["matching"].erase("exclude"); }},
      {"/blocks/matching/presented", "a separate block that matches it",
       [](auto& p) {
         p["factors"]["damping"] = {{"levels", {0.2, 0.4}}};
         p["stimuli"]["rendered"]["parameters"]["friction_damping_N_s_per_m"]["factor"] = "damping";
         p["blocks"]["matching"]["crossed"].push_back("damping");
         p["blocks"]["comparisons"]["crossed"].push_back("damping");
         for (auto& row : p["blocks"]["familiarisation"]["listed"]) row["damping"] = 0.2;
       }},
      {"/blocks/comparisons/equal_roughness", "neither matched",
       [](auto& p) {
         p["blocks"]["matching"]["exclude"].push_back({{"model", "recorded"}});
       }},
      {"/blocks/comparisons/equal_roughness", "neither matched",
       [](auto& p) { p["stimuli"]["reference"]["material"]["friction"] = 0.4; }},
  };
  for (const FaultOfMatching& fault : faults) {
    SCOPED_TRACE(std::string(fault.pointer) + ": " + fault.message);
    RoughnessJson file = realism_of_models();
    fault.change(file);
    EXPECT_THAT(test::problems_at(file, fault.pointer, test::models_of_library()),
                HasSubstr(fault.message));
  }
}

TEST(EqualRoughness, NeedsModelsWithAnAmplitude) {
  std::vector<ModelDeclaration> models = test::models_of_library();
  for (ModelDeclaration& model : models) {
    if (model.id == "recorded") model.amplitude_parameter.reset();
  }
  RoughnessJson file = realism_of_models();
  for (auto& [name, stimulus] : file["stimuli"].items()) stimulus.erase("equal_force");
  const ProtocolReading reading = test::reading_of(file, models);
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems.front().pointer, "/blocks/matching/vary/parameter");
  EXPECT_THAT(reading.problems.front().message.english(), HasSubstr("has no amplitude"));
}

TEST(EqualRoughness, HasAStandardOfOneInStoredProtocols) {
  const StoredProtocol stored = stored_protocol(realism_of_models().dump());
  EXPECT_EQ(stored.protocol.blocks.at("matching").vary->standard, 1.0);
}

// --- the purpose ---------------------------------------------------------------------------------

/// How the magnitude that a judge perceives grows with the amplitude of a model: ln m = strength + exponent·ln a.
struct PerceivedModel {
  double strength = 0.0;
  double exponent = 1.0;
};

std::map<std::string, PerceivedModel> perceived_models() {
  return {{"height_map", {}},
          {"normal_map", {.strength = -0.5, .exponent = 0.9}},
          {"lateral_gradient", {.strength = 0.35, .exponent = 1.1}},
          {"filtered_noise", {.strength = 0.8, .exponent = 1.0}},
          {"recorded", {.strength = -0.2, .exponent = 0.8}}};
}

/// Judges by the magnitude alone, as the observer of the protocol does without expectations.
class JudgeOfStrength {
 public:
  JudgeOfStrength(const Protocol& protocol, std::uint64_t seed)
      : protocol_(protocol),
        random_(Random(seed)),
        observer_(protocol.observer, Random(seed).split("observer")) {
    Random differences = random_.split("differences");
    for (const auto& [model, perceived] : perceived_models()) {
      own_[model] =
          perceived.strength + (model == "height_map" ? 0.0 : 0.15 * differences.normal());
    }
  }

  /// The position of the surface that is chosen; nothing for a tie.
  std::optional<std::size_t> judge(const Trial& trial) {
    std::vector<ForceFeatures> felt{};
    for (const PlannedPresentation& planned : trial.presentations) {
      const std::string& model = planned.stimulus.model;
      ForceFeatures features{};
      features.size =
          own_.at(model) + perceived_models().at(model).exponent *
                               std::log(planned.stimulus.relative_amplitude.value_or(1.0));
      felt.push_back(features);
    }
    const Random of_attempt = random_.split(static_cast<std::uint64_t>(trial.ordinal));
    const Judgement judgement{.protocol = protocol_,
                              .trial = trial,
                              .question = trial.questions.front(),
                              .felt = felt,
                              .expectations = expectations_,
                              .observer = observer_,
                              .of_attempt = of_attempt,
                              .of_participant = random_};
    const VirtualResponse response = kind_named(trial.kind).judge(judgement);
    const std::size_t option = std::get<ChosenOption>(response.answer).option;
    return option < felt.size() ? std::optional(option) : std::nullopt;
  }

 private:
  const Protocol& protocol_;
  Random random_;
  VirtualObserver observer_;
  Expectations expectations_{};
  std::map<std::string, double> own_{};
};

/// The proportion of choices of each model in so many comparisons.
std::map<std::string, double> proportions_of_choices(const Protocol& protocol, int comparisons) {
  std::map<std::string, std::pair<int, int>> chosen{};  // of how many
  for (std::uint64_t participant = 1; comparisons > 0; ++participant) {
    JudgeOfStrength judge(protocol, participant);
    Course course(protocol, {.seed = participant});
    while (const Trial* const trial = course.awaited()) {
      const std::optional<std::size_t> choice = judge.judge(*trial);
      course.advance(
          {.answer = TrialOutcome::Answer{
               .value = relative_amplitude_of(*trial),
               .outcome = forced_outcome(trial->presentations.at(*choice).role == "comparison")}});
    }
    for (const Trial& trial : course.plan().trials) {
      if (trial.block != "comparisons" || comparisons-- <= 0) continue;
      const std::optional<std::size_t> choice = judge.judge(trial);
      if (!choice) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        auto& [count, of] = chosen[trial.presentations[i].stimulus.model];
        ++of;
        count += *choice == i ? 1 : 0;
      }
    }
  }
  std::map<std::string, double> proportions{};
  for (const auto& [model, count] : chosen) {
    proportions[model] = static_cast<double>(count.first) / count.second;
  }
  return proportions;
}

TEST(EqualRoughness, LetsAJudgeOfStrengthChooseEachModelInHalfOfItsComparisons) {
  RoughnessJson file = realism_of_models();
  file["observer"] = {
      {"expectation", "none"}, {"feature_noise", 0.2}, {"magnitude_of", "normal_force"}};
  // The errors of the matches of a participant are common to all comparisons of this participant. With 20 comparisons of each
  // of 400 participants the standard error of a proportion is 0.9 %; with 60 of 133 it would be 1.6 %.
  file["blocks"]["comparisons"]["repetitions"] = 1;
  constexpr int kComparisons = 8000;
  const auto matched = proportions_of_choices(valid_models(file), kComparisons);
  ASSERT_EQ(matched.size(), 5U);
  for (const auto& [model, proportion] : matched) {
    EXPECT_NEAR(proportion, 0.5, 0.03) << model << " at equal roughness";
  }
  file["blocks"]["comparisons"].erase("equal_roughness");
  const auto unmatched = proportions_of_choices(valid_models(file), kComparisons / 4);
  EXPECT_GT(unmatched.at("filtered_noise"), 0.9) << "the strongest";
  EXPECT_LT(unmatched.at("normal_map"), 0.1) << "the weakest";
}

}  // namespace
}  // namespace asperity

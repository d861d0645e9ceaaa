// Assumptions that are taken from the responses of a study are those from which the study was simulated.

#include "app/power/calibration.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/power/power_model.h"
#include "app/power/simulated_study.h"
#include "protocols/file/protocol_reader.h"
#include "tests/app/made_up_study.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct CalibratedStudy {
  std::vector<Assumption> assumptions{};

  const Assumption& at(const std::string& name) const {
    return *std::find_if(assumptions.begin(), assumptions.end(),
                         [&name](const Assumption& each) { return each.name == name; });
  }
  double value(const std::string& name) const { return at(name).value.value(); }
};

/// The assumptions of a protocol with those of a study that was simulated from `truth`.
CalibratedStudy calibrated_from(const Protocol& protocol,
                                const std::map<std::string, double>& truth, int participants) {
  std::vector<Assumption> assumptions = assumptions_of(protocol);
  for (const auto& [parameter, value] : truth) {
    set_assumption(assumptions, parameter, value, "the test");
  }
  const PowerModel model(protocol, assumptions);
  const auto study = simulated_study(model.tables(), participants, Random(5));
  return {calibrated(assumptions_of(protocol), protocol, study, "pilot A, 9 participants")};
}

CalibratedStudy calibrated_from(const std::string& name, const std::map<std::string, double>& truth,
                                int participants) {
  return calibrated_from(read_protocol(test::library_text(name), name, test::models_of_library()),
                         truth, participants);
}

// The tolerances are four standard errors with 150 participants, four items and six repetitions.
TEST(Calibration, RecoversTheVariationOfRatings) {
  const CalibratedStudy study = calibrated_from("roughness_of_photographs",
                                                {{"level", 50.0},
                                                 {"level_sd", 6.0},
                                                 {"noise_sd", 8.0},
                                                 {"difference", 10.0},
                                                 {"difference_sd", 8.0},
                                                 {"lapse", 0.0}},
                                                150);
  EXPECT_NEAR(study.value("ratings.rough.level"), 50.0, 2.2);
  EXPECT_NEAR(study.value("ratings.rough.level_sd"), 6.0, 1.5);
  EXPECT_NEAR(study.value("ratings.rough.noise_sd"), 8.0, 0.4);
  EXPECT_NEAR(study.value("ratings.rough.difference_sd"), 8.0, 1.6);
  EXPECT_EQ(study.at("ratings.rough.difference_sd").source, "pilot A, 9 participants");
  EXPECT_FALSE(study.at("ratings.rough.difference").value) << "the researcher states the effect";
  EXPECT_EQ(study.at("ratings.rough.lapse").source, kAssumed) << "ratings do not show lapses";
}

TEST(Calibration, RecoversThresholdsOfStaircases) {
  const CalibratedStudy study = calibrated_from(
      "amplitude_jnd",
      {{"threshold", 10e-6}, {"threshold_sd", 0.2}, {"order", 0.0}, {"order_sd", 0.5}}, 24);
  const double threshold_m = study.value("comparisons.rougher.threshold");
  EXPECT_GT(threshold_m, 10e-6 / 1.35);
  EXPECT_LT(threshold_m, 10e-6 * 1.35);
  EXPECT_TRUE(study.at("comparisons.rougher.order_sd").value);
  EXPECT_FALSE(study.at("comparisons.rougher.order").value) << "a test of the family concerns it";
}

// The thresholds of all participants with the left and the right hand have the ratio 4, whose logarithm alone has the standard
// deviation 0.7 over all thresholds; those of the participants differ by less than the error of their estimates.
TEST(Calibration, SeparatesParticipantsFromConditions) {
  nlohmann::json file = test::without_practice(test::library_file("amplitude_jnd"));
  file["factors"]["hand"] = {{"levels", {"left", "right"}}};
  file["counterbalance"] = "latin";
  for (nlohmann::json& step : file["flow"]) {
    if (step.contains("run")) step["for_each"] = "hand";
  }
  const CalibratedStudy study =
      calibrated_from(read_protocol(file.dump(), "amplitude_jnd", test::models_of_library()),
                      {{"threshold", 10e-6},
                       {"threshold_sd", 0.05},
                       {"hand.ratio", 4.0},
                       {"hand.ratio_sd", 0.0},
                       {"order", 0.0},
                       {"order_sd", 0.1}},
                      16);
  EXPECT_EQ(study.at("comparisons.rougher.threshold_sd").source, "pilot A, 9 participants");
  EXPECT_LT(study.value("comparisons.rougher.threshold_sd"), 0.45);
}

// Some 100 easy catch trials, a fifth of which are errors.
TEST(Calibration, RecoversLapsesFromCatchTrials) {
  const CalibratedStudy study =
      calibrated_from("amplitude_jnd", {{"lapse", 0.4}, {"order", 0.0}, {"order_sd", 0.1}}, 24);
  EXPECT_NEAR(study.value("comparisons.rougher.lapse"), 0.4, 0.25);
}

/// Two participants with this mean rating of the four textures, each of which they rate twice.
void add_ratings(MadeUpStudy& made, std::int64_t protocol, int mean, SessionMode mode) {
  for (const int own : {mean - 4, mean + 4}) {
    std::vector<MadeUpTrial> trials{};
    for (const auto& [texture, difference] : {std::pair("metal", -6), std::pair("stone", -2),
                                              std::pair("wood", 2), std::pair("brick", 6)}) {
      for (const int noise : {-1, 1}) {
        MadeUpTrial trial{};
        trial.block = "ratings";
        trial.factors_json = nlohmann::json{{"texture", texture}}.dump();
        trial.surfaces = {surface_of(texture, "height_map", texture)};
        trial.questions = {"rough"};
        trial.answers = {std::to_string(own + difference + noise)};
        trials.push_back(std::move(trial));
      }
    }
    const std::string label = "p" + std::to_string(own);
    made.add_person(label, "");
    made.add_session(label, protocol, trials, mode);
  }
}

// Of pilot sessions rather than others, and of this version of the protocol rather than another one: never of both.
TEST(Calibration, IsByOneGroupAndOneVersion) {
  MadeUpStudy made{};
  const std::string name = "roughness_of_photographs";
  const std::string source = test::library_text(name);
  const Protocol protocol = read_protocol(source, name, test::models_of_library());
  const auto level = [&] {
    const std::vector<Assumption> all =
        calibrated_by_study(assumptions_of(protocol), protocol, made.study());
    return *std::ranges::find(all, "ratings.rough.level", &Assumption::name);
  };
  const std::int64_t before = made.add_protocol(name, "rating", source, "0.8.0");
  add_ratings(made, before, 20, SessionMode::run);
  add_ratings(made, made.add_protocol(name, "rating", source, "0.9.0"), 30, SessionMode::run);
  EXPECT_NEAR(level().value.value(), 30.0, 1e-9);
  EXPECT_EQ(level().source, "study study, version 0.9.0 of the protocol, 2 participants");
  const std::int64_t current = made.add_protocol(name, "rating", source, protocol.version);
  add_ratings(made, current, 40, SessionMode::run);
  EXPECT_NEAR(level().value.value(), 40.0, 1e-9);
  EXPECT_EQ(level().source, "study study, 2 participants");
  add_ratings(made, before, 50, SessionMode::pilot);
  EXPECT_NEAR(level().value.value(), 50.0, 1e-9);
  EXPECT_EQ(level().source, "pilot study, version 0.8.0 of the protocol, 2 participants");
}

TEST(Calibration, NeedsAStudyOfTheProtocol) {
  const MadeUpStudy made{};
  const Protocol protocol =
      read_protocol(test::library_text("amplitude_jnd"), "file", test::models_of_library());
  EXPECT_THAT(
      [&] {
        calibrated_by_study(assumptions_of(protocol), protocol,
                            Study::open(made.folder(), Access::read_only));
      },
      ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(protocol.name), HasSubstr("piloted"))));
}

}  // namespace
}  // namespace asperity

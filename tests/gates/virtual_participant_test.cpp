// How a virtual participant answers, attempt by attempt, and where its answers say they come from.

#include "app/session/respondents/virtual_participant.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/study_files/height_field_files.h"
#include "app/tasks/new_study.h"
#include "app/tasks/simulation/simulation.h"
#include "protocols/plan/plan.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "renderers/offline/roughness_stroke.h"
#include "stimuli/heights/synthetic_surface.h"
#include "tests/gates/simulated_study.h"
#include "tests/support/replies.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using json = nlohmann::ordered_json;

const Wait kNobodyWaits = [](double) {};

ForceFeatures features_at(double value) {
  ForceFeatures features{};
  features.spectrum.fill(value);
  features.size = value;
  features.roughness = value;
  return features;
}

ExpectationsByExploration expectations_for(const Protocol& protocol) {
  ExpectationsByExploration by_exploration{};
  Expectations expectations{};
  double value = -6.0;
  for (const auto& [name, texture] : protocol.textures) {
    expectations[name] = features_at(value);
    value += 0.5;
  }
  for (const auto& [name, exploration] : protocol.explorations) by_exploration[name] = expectations;
  return by_exploration;
}

std::vector<std::size_t> answer_to(VirtualParticipant& participant, const Trial& trial,
                                   int attempt) {
  participant.begin_attempt(trial.ordinal, attempt);
  const std::vector<ForceFeatures> felt(trial.presentations.size(), features_at(-4.6));
  return options_of(participant.ask(trial, trial.questions, felt, {}, kNobodyWaits));
}

Protocol noisy(std::string_view name) {
  return library_protocol(name,
                          [](json& protocol) { protocol["observer"]["feature_noise"] = 1.0; });
}

// A session that is resumed at any trial asks the same questions of a participant made anew.
TEST(VirtualParticipant, AnswersAResumedSessionAsAnUninterruptedOne) {
  for (const char* name : {"improved_selection", "improved_matching", "improved_recognition"}) {
    const Protocol protocol = noisy(name);
    const Plan plan = make_plan(protocol, {5, 0});
    const Random random = Random(5).split("participant");
    VirtualParticipant whole(protocol, expectations_for(protocol), {}, random);
    std::vector<std::vector<std::size_t>> answers{};
    for (const Trial& trial : plan.trials) answers.push_back(answer_to(whole, trial, 1));
    const std::set<std::vector<std::size_t>> different(answers.begin(), answers.end());
    EXPECT_GT(different.size(), 2U) << name << " is answered always alike, which shows nothing";
    for (std::size_t first = 0; first < plan.trials.size(); ++first) {
      VirtualParticipant resumed(protocol, expectations_for(protocol), {}, random);
      EXPECT_EQ(answer_to(resumed, plan.trials[first], 1), answers[first]) << name << ' ' << first;
    }
  }
}

TEST(VirtualParticipant, DrawsAnewForAnotherAttempt) {
  const Protocol protocol = noisy("improved_recognition");
  const Plan plan = make_plan(protocol, {5, 0});
  VirtualParticipant participant(protocol, expectations_for(protocol), {}, Random(5));
  std::set<std::vector<std::size_t>> different{};
  for (int attempt = 1; attempt <= 20; ++attempt) {
    different.insert(answer_to(participant, plan.trials.front(), attempt));
  }
  EXPECT_GT(different.size(), 1U);
}

TEST(VirtualParticipant, SaysWhereAnAnswerIsAGuess) {
  for (const char* name : {"improved_selection", "improved_matching", "improved_recognition"}) {
    const auto source_of = [name](const std::function<void(json&)>& change, bool expects) {
      const Protocol protocol = library_protocol(name, change);
      VirtualParticipant participant(
          protocol, expects ? expectations_for(protocol) : ExpectationsByExploration{}, {},
          Random(5));
      (void)answer_to(participant, make_plan(protocol, {5, 0}).trials.front(), 1);
      return participant.source();
    };
    EXPECT_EQ(source_of({}, true), "virtual") << name;
    EXPECT_EQ(source_of([](json& p) { p["observer"]["expectation"] = "none"; }, false),
              "virtual_guess")
        << name;
    EXPECT_EQ(source_of([](json& p) { p["observer"]["deaf"] = true; }, true), "virtual_guess")
        << name;
  }
}

// A surface that is pressed harder is expected to feel as it does when it is pressed harder.
TEST(VirtualParticipant, ExpectsWhatTheExplorationOfTheTrialFeelsLike) {
  const Protocol protocol = library_protocol("improved_matching", [](json& p) {
    p["explorations"]["another"] = p["explorations"]["stroking"];
  });
  ExpectationsByExploration expectations = expectations_for(protocol);
  const Trial trial = make_plan(protocol, {5, 0}).trials.front();
  const auto answer = [&] {
    VirtualParticipant participant(protocol, expectations, {}, Random(5));
    return answer_to(participant, trial, 1);
  };
  const std::vector<std::size_t> first = answer();
  expectations.erase("another");  // sorts before the exploration of the trial
  EXPECT_EQ(answer(), first);
  expectations.erase("stroking");
  VirtualParticipant participant(protocol, expectations, {}, Random(5));
  (void)answer_to(participant, trial, 1);
  EXPECT_EQ(participant.source(), "virtual_guess");
}

// A question about the person or the session is answered by rote, not guessed.
TEST(VirtualParticipant, DoesNotCallAnswersToOtherQuestionsGuesses) {
  const Protocol protocol = library_protocol(
      "improved_recognition", [](json& p) { p["observer"]["expectation"] = "none"; });
  VirtualParticipant participant(protocol, {}, {}, Random(5));
  (void)answer_to(participant, make_plan(protocol, {5, 0}).trials.front(), 1);
  (void)participant.answer(protocol.questions.begin()->second, kNobodyWaits);
  EXPECT_EQ(participant.source(), "virtual");
}

/// Features expected of the textures of the recognition protocol, were they all one rough surface.
ForceFeatures expected_of_noise(const std::filesystem::path& folder,
                                const std::function<void(json&)>& change) {
  const Protocol protocol = library_protocol("chapter_recognition", change);
  const ModelRegistry models = built_in_models();
  StimulusBuilder builder(models, folder);
  return expectations_of(protocol, builder, Random(3)).at("stroking").at("metal");
}

// A Gaussian of 2 mm leaves 1 − exp(−½ (2/8.4)²) = 3 % of the waves in the first band, where the
// hand's own unsteadiness is left, and all of those under half a millimetre.
TEST(VirtualParticipant, ExpectsNoMoreThanAPhotographKeeps) {
  const TemporaryFolder folder{};
  std::filesystem::create_directories(folder / "stimuli");
  const HeightField rough = make_surface("noise", {{"rms_m", 1e-4}, {"exponent", 3.0}},
                                         {.width_m = 0.04, .pixels = 256, .seed = 2});
  for (const char* name : {"metal", "stone", "wood", "brick", "sandpaper", "pebbles"}) {
    save_height_field(folder / "stimuli" / (std::string(name) + "_true.png"), rough, {},
                      Overwrite::refuse);
  }
  const ForceFeatures whole = expected_of_noise(
      folder.path(), [](json& p) { p["observer"].erase("gaussian_wavelength_m"); });
  const ForceFeatures kept = expected_of_noise(
      folder.path(), [](json& p) { p["observer"]["gaussian_wavelength_m"] = 0.002; });
  EXPECT_LT(kept.spectrum.front(), whole.spectrum.front() - 1.0);
  EXPECT_NEAR(kept.spectrum[8], whole.spectrum[8], 0.3);
}

const std::vector<std::pair<std::string, double>> kThreeWaves{
    {"spacing_07", 0.0007}, {"spacing_14", 0.0014}, {"spacing_28", 0.0028}};

/// Three waves under the smallest and the largest tip, once each, on a plate that is soon made.
void make_short(json& protocol) {
  protocol["surface"]["extent_m"] = {0.05, 0.028};
  protocol["bodies"]["plate"]["size_m"] = {0.05, 0.028, 0.004};
  protocol["explorations"]["stroking"]["stroke_length_m"] = {
      {"minimum", 0.01}, {"target", 0.02}, {"maximum", 0.04}};
  json waves = json::array();
  json textures{};
  for (const auto& [wave, spacing_m] : kThreeWaves) {
    waves.push_back(wave);
    textures[wave] = {{"height_field", "stimuli/" + wave + ".png"}, {"spacing_m", spacing_m}};
  }
  protocol["textures"] = textures;
  json stimulus = protocol["stimuli"]["cones"];
  stimulus["parameters"] = {{"cell_m", 5e-5}, {"step_m", 5e-5}};
  protocol["stimuli"] = json{{"wave", stimulus}};
  protocol["factors"]["texture"]["levels"] = waves;
  protocol["factors"]["tip"]["levels"] = {"sphere_1mm", "sphere_3mm"};
  json main = protocol["blocks"]["main"];
  main["repetitions"] = 1;
  main["presented"] = json::array({json{{"stimulus", "wave"}}});
  main.erase("anchor");
  main.erase("pause_before_trial_s");
  protocol["blocks"] = json{{"main", main}};
  protocol["flow"] = json::array({json{{"run", "main"}, {"for_each", "tip"}}});
  protocol["observer"]["feature_noise"] = 0.0;
  protocol["observer"]["lapse"] = 0.0;
}

/// What one participant without noise says of the short protocol, by stimulus and exploration.
using Numbers = std::map<std::pair<std::string, std::string>, double>;
Numbers numbers_of_one(const std::function<void(json&)>& change) {
  const TemporaryFolder folder{};
  new_study(folder / "study");
  for (const auto& [name, spacing_m] : kThreeWaves) {
    save_height_field(
        folder / "study/stimuli" / (name + ".png"),
        make_surface("sinusoid", {{"spacing_m", spacing_m}, {"amplitude_m", 1e-4}},
                     {.width_m = 0.028,
                      .pixels = static_cast<std::size_t>(8.0 * 0.028 / spacing_m + 0.5),
                      .seed = 1}),
        {}, Overwrite::refuse);
  }
  SimulationInputs inputs{};
  inputs.protocols = {folder / "short.json"};
  inputs.study = folder / "study";
  inputs.seed = 1;
  inputs.participants = 1;
  inputs.recordings = Recordings::none;
  std::ofstream(inputs.protocols[0], std::ios::binary)
      << library_protocol("roughness_diameter", [&change](json& protocol) {
           make_short(protocol);
           change(protocol);
         }).source;
  (void)simulate(inputs, built_in_models(), {}, {}, {});
  Numbers numbers{};
  const Study study = Study::open(inputs.study, Access::read_only);
  std::map<int, std::string> hands{};
  for (const PlannedTrialRow& trial : study.plan(study.sessions().front().id)) {
    hands[trial.trial] = json::parse(trial.factors_json).value("hand", std::string());
  }
  for (const AttemptRow& attempt : study.attempts(study.sessions().front().id)) {
    EXPECT_EQ(attempt.responses.at(0).source, "virtual");
    numbers[{attempt.presentations.at(0).stimulus, hands.at(attempt.trial)}] =
        attempt.responses[0].answer_number.value();
  }
  return numbers;
}

// Between waves 0.7 mm apart a ball of 3 mm sinks by a third of what one of 1 mm does; 2.8 mm apart
// both go down to the troughs.
TEST(VirtualParticipant, FindsFineWavesRougherWithASmallTipThanWithALargeOne) {
  const Numbers numbers = numbers_of_one([](json&) {});
  ASSERT_EQ(numbers.size(), 6U);
  const auto of_fine = [&numbers](const std::string& tip) {
    return numbers.at({"wave_spacing_07_pd_gradient_" + tip, ""}) /
           numbers.at({"wave_spacing_28_pd_gradient_" + tip, ""});
  };
  EXPECT_GT(of_fine("sphere_1mm"), 1.5 * of_fine("sphere_3mm"));
}

/// One way of drawing a tip of 2 mm, as an exploration that nothing can fail.
struct Hand {
  std::string name{};
  double force_N = 0.8;
  double speed_m_per_s = 0.06;
};

/// The condition is how the hand draws, one hand after the other.
void draw_with(json& protocol, const std::vector<Hand>& hands) {
  json levels = json::array();
  json explorations{};
  for (const Hand& hand : hands) {
    levels.push_back(hand.name);
    explorations[hand.name] = {{"direction_rad", 0},
                               {"stroke_length_m", {{"target", 0.02}}},
                               {"speed_m_per_s", {{"target", hand.speed_m_per_s}}},
                               {"normal_force_N", {{"target", hand.force_N}}},
                               {"minimum_contact_s", 3},
                               {"maximum_contact_s", 8}};
  }
  protocol["explorations"] = explorations;
  protocol["factors"].erase("tip");
  protocol["factors"]["hand"] = {{"levels", levels}, {"meaning", "How the hand draws."}};
  protocol["estimation"]["condition"] = "hand";
  protocol["stimuli"]["wave"]["tool"] = "sphere_2mm";
  protocol["blocks"]["main"]["exploration"] = {{"factor", "hand"}};
  protocol["flow"] = json::array({json{{"run", "main"}, {"for_each", "hand"}}});
  protocol["observer"]["magnitude_of"] = "held_tool";
}

/// RMS acceleration that a sweep of that tip predicts for such a stroke.
double predicted_m_per_s2(const Hand& hand, double spacing_m) {
  static const ModelRegistry kModels = built_in_models();
  RoughnessStroke stroke{};
  stroke.model = kModels.find("pd_gradient");
  stroke.material = {.stiffness_N_per_m = 3000.0, .friction = 0.0};
  stroke.tip.diameter_m = 0.002;
  stroke.force_N = hand.force_N;
  stroke.speed_m_per_s = hand.speed_m_per_s;
  const TextureAtSpacing texture =
      texture_at_spacing({.kind = "sinusoid", .values = {{"amplitude_m", 1e-4}}}, spacing_m);
  return dragged(stroke, texture)->roughness.value().rms_accel_m_per_s2;
}

/// Over each wave, wherever the sweep tells two hands apart by a quarter. How often it does.
int expect_order_of_the_sweep(const Numbers& numbers, const std::vector<Hand>& hands) {
  int told_apart = 0;
  for (const auto& [wave, spacing_m] : kThreeWaves) {
    const std::string stimulus = "wave_" + wave + "_pd_gradient";
    for (std::size_t i = 0; i < hands.size(); ++i) {
      for (std::size_t j = i + 1; j < hands.size(); ++j) {
        const double by_sweep =
            predicted_m_per_s2(hands[j], spacing_m) / predicted_m_per_s2(hands[i], spacing_m);
        const double by_person =
            numbers.at({stimulus, hands[j].name}) / numbers.at({stimulus, hands[i].name});
        std::cout << wave << ", " << hands[j].name << " over " << hands[i].name << ": sweep "
                  << by_sweep << ", participant " << by_person << '\n';
        if (std::abs(std::log(by_sweep)) < std::log(1.25)) continue;
        ++told_apart;
        EXPECT_EQ(by_sweep > 1.0, by_person > 1.0)
            << wave << ": " << hands[j].name << " over " << hands[i].name;
      }
    }
  }
  return told_apart;
}

TEST(VirtualParticipant, WhoFeelsAHeldToolFindsASurfaceRougherTheHarderItIsPressed) {
  const std::vector<Hand> hands{{.name = "light", .force_N = 0.25},
                                {.name = "medium", .force_N = 0.7},
                                {.name = "firm", .force_N = 2.0}};
  const Numbers numbers = numbers_of_one([&hands](json& protocol) { draw_with(protocol, hands); });
  ASSERT_EQ(numbers.size(), 9U);
  EXPECT_EQ(expect_order_of_the_sweep(numbers, hands), 9);
}

// Coarse waves come by so slowly under a slow hand that its hold follows them; fine ones shake the
// tool's mass with either speed.
TEST(VirtualParticipant, WhoFeelsAHeldToolFindsCoarseWavesRougherTheFasterTheyComeBy) {
  const std::vector<Hand> hands{{.name = "slow", .speed_m_per_s = 0.02},
                                {.name = "fast", .speed_m_per_s = 0.1}};
  const Numbers numbers = numbers_of_one([&hands](json& protocol) { draw_with(protocol, hands); });
  ASSERT_EQ(numbers.size(), 6U);
  EXPECT_GE(expect_order_of_the_sweep(numbers, hands), 1);
}

// "I cannot tell" stands last among the options of these protocols; guesses are of the others, all
// of them.
TEST(VirtualParticipant, GuessesAmongSurfacesAndPicturesOnly) {
  for (const auto& [name, open] :
       {std::pair("improved_selection", 3U), std::pair("improved_recognition", 6U)}) {
    const Protocol protocol =
        library_protocol(name, [](json& p) { p["observer"]["expectation"] = "none"; });
    const Plan plan = make_plan(protocol, {5, 0});
    ASSERT_EQ(plan.trials.front().questions.front().options.size(), open + 1);
    VirtualParticipant participant(protocol, {}, {}, Random(5));
    std::set<std::string> values{};
    for (int attempt = 1; attempt <= 200; ++attempt) {
      const std::size_t chosen = answer_to(participant, plan.trials.front(), attempt).at(0);
      values.insert(plan.trials.front().questions.front().options.at(chosen).value);
    }
    EXPECT_EQ(values.size(), open) << name;
    EXPECT_FALSE(values.contains("cannot_tell")) << name;
  }
}

}  // namespace
}  // namespace asperity

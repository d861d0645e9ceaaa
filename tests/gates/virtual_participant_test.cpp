// How a virtual participant answers, attempt by attempt, and where its answers say they come from.

#include "app/conductor/virtual_participant.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/height_field_files.h"
#include "app/tasks/new_study.h"
#include "app/tasks/simulation.h"
#include "protocols/plan.h"
#include "renderers/force_model.h"
#include "stimuli/synthetic_surface.h"
#include "tests/gates/simulated_study.h"

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

Expectations expectations_for(const Protocol& protocol) {
  Expectations expectations{};
  double value = -6.0;
  for (const auto& [name, texture] : protocol.textures) {
    expectations[name] = features_at(value);
    value += 0.5;
  }
  return expectations;
}

std::vector<std::size_t> answer_to(VirtualParticipant& participant, const Trial& trial,
                                   int attempt) {
  participant.begin_attempt(trial.ordinal, attempt);
  const std::vector<ForceFeatures> felt(trial.presentations.size(), features_at(-4.6));
  return participant.ask(trial, felt, {}, kNobodyWaits).options;
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
          protocol, expects ? expectations_for(protocol) : Expectations{}, {}, Random(5));
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
  return expectations_of(protocol, builder, Random(3)).at("metal");
}

// A Gaussian of 2 mm leaves 1 − exp(−½ (2/8.4)²) = 3 % of the waves in the first band, where the
// hand's own unsteadiness is left, and all of those under half a millimetre.
TEST(VirtualParticipant, ExpectsNoMoreThanAPhotographKeeps) {
  std::string pattern = (std::filesystem::temp_directory_path() / "asperity_XXXXXX").string();
  ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
  const std::filesystem::path folder = pattern;
  std::filesystem::create_directories(folder / "stimuli");
  const HeightField rough = make_surface("noise", {{"rms_m", 1e-4}, {"exponent", 3.0}},
                                         {.width_m = 0.04, .pixels = 256, .seed = 2});
  for (const char* name : {"metal", "stone", "wood", "brick", "sandpaper", "pebbles"}) {
    save_height_field(folder / "stimuli" / (std::string(name) + "_true.png"), rough, {},
                      Overwrite::refuse);
  }
  const ForceFeatures whole =
      expected_of_noise(folder, [](json& p) { p["observer"].erase("gaussian_wavelength_m"); });
  const ForceFeatures kept =
      expected_of_noise(folder, [](json& p) { p["observer"]["gaussian_wavelength_m"] = 0.002; });
  std::filesystem::remove_all(folder);
  EXPECT_LT(kept.spectrum.front(), whole.spectrum.front() - 1.0);
  EXPECT_NEAR(kept.spectrum[8], whole.spectrum[8], 0.3);
}

/// Three waves under the smallest and the largest tip, once each, on a plate that is soon made.
void make_short(json& protocol) {
  protocol["surface"]["extent_m"] = {0.05, 0.028};
  protocol["bodies"]["plate"]["size_m"] = {0.05, 0.028, 0.004};
  protocol["explorations"]["stroking"]["stroke_length_m"] = {
      {"minimum", 0.01}, {"target", 0.02}, {"maximum", 0.04}};
  const std::vector<std::string> waves{"spacing_07", "spacing_14", "spacing_28"};
  json textures{};
  for (const std::string& wave : waves) textures[wave] = protocol["textures"][wave];
  protocol["textures"] = textures;
  protocol["factors"]["texture"]["levels"] = waves;
  protocol["factors"]["tip"]["levels"] = {"sphere_1mm", "sphere_3mm"};
  json main = protocol["blocks"]["main"];
  main["repetitions"] = 1;
  main.erase("anchor");
  main.erase("pause_before_trial_s");
  protocol["blocks"] = json{{"main", main}};
  protocol["flow"] = json::array({json{{"run", "main"}, {"for_each", "tip"}}});
  protocol["observer"]["feature_noise"] = 0.0;
  protocol["observer"]["lapse"] = 0.0;
}

// Between waves 0.7 mm apart a ball of 3 mm sinks by a third of what one of 1 mm does; 2.8 mm apart
// both go down to the troughs.
TEST(VirtualParticipant, FindsFineWavesRougherWithASmallTipThanWithALargeOne) {
  std::string pattern = (std::filesystem::temp_directory_path() / "asperity_XXXXXX").string();
  ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
  const std::filesystem::path folder = pattern;
  new_study(folder / "study");
  for (const auto& [name, spacing_m] :
       {std::pair("wave_07", 0.0007), std::pair("wave_14", 0.0014), std::pair("wave_28", 0.0028)}) {
    save_height_field(
        folder / "study/stimuli" / (std::string(name) + ".png"),
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
      << library_protocol("roughness_diameter", make_short).source;
  (void)simulate(inputs, built_in_models(), {}, {}, {});
  std::map<std::string, double> numbers{};
  {
    const Study study = Study::open(inputs.study, Access::read_only);
    for (const AttemptRow& attempt : study.attempts(study.sessions().front().id)) {
      ASSERT_EQ(attempt.responses.size(), 1U);
      EXPECT_EQ(attempt.responses[0].source, "virtual");
      numbers[attempt.presentations[0].stimulus] = attempt.responses[0].answer_number.value();
    }
  }
  std::filesystem::remove_all(folder);
  ASSERT_EQ(numbers.size(), 6U);
  const auto of_fine = [&numbers](const std::string& tip) {
    return numbers.at("wave_spacing_07_pd_gradient_" + tip) /
           numbers.at("wave_spacing_28_pd_gradient_" + tip);
  };
  EXPECT_GT(of_fine("sphere_1mm"), 1.5 * of_fine("sphere_3mm"));
}

// "I cannot tell" stands last among the options of these protocols; guesses are of the others, all
// of them.
TEST(VirtualParticipant, GuessesAmongSurfacesAndPicturesOnly) {
  for (const auto& [name, open] :
       {std::pair("improved_selection", 3U), std::pair("improved_recognition", 6U)}) {
    const Protocol protocol =
        library_protocol(name, [](json& p) { p["observer"]["expectation"] = "none"; });
    const Plan plan = make_plan(protocol, {5, 0});
    ASSERT_EQ(plan.trials.front().question.options.size(), open + 1);
    VirtualParticipant participant(protocol, {}, {}, Random(5));
    std::set<std::string> values{};
    for (int attempt = 1; attempt <= 200; ++attempt) {
      const std::size_t chosen = answer_to(participant, plan.trials.front(), attempt).at(0);
      values.insert(plan.trials.front().question.options.at(chosen).value);
    }
    EXPECT_EQ(values.size(), open) << name;
    EXPECT_FALSE(values.contains("cannot_tell")) << name;
  }
}

}  // namespace
}  // namespace asperity

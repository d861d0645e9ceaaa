// A plan: what it holds, what it balances, and that it never changes.

#include "protocols/plan/plan.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

Protocol read(const std::string& text) {
  return read_protocol(text, "p.json", test::example_models());
}

Protocol library(std::string_view name) {
  return read_protocol(test::library_text(name), std::string(name), test::models_of_library());
}

std::string text_of_plan(const Plan& plan) {
  std::string text{};
  for (const Trial& trial : plan.trials) text += json_of(trial) + "\n";
  return text;
}

TEST(Plan, BeginsEveryRunOfABlockWithItsAnchorAndHoldsTheConditionWithinIt) {
  const Protocol protocol = library("roughness_diameter");
  std::set<std::string> first_tips{};
  for (int row = 0; row < 3; ++row) {
    const Plan plan = make_plan(protocol, {.seed = 5, .counterbalance_row = row});
    ASSERT_EQ(plan.trials.size(), 6U + 3U * 22U);
    std::set<std::string> tips{};
    for (std::size_t i = 6; i < plan.trials.size(); ++i) {
      const Trial& trial = plan.trials[i];
      const bool is_anchor = (i - 6) % 22 == 0;
      EXPECT_EQ(trial.presentations[0].role, is_anchor ? "anchor" : "target");
      EXPECT_EQ(trial.repetition == 0, is_anchor);
      if (is_anchor) {
        EXPECT_EQ(text_of(trial.factors.at("texture")), "spacing_14");
        tips.insert(text_of(trial.factors.at("tip")));
      }
      EXPECT_EQ(trial.factors.at("tip"), plan.trials[i - (i - 6) % 22].factors.at("tip"));
      EXPECT_EQ(name_of(trial.questions.front().form), "number");
      EXPECT_TRUE(trial.questions.front().options.empty());
    }
    EXPECT_EQ(tips.size(), 3U);
    first_tips.insert(text_of(plan.trials[6].factors.at("tip")));
  }
  // The rows of the Latin square begin with each tip in turn.
  EXPECT_EQ(first_tips.size(), 3U);
}

TEST(Plan, ExploresATrialAsTheLevelOfItsFactorSays) {
  Protocol protocol = library("roughness_diameter");
  protocol.explorations["firmly"] = protocol.explorations.at("stroking");
  protocol.explorations["firmly"].name = "firmly";
  protocol.factors["force"].levels = {std::string("stroking"), std::string("firmly")};
  protocol.blocks.at("main").crossed.push_back("force");
  protocol.blocks.at("main").anchor["force"] = std::string("stroking");
  protocol.blocks.at("main").exploration = {.factor = "force"};
  const Plan plan = make_plan(protocol, {.seed = 5, .counterbalance_row = 0});
  for (std::size_t i = 6; i < plan.trials.size(); ++i) {
    EXPECT_EQ(exploration_of(protocol, plan.trials[i]).name,
              text_of(plan.trials[i].factors.at("force")));
  }
}

TEST(Plan, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Protocol protocol = library("improved_selection");
  EXPECT_EQ(text_of_plan(make_plan(protocol, {7, 0})), text_of_plan(make_plan(protocol, {7, 0})));
  EXPECT_NE(text_of_plan(make_plan(protocol, {7, 0})), text_of_plan(make_plan(protocol, {8, 0})));
}

// Stored plans are compared with new ones when a session is resumed: a change here breaks studies
// that are running.
TEST(Plan, NeverChangesForASeed) {
  const Plan plan =
      make_plan(read(test::example_selection()), {.seed = 42, .counterbalance_row = 0});
  std::string summary{};
  for (const Trial& trial : plan.trials) {
    summary += text_of(trial.factors.at("texture")) + ":";
    for (const PlannedPresentation& planned : trial.presentations) {
      summary += " " + planned.code + "=" + planned.item;
    }
    summary += "\n";
  }
  EXPECT_EQ(summary,
            "metal: A=stochastic B=sinusoid C=height_map\n"
            "stone: A=height_map B=stochastic C=sinusoid\n"
            "stone: A=sinusoid B=height_map C=stochastic\n"
            "metal: A=stochastic B=height_map C=sinusoid\n"
            "metal: A=sinusoid B=stochastic C=height_map\n"
            "stone: A=height_map B=sinusoid C=stochastic\n");
  // Written over several lines here; in the text itself there is no space.
  const std::string first =
      R"({"ordinal":1,"block":"main","block_ordinal":1,"phase":"main","repetition":3,
   "factors":{"texture":"metal"},
   "presentations":[
    {"position":1,"role":"alternative","item":"stochastic","code":"A","stimulus":"rendered_metal_stochastic",
     "model":"stochastic","texture":"metal","height_field":"stimuli/metal.png","parameters":{},
     "equal_force":{"rms_N":null,"to_model":"height_map","band_low_Hz":5.0,"band_high_Hz":500.0}},
    {"position":2,"role":"alternative","item":"sinusoid","code":"B","stimulus":"rendered_metal_sinusoid",
     "model":"sinusoid","texture":"metal","height_field":"stimuli/metal.png","parameters":{},
     "equal_force":{"rms_N":null,"to_model":"height_map","band_low_Hz":5.0,"band_high_Hz":500.0}},
    {"position":3,"role":"alternative","item":"height_map","code":"C","stimulus":"rendered_metal_height_map",
     "model":"height_map","texture":"metal","height_field":"stimuli/metal.png","parameters":{},
     "equal_force":{"rms_N":null,"to_model":"height_map","band_low_Hz":5.0,"band_high_Hz":500.0}}],
   "standard_picture":"stimuli/metal_photo.png","layout":"one_after_another",
   "questions":[{"name":"most_realistic","form":"choice",
    "options":[{"value":"stochastic","label":"A","picture":null},
     {"value":"sinusoid","label":"B","picture":null},
     {"value":"height_map","label":"C","picture":null}],"correct":[]}]})";
  EXPECT_EQ(json_of(plan.trials[0]), nlohmann::ordered_json::parse(first).dump());
}

TEST(Plan, SelectionOffersTheSurfacesByTheirCodesAndShowsThePicture) {
  const Plan plan = make_plan(read(test::example_selection()), {1, 0});
  for (const Trial& trial : plan.trials) {
    const std::string texture = text_of(trial.factors.at("texture"));
    EXPECT_EQ(trial.standard_picture, "stimuli/" + texture + "_photo.png");
    EXPECT_TRUE(trial.questions.front().correct.empty());
    ASSERT_EQ(trial.questions.front().options.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(trial.questions.front().options[i].value, trial.presentations[i].item);
      EXPECT_EQ(trial.questions.front().options[i].label,
                std::string(1, static_cast<char>('A' + i)));
      EXPECT_EQ(trial.presentations[i].position, static_cast<int>(i) + 1);
      EXPECT_EQ(trial.presentations[i].role, "alternative");
      EXPECT_EQ(trial.presentations[i].stimulus.texture, texture);
      EXPECT_EQ(trial.presentations[i].stimulus.height_field, "stimuli/" + texture + ".png");
      EXPECT_EQ(trial.presentations[i].equal_force->to_model, "height_map");
    }
  }
}

TEST(Plan, CrossesRepeatsAndConstrainsOverAThousandSeeds) {
  const Protocol protocol = read(test::example_selection());
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Plan plan = make_plan(protocol, {seed, 0});
    ASSERT_EQ(plan.trials.size(), 6U);
    std::map<std::string, int> textures{};
    std::map<std::pair<std::string, int>, int> places{};
    std::set<std::pair<std::string, int>> repetitions{};
    int in_a_row = 0;
    std::string before{};
    for (const Trial& trial : plan.trials) {
      const std::string texture = text_of(trial.factors.at("texture"));
      ++textures[texture];
      repetitions.emplace(texture, trial.repetition);
      in_a_row = texture == before ? in_a_row + 1 : 1;
      before = texture;
      ASSERT_LE(in_a_row, 2);
      for (const PlannedPresentation& planned : trial.presentations) {
        ++places[{planned.item, planned.position}];
      }
    }
    ASSERT_EQ(textures, (std::map<std::string, int>{{"metal", 3}, {"stone", 3}}));
    ASSERT_EQ(repetitions.size(), 6U);
    ASSERT_EQ(places.size(), 9U);
    for (const auto& [place, count] : places) ASSERT_EQ(count, 2);  // 6 trials / 3 positions
  }
}

TEST(Plan, FirstPositionsFavourNoModelWhenShuffled) {
  const Protocol protocol = library("chapter_selection");
  std::map<std::string, int> first{};
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    for (const Trial& trial : make_plan(protocol, {seed, 0}).trials) {
      ++first[trial.presentations.front().item];
    }
  }
  // 3000 trials, a third each; 5 standard deviations are 5·√(3000·2/9) ≈ 129.
  for (const auto& [model, count] : first) EXPECT_NEAR(count, 1000, 129);
}

TEST(Plan, DrawsLevelsEquallyOftenAsFarAsItGoes) {
  const Protocol protocol = library("chapter_recognition");
  std::map<std::string, int> counts{};
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    std::set<std::string> drawn{};
    for (const Trial& trial : make_plan(protocol, {seed, 0}).trials) {
      const std::string texture = text_of(trial.factors.at("texture"));
      drawn.insert(texture);
      ++counts[texture];
      ASSERT_EQ(trial.questions.front().correct, std::vector<std::string>{texture});
      ASSERT_EQ(trial.presentations.front().item, texture);
    }
    ASSERT_EQ(drawn.size(), 3U);  // three of the four, never one twice
  }
  // 3000 draws, a quarter each; they are not independent within a session, which only helps.
  for (const auto& [texture, count] : counts) EXPECT_NEAR(count, 750, 5 * 24);
}

TEST(Plan, MatchingAssignsEveryPictureOnceAndKnowsTheTruth) {
  const Plan plan = make_plan(library("chapter_matching"), {3, 0});
  for (const Trial& trial : plan.trials) {
    EXPECT_EQ(name_of(trial.questions.front().form), "assignment");
    EXPECT_TRUE(trial.pictures_after_feeling);
    EXPECT_FALSE(trial.arrangement.allows_revisits());
    ASSERT_EQ(trial.questions.front().correct.size(), 4U);
    std::set<std::string> options{};
    for (const Option& option : trial.questions.front().options) {
      options.insert(option.value);
      EXPECT_TRUE(option.picture);
      EXPECT_NE(option.label, option.value);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(trial.questions.front().correct[i], trial.presentations[i].item);
      EXPECT_TRUE(options.contains(trial.presentations[i].item));
    }
  }
}

std::string pictures_of(const Trial& trial) {
  std::string text{};
  for (const Option& option : trial.questions.front().options) text += option.value + " ";
  return text;
}

TEST(Plan, PicturesChangePlacesInEveryTrialOnlyWhenAsked) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::set<std::string> fixed{};
    for (const Trial& trial : make_plan(library("chapter_recognition"), {seed, 0}).trials) {
      fixed.insert(pictures_of(trial));
    }
    EXPECT_EQ(fixed.size(), 1U);
    std::set<std::string> reshuffled{};
    for (const Trial& trial : make_plan(library("improved_recognition"), {seed, 0}).trials) {
      reshuffled.insert(pictures_of(trial));
    }
    EXPECT_GT(reshuffled.size(), 10U);
  }
  std::set<std::string> over_sessions{};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    over_sessions.insert(
        pictures_of(make_plan(library("chapter_recognition"), {seed, 0}).trials[0]));
  }
  EXPECT_GT(over_sessions.size(), 30U);
}

TEST(Plan, CannotTellComesLast) {
  const Plan plan = make_plan(library("improved_recognition"), {1, 0});
  EXPECT_EQ(plan.trials[0].questions.front().options.back().value, "cannot_tell");
  EXPECT_EQ(plan.trials[0].questions.front().options.size(), 7U);
}

TEST(Plan, RestsAfterSoManyTrialsButNotAfterTheLast) {
  const Plan plan = make_plan(read(test::example_selection()), {1, 0});
  std::string steps{};
  for (const PlanStep& step : plan.steps) steps += "SCBAT"[step.index()];
  EXPECT_EQ(steps, "SCTTTBTTT");
}

TEST(Plan, CriterionBlocksHoldTheirMostTrials) {
  const Plan plan = make_plan(library("improved_matching"), {1, 0});
  EXPECT_EQ(std::count_if(plan.trials.begin(), plan.trials.end(),
                          [](const Trial& trial) { return trial.phase == Phase::practice; }),
            6);
}

std::string iterated() {
  std::string text = replaced(test::example_selection(), R"("crossed": ["texture"],)", "");
  text = replaced(text, R"("maximum_in_a_row": {"texture": 2},)", "");
  text =
      replaced(text, R"("levels": ["metal", "stone"])", R"("levels": ["metal", "stone", "wood"])");
  text = replaced(text, R"("textures": {)",
                  R"("counterbalance": "williams", "textures": {
                  "wood": {"height_field": "stimuli/wood.png", "picture": "stimuli/wood_photo.png"},)");
  return replaced(text, R"({"run": "main", "break_every_trials": 3,)",
                  R"({"run": "main", "for_each": "texture",)");
}

std::vector<std::string> order_of_blocks(const Plan& plan) {
  std::vector<std::string> order{};
  int block = 0;
  for (const Trial& trial : plan.trials) {
    if (trial.block_ordinal == block) continue;
    block = trial.block_ordinal;
    order.push_back(text_of(trial.factors.at("texture")));
  }
  return order;
}

TEST(Plan, CounterbalancesTheOrderOfAnIteratedFactor) {
  const Protocol protocol = read(iterated());
  ASSERT_EQ(counterbalance_rows(protocol), 6);  // a Williams square of three has six rows
  std::map<std::pair<std::string, std::size_t>, int> places{};
  std::map<std::pair<std::string, std::string>, int> neighbours{};
  for (int row = 0; row < 6; ++row) {
    const auto order = order_of_blocks(make_plan(protocol, {5, row}));
    ASSERT_EQ(order.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      ++places[{order[i], i}];
      if (i > 0) ++neighbours[{order[i - 1], order[i]}];
    }
    EXPECT_EQ(order, order_of_blocks(make_plan(protocol, {99, row}))) << "the row decides, no seed";
    EXPECT_EQ(order, order_of_blocks(make_plan(protocol, {5, row + 6}))) << "rows repeat";
  }
  EXPECT_EQ(places.size(), 9U);
  for (const auto& [place, count] : places) EXPECT_EQ(count, 2);
  EXPECT_EQ(neighbours.size(), 6U);
  for (const auto& [pair, count] : neighbours) EXPECT_EQ(count, 2);
}

TEST(Plan, CounterbalancesTwoFactorsInEveryCombination) {
  std::string text = replaced(iterated(), R"("factors": {)",
                              R"("factors": {"posture": {"levels": ["sitting", "standing"]},)");
  text = replaced(text, R"("blocks": {)", R"("blocks": {"other": {
      "listed": [{"texture": "metal"}, {"texture": "stone"}, {"texture": "wood"}],
      "presented": [{"stimulus": "rendered", "with": {"model": "height_map"}},
                    {"stimulus": "rendered", "with": {"model": "sinusoid"}}],
      "question": {"name": "q", "prompt": "Which?"}, "exploration": "stroking"},)");
  text = replaced(text, R"({"check": "device"},)",
                  R"({"check": "device"}, {"run": "other", "for_each": "posture"},)");
  const Protocol protocol = read(text);
  ASSERT_EQ(counterbalance_rows(protocol), 2 * 6);
  std::set<std::string> orders{};
  for (int row = 0; row < 12; ++row) {
    const Plan plan = make_plan(protocol, {1, row});
    std::string order = text_of(plan.trials.front().factors.at("posture"));
    int block = 0;
    for (const Trial& trial : plan.trials) {
      if (trial.block != "main" || trial.block_ordinal == block) continue;
      block = trial.block_ordinal;
      order += " " + text_of(trial.factors.at("texture"));
    }
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 12U);
}

TEST(Plan, RestsBetweenTheLevelsOfAnIteratedFactor) {
  const Plan plan = make_plan(read(iterated()), {1, 0});
  std::string steps{};
  for (const PlanStep& step : plan.steps) steps += "SCBAT"[step.index()];
  EXPECT_EQ(steps, "SCTTTBTTTBTTT");
}

TEST(Plan, WithoutCounterbalancingThereIsOneRowAndLevelsComeAsListed) {
  const Protocol protocol = read(replaced(iterated(), R"("williams")", R"("none")"));
  EXPECT_EQ(counterbalance_rows(protocol), 1);
  EXPECT_EQ(order_of_blocks(make_plan(protocol, {4, 3})),
            (std::vector<std::string>{"metal", "stone", "wood"}));
}

TEST(Plan, TellsTheExperimenterWhichCodedSampleToPlace) {
  std::string text = replaced(test::example_selection(), R"("photograph")", R"("physical_sample")");
  text = replaced(text, R"("metal": {)", R"("metal": {"code": "K7",)");
  text = replaced(text, R"("stone": {)", R"("stone": {"code": "K2",)");
  text = replaced(text, R"({"name": "most_realistic",)",
                  R"({"name": "most_realistic", "experimenter_prompt": "Place sample {code}.",)");
  for (const Trial& trial : make_plan(read(text), {1, 0}).trials) {
    EXPECT_EQ(trial.experimenter_prompt, text_of(trial.factors.at("texture")) == "metal"
                                             ? "Place sample K7."
                                             : "Place sample K2.");
    EXPECT_FALSE(trial.standard_picture);
  }
}

void expect_bound_to_a_factor(const std::string& model, const std::string& parameter) {
  std::string text = replaced(
      test::example_selection(), R"("texture": {"factor": "texture"},
      "equal_force": {"to_model": "height_map"})",
      R"("texture": "metal", "parameters": {")" + parameter + R"(": {"factor": "scale"}})");
  text = replaced(text, R"("model": {"factor": "model"})", R"("model": ")" + model + '"');
  text = replaced(text, R"("factors": {)", R"("factors": {"scale": {"levels": [0.5, 1, 2]},)");
  text = replaced(text, R"("crossed": ["texture"])", R"("crossed": [])");
  EXPECT_THROW(read(text), ProtocolError);  // an empty crossing is a mistake
  text = replaced(text, R"("crossed": [],)", "");
  text = replaced(text, R"("maximum_in_a_row": {"texture": 2},)", "");
  text = replaced(text, R"({"model": "height_map"}})", R"({"scale": 0.5}, "item": "half"})");
  text = replaced(text, R"({"model": "sinusoid"}})", R"({"scale": 1}, "item": "one"})");
  text = replaced(text, R"({"model": "stochastic"}})", R"({"scale": 2}, "item": "two"})");
  const Plan plan = make_plan(read(text), {1, 0});
  std::set<std::string> items{};
  for (const PlannedPresentation& planned : plan.trials[0].presentations) {
    items.insert(planned.item);
    const double scale = number_of(planned.stimulus.parameters, parameter);
    EXPECT_EQ(scale, planned.item == "half" ? 0.5 : planned.item == "one" ? 1.0 : 2.0);
  }
  EXPECT_EQ(items.size(), 3U);
}

TEST(Plan, BindsParametersToFactors) {
  expect_bound_to_a_factor("height_map", "height_scale");
  expect_bound_to_a_factor("stochastic", "noise_sd_N");  // a unit's capital is part of a name
}

TEST(Plan, GivesASurfaceTheTextureOfItsStimulusAndAToolItsOwn) {
  const Plan plan = make_plan(read(test::example_bodies()), {1, 0});
  ASSERT_EQ(plan.trials.size(), 2U);
  for (const Trial& trial : plan.trials) {
    const std::string ground = text_of(trial.factors.at("ground"));
    for (const PlannedPresentation& planned : trial.presentations) {
      const StimulusDescription& stimulus = planned.stimulus;
      ASSERT_TRUE(stimulus.surface && stimulus.tool);
      EXPECT_EQ(stimulus.surface->name, "plate");
      EXPECT_EQ(stimulus.surface->texture, ground);
      EXPECT_EQ(stimulus.surface->height_field, "stimuli/" + ground + ".png");
      EXPECT_EQ(stimulus.tool->name, planned.item);
      EXPECT_EQ(stimulus.tool->height_field.value_or("smooth"),
                planned.item == "roll" ? "stimuli/stone.png" : "smooth");
      EXPECT_EQ(stimulus.name, "felt_" + ground + "_pd_gradient_" + planned.item);
    }
  }
  const std::string written = json_of(plan.trials.front());
  EXPECT_NE(written.find(R"("tool":{"body":"rasp","mesh":"stimuli/rasp.mesh")"), std::string::npos)
      << written;
}

// Stored plans are compared by their bytes; one that a script has read and written again is still the same plan.
TEST(Plan, IsWrittenAsNlohmannWritesIt) {
  const auto rewritten = [](const std::string& json) {
    return nlohmann::ordered_json::parse(json).dump();
  };
  for (const LibraryProtocol& each : library_protocols()) {
    const Plan plan = make_plan(library(each.name), {.seed = 3, .counterbalance_row = 1});
    for (const Trial& trial : plan.trials) {
      ASSERT_EQ(json_of(trial), rewritten(json_of(trial))) << each.name;
      ASSERT_EQ(nlohmann::ordered_json::parse(factors_json_of(trial)),
                nlohmann::ordered_json::parse(json_of(trial)).at("factors"));
      ASSERT_EQ(factors_json_of(trial), rewritten(factors_json_of(trial)));
    }
  }
  Trial trial = make_plan(read(test::example_bodies()), {1, 0}).trials.front();
  for (const char* text : {"", "\"", "\\", "a\"b\\c/d", "\b\f\n\r\t", "\x01\x1f\x7f",
                           "Rauheit: größer, 粗い", "{", "[", ":", ",", "</script>"}) {
    trial.questions.front().correct.emplace_back(text);
    trial.factors[text] = text;
    trial.presentations.front().stimulus.parameters[text] = text;
  }
  for (const double number : {0.0, -0.0, 1.0, 0.1, 1.0 / 3.0, -2.5e-7, 1e-5, 1e15, 1e16, 1e17,
                              6.02214076e23, 5e-324, 1.7976931348623157e308}) {
    trial.factors["at " + std::to_string(trial.factors.size())] = number;
    trial.presentations.front().equal_force =
        EqualForce{.rms_N = number, .band_low_Hz = number, .band_high_Hz = -number};
    ASSERT_EQ(json_of(trial), rewritten(json_of(trial)));
  }
  const auto read_again = nlohmann::ordered_json::parse(json_of(trial));
  EXPECT_EQ(read_again.at("questions").at(0).at("correct").get<std::vector<std::string>>(),
            trial.questions.front().correct);
  for (const auto& [name, level] : trial.factors) {
    const nlohmann::ordered_json& written = read_again.at("factors").at(name);
    if (const double* number = std::get_if<double>(&level)) {
      EXPECT_EQ(written.get<double>(), *number);
    } else {
      EXPECT_EQ(written.get<std::string>(), std::get<std::string>(level));
    }
  }
  trial.questions.front().correct.front() = "\xff";
  EXPECT_THROW((void)json_of(trial), nlohmann::json::exception);
}

TEST(Plan, AddingABlockDoesNotMoveTheTrialsOfThoseBeforeIt) {
  const std::string before = test::example_selection();
  const std::string after =
      replaced(before, R"({"run": "main", "break_every_trials": 3,)",
               R"({"run": "main"}, {"run": "main", "break_every_trials": 3,)");
  const Plan one = make_plan(read(before), {5, 0});
  const Plan two = make_plan(read(after), {5, 0});
  for (std::size_t i = 0; i < one.trials.size(); ++i) {
    EXPECT_EQ(json_of(one.trials[i]), json_of(two.trials[i]));
  }
}

TEST(PlanCost, AddsUpWhatThePlanHolds) {
  const Protocol protocol = read(test::example_selection());
  const Plan plan = make_plan(protocol, {1, 0});
  const PlanCost cost = cost_of(protocol, plan);
  EXPECT_EQ(cost.trials, 6);
  EXPECT_EQ(cost.contacts, 18);
  // 4 strokes of 0.06 m at 0.06 m/s: 4 s each.
  EXPECT_DOUBLE_EQ(cost.contact_s, 18 * 4.0);
  // Per trial 3 · 4 s + 0.5 s before + 2 · 0.5 s between + 4 s to answer = 17.5 s; the screen of
  // one word takes the shortest reading, 5 s; the check 15 s; one break of 60 s.
  EXPECT_DOUBLE_EQ(cost.total_s, 5.0 + 15.0 + 6 * 17.5 + 60.0);
  EXPECT_DOUBLE_EQ(cost.longest_without_break_s, 5.0 + 15.0 + 3 * 17.5);
}

// Each request takes the shortest reading, 5 s, and each recording 3 s.
TEST(PlanCost, CountsTheDriftChecksOfBreaks) {
  const std::string pause = R"("pause": {"minimum_s": 60})";
  const auto total_s = [](const std::string& text) {
    const Protocol protocol = read(text);
    return cost_of(protocol, make_plan(protocol, {1, 0})).total_s;
  };
  const std::string without = test::example_selection();
  const std::string released = R"("drift_check": {"text": "Let go.", "duration_s": 3)";
  const std::string head = R"("pause": {"minimum_s": 60, )";
  EXPECT_DOUBLE_EQ(total_s(replaced(without, pause, head + released + "}}")) - total_s(without),
                   5.0 + 3.0);
  EXPECT_DOUBLE_EQ(
      total_s(replaced(without, pause, head + released + R"(, "tip_text": "Hold it."}})")) -
          total_s(without),
      2.0 * (5.0 + 3.0));
  EXPECT_THROW(read(replaced(without, pause, head + R"("zero_force": false, )" + released + "}}")),
               ProtocolError);
}

TEST(Criterion, IsMetByTheLastAnswersAlone) {
  const Protocol::Criterion criterion{.correct = 3, .of_last = 4, .maximum_trials = 8};
  EXPECT_EQ(state_of(criterion, {}), BlockState::go_on);
  EXPECT_EQ(state_of(criterion, {true, true}), BlockState::go_on);
  EXPECT_EQ(state_of(criterion, {true, true, true}), BlockState::criterion_met);
  EXPECT_EQ(state_of(criterion, {true, false, true, true}), BlockState::criterion_met);
  // Three right in all, but never three among four in a row.
  EXPECT_EQ(state_of(criterion, {true, false, false, true, true}), BlockState::go_on);
  EXPECT_EQ(state_of(criterion, {true, false, false, true, true, false, false}), BlockState::go_on);
}

TEST(Criterion, FailsAtTheMostTrialsUnlessTheLastAnswerMeetsIt) {
  const Protocol::Criterion criterion{.correct = 2, .of_last = 2, .maximum_trials = 4};
  EXPECT_EQ(state_of(criterion, {true, false, true, false}), BlockState::criterion_failed);
  EXPECT_EQ(state_of(criterion, {true, false, true, true}), BlockState::criterion_met);
}

}  // namespace
}  // namespace asperity

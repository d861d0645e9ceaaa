// The protocols that come with the program: valid, and as careful as they claim to be.

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/observer/virtual_observer.h"
#include "protocols/plan/course.h"
#include "protocols/texts/stated_numbers.h"
#include "protocols/warnings/warnings.h"
#include "tests/protocols/protocol_files.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

class Library : public testing::TestWithParam<LibraryProtocol> {
 protected:
  Protocol protocol() const {
    return read_protocol(GetParam().text, std::string(GetParam().name) + ".json",
                         test::models_of_library());
  }
};

TEST_P(Library, IsValidAndNamedLikeItsFile) {
  try {
    EXPECT_EQ(protocol().name, GetParam().name);
  } catch (const ProtocolError& error) {
    FAIL() << error.what();
  }
}

TEST_P(Library, GivesNoWarning) {
  for (const Diagnostic& warning : warnings_about(protocol(), std::string(GetParam().name))) {
    ADD_FAILURE() << text_of(warning);
  }
}

// Templates get other textures and scales: a number in words would no longer be true. Pairs have two surfaces.
TEST_P(Library, StatesNoNumberOfItsDesignInWords) {
  const Protocol read = protocol();
  std::vector<std::string> texts{};
  for (const Protocol::Step& step : read.flow) {
    if (const auto* const screen = std::get_if<Protocol::Screen>(&step))
      texts.push_back(screen->text);
  }
  for (const std::string& text : texts) {
    for (const StatedNumber& stated : numbers_stated_in(text, "en")) {
      const bool is_of_design = stated.name == "scales" || stated.name == "pictures" ||
                                (stated.name == "surfaces" && stated.number > 2);
      EXPECT_FALSE(is_of_design && stated.number > 1) << stated.words << ": " << text;
    }
    EXPECT_EQ(text.find("finest"), std::string::npos) << text;
  }
}

TEST_P(Library, AsksWhatAnEthicsBoardExpects) {
  const Protocol read = protocol();
  EXPECT_FALSE(read.consent_version.empty());
  EXPECT_NE(read.consent_statement.find("stop at any time"), std::string::npos);
  const std::set<std::string> asked(read.participant_questions.begin(),
                                    read.participant_questions.end());
  for (const char* const name : {"age", "sex", "handedness", "hand_used", "hand_problems"}) {
    EXPECT_TRUE(asked.contains(name)) << name;
  }
  const auto* const first = std::get_if<Protocol::Screen>(&read.flow.front());
  ASSERT_NE(first, nullptr);
  EXPECT_NE(first->text.find("stop at any time"), std::string::npos);
  EXPECT_TRUE(std::any_of(read.flow.begin(), read.flow.end(), [](const Protocol::Step& step) {
    return std::holds_alternative<Protocol::Ask>(step);
  })) << "closing questions";
}

// Even somebody who feels every surface for as long as allowed rests in time.
TEST_P(Library, RestsAtLeastEveryTenMinutesWithTheForceZeroed) {
  Protocol read = protocol();
  for (auto& [name, exploration] : read.explorations) {
    exploration.minimum_contact_s = exploration.maximum_contact_s;
  }
  const Plan plan = example_plan(read, {.seed = 1, .counterbalance_row = 0});
  const PlanCost cost = cost_of(read, plan);
  EXPECT_LE(cost.longest_without_break_s, 600.0);
  EXPECT_LE(cost.total_s, 3600.0);
  int breaks = 0;
  for (const PlanStep& step : plan.steps) {
    if (const auto* const pause = std::get_if<Protocol::Break>(&step)) {
      ++breaks;
      EXPECT_TRUE(pause->zero_force);
      EXPECT_FALSE(pause->text.empty());
    }
  }
  EXPECT_GE(breaks, 1);
}

TEST_P(Library, ChapterVariantsGiveOneOutcomePerColumn) {
  const Protocol read = protocol();
  if (read.design != ProtocolDesign::chapter) return;
  const Plan plan = make_plan(read, {.seed = 7, .counterbalance_row = 0});
  ASSERT_EQ(plan.trials.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(text_of(plan.trials[i].factors.at("column")), std::to_string(i + 1));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Library,
                         testing::ValuesIn(library_protocols().begin(), library_protocols().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(LibraryProtocols, AreTheFilesOfTheLibrary) {
  std::set<std::string> names{};
  for (const LibraryProtocol& each : library_protocols()) names.emplace(each.name);
  std::set<std::string> files{};
  const std::filesystem::path folder = std::string(ASPERITY_SOURCE_DIR) + "/protocols/library";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() == ".json" && file.stem().extension().empty()) files.insert(file.stem());
  }
  EXPECT_EQ(names, files);
}

/// A protocol in German and in English, without what its language decides.
struct InBothLanguages {
  Protocol english{};
  Protocol german{};
  std::string english_rest{};
  std::string german_rest{};
};

std::vector<InBothLanguages> read_in_both_languages() {
  std::vector<InBothLanguages> all{};
  for (const LibraryProtocol& each : library_protocols()) {
    const std::string name(each.name);
    const std::string german = test::library_text(each.name, "de");
    const auto read = [&name](const std::string& text) {
      return read_protocol(text, name, test::models_of_library());
    };
    const std::string english(each.text);
    all.push_back({.english = read(english),
                   .german = read(german),
                   .english_rest = without_texts(english),
                   .german_rest = without_texts(german)});
  }
  return all;
}

const std::vector<InBothLanguages>& in_both_languages() {
  static const std::vector<InBothLanguages> kAll = read_in_both_languages();
  return kAll;
}

TEST(LibraryProtocols, AreTheSameInGermanButForTheirTexts) {
  for (const InBothLanguages& both : in_both_languages()) {
    EXPECT_EQ(both.german.language, "de");
    EXPECT_EQ(both.english.language, "en");
    EXPECT_EQ(both.german.version, both.english.version) << both.german.name;
    EXPECT_EQ(both.german_rest, both.english_rest) << both.german.name;
    EXPECT_NE(both.german.consent_statement.find("jederzeit"), std::string::npos);
    for (const auto& [name, question] : both.german.questions) {
      EXPECT_EQ(values_of(question.options), values_of(both.english.questions.at(name).options))
          << name;
      EXPECT_NE(question.prompt, both.english.questions.at(name).prompt) << name;
      for (const Option& option : question.options) EXPECT_NE(option.text, option.value) << name;
    }
  }
}

TEST(LibraryProtocols, GiveTheSamePlansInGerman) {
  for (const InBothLanguages& both : in_both_languages()) {
    const Plan english = example_plan(both.english, {.seed = 2, .counterbalance_row = 1});
    const Plan german = example_plan(both.german, {.seed = 2, .counterbalance_row = 1});
    ASSERT_EQ(german.trials.size(), english.trials.size());
    for (std::size_t i = 0; i < german.trials.size(); ++i) {
      EXPECT_EQ(test::without_wording(nlohmann::json::parse(json_of(german.trials[i]))),
                test::without_wording(nlohmann::json::parse(json_of(english.trials[i]))))
          << both.german.name << ", trial " << i;
    }
  }
}

Protocol library_protocol(const std::string& name) {
  return read_protocol(test::library_text(name), name, test::models_of_library());
}

TEST(LibraryProtocols, HoldForceAndSpeedByBandsThatDoNotMeet) {
  const std::pair<const char*, std::vector<const char*>> kHeld[] = {
      {"roughness_force", {"light", "medium", "firm"}}, {"roughness_speed", {"slow", "fast"}}};
  for (const auto& [name, conditions] : kHeld) {
    const Protocol read = library_protocol(name);
    double reached = 0.0;
    for (const char* const condition : conditions) {
      const Exploration& asked = read.explorations.at(condition);
      const Band& band =
          read.name == "roughness_force" ? asked.normal_force_N : asked.speed_m_per_s;
      EXPECT_GT(*band.minimum, reached) << name << ' ' << condition;
      reached = *band.maximum;
      EXPECT_EQ(asked.on_failure, Exploration::OnFailure::requeue_at_end_of_block);
      EXPECT_NE(asked.guidance, Exploration::Guidance::experimenter);
      EXPECT_GT(asked.required_fraction_in_band, 0.5);
    }
  }
}

// A share of the normal force would hardly know what force and speed do.
TEST(LibraryProtocols, HaveVirtualNumbersOfForceAndSpeedThatDependOnBoth) {
  for (const char* const name : {"roughness_force", "roughness_speed"}) {
    const ObserverDeclaration observer = library_protocol(name).observer;
    EXPECT_EQ(observer.magnitude_of, ObserverDeclaration::MagnitudeOf::held_tool) << name;
    EXPECT_EQ(observer.magnitude.exponent, 1.0) << name;
    EXPECT_EQ(observer.feature_noise, 0.15) << name;
    EXPECT_EQ(observer.lapse, 0.02) << name;
  }
}

TEST(LibraryProtocols, PractiseTheExtremesAndHoldTipAndHandWithinABlock) {
  for (const char* const name : {"roughness_diameter", "roughness_force", "roughness_speed"}) {
    const Protocol read = library_protocol(name);
    const std::string& factor = read.estimation->condition;
    const std::vector<Level>& levels = read.factors.at(factor).levels;
    const bool is_of_hand = factor != "tip";
    std::set<std::pair<std::string, std::string>> practised{};
    std::set<std::pair<std::size_t, std::string>> places{};  // of a condition among the blocks
    for (int row = 0; row < static_cast<int>(levels.size()); ++row) {
      std::map<int, std::set<std::string>> in_block{};
      std::map<int, int> first_repetition{};
      // By block and repetition, without the anchor.
      std::map<std::pair<int, int>, std::vector<std::string>> waves{};
      const Plan plan = make_plan(read, {.seed = 1, .counterbalance_row = row});
      for (const Trial& trial : plan.trials) {
        const std::string condition = text_of(trial.factors.at(factor));
        const std::string wave = text_of(trial.factors.at("texture"));
        if (is_of_hand) {
          EXPECT_EQ(exploration_of(read, trial).name, condition);
        }
        if (trial.phase != Phase::main) {
          practised.emplace(wave, condition);
          continue;
        }
        if (in_block[trial.block_ordinal].insert(condition).second) {
          places.emplace(in_block.size(), condition);
        }
        first_repetition.emplace(trial.block_ordinal, trial.repetition);
        if (trial.repetition > 0) {
          waves[{trial.block_ordinal, trial.repetition}].push_back(wave);
        }
      }
      EXPECT_EQ(in_block.size(), levels.size());
      for (const auto& [block, conditions] : in_block) EXPECT_EQ(conditions.size(), 1U);
      for (const auto& [block, repetition] : first_repetition) EXPECT_EQ(repetition, 0);  // anchor
      std::set<std::vector<std::string>> orders{};
      for (const auto& [where, order] : waves) {
        EXPECT_EQ(std::set<std::string>(order.begin(), order.end()).size(), 7U);
        EXPECT_EQ(order.size(), 7U) << "each wave once in a repetition";
        orders.insert(order);
      }
      EXPECT_EQ(waves.size(), 3 * levels.size());
      EXPECT_EQ(orders.size(), waves.size()) << "shuffled anew";
    }
    EXPECT_EQ(places.size(), levels.size() * levels.size()) << "each in each place of the square";
    for (const char* const wave : {"spacing_05", "spacing_35"}) {
      if (!is_of_hand) {
        EXPECT_TRUE(practised.contains({wave, "sphere_2mm"})) << wave;
        continue;
      }
      for (const Level& level : {levels.front(), levels.back()}) {
        EXPECT_TRUE(practised.contains({wave, text_of(level)})) << name << ' ' << wave;
      }
    }
  }
}

TEST(LibraryProtocols, CompareTenModelsInEveryPairAndBothOrders) {
  const Protocol read = library_protocol("models_in_pairs");
  EXPECT_EQ(read.factors.at("model").levels.size(), 10U);
  const Plan plan = make_plan(read, {.seed = 3, .counterbalance_row = 0});
  std::map<std::pair<std::string, std::string>, int> pairs{};
  std::set<std::string> familiar{};
  for (const Trial& trial : plan.trials) {
    ASSERT_EQ(trial.presentations.size(), 2U);
    const std::string& first = trial.presentations.front().stimulus.model;
    const std::string& second = trial.presentations.back().stimulus.model;
    if (trial.phase == Phase::main) {
      ++pairs[{first, second}];
    } else {
      familiar.insert({first, second});
    }
  }
  EXPECT_EQ(familiar.size(), 10U) << "each model is felt before the main part";
  EXPECT_EQ(pairs.size(), 90U);
  for (const auto& [pair, count] : pairs) {
    EXPECT_NE(pair.first, pair.second);
    EXPECT_EQ(count, 1) << pair.first << ' ' << pair.second;
  }
}

TEST(LibraryProtocols, ShowDistractorsThatNobodyFeels) {
  const Protocol read = library_protocol("chapter_recognition");
  for (const char* const name : {"sandpaper", "pebbles"}) {
    const Texture& texture = read.textures.at(name);
    EXPECT_FALSE(texture.height_field);
    EXPECT_TRUE(texture.picture && texture.true_height_field);
    EXPECT_NE(texture.note.find("no rendered counterpart"), std::string::npos);
  }
}

// What virtual hands felt on six strokes (seeds 1 to 6) of the textures that scripts/demo-photos
// makes of the photographs (scripts/fetch-photos), rendered by height_map.
const std::vector<std::vector<ForceFeatures>>& strokes_over_the_photographs() {
  static const std::vector<std::vector<ForceFeatures>> kStrokes{
      {ForceFeatures{
           {-4.76, -4.89, -3.98, -3.74, -3.37, -3.58, -4.39, -4.95, -5.61, -6.05}, -2.88, -4.22},
       ForceFeatures{
           {-4.2, -4.06, -3.82, -3.78, -3.74, -3.95, -4.26, -4.65, -5.33, -5.86}, -2.95, -4.35},
       ForceFeatures{
           {-4.65, -4.64, -4.21, -4.01, -3.74, -4.03, -4.11, -4.44, -5.07, -5.61}, -3.1, -4.35}},
      {ForceFeatures{
           {-5.21, -4.98, -4.1, -3.86, -3.52, -3.7, -4.46, -5.07, -5.71, -6.08}, -3.01, -4.37},
       ForceFeatures{
           {-4.5, -4.09, -3.83, -3.84, -3.73, -3.96, -4.21, -4.47, -5.23, -5.76}, -2.97, -4.34},
       ForceFeatures{
           {-4.48, -4.33, -3.88, -3.74, -3.79, -3.79, -3.99, -4.39, -4.92, -5.52}, -2.93, -4.29}},
      {ForceFeatures{
           {-4.6, -4.78, -4.1, -3.84, -3.5, -3.68, -4.42, -5.11, -5.63, -6.02}, -2.97, -4.36},
       ForceFeatures{
           {-4.62, -4.26, -4.1, -3.85, -3.83, -4.09, -4.33, -4.68, -5.23, -5.77}, -3.1, -4.39},
       ForceFeatures{
           {-4.38, -4.32, -4.07, -3.77, -3.8, -3.78, -4.06, -4.36, -4.97, -5.67}, -2.96, -4.3}},
      {ForceFeatures{
           {-4.96, -5.03, -4.05, -3.76, -3.45, -3.63, -4.38, -5.02, -5.67, -5.99}, -2.93, -4.28},
       ForceFeatures{
           {-4.41, -4.08, -3.73, -3.77, -3.66, -4.09, -4.21, -4.72, -5.29, -5.9}, -2.94, -4.32},
       ForceFeatures{
           {-4.97, -4.89, -4.12, -3.99, -3.95, -3.9, -3.97, -4.52, -5.03, -5.71}, -3.11, -4.41}},
      {ForceFeatures{
           {-4.85, -4.86, -4.11, -3.84, -3.47, -3.65, -4.33, -5.03, -5.6, -5.99}, -2.96, -4.35},
       ForceFeatures{
           {-4.58, -4.25, -3.99, -3.8, -3.66, -4.02, -4.34, -4.71, -5.23, -5.77}, -3.02, -4.34},
       ForceFeatures{
           {-4.67, -4.4, -4.04, -3.83, -3.96, -3.93, -3.97, -4.36, -4.98, -5.64}, -3.03, -4.31}},
      {ForceFeatures{
           {-4.89, -4.91, -4.04, -3.78, -3.49, -3.7, -4.44, -5.01, -5.65, -5.99}, -2.97, -4.33},
       ForceFeatures{
           {-4.75, -4.26, -3.86, -3.81, -3.71, -4.18, -4.31, -4.71, -5.23, -5.81}, -3.04, -4.39},
       ForceFeatures{
           {-4.89, -4.67, -4.09, -3.78, -3.7, -3.95, -4.18, -4.48, -4.96, -5.7}, -3.04, -4.36}}};
  return kStrokes;
}

// The priors come from another recipe and another stroke, and still tell the three apart: by chance
// all three are right once in 3! = 6 strokes, and in five or more of six with a probability of
// (6·5 + 1)/6⁶ = 0.0007.
TEST(LibraryProtocols, StatePriorsByWhichThePhotographsCanBeMatched) {
  for (const char* const protocol : {"photo_matching", "photo_recognition"}) {
    const Protocol read = library_protocol(protocol);
    std::vector<ForceFeatures> expected{};
    for (const char* const name : {"brick", "gravel", "grass"}) {
      expected.push_back(read.textures.at(name).prior.value());
    }
    ObserverDeclaration ideal = read.observer;
    ideal.feature_noise = 0.0;
    ideal.position_bias = 0.0;
    ideal.lapse = 0.0;
    int all_right = 0;
    for (const std::vector<ForceFeatures>& felt : strokes_over_the_photographs()) {
      VirtualObserver observer(ideal, Random(1));
      if (observer.match(felt, expected) == std::vector<std::size_t>{0, 1, 2}) ++all_right;
    }
    EXPECT_GE(all_right, 5) << protocol;
  }
}

}  // namespace
}  // namespace asperity

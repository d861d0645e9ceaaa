// The combinations of a block: excluded ones, derived levels, unequal repetitions, and places in the order.

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/design/arithmetic.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/example.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using testing::HasSubstr;

/// A rating of waves: two wavelengths times three speeds, and the keys given in its block.
std::string rated_waves(const std::string& keys) {
  std::string text = test::example_selection();
  text = replaced(text, R"("kind": "selection")", R"("kind": "rating")");
  text = replaced(text, R"(  "realism_standard": "photograph",)", "");
  text = replaced(
      text, R"("model": {"levels": ["height_map", "sinusoid", "stochastic"]},)",
      R"("wavelength": {"levels": [0.001, 0.002]}, "speed": {"levels": [0.02, 0.04, 0.08]},)");
  text =
      replaced(text, R"("model": {"factor": "model"},
      "texture": {"factor": "texture"},
      "equal_force": {"to_model": "height_map"})",
               R"("model": "sinusoid", "parameters": {"wavelength_m": {"factor": "wavelength"}})");
  const std::size_t from = text.find(R"("crossed": ["texture"])");
  const std::size_t to = text.find(R"("exploration": "stroking")");
  return text.replace(from, to - from, R"("crossed": ["wavelength", "speed"], )" + keys + R"(
      "presented": [{"stimulus": "rendered", "item": "wave"}],
      "question": {"name": "rough", "prompt": "How rough?", "scale": {"points": 7}},
      )");
}

Protocol read_waves(const std::string& keys) {
  return read_protocol(rated_waves(keys), "p.json", test::example_models());
}

std::string problems_of_waves(const std::string& keys) {
  try {
    (void)read_waves(keys);
  } catch (const ProtocolError& error) {
    return error.what();
  }
  return {};
}

double number_at(const Trial& trial, const std::string& factor) {
  return std::get<double>(trial.factors.at(factor));
}

std::vector<Trial> trials_with(const std::string& keys, std::uint64_t seed = 1) {
  const Plan plan = make_plan(read_waves(keys), {.seed = seed});
  return {plan.trials.begin(), plan.trials.end()};
}

double value_of(const std::string& formula) {
  const auto parsed = Arithmetic::parse(formula);
  EXPECT_TRUE(std::holds_alternative<Arithmetic>(parsed)) << formula;
  if (!std::holds_alternative<Arithmetic>(parsed)) return std::nan("");
  return std::get<Arithmetic>(parsed).value(
      [](const std::string& name) { return name == "speed" ? 8.0 : 2.0; });
}

TEST(Arithmetic, FollowsTheUsualPrecedence) {
  EXPECT_EQ(value_of("1 + 2 * 3"), 7.0);
  EXPECT_EQ(value_of("(1 + 2) * 3"), 9.0);
  EXPECT_EQ(value_of("8 - 4 - 2"), 2.0);
  EXPECT_EQ(value_of("8 / 4 / 2"), 1.0);
  EXPECT_EQ(value_of("-speed + 1"), -7.0);
  EXPECT_EQ(value_of("2 * -(speed / spacing)"), -8.0);
  EXPECT_DOUBLE_EQ(value_of("1.5e-1*speed"), 1.2);
}

TEST(Arithmetic, StatesWhatCannotBeRead) {
  const auto problem = [](const std::string& formula) {
    const auto parsed = Arithmetic::parse(formula);
    const auto* const found = std::get_if<ArithmeticProblem>(&parsed);
    return found == nullptr ? std::string() : found->text.english();
  };
  EXPECT_EQ(problem("speed /"), "a number, a factor or \"(\" is missing at character 8");
  EXPECT_EQ(problem("(1 + 2"), "a \")\" is missing at character 7");
  EXPECT_EQ(problem("speed ^ 2"), "\"^\" is not expected at character 7");
  EXPECT_EQ(problem("1 2"), "\"2\" is not expected at character 3");
  EXPECT_THAT(problem(std::string(100, '(') + "1"), HasSubstr("too many levels of parentheses"));
  EXPECT_NE(problem(""), "");
}

TEST(ExcludedCombinations, AreAbsent) {
  const std::vector<Trial> trials =
      trials_with(R"("exclude": [{"wavelength": 0.001, "speed": 0.08}, {"speed": 0.02}],)");
  ASSERT_EQ(trials.size(), 3U);  // 6 without 1 and without 2
  for (const Trial& trial : trials) {
    EXPECT_NE(number_at(trial, "speed"), 0.02);
    EXPECT_FALSE(number_at(trial, "wavelength") == 0.001 && number_at(trial, "speed") == 0.08);
  }
}

TEST(ExcludedCombinations, MustExistAndLeaveSome) {
  EXPECT_THAT(problems_of_waves(R"("exclude": [{"speed": 0.03}],)"),
              HasSubstr("is not a level of the factor \"speed\""));
  EXPECT_THAT(
      problems_of_waves(R"("exclude": [{"speed": 0.02}, {"speed": 0.04}, {"speed": 0.08}],)"),
      HasSubstr("all combinations are excluded; remove entries (/blocks/main/exclude)"));
  EXPECT_THAT(problems_of_waves(R"("exclude": [{"texture": "stone"}],)"),
              HasSubstr("neither crosses, lists nor varies the factor \"texture\""));
}

TEST(DerivedLevels, AreComputedInEveryTrialAndBoundLikeAnyFactor) {
  const std::string keys = R"("derived": {"frequency": "speed / wavelength"},)";
  for (const Trial& trial : trials_with(keys)) {
    EXPECT_NEAR(number_at(trial, "frequency"),
                number_at(trial, "speed") / number_at(trial, "wavelength"), 1e-9);
  }
  const Protocol protocol = read_waves(keys);
  // 20, 40, 80 and 10, 20, 40 Hz.
  EXPECT_EQ(protocol.factors.at("frequency").levels, (std::vector<Level>{10.0, 20.0, 40.0, 80.0}));
  EXPECT_EQ(protocol.factors.at("frequency").meaning, "Computed as speed / wavelength");
  const Protocol bound =
      read_protocol(replaced(rated_waves(R"("derived": {"half": "0.3 * wavelength"},)"),
                             R"({"factor": "wavelength"})", R"({"factor": "half"})"),
                    "p.json", test::example_models());
  // 12 significant digits: 0.3 · 0.001 is the level 0.0003.
  EXPECT_EQ(bound.factors.at("half").levels, (std::vector<Level>{0.0003, 0.0006}));
}

TEST(DerivedLevels, AreRefusedWhereTheyCannotBeComputed) {
  EXPECT_THAT(problems_of_waves(R"("derived": {"frequency": "speed / wavelenght"},)"),
              HasSubstr("did you mean \"wavelength\"?"));
  EXPECT_THAT(problems_of_waves(R"("derived": {"frequency": "speed /"},)"),
              HasSubstr("the formula cannot be read: a number, a factor or \"(\" is missing at "
                        "character 8; correct it (/blocks/main/derived/frequency)"));
  EXPECT_THAT(problems_of_waves(R"x("derived": {"frequency": "speed / (wavelength - 0.002)"},)x"),
              HasSubstr("no finite value for speed 0.02, wavelength 0.002"));
  EXPECT_THAT(problems_of_waves(R"("derived": {"speed": "2 * wavelength"},)"),
              HasSubstr("declared with levels and cannot be computed"));
  EXPECT_THAT(problems_of_waves(R"("derived": {"f": "speed / g", "g": "wavelength"},)"),
              HasSubstr("\"g\" is itself computed"));
  EXPECT_THAT(problems_of_waves(R"("derived": {"f": "2 * texture"},)"),
              HasSubstr("neither crosses, lists nor varies the factor \"texture\""));
  // The place of a level that the parameter does not accept is that of the formula.
  EXPECT_THAT(
      [] {
        (void)read_protocol(replaced(rated_waves(R"("derived": {"far": "1000 * wavelength"},)"),
                                     R"({"factor": "wavelength"})", R"({"factor": "far"})"),
                            "p.json", test::example_models());
      },
      testing::ThrowsMessage<ProtocolError>(HasSubstr("(/blocks/main/derived/far)")));
}

TEST(UnequalRepetitions, ArePresentedThatOften) {
  const std::vector<Trial> trials = trials_with(
      R"("repetitions": 2, "repetitions_of": [{"levels": {"speed": 0.04}, "repetitions": 5},
                                              {"levels": {"speed": 0.08}, "repetitions": 1}],)");
  ASSERT_EQ(trials.size(), 16U);  // two wavelengths times 2 + 5 + 1
  std::map<double, std::multiset<int>> repetitions{};
  for (const Trial& trial : trials) {
    repetitions[number_at(trial, "speed")].insert(trial.repetition);
  }
  EXPECT_EQ(repetitions.at(0.02), (std::multiset<int>{1, 1, 2, 2}));
  EXPECT_EQ(repetitions.at(0.04), (std::multiset<int>{1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
  EXPECT_EQ(repetitions.at(0.08), (std::multiset<int>{1, 1}));
}

TEST(UnequalRepetitions, AreRefusedWhereTheyContradictEachOther) {
  EXPECT_THAT(problems_of_waves(
                  R"("repetitions_of": [{"levels": {"speed": 0.04}, "repetitions": 5},
                                {"levels": {"wavelength": 0.001}, "repetitions": 3}],)"),
              HasSubstr("already has repetitions by an earlier entry"));
  EXPECT_THAT(problems_of_waves(R"("exclude": [{"speed": 0.04}],
                   "repetitions_of": [{"levels": {"speed": 0.04}, "repetitions": 5}],)"),
              HasSubstr("no combination has speed 0.04"));
  EXPECT_THAT(problems_of_waves(R"("order": "shuffle_within_repetition",
                   "repetitions_of": [{"levels": {"speed": 0.04}, "repetitions": 5}],)"),
              HasSubstr("with unequal repetitions the repetitions do not have the same trials"));
}

TEST(MinimumDistance, SeparatesTrialsWithTheSameLevel) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<Trial> trials =
        trials_with(R"("repetitions": 3, "minimum_distance": {"speed": 3},)", seed);
    ASSERT_EQ(trials.size(), 18U);
    for (std::size_t i = 0; i + 2 < trials.size(); ++i) {
      EXPECT_NE(number_at(trials[i], "speed"), number_at(trials[i + 1], "speed"));
      EXPECT_NE(number_at(trials[i], "speed"), number_at(trials[i + 2], "speed"));
    }
  }
}

TEST(MinimumDistance, IsRefusedWithTheReasonWhereItCannotBeMet) {
  EXPECT_THAT(problems_of_waves(R"("repetitions": 2, "minimum_distance": {"speed": 4},)"),
              HasSubstr("the level \"0.02\" has 4 trials, which at a distance of 4 need 13 "
                        "positions, but the block has 12 trials"));
  EXPECT_THAT(problems_of_waves(R"("order": "fixed", "minimum_distance": {"wavelength": 2},)"),
              HasSubstr("the fixed order of this block violates \"minimum_distance\""));
  // Each alone is possible: six positions of each wavelength in turn leave none for the third speed.
  EXPECT_THAT(problems_of_waves(R"("minimum_distance": {"wavelength": 2, "speed": 4},)"),
              HasSubstr("(/blocks/main/minimum_distance)"));
}

TEST(FixedPositions, HaveTheirLevels) {
  std::set<double> first{};
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const std::vector<Trial> trials = trials_with(
        R"("repetitions": 2, "fixed_positions": [{"position": 1, "levels": {"speed": 0.08}},
           {"position": 12, "levels": {"speed": 0.02, "wavelength": 0.002}}],)",
        seed);
    ASSERT_EQ(trials.size(), 12U);
    EXPECT_EQ(number_at(trials.front(), "speed"), 0.08);
    first.insert(number_at(trials.front(), "wavelength"));
    EXPECT_EQ(number_at(trials.back(), "speed"), 0.02);
    EXPECT_EQ(number_at(trials.back(), "wavelength"), 0.002);
  }
  EXPECT_EQ(first.size(), 2U) << "what is not fixed is drawn";
}

TEST(FixedPositions, AreRefusedWithTheReasonWhereTheyCannotBeMet) {
  EXPECT_THAT(
      problems_of_waves(R"("fixed_positions": [{"position": 7, "levels": {"speed": 0.08}}],)"),
      HasSubstr("the block has 6 trials; state a position from 1 to 6"));
  EXPECT_THAT(problems_of_waves(R"("fixed_positions": [{"position": 1, "levels": {"speed": 0.08}},
         {"position": 2, "levels": {"speed": 0.08}}, {"position": 3, "levels": {"speed": 0.08}}],)"),
              HasSubstr("only 2 trials have speed 0.08, and more positions require them"));
  EXPECT_THAT(problems_of_waves(R"("fixed_positions": [{"position": 1, "levels": {"speed": 0.08}},
         {"position": 1, "levels": {"speed": 0.02}}],)"),
              HasSubstr("the position 1 is already fixed"));
  EXPECT_THAT(problems_of_waves(R"("minimum_distance": {"speed": 2},
         "fixed_positions": [{"position": 1, "levels": {"speed": 0.08}},
         {"position": 2, "levels": {"speed": 0.08}}],)"),
              HasSubstr("satisfies \"fixed_positions\" together with the other constraints"));
}

}  // namespace
}  // namespace asperity

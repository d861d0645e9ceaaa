// Stated effects as levels of a power analysis.

#include "app/power/curve/effect_levels.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::vector<Assumption>& assumptions() {
  static const std::vector<Assumption> kAssumptions{
      {.name = "pairs.rougher.order",
       .part = Assumption::Part::effect,
       .value = 0.3,
       .unit = "log-odds",
       .source = "pilot of 8 participants"},
      {.name = "pairs.rougher.ratio",
       .part = Assumption::Part::effect,
       .unit = "1",
       .null_value = 1.0},
      {.name = "pairs.rougher.order_sd", .part = Assumption::Part::effect_sd, .value = 0.2}};
  return kAssumptions;
}

TEST(StatedEffect, HasANameAndValues) {
  const StatedEffect effect = stated_effect_in("pairs.rougher.order=0.5,null,-1e-1");
  EXPECT_EQ(effect.name, "pairs.rougher.order");
  EXPECT_THAT(effect.values, ElementsAre(0.5, std::nullopt, -0.1));
  for (const std::string text : {"order", "=0.5", "order=", "order=a", "order=1,,2", "order=nan"}) {
    EXPECT_THAT(refusal_of<std::invalid_argument>([&] { stated_effect_in(text); }),
                HasSubstr("write NAME=VALUE"))
        << text;
  }
}

TEST(EffectLevels, AreOneForEachValue) {
  const std::vector<EffectLevel> levels =
      effect_levels(assumptions(),
                    {stated_effect_in("pairs.rougher.order=0.5,null"),
                     stated_effect_in("pairs.rougher.ratio=null")},
                    "smallest effect of interest");
  ASSERT_THAT(levels, SizeIs(2));
  EXPECT_EQ(levels[0].text, "pairs.rougher.order=0.5, pairs.rougher.ratio=1");
  EXPECT_EQ(levels[0].assumptions[0].value, 0.5);
  EXPECT_EQ(levels[0].assumptions[0].source, "smallest effect of interest");
  EXPECT_EQ(levels[0].assumptions[2].value, 0.2);
  EXPECT_FALSE(levels[0].is_null);
  EXPECT_EQ(levels[1].text, "pairs.rougher.order=0, pairs.rougher.ratio=1");
  EXPECT_EQ(levels[1].assumptions[0].source, kNoEffect) << "not an effect of interest";
  EXPECT_TRUE(levels[1].is_null);
}

// The same effect of two questions.
TEST(EffectLevels, AnEndOfSeveralNamesStatesThemAll) {
  std::vector<Assumption> two = assumptions();
  two.push_back(
      {.name = "pairs.harder.order", .part = Assumption::Part::effect, .null_value = 0.1});
  const std::vector<EffectLevel> levels = effect_levels(two, {stated_effect_in("order=null")}, "s");
  EXPECT_EQ(levels[0].text, "pairs.rougher.order=0, pairs.harder.order=0.1");
  EXPECT_THAT(levels[0].stated, ElementsAre("pairs.rougher.order", "pairs.harder.order"));
}

// An effect without a value is not at its value without an effect: the model refuses it.
TEST(EffectLevels, WithoutStatedEffectsAreTheAssumptions) {
  const std::vector<EffectLevel> levels = effect_levels(assumptions(), {}, "unused");
  ASSERT_THAT(levels, SizeIs(1));
  EXPECT_EQ(levels[0].text, "pairs.rougher.order=0.3");
  EXPECT_EQ(levels[0].assumptions[0].source, "pilot of 8 participants");
  EXPECT_FALSE(levels[0].is_null);
}

TEST(EffectLevels, RefuseUnknownNamesWithTheKnownOnes) {
  const auto refusal = [](const std::vector<StatedEffect>& stated) {
    return refusal_of<std::invalid_argument>([&] { effect_levels(assumptions(), stated, ""); });
  };
  EXPECT_EQ(refusal({stated_effect_in("pairs.rougher.order_sd=1")}),
            "pairs.rougher.order_sd is not an effect of the protocol; its effects are "
            "pairs.rougher.order (log-odds) and pairs.rougher.ratio");
  EXPECT_THAT(refusal({stated_effect_in("pairs.rougher.order=1"), stated_effect_in("order=2")}),
              HasSubstr("is stated twice"));
  EXPECT_THAT(refusal({stated_effect_in("pairs.rougher.order=1,2"),
                       stated_effect_in("pairs.rougher.ratio=1,2")}),
              HasSubstr("several effects have more than one value"));
}

// Tables with other values of the stated effects have the same remaining assumptions.
TEST(EffectLevels, HaveTheRestInCommon) {
  const std::vector<Assumption> rest =
      without_stated(assumptions(), {stated_effect_in("pairs.rougher.order=0.5")});
  EXPECT_FALSE(rest[0].value);
  EXPECT_EQ(rest[0].source, "");
  EXPECT_EQ(rest[2].value, 0.2);
}

}  // namespace
}  // namespace asperity

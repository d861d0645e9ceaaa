// Pairs whose dissimilarity is rated: how they are planned and shared, and what a file cannot ask.

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/plan/block_rows.h"
#include "protocols/plan/course.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// The library's protocol without its familiarisation.
json rated_models() {
  json protocol = test::library_file("map_of_renderings");
  protocol["blocks"].erase("familiarisation");
  for (const char* const factor : {"familiar_1", "familiar_2"}) {
    protocol["factors"].erase(factor);
    protocol["stimuli"].erase(factor);
  }
  protocol["flow"] = json::parse(R"([{"run": "ratings"}])");
  return protocol;
}

json& ratings_block(json& protocol) { return protocol["blocks"]["ratings"]; }

/// With the first `count` of the ten models.
json with_models(std::size_t count, const json& all_pairs) {
  json protocol = rated_models();
  json& levels = protocol["factors"]["model"]["levels"];
  levels.erase(levels.begin() + static_cast<std::ptrdiff_t>(count), levels.end());
  json& stated = ratings_block(protocol)["all_pairs"];
  stated = {{"factor", "model"}};
  if (!all_pairs.is_null()) stated.update(all_pairs);
  ratings_block(protocol)["positions"] = "shuffle";
  if (stated.value("in_both_orders", false)) ratings_block(protocol).erase("positions");
  return protocol;
}

Protocol valid_ratings(const json& protocol) {
  return test::valid(protocol, test::models_of_library());
}

std::string problem_in_ratings(const json& protocol, const std::string& pointer) {
  return test::problems_at(protocol, pointer, test::models_of_library());
}

using ModelPair = std::pair<std::string, std::string>;

ModelPair felt_in(const Trial& trial) {
  return {trial.presentations.at(0).item, trial.presentations.at(1).item};
}

ModelPair in_either_order(ModelPair pair) {
  if (pair.second < pair.first) std::swap(pair.first, pair.second);
  return pair;
}

/// How often each pair is rated, whatever its order.
std::map<ModelPair, int> rated_pairs(const Plan& plan) {
  std::map<ModelPair, int> pairs{};
  for (const Trial& trial : plan.trials) ++pairs[in_either_order(felt_in(trial))];
  return pairs;
}

TEST(RatedPairs, AreAllPairsOnceAndEachSurfaceWithItself) {
  const Plan plan = make_plan(valid_ratings(rated_models()), {.seed = 3});
  const std::map<ModelPair, int> pairs = rated_pairs(plan);
  EXPECT_EQ(plan.trials.size(), 10U * 9U / 2U + 10U);
  EXPECT_EQ(pairs.size(), plan.trials.size()) << "each of them once";
  EXPECT_EQ(std::count_if(pairs.begin(), pairs.end(),
                          [](const auto& each) { return each.first.first == each.first.second; }),
            10);
}

TEST(RatedPairs, ComeInBothOrdersAndRepeatedlyForTheReliability) {
  json protocol = with_models(5, {{"in_both_orders", true}, {"with_identical", true}});
  ratings_block(protocol)["repetitions"] = 2;
  std::map<ModelPair, int> orders{};
  for (const Trial& trial : make_plan(valid_ratings(protocol), {.seed = 4}).trials) {
    ++orders[felt_in(trial)];
  }
  EXPECT_EQ(orders.size(), 5U * 4U + 5U) << "every order, and identical pairs, which have one";
  for (const auto& [pair, times] : orders) EXPECT_EQ(times, 2) << pair.first << ' ' << pair.second;
}

TEST(RatedPairs, BeginWithEitherSurfaceEquallyOftenInBalancedPositions) {
  json protocol = with_models(8, {});
  ratings_block(protocol)["positions"] = "balanced";
  int in_order_of_levels = 0;
  const json& levels = protocol["factors"]["model"]["levels"];
  const auto place = [&levels](const std::string& level) {
    return std::find(levels.begin(), levels.end(), level) - levels.begin();
  };
  const Plan plan = make_plan(valid_ratings(protocol), {.seed = 5});
  for (const Trial& trial : plan.trials) {
    const ModelPair felt = felt_in(trial);
    if (place(felt.first) < place(felt.second)) ++in_order_of_levels;
  }
  EXPECT_EQ(plan.trials.size(), 28U);
  EXPECT_EQ(in_order_of_levels, 14);
}

/// The plans of successive participants, one for each part.
std::vector<Plan> plans_of_parts(const json& protocol, int parts) {
  const Protocol read = valid_ratings(protocol);
  EXPECT_EQ(counterbalance_rows(read), parts);
  std::vector<Plan> plans{};
  for (int row = 0; row < parts; ++row) {
    plans.push_back(make_plan(read, {.seed = 6, .counterbalance_row = row}));
  }
  return plans;
}

TEST(PartsOfPairs, ContainEveryPairOnceAndEveryLevelEquallyOften) {
  for (const auto& [models, parts] :
       {std::pair(10, 3), std::pair(10, 4), std::pair(10, 9), std::pair(9, 3), std::pair(7, 2)}) {
    SCOPED_TRACE(std::to_string(models) + " models in " + std::to_string(parts) + " parts");
    std::map<ModelPair, int> of_all{};
    std::set<std::size_t> sizes{};
    for (const Plan& plan :
         plans_of_parts(with_models(static_cast<std::size_t>(models), {{"parts", parts}}), parts)) {
      sizes.insert(plan.trials.size());
      std::map<std::string, int> occurrences{};
      for (const auto& [pair, times] : rated_pairs(plan)) {
        of_all[pair] += times;
        ++occurrences[pair.first];
        ++occurrences[pair.second];
      }
      EXPECT_EQ(occurrences.size(), static_cast<std::size_t>(models));
      const auto [fewest, most] =
          std::minmax_element(occurrences.begin(), occurrences.end(),
                              [](const auto& a, const auto& b) { return a.second < b.second; });
      EXPECT_LE(most->second - fewest->second, models % 2) << "an odd level is left over";
    }
    EXPECT_EQ(of_all.size(), static_cast<std::size_t>(models * (models - 1) / 2));
    for (const auto& [pair, times] : of_all) EXPECT_EQ(times, 1) << pair.first << pair.second;
    EXPECT_LE(*sizes.rbegin() - *sizes.begin(), static_cast<std::size_t>(models / 2))
        << "one round";
  }
}

/// The number of groups of levels that are not related by any rated pair.
std::size_t unrelated_groups(const Plan& plan) {
  std::map<std::string, std::string> leader{};
  const auto leader_of = [&leader](std::string level) {
    while (leader.emplace(level, level).first->second != level) level = leader.at(level);
    return level;
  };
  for (const auto& [pair, times] : rated_pairs(plan)) {
    leader[leader_of(pair.first)] = leader_of(pair.second);
  }
  return static_cast<std::size_t>(std::count_if(
      leader.begin(), leader.end(), [](const auto& each) { return each.first == each.second; }));
}

// With ten levels there are nine rounds. Every third of them would leave four levels unrelated to the others.
TEST(PartsOfPairs, RelateAllLevelsForEachParticipantWithTwoRoundsOrMore) {
  for (const auto& [models, parts] :
       {std::pair(10, 3), std::pair(10, 4), std::pair(9, 3), std::pair(9, 4), std::pair(6, 2)}) {
    for (const Plan& plan :
         plans_of_parts(with_models(static_cast<std::size_t>(models), {{"parts", parts}}), parts)) {
      EXPECT_EQ(unrelated_groups(plan), 1U) << models << " models in " << parts << " parts";
    }
  }
}

TEST(PartsOfPairs, HaveIdenticalPairsAndBothOrdersInEachOfThem) {
  for (const Plan& plan : plans_of_parts(
           with_models(6, {{"parts", 5}, {"in_both_orders", true}, {"with_identical", true}}), 5)) {
    EXPECT_EQ(plan.trials.size(), 3U * 2U + 6U) << "a round of three pairs";
    std::set<ModelPair> orders{};
    for (const Trial& trial : plan.trials) orders.insert(felt_in(trial));
    for (const ModelPair& pair : orders) {
      EXPECT_TRUE(orders.contains({pair.second, pair.first}));
    }
  }
}

TEST(PartsOfPairs, OccurWithEveryOrderOfTheCounterbalancing) {
  json protocol = with_models(6, {{"parts", 2}});
  protocol["factors"]["hand"] = {{"levels", {"left", "right"}}};
  protocol["counterbalance"] = "latin";
  protocol["flow"] = json::parse(R"([{"run": "ratings", "for_each": "hand"}])");
  const Protocol read = valid_ratings(protocol);
  ASSERT_EQ(counterbalance_rows(read), 4);
  std::set<std::pair<std::string, std::size_t>> found{};
  for (int row = 0; row < 4; ++row) {
    const Plan plan = make_plan(read, {.seed = 6, .counterbalance_row = row});
    // Five rounds of three pairs: three rounds in the first part and two in the second, for each hand.
    found.emplace(text_of(plan.trials.front().factors.at("hand")), plan.trials.size());
  }
  EXPECT_EQ(found, (std::set<std::pair<std::string, std::size_t>>{
                       {"left", 18}, {"left", 12}, {"right", 18}, {"right", 12}}));
}

TEST(PartsOfPairs, AreTheSameForAParticipantInAnySeedAndOrderedByIt) {
  const Protocol read = valid_ratings(with_models(10, {{"parts", 3}}));
  const Plan one = make_plan(read, {.seed = 1, .counterbalance_row = 1});
  const Plan other = make_plan(read, {.seed = 2, .counterbalance_row = 1});
  EXPECT_EQ(rated_pairs(one), rated_pairs(other));
  const auto order = [](const Plan& plan) {
    std::vector<ModelPair> pairs{};
    for (const Trial& trial : plan.trials) pairs.push_back(felt_in(trial));
    return pairs;
  };
  EXPECT_NE(order(one), order(other));
  EXPECT_EQ(order(one), order(make_plan(read, {.seed = 1, .counterbalance_row = 4})))
      << "row 4 is the same part again";
}

TEST(PartsOfPairs, CountTheTrialsOfTheLargestOne) {
  const Protocol read = valid_ratings(with_models(10, {{"parts", 4}, {"with_identical", true}}));
  const Protocol::Block& block = read.blocks.at("ratings");
  EXPECT_EQ(row_count(read, block), 55U);
  EXPECT_EQ(trial_count(read, block), 3U * 5U + 10U) << "nine rounds: 3 + 2 + 2 + 2";
}

TEST(RatedPairs, AskForOnePointOnOneScale) {
  const Plan plan = make_plan(valid_ratings(rated_models()), {.seed = 3});
  for (const Trial& trial : plan.trials) {
    ASSERT_EQ(trial.questions.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<ScaleForm>(trial.questions.front().form));
    EXPECT_TRUE(trial.questions.front().options.empty());
    EXPECT_TRUE(trial.questions.front().correct.empty());
  }
}

TEST(Similarity, RefusesWhatIsNoRatingOfTwoSurfaces) {
  json one = rated_models();
  ratings_block(one).erase("all_pairs");
  ratings_block(one)["crossed"] = {"model"};
  EXPECT_THAT(problem_in_ratings(one, "/blocks/ratings/presented"),
              HasSubstr("exactly two surfaces"));
  json twice = rated_models();
  json question = ratings_block(twice)["question"];
  ratings_block(twice).erase("question");
  ratings_block(twice)["questions"] = json::array({question, question});
  ratings_block(twice)["questions"][1]["name"] = "again";
  EXPECT_THAT(problem_in_ratings(twice, "/blocks/ratings/questions"),
              HasSubstr("a similarity needs one question answered by a scale"));
  json as_listed = rated_models();
  ratings_block(as_listed).erase("positions");
  EXPECT_THAT(problem_in_ratings(as_listed, "/blocks/ratings/all_pairs"),
              HasSubstr("always be presented first"));
}

TEST(Similarity, RefusesPartsThatAreNotThere) {
  const std::string place = "/blocks/ratings/all_pairs/parts";
  EXPECT_EQ(problem_in_ratings(with_models(6, {{"parts", 5}}), place), "");
  EXPECT_THAT(problem_in_ratings(with_models(6, {{"parts", 6}}), place),
              HasSubstr("at most 5 parts"));
  EXPECT_THAT(problem_in_ratings(with_models(7, {{"parts", 8}}), place),
              HasSubstr("at most 7 parts"));
  EXPECT_THAT(problem_in_ratings(with_models(6, {{"parts", 0}}), place), HasSubstr("1"));
  json two = with_models(6, {{"parts", 2}});
  two["blocks"]["second"] = two["blocks"]["ratings"];
  two["flow"].push_back({{"run", "second"}});
  EXPECT_EQ(problem_in_ratings(two, place), "");
  two["blocks"]["second"]["all_pairs"]["parts"] = 3;
  EXPECT_THAT(problem_in_ratings(two, place),
              HasSubstr("the block \"second\" are divided into 3 parts"));
}

TEST(Similarity, ChecksTheOrderOfEveryPart) {
  // Three rounds of three pairs in the first part, two in the second: 9 trials, and 6.
  json protocol = with_models(6, {{"parts", 2}});
  ratings_block(protocol)["positions"] = "balanced";
  EXPECT_THAT(problem_in_ratings(protocol, "/blocks/ratings/positions"),
              HasSubstr("the block has 9"));
  ratings_block(protocol)["positions"] = "shuffle";
  protocol["factors"]["load"] = {{"levels", {"low", "high"}}};
  ratings_block(protocol)["crossed"] = {"load"};
  const auto fixed_at = [&protocol](int position) {
    const json low = {{"load", "low"}};
    ratings_block(protocol)["fixed_positions"] = json::array();
    ratings_block(protocol)["fixed_positions"].push_back({{"position", position}, {"levels", low}});
    return problem_in_ratings(protocol, "/blocks/ratings/fixed_positions/0/position");
  };
  EXPECT_EQ(fixed_at(12), "");
  EXPECT_NE(fixed_at(13), "") << "18 trials in the first part, and 12 in the second";
}

TEST(Similarity, KeepsItsKeysToItself) {
  json protocol = rated_models();
  protocol["kind"] = "paired_comparison";
  protocol.erase("analysis");
  ratings_block(protocol)["question"].erase("scale");
  ratings_block(protocol)["question"]["rates"] = "similarity";
  ratings_block(protocol)["all_pairs"]["parts"] = 3;
  EXPECT_THAT(problem_in_ratings(protocol, "/blocks/ratings/question/rates"),
              HasSubstr("only a similarity has this key"));
  EXPECT_THAT(problem_in_ratings(protocol, "/blocks/ratings/all_pairs/parts"),
              HasSubstr("only a similarity"));
  EXPECT_THAT(problem_in_ratings(protocol, "/blocks/ratings/all_pairs/with_identical"),
              HasSubstr("only a similarity"));
}

TEST(Similarity, AsksOneQuestionInAllItsMainBlocks) {
  json protocol = with_models(6, {});
  protocol["blocks"]["second"] = protocol["blocks"]["ratings"];
  protocol["flow"].push_back({{"run", "second"}});
  const std::string place = "/blocks/second/question";
  EXPECT_EQ(problem_in_ratings(protocol, place), "");
  json reversed = protocol;
  reversed["blocks"]["second"]["question"]["rates"] = "similarity";
  EXPECT_THAT(problem_in_ratings(reversed, place), HasSubstr("has another question"));
  json longer = protocol;
  longer["blocks"]["second"]["question"]["scale"]["maximum"] = 10;
  EXPECT_THAT(problem_in_ratings(longer, place + "/name"), HasSubstr("on another scale"));
  json stated = protocol;
  stated["blocks"]["second"]["question"]["rates"] = "dissimilarity";
  EXPECT_EQ(problem_in_ratings(stated, place), "") << "the same as without the key";
}

}  // namespace
}  // namespace asperity

// The gates in small: some two hundred trials of each kind, judged by exact intervals.

#include "tests/gates/gate_checks.h"

namespace asperity {
namespace {

// With two hundred trials an exact interval is wider than the gate; chance has to lie in it.
constexpr double kNoMargin = 1.0;
// Enough to be judged: 2.5 s of contact are 150 mm, and 51 mm give features.
constexpr int kFewStrokes = 2;

TEST(DeafObserver, AnswersByChanceInEveryKind) {
  SimulatedStudy study;
  const GateCounts selection =
      study.run({"chapter_selection", GateObserver::deaf, 17, 4, {101}, kFewStrokes});
  EXPECT_EQ(selection.trials, 204U);
  expect_no_model_preferred(selection, kNoMargin);
  expect_all_marked_as_guesses(selection);

  const GateCounts matching =
      study.run({"improved_matching", GateObserver::deaf, 52, 4, {102}, kFewStrokes});
  EXPECT_EQ(matching.trials, 208U);
  expect_items_by_chance(matching, 4, kNoMargin);
  expect_by_chance("matched wholly", {matching.whole, matching.trials}, whole_chance(4), kNoMargin);
  expect_all_marked_as_guesses(matching);

  const GateCounts recognition =
      study.run({"improved_recognition", GateObserver::deaf, 10, 5, {103}, kFewStrokes});
  EXPECT_EQ(recognition.trials, 200U);
  expect_by_chance("recognised", {recognition.right, recognition.trials}, 1.0 / 6.0, kNoMargin);
  expect_all_marked_as_guesses(recognition);

  const GateCounts tools =
      study.run({"tools_matching", GateObserver::deaf, 6, 1, {107}, kFewStrokes});
  EXPECT_EQ(tools.trials, 6U);
  expect_items_by_chance(tools, 3, kNoMargin);
  expect_all_marked_as_guesses(tools);
}

TEST(NoiselessObserver, GetsMostItemsRightOnTexturesWithKnownHeights) {
  SimulatedStudy study;
  expect_most_items_right(
      "matched", study.run({"improved_matching", GateObserver::noiseless, 24, 2, {104}, {}}));
  expect_most_items_right(
      "recognised", study.run({"improved_recognition", GateObserver::noiseless, 10, 5, {105}, {}}));
  // Expected are the same bodies, felt by another hand.
  expect_most_items_right(
      "matched tools",
      study.run({"tools_matching", GateObserver::noiseless, 3, 1, {106}, kFewStrokes}));
}

}  // namespace
}  // namespace asperity

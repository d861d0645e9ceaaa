// Checks of a text that changes faster than it can be checked.

#include "app/gui/editor/live_check.h"

#include <atomic>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

/// A check that says in `file` what it was given.
ProtocolCheck echo(const std::string& text) {
  ProtocolCheck check{};
  check.file = text;
  return check;
}

TEST(LiveCheck, ChecksOnAnotherThread) {
  std::thread::id checked_on{};
  LiveCheck live([] { return std::string("text"); },
                 [&](const std::string& text) {
                   checked_on = std::this_thread::get_id();
                   return echo(text);
                 });
  QSignalSpy checked(&live, &LiveCheck::checked);
  live.want();
  EXPECT_FALSE(live.is_settled());
  ASSERT_TRUE(checked.wait(kPatience_ms));
  EXPECT_TRUE(live.is_settled());
  EXPECT_NE(checked_on, std::thread::id{});
  EXPECT_NE(checked_on, std::this_thread::get_id());
}

TEST(LiveCheck, ChecksOnceWhatOneActionChangesSeveralTimes) {
  int checks = 0;
  std::string text{};
  LiveCheck live([&] { return text; },
                 [&](const std::string& given) {
                   ++checks;
                   return echo(given);
                 });
  std::vector<std::string> said{};
  QObject::connect(&live, &LiveCheck::checked,
                   [&](const LiveCheck::Result& result) { said.push_back(result->file); });
  for (const char c : std::string("typed")) {
    text += c;
    live.want();
  }
  ASSERT_TRUE(eventually([&] { return live.is_settled(); }));
  EXPECT_EQ(checks, 1);
  EXPECT_EQ(said, std::vector<std::string>{"typed"});
}

TEST(LiveCheck, BeginsWhileTheTypingContinues) {
  std::atomic<bool> has_begun{false};
  LiveCheck live([] { return std::string("text"); },
                 [&](const std::string& text) {
                   has_begun = true;
                   return echo(text);
                 });
  // A key in every round of events: there is no pause.
  EXPECT_TRUE(eventually([&] {
    live.want();
    return has_begun.load();
  }));
}

TEST(LiveCheck, ChecksOnlyTheNewestOfTheTextsThatWereTypedDuringACheck) {
  std::promise<void> go_on{};
  const std::shared_future<void> gate = go_on.get_future().share();
  std::atomic<bool> has_begun{false};
  std::vector<std::string> given{};
  std::string text = "old";
  LiveCheck live([&] { return text; },
                 [&](const std::string& now) {
                   given.push_back(now);
                   has_begun = true;
                   gate.wait();
                   return echo(now);
                 });
  std::vector<std::string> said{};
  QObject::connect(&live, &LiveCheck::checked,
                   [&](const LiveCheck::Result& result) { said.push_back(result->file); });
  live.want();
  EXPECT_TRUE(eventually([&] { return has_begun.load(); }));
  for (const char* const typed : {"newer", "newest"}) {
    text = typed;
    live.want();
  }
  EXPECT_FALSE(live.is_settled());
  go_on.set_value();
  ASSERT_TRUE(eventually([&] { return live.is_settled(); }));
  EXPECT_EQ(given, (std::vector<std::string>{"old", "newest"}));
  EXPECT_EQ(said, std::vector<std::string>{"newest"});
}

TEST(LiveCheck, ChecksTheNewestTextWhereTheOneBeforeCouldNotBeChecked) {
  std::promise<void> go_on{};
  const std::shared_future<void> gate = go_on.get_future().share();
  std::atomic<bool> has_begun{false};
  std::string text = "old";
  LiveCheck live([&] { return text; },
                 [&](const std::string& now) {
                   has_begun = true;
                   gate.wait();
                   if (now == "old") throw std::runtime_error("no disk");
                   return echo(now);
                 });
  QSignalSpy checked(&live, &LiveCheck::checked);
  QSignalSpy failed(&live, &LiveCheck::failed);
  live.want();
  EXPECT_TRUE(eventually([&] { return has_begun.load(); }));
  text = "new";
  live.want();
  go_on.set_value();
  ASSERT_TRUE(eventually([&] { return live.is_settled(); }));
  EXPECT_EQ(checked.size(), 1);
  EXPECT_EQ(failed.size(), 0);
}

TEST(LiveCheck, ChecksNothingWhileItIsHeld) {
  std::promise<void> go_on{};
  const std::shared_future<void> gate = go_on.get_future().share();
  std::atomic<int> begun = 0;
  std::string text = "old";
  LiveCheck live([&] { return text; },
                 [&](const std::string& now) {
                   ++begun;
                   gate.wait();
                   return echo(now);
                 });
  QSignalSpy checked(&live, &LiveCheck::checked);
  live.want();
  live.set_held(true);  // before it began
  constexpr int kMoment_ms = 50;
  QTest::qWait(kMoment_ms);
  EXPECT_EQ(begun, 0);
  live.set_held(false);
  ASSERT_TRUE(eventually([&] { return begun == 1; }));
  text = "new";
  live.want();
  live.set_held(true);  // while the one before runs
  go_on.set_value();
  text = "newest";
  live.want();
  QTest::qWait(kMoment_ms);
  EXPECT_EQ(begun, 1);
  EXPECT_EQ(checked.size(), 0) << "what was found in an older text";
  EXPECT_FALSE(live.is_settled());
  live.set_held(false);
  ASSERT_TRUE(eventually([&] { return live.is_settled(); }));
  ASSERT_EQ(checked.size(), 1);
  EXPECT_EQ(checked[0][0].value<LiveCheck::Result>()->file, "newest");
}

TEST(LiveCheck, SaysWhyATextCouldNotBeChecked) {
  LiveCheck live([] { return std::string{}; },
                 [](const std::string&) -> ProtocolCheck { throw std::runtime_error("no disk"); });
  QSignalSpy failed(&live, &LiveCheck::failed);
  live.want();
  ASSERT_TRUE(failed.wait(kPatience_ms));
  EXPECT_EQ(failed[0][0].toString(), "no disk");
  EXPECT_TRUE(live.is_settled());
}

}  // namespace
}  // namespace asperity

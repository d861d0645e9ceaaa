// Checks of a text that changes faster than it can be checked.

#include "app/gui/editor/live_check.h"

#include <future>
#include <thread>

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

TEST(LiveCheck, WaitsForAPauseInTheTyping) {
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

TEST(LiveCheck, DropsWhatItFindsInATextThatIsNoLongerThere) {
  std::promise<void> go_on{};
  std::shared_future<void> gate = go_on.get_future().share();
  std::promise<void> begun{};
  std::string text = "old";
  LiveCheck live([&] { return text; },
                 [&](const std::string& given) {
                   if (given == "old") {
                     begun.set_value();
                     gate.wait();
                   }
                   return echo(given);
                 });
  std::vector<std::string> said{};
  QObject::connect(&live, &LiveCheck::checked,
                   [&](const LiveCheck::Result& result) { said.push_back(result->file); });
  live.want_now();
  begun.get_future().wait();
  text = "new";
  live.want_now();
  go_on.set_value();
  ASSERT_TRUE(eventually([&] { return live.is_settled(); }));
  EXPECT_EQ(said, std::vector<std::string>{"new"});
}

TEST(LiveCheck, SaysWhyATextCouldNotBeChecked) {
  LiveCheck live([] { return std::string{}; },
                 [](const std::string&) -> ProtocolCheck { throw std::runtime_error("no disk"); });
  QSignalSpy failed(&live, &LiveCheck::failed);
  live.want_now();
  ASSERT_TRUE(failed.wait(kPatience_ms));
  EXPECT_EQ(failed[0][0].toString(), "no disk");
  EXPECT_TRUE(live.is_settled());
}

}  // namespace
}  // namespace asperity

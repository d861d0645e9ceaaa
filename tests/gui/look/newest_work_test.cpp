// Work of which only the newest request matters: order, thread and errors.

#include "app/gui/look/newest_work.h"

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <vector>

#include <QtCore/QThread>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(NewestWork, LeavesOutWhatWaitedWhenSomethingNewerWasAsked) {
  NewestWork work{};
  std::mutex gate{};
  std::vector<int> begun{};  // of the worker; read when it is settled
  std::vector<int> delivered{};
  gate.lock();
  std::atomic<bool> first_runs{false};
  const auto ask = [&](int number) {
    work.ask(
        [&, number]() -> NewestWork::Delivery {
          begun.push_back(number);
          first_runs = true;
          const std::lock_guard wait(gate);
          return [&, number] { delivered.push_back(number); };
        },
        [](const QString&) { FAIL(); });
  };
  ask(1);
  ASSERT_TRUE(eventually([&] { return first_runs.load(); }));
  for (int number = 2; number <= 50; ++number) ask(number);
  EXPECT_TRUE(work.is_busy());
  gate.unlock();
  ASSERT_TRUE(eventually([&] { return !work.is_busy(); }));
  EXPECT_EQ(begun, (std::vector<int>{1, 50}));
  EXPECT_EQ(delivered, (std::vector<int>{1, 50}));
}

TEST(NewestWork, WorksAwayFromTheGuiThreadAndDeliversOnIt) {
  NewestWork work{};
  QThread* worked_on = nullptr;
  QThread* delivered_on = nullptr;
  work.ask(
      [&]() -> NewestWork::Delivery {
        worked_on = QThread::currentThread();
        return [&] { delivered_on = QThread::currentThread(); };
      },
      [](const QString&) { FAIL(); });
  ASSERT_TRUE(eventually([&] { return !work.is_busy(); }));
  EXPECT_NE(worked_on, QThread::currentThread());
  EXPECT_EQ(delivered_on, QThread::currentThread());
}

TEST(NewestWork, SaysWhatAnExceptionSays) {
  NewestWork work{};
  QString said{};
  work.ask([]() -> NewestWork::Delivery { throw std::invalid_argument("too short a wave"); },
           [&said](const QString& what) { said = what; });
  ASSERT_TRUE(eventually([&] { return !work.is_busy(); }));
  EXPECT_EQ(said, "too short a wave");
}

}  // namespace
}  // namespace asperity

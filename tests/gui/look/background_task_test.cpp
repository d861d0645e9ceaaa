// Background tasks: results, errors, replacement and destruction while they run.

#include "app/gui/look/background_task.h"

#include <atomic>
#include <optional>
#include <stdexcept>

#include <QtCore/QThread>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(BackgroundTask, DeliversItsResultOnTheGuiThread) {
  BackgroundTask task{};
  QSignalSpy finished(&task, &BackgroundTask::finished);
  QThread* worked_on = nullptr;
  QThread* delivered_on = nullptr;
  int result = 0;
  task.run<int>(
      [&worked_on](const std::stop_token&, const BackgroundTask::Progress&) {
        worked_on = QThread::currentThread();
        return 7;
      },
      [&](int value) {
        delivered_on = QThread::currentThread();
        result = value;
      },
      [](const QString&) { FAIL(); });
  ASSERT_TRUE(finished.wait(kPatience_ms));
  EXPECT_EQ(result, 7);
  EXPECT_NE(worked_on, QThread::currentThread());
  EXPECT_EQ(delivered_on, QThread::currentThread());
  EXPECT_FALSE(task.is_running());
}

TEST(BackgroundTask, SaysWhatAnExceptionSays) {
  BackgroundTask task{};
  QSignalSpy finished(&task, &BackgroundTask::finished);
  QString said{};
  task.run<int>(
      [](const std::stop_token&, const BackgroundTask::Progress&) -> int {
        throw std::runtime_error("no such photograph");
      },
      [](int) { FAIL(); }, [&said](const QString& what) { said = what; });
  ASSERT_TRUE(finished.wait(kPatience_ms));
  EXPECT_EQ(said, "no such photograph");
}

TEST(BackgroundTask, BeginsAnewWithoutWaitingForWhatItReplaces) {
  std::atomic<bool> may_end{false};  // outlives the task, which waits at its end
  BackgroundTask task{};
  QSignalSpy finished(&task, &BackgroundTask::finished);
  task.run<int>(
      [&may_end](const std::stop_token&, const BackgroundTask::Progress&) {
        while (!may_end) QThread::yieldCurrentThread();  // deaf to being stopped
        return 1;
      },
      [](int) { FAIL() << "it was replaced"; }, [](const QString&) { FAIL(); });
  int result = 0;
  task.run<int>([](const std::stop_token&, const BackgroundTask::Progress&) { return 2; },
                [&result](int value) { result = value; }, [](const QString&) { FAIL(); });
  EXPECT_TRUE(finished.wait(kPatience_ms));
  EXPECT_EQ(result, 2);
  EXPECT_FALSE(task.is_running());
  may_end = true;
}

TEST(BackgroundTask, StopsItsWorkWhenItIsDestroyed) {
  std::atomic<bool> stopped{false};
  {
    BackgroundTask task{};
    task.run<int>(
        [&stopped](const std::stop_token& stop, const BackgroundTask::Progress&) {
          while (!stop.stop_requested()) QThread::yieldCurrentThread();
          stopped = true;
          return 0;
        },
        [](int) { FAIL(); }, [](const QString&) { FAIL(); });
  }
  EXPECT_TRUE(stopped);
  QTest::qWait(1);  // nothing is delivered to the dead task
}

// As by a window that closes itself when its work is done. What takes the place of the task in memory would hear
// what is emitted by one that is there no more.
TEST(BackgroundTask, MayBeDestroyedByWhatItDelivers) {
  for (const bool fails : {false, true}) {
    std::optional<BackgroundTask> task{};
    int finished = 0;
    bool is_replaced = false;
    const auto replace = [&] {
      task.reset();
      task.emplace();
      QObject::connect(&*task, &BackgroundTask::finished, &*task, [&finished] { ++finished; });
      is_replaced = true;
    };
    task.emplace();
    task->run<int>(
        [fails](const std::stop_token&, const BackgroundTask::Progress&) {
          return fails ? throw std::runtime_error("no such photograph") : 7;
        },
        [&replace](int) { replace(); }, [&replace](const QString&) { replace(); });
    ASSERT_TRUE(eventually([&is_replaced] { return is_replaced; }));
    EXPECT_EQ(finished, 0) << fails;
  }
}

}  // namespace
}  // namespace asperity

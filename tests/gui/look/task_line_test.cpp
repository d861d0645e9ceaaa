// The line of a background task: its words, its progress and its button to cancel.

#include "app/gui/look/task_line.h"

#include <atomic>

#include <QtCore/QThread>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/look/background_task.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

class TaskLineTest : public testing::Test {
 protected:
  TaskLineTest() {
    window_.resize(600, 48);
    line_.resize(600, 48);
    window_.show();
  }

  /// Tells that half is done and goes on until it may end or is stopped.
  void begin() {
    task_.run<bool>(
        [this](const std::stop_token& stop, const BackgroundTask::Progress& progress) {
          progress(0.5);
          while (!may_end_ && !stop.stop_requested()) QThread::yieldCurrentThread();
          return !stop.stop_requested();
        },
        [this](bool done) { (done ? done_ : stopped_) = true; }, [](const QString&) { FAIL(); });
  }
  void wait_for(const std::function<bool()>& condition) { ASSERT_TRUE(eventually(condition)); }

  std::atomic<bool> may_end_{false};
  bool done_ = false;
  bool stopped_ = false;
  BackgroundTask task_{};
  QWidget window_{};
  TaskLine line_{task_, &window_};
};

TEST_F(TaskLineTest, SaysWhatIsDoneAndHowFarUntilItHasEnded) {
  line_.set_words("Reading wall.png …");
  EXPECT_FALSE(line_.isVisible());
  begin();
  wait_for([this] { return line_.isVisible(); });
  EXPECT_EQ(line_.findChild<QLabel*>("task_words")->text(), "Reading wall.png …");
  const auto* bar = line_.findChild<QProgressBar*>("task_progress");
  wait_for([bar] { return 2 * bar->value() == bar->maximum() && bar->maximum() > 0; });
  may_end_ = true;
  wait_for([this] { return done_; });
  EXPECT_FALSE(line_.isVisible());
}

TEST_F(TaskLineTest, AsksForTheEndOnce) {
  QObject::connect(&line_, &TaskLine::cancelWanted, &task_, &BackgroundTask::cancel);
  begin();
  wait_for([this] { return line_.isVisible(); });
  auto* cancel = line_.findChild<QPushButton*>("task_cancel");
  QTest::mouseClick(cancel, Qt::LeftButton);
  EXPECT_FALSE(cancel->isEnabled());
  wait_for([this] { return stopped_; });
  EXPECT_FALSE(line_.isVisible());
}

TEST_F(TaskLineTest, GoesAtOnceWhenTheTaskIsAbandoned) {
  QObject::connect(&line_, &TaskLine::cancelWanted, &task_, &BackgroundTask::abandon);
  begin();
  wait_for([this] { return line_.isVisible(); });
  QTest::mouseClick(line_.findChild<QPushButton*>("task_cancel"), Qt::LeftButton);
  EXPECT_FALSE(line_.isVisible());
  EXPECT_FALSE(task_.is_running());
  may_end_ = true;
  begin();  // a new run has a new button
  wait_for([this] { return done_; });
  EXPECT_FALSE(stopped_);
  EXPECT_TRUE(line_.findChild<QPushButton*>("task_cancel")->isEnabled());
}

}  // namespace
}  // namespace asperity

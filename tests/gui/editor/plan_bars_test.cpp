// The bars of a plan: widths, words, and what a press shows.

#include "app/gui/plan/plan_bars.h"

#include <string>

#include <QtCore/QRegularExpression>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <gtest/gtest.h>

#include "protocols/file/protocol_reader.h"
#include "protocols/plan/course.h"
#include "tests/gui/support/widgets.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

class BarsOfAPlan : public testing::Test {
 protected:
  explicit BarsOfAPlan(const char* name = "photo_recognition")
      : protocol(read_protocol(test::library_text(name), name, test::models_of_library())),
        plan(example_plan(protocol, {1, 0})) {
    bars.resize(600, 80);
    const std::vector<PlanPart> parts = parts_of(protocol, plan);
    bars.show_parts(parts, runs_in(protocol, parts));
    bars.show();
  }
  QString legend() const {
    QString text = child<QLabel>(bars, "plan_legend").text();
    return text.remove(QRegularExpression("<[^>]*>")).replace("&nbsp;", " ").replace("&ensp;", "");
  }

  Protocol protocol;
  Plan plan;
  PlanBars bars{};
};

TEST_F(BarsOfAPlan, NameEveryBlockWithItsTrials) {
  for (const PlannedRun& run : runs_in(protocol, parts_of(protocol, plan))) {
    EXPECT_TRUE(legend().contains(QString::fromStdString(run.block->name)))
        << legend().toStdString();
    EXPECT_TRUE(legend().contains(QString("%1 trial").arg(run.trials))) << legend().toStdString();
  }
  EXPECT_TRUE(bars.accessibleDescription().contains("break: at least"));
}

TEST_F(BarsOfAPlan, LeadToTheFirstStepOfAPart) {
  QSignalSpy wanted(&bars, &PlanBars::step_wanted);
  QTest::mouseClick(&bars, Qt::LeftButton, {}, QPoint(1, 8));
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(wanted.takeFirst().front().toInt(), 0);
  QTest::mouseClick(&bars, Qt::LeftButton, {}, QPoint(599, 8));
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(wanted.front().front().toInt(),
            static_cast<int>(parts_of(protocol, plan).back().first_step));
}

TEST_F(BarsOfAPlan, AreBlankWhereThereIsABreakAndColouredWhereThereAreTrials) {
  const QImage image = bars.grab().toImage();
  const std::vector<PlanPart> parts = parts_of(protocol, plan);
  double total_s = 0.0;
  for (const PlanPart& part : parts) total_s += part.duration_s;
  const QColor ground = image.pixelColor(1, 70);
  double left_s = 0.0;
  for (const PlanPart& part : parts) {
    const double middle_s = left_s + 0.5 * part.duration_s;
    left_s += part.duration_s;
    if (part.duration_s < 0.03 * total_s) continue;  // moved by the least widths of the others
    const QColor color = image.pixelColor(static_cast<int>(middle_s / total_s * image.width()), 1);
    EXPECT_EQ(color != ground, part.what == PlanPart::What::trials) << middle_s;
  }
}

class BarsOfAStaircase : public BarsOfAPlan {
 protected:
  BarsOfAStaircase() : BarsOfAPlan("amplitude_jnd") {}
};

TEST_F(BarsOfAStaircase, StateTheLargestNumberOfTrials) {
  const std::vector<PlannedRun> runs = runs_in(protocol, parts_of(protocol, plan));
  const bool varies =
      std::ranges::any_of(runs, [](const PlannedRun& run) { return run.most_trials.has_value(); });
  EXPECT_EQ(legend().contains("at most"), varies) << legend().toStdString();
}

}  // namespace
}  // namespace asperity

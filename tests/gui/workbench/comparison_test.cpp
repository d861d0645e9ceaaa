// Strokes over a finished relief while the models of the comparison are being prepared.

#include <QtCore/QTemporaryDir>
#include <QtGui/QMouseEvent>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDoubleSpinBox>
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include "app/gui/base/open_study.h"
#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/parameter_form.h"
#include "app/gui/workbench/relief_view.h"
#include "app/gui/workbench/signal_plots.h"
#include "app/gui/workbench/workbench_page.h"
#include "app/study_files/height_field_files.h"
#include "app/tasks/new_study.h"
#include "stimuli/heights/synthetic_surface.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

class Comparison : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    const std::filesystem::path folder = folder_.path().toStdString();
    new_study(folder / "study");
    study_ = std::make_unique<OpenStudy>(folder / "study");
    save_height_field(folder / "brick.png",
                      make_surface("brick", {}, {.width_m = 0.05, .pixels = 256, .seed = 3}), {},
                      Overwrite::refuse);
    page_ = std::make_unique<WorkbenchPage>(*study_);
    page_->resize(1004, 664);  // what the window of 1280 × 720 leaves to it
    page_->show();
    page_->open_file(folder / "brick.png");
    settle();
    QTest::mouseClick(&find<QAbstractButton>("mode_comparing"), Qt::LeftButton);
    settle();
  }

  void settle() {
    ASSERT_TRUE(eventually([this] { return page_->is_settled(); }));
  }

  template <class Widget>
  Widget& find(const char* name) {
    return child<Widget>(*page_, name);
  }

  ForceComparison& comparison() { return find<ForceComparison>("comparison"); }
  const std::vector<PlotSeries>& forces() { return find<SignalPlots>("forces").signal_series(); }

  QPoint at(double x_m) { return find<ReliefView>("relief").position_of({x_m, 0.0}).toPoint(); }
  void press(double x_m) {
    QTest::mousePress(&find<ReliefView>("relief"), Qt::LeftButton, {}, at(x_m));
  }
  void move(double x_m) {
    auto& relief = find<ReliefView>("relief");
    QMouseEvent moved(QEvent::MouseMove, at(x_m), relief.mapToGlobal(at(x_m)), Qt::NoButton,
                      Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&relief, &moved);
  }
  void release(double x_m) {
    QTest::mouseRelease(&find<ReliefView>("relief"), Qt::LeftButton, {}, at(x_m));
  }

  /// What the plot of the forces says in place of curves.
  QString words_in_plot() {
    const auto* plot = find<SignalPlots>("forces").findChild<QCustomPlot*>();
    if (plot->itemCount() == 0) return {};
    return qobject_cast<QCPItemText*>(plot->item(0))->text().simplified();
  }

  void expect_stroke_from_here(double x_m) {
    EXPECT_TRUE(comparison().is_preparing());
    EXPECT_EQ(words_in_plot(), "Preparing the models…");
    EXPECT_TRUE(forces().empty());
    move(x_m);
    ASSERT_TRUE(eventually([this] { return !forces().empty() && forces().front().y.size() > 200; }))
        << "within the same drag";
    EXPECT_TRUE(comparison().stroke().is_going_on());
    EXPECT_NEAR(comparison().stroke().path().front().position_m.x, x_m, 5e-4)
        << "the hand had gone there meanwhile";
    release(x_m);
    EXPECT_FALSE(comparison().stroke().is_going_on());
  }

  QTemporaryDir folder_{};
  std::unique_ptr<OpenStudy> study_{};
  std::unique_ptr<WorkbenchPage> page_{};
};

TEST_F(Comparison, TakesUpADragOnceTheModelsAreReady) {
  EXPECT_EQ(words_in_plot(), "Drag over the relief to feel it");
  find<QCheckBox>("model_lateral_gradient").setChecked(true);
  press(-0.01);
  expect_stroke_from_here(0.01);
  EXPECT_EQ(forces().size(), 3U);
}

TEST_F(Comparison, TakesUpADragThatEndsTheEditingOfAValue) {
  auto& form = find<ParameterForm>("form_height_map");
  auto& field = child<QDoubleSpinBox>(form, "height_scale");
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, "2");
  press(-0.01);
  expect_stroke_from_here(0.01);
  EXPECT_EQ(number_of(comparison().stroke().models().front().inputs.parameters, "height_scale"),
            2.0);
}

TEST_F(Comparison, BeginsAStrokeAgainWithModelsThatAreChangedDuringIt) {
  press(-0.01);
  ASSERT_TRUE(eventually([this] { return forces().size() == 2U; }));
  find<QCheckBox>("model_lateral_gradient").setChecked(true);
  expect_stroke_from_here(0.01);
}

TEST_F(Comparison, DropsADragThatEndsBeforeTheModelsAreReady) {
  find<QCheckBox>("model_lateral_gradient").setChecked(true);
  press(-0.01);
  release(-0.01);
  settle();
  EXPECT_FALSE(comparison().stroke().is_going_on());
  EXPECT_TRUE(comparison().stroke().path().empty());
  EXPECT_EQ(words_in_plot(), "Drag over the relief to feel it");
}

TEST_F(Comparison, StrokesAcrossOnceTheModelsAreReady) {
  find<QCheckBox>("model_lateral_gradient").setChecked(true);
  QTest::mouseClick(&find<QAbstractButton>("stroke_across"), Qt::LeftButton);
  ASSERT_TRUE(eventually([this] { return forces().size() == 3U; }));
  EXPECT_NEAR(comparison().stroke().path().front().position_m.x, -0.45 * 0.05, 1e-9);
}

}  // namespace
}  // namespace asperity

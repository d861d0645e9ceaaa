// Strokes over a relief on the workbench: the forces of the models, and their sound.

#include <string>
#include <vector>

#include <QtCore/QThread>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <gtest/gtest.h>

#include "app/gui/base/open_study.h"
#include "app/gui/look/task_line.h"
#include "app/gui/window/study_window.h"
#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/parameter_form.h"
#include "app/gui/workbench/recipe_panel.h"
#include "app/gui/workbench/relief_view.h"
#include "app/gui/workbench/signal_plots.h"
#include "app/gui/workbench/workbench_page.h"
#include "renderers/offline/along_path.h"
#include "tests/gui/sound/fake_card.h"
#include "tests/gui/support/widgets.h"
#include "tests/gui/workbench/page_of_the_workbench.h"

namespace asperity {
namespace {

TEST_F(BrickOnTheWorkbench, StrokesTheReliefAndShowsTheForceOfEachChosenModel) {
  click("mode_comparing");
  find<QCheckBox>("model_lateral_gradient").setChecked(true);
  settle();
  auto& relief = find<ReliefView>("relief");
  auto& comparison = find<ForceComparison>("comparison");
  const auto at = [&relief](double x_m) { return relief.position_of({x_m, 0.0}).toPoint(); };
  QTest::mousePress(&relief, Qt::LeftButton, {}, at(-0.03));
  for (int k = 1; k <= 20; ++k) {
    QMouseEvent moved(QEvent::MouseMove, at(-0.03 + 0.003 * k),
                      relief.mapToGlobal(at(-0.03 + 0.003 * k)), Qt::NoButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&relief, &moved);
    const std::size_t samples = comparison.stroke().path().size();
    ASSERT_TRUE(eventually([&] { return comparison.stroke().path().size() >= samples + 16; }));
  }
  const auto& live = find<SignalPlots>("forces");
  EXPECT_TRUE(eventually([&] {
    return live.signal_series().size() == 3U && live.signal_series().front().y.size() > 300 &&
           !live.spectrum_series().front().y.empty();
  })) << "while the mouse strokes";
  QTest::mouseRelease(&relief, Qt::LeftButton, {}, at(0.03));
  EXPECT_FALSE(comparison.stroke().is_going_on());

  const ForceStroke& stroke = comparison.stroke();
  EXPECT_GT(stroke.path().back().position_m.x, stroke.path().front().position_m.x + 0.02);
  ASSERT_EQ(stroke.models().size(), 3U);
  for (std::size_t m = 0; m < 3; ++m) {
    const StrokedModel& stroked = stroke.models()[m];
    const auto renderer = make_renderer(*study_->models().find(stroked.id), stroked.inputs);
    const std::vector<RenderedTick> offline = along_path(*renderer, stroke.path(), 1000.0);
    for (std::size_t i = 0; i < offline.size(); ++i) {
      ASSERT_EQ(stroke.forces_N()[m][i], offline[i].wrench.force_N) << stroked.id;
    }
  }
  const auto& shown = find<SignalPlots>("forces").signal_series();
  ASSERT_EQ(shown.size(), 3U);
  EXPECT_EQ(shown[0].name, "Height map");
  EXPECT_EQ(shown[0].y.back(), stroke.forces_N()[0].back().z);
  EXPECT_FALSE(find<SignalPlots>("forces").spectrum_series().front().y.empty());
}

TEST_F(BrickOnTheWorkbench, TakesAModelsParametersFromTheReliefUnlessTheyAreGiven) {
  click("mode_comparing");
  find<QCheckBox>("model_stochastic").setChecked(true);
  settle();
  auto* form = page_->findChild<ParameterForm*>("form_stochastic");
  const double suggested_N = number_of(form->values(), "noise_sd_N");
  EXPECT_NEAR(suggested_N, 500.0 * page_->field()->rms_m(), 1e-9);
  auto* field = form->findChild<QDoubleSpinBox*>("noise_sd_N");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "0.3");
  QTest::keyClick(field, Qt::Key_Return);
  settle();
  for (const StrokedModel& stroked : find<ForceComparison>("comparison").stroke().models()) {
    if (stroked.id != "stochastic") continue;
    EXPECT_EQ(number_of(stroked.inputs.parameters, "noise_sd_N"), 0.3);
  }
}

TEST_F(BrickOnTheWorkbench, StrokesAcrossOnTheSamePathHoweverTheFramesCome) {
  click("mode_comparing");
  settle();
  auto& comparison = find<ForceComparison>("comparison");
  const auto stroke_across = [&](int frame_ms) {
    click("stroke_across");
    while (comparison.stroke().path().size() < 400) {
      QThread::msleep(static_cast<unsigned long>(frame_ms));  // a busy machine
      QCoreApplication::processEvents();
    }
    comparison.end_stroke();
    return comparison.stroke().path();
  };
  const std::vector<ProbeState> even = stroke_across(1);
  const std::vector<ProbeState> uneven = stroke_across(150);
  for (std::size_t i = 0; i < 400; ++i) {
    ASSERT_EQ(even[i].position_m, uneven[i].position_m) << i;
  }
}

TEST_F(BrickOnTheWorkbench, ShowsTheDentInASoftSurfaceDuringAStroke) {
  click("mode_comparing");
  settle();
  auto& relief = find<ReliefView>("relief");
  const auto& caption = find<QLabel>("caption");
  const QImage before = relief.picture();
  EXPECT_FALSE(caption.text().contains("dent"));
  find<QCheckBox>("model_elastic_halfspace").setChecked(true);
  settle();
  click("stroke_across");
  auto& comparison = find<ForceComparison>("comparison");
  ASSERT_TRUE(eventually([&] { return comparison.stroke().path().size() > 300; }));
  comparison.end_stroke();
  settle();
  ASSERT_TRUE(comparison.dent());
  EXPECT_NEAR(comparison.dent()->surface.centre_m.x, comparison.stroke().path().back().position_m.x,
              1e-12);
  EXPECT_TRUE(caption.text().contains("The dent is that of “Elastic halfspace”"))
      << caption.text().toStdString();
  EXPECT_NE(relief.picture(), before);
  click("mode_making");
  settle();
  EXPECT_FALSE(caption.text().contains("dent"));
}

TEST_F(BrickOnTheWorkbench, TellsHowRoughTheStrokeIsThroughEveryModel) {
  click("mode_comparing");
  find<QCheckBox>("model_lateral_gradient").setChecked(true);
  settle();
  auto& comparison = find<ForceComparison>("comparison");
  auto& roughness = find<SignalPlot>("roughness");
  auto& numbers = find<QLabel>("large_names");
  EXPECT_TRUE(roughness.isVisible());
  EXPECT_TRUE(roughness.series().empty());
  click("stroke_across");
  ASSERT_TRUE(eventually([&] { return !roughness.series().empty(); }));
  EXPECT_GE(comparison.stroke().path().size(), 500U) << "the beginning is left out";
  ASSERT_TRUE(eventually([&] { return !comparison.stroke().is_going_on(); }));
  ASSERT_EQ(roughness.series().size(), 3U);
  for (std::size_t m = 0; m < 3; ++m) {
    const PlotSeries& curve = roughness.series()[m];
    EXPECT_EQ(curve.color, find<SignalPlots>("forces").signal_series()[m].color);
    // The same forces at once: live is what is computed later.
    FeltRoughness later(FeltRoughness::Judging{});
    const auto samples = static_cast<std::size_t>(std::lround(1000.0 * curve.x.back())) + 1;
    for (std::size_t i = 0; i < samples; ++i) later.add(comparison.stroke().forces_N()[m][i]);
    EXPECT_EQ(curve.y.back(), later.roughness().value().rms_accel_m_per_s2);
    EXPECT_GT(curve.y.back(), 0.01);
    EXPECT_TRUE(numbers.text().contains(curve.name)) << numbers.text().toStdString();
    EXPECT_NEAR(curve.name.toDouble(), curve.y.back(), 0.05);
  }
  EXPECT_TRUE(roughness.toolTip().contains("Lateral gradient: RMS "));
  comparison.begin_stroke(0.0, 0.0);
  comparison.end_stroke();
  EXPECT_TRUE(roughness.series().empty()) << "of another stroke";
  EXPECT_FALSE(roughness.toolTip().contains("RMS "));
}

TEST_F(Workbench, PlaysTheForceOfTheModelThatIsToBeHeard) {
  drop(photograph("brick", 256));
  click("mode_comparing");
  auto& comparison = find<ForceComparison>("comparison");
  comparison.set_sound(output_of(card_));
  find<QComboBox>("heard").setCurrentIndex(4);
  EXPECT_TRUE(find<QCheckBox>("model_lateral_gradient").isChecked());
  find<QComboBox>("force_component").setCurrentIndex(1);
  settle();
  EXPECT_EQ(card_.peak, 0.0);
  click("stroke_across");
  ASSERT_TRUE(eventually([this] { return card_.highest_peak > 0.0; }));
}

TEST_F(Workbench, IsSilentOnceNobodyLooksAtIt) {
  drop(photograph("brick", 256));
  click("mode_comparing");
  auto& comparison = find<ForceComparison>("comparison");
  comparison.set_sound(output_of(card_));
  EXPECT_FALSE(card_.open) << "nothing is to be heard";
  find<QComboBox>("heard").setCurrentIndex(4);
  find<QComboBox>("force_component").setCurrentIndex(1);
  settle();
  const auto hear = [this] {
    click("stroke_across");
    ASSERT_TRUE(eventually([this] { return card_.highest_peak > 0.0; }));
    EXPECT_TRUE(card_.open);
  };
  const auto expect_silence = [&] {
    ASSERT_TRUE(eventually([this] { return !card_.open; }));
    EXPECT_FALSE(comparison.stroke().is_going_on());
    card_.highest_peak = 0.0;
  };
  hear();
  page_->hide();  // another page is shown, or the window is closed
  expect_silence();
  page_->show();
  hear();
  click("mode_making");
  expect_silence();
  click("mode_comparing");
  hear();
  find<QComboBox>("heard").setCurrentIndex(0);
  EXPECT_TRUE(eventually([this] { return !card_.open; }));
}

TEST_F(Workbench, LetsTheSoundCardGoWithItsPageItsWindowAndItsStudy) {
  for (const char* way : {"page", "window", "study"}) {
    StudyWindow window;
    ASSERT_TRUE(window.open_study(study_folder()));
    window.show();
    window.show_page("workbench");
    auto* page = window.findChild<WorkbenchPage*>("workbench");
    ASSERT_NE(page, nullptr);
    page->open_file(photograph("brick", 128));
    ASSERT_TRUE(eventually([page] { return page->is_settled(); }));
    QTest::mouseClick(page->findChild<QAbstractButton*>("mode_comparing"), Qt::LeftButton);
    page->findChild<ForceComparison*>("comparison")->set_sound(output_of(card_));
    page->findChild<QComboBox*>("heard")->setCurrentIndex(1);
    ASSERT_TRUE(eventually([this] { return card_.open > 0; })) << way;
    if (way == std::string("page")) {
      window.show_page("protocols");
    } else if (way == std::string("window")) {
      ASSERT_TRUE(window.close());
    } else {
      window.close_study();
    }
    ASSERT_TRUE(eventually([this] { return !card_.open; })) << way;
  }
}

TEST_F(Workbench, SaysThatASoundCardCannotBeOpened) {
  drop(photograph("brick", 128));
  click("mode_comparing");
  card_.lost = true;
  find<ForceComparison>("comparison").set_sound(output_of(card_));
  find<QComboBox>("heard").setCurrentIndex(1);
  auto& said = find<QLabel>("no_sound");
  ASSERT_TRUE(eventually([&] { return said.isVisible(); }));
  EXPECT_TRUE(said.text().contains("Headphones could not be opened"));
  card_.lost = false;
  EXPECT_TRUE(eventually([&] { return !said.isVisible(); })) << "it plays now";
}

TEST_F(Workbench, SaysThatASoundCardDoesNotPlay) {
  drop(photograph("brick", 128));
  click("mode_comparing");
  card_.stands_still = true;
  find<ForceComparison>("comparison").set_sound(output_of(card_));
  find<QComboBox>("heard").setCurrentIndex(1);
  auto& said = find<QLabel>("no_sound");
  EXPECT_FALSE(said.isVisible()) << "it may only take its time";
  ASSERT_TRUE(eventually([&] { return said.isVisible(); }));
  EXPECT_TRUE(said.text().contains("Headphones produces no sound"));
  find<ForceComparison>("comparison").set_sound(null_output());
  EXPECT_TRUE(said.text().contains("There is no sound output"));
}

TEST_F(BrickOnTheWorkbench, SaysThatThereIsNothingToHearAForceWith) {
  click("mode_comparing");
  find<ForceComparison>("comparison").set_sound(null_output());
  EXPECT_FALSE(find<QComboBox>("heard").isEnabled());
  EXPECT_TRUE(find<QLabel>("no_sound").text().contains("sound output"));
  EXPECT_TRUE(find<QLabel>("no_sound").isVisible());
}

}  // namespace
}  // namespace asperity

// Plots of the workbench that are narrow: what stands at their axes and in them.

#include "app/gui/workbench/signal_plots.h"

#include <algorithm>

#include <QtTest/QTest>
#include <gtest/gtest.h>
#include <qcustomplot.h>

namespace asperity {
namespace {

/// How many numbers stand at an axis.
std::ptrdiff_t numbers_at(const QCPAxis& axis) {
  const QVector<double> places = axis.tickVector();
  const QCPRange shown = axis.range();
  return std::count_if(places.begin(), places.end(),
                       [&shown](double place) { return shown.contains(place); });
}

QCustomPlot& plot_in(SignalPlot& plot) { return *plot.findChild<QCustomPlot*>(); }

void show_narrow(SignalPlot& plot) {
  plot.resize(200, 220);
  plot.show();
}

TEST(SignalPlot, HasTwoNumbersAtEachAxisHoweverNarrowItIs) {
  for (const double high : {7.0, 40.0, 149.0, 330.0, 496.0, 700.0}) {
    SignalPlot plot({.heading = "Force", .x = "Frequency, Hz", .y = "Power, N²/Hz"});
    show_narrow(plot);
    plot.show_series({{.x = {0.01 * high, high}, .y = {1.0, 2.0}}});
    plot_in(plot).replot();
    EXPECT_GE(numbers_at(*plot_in(plot).xAxis), 2) << high;
  }
  for (const double high : {2.0, 7.0, 15.0, 90.0}) {
    SignalPlot plot({.heading = "Spectrum of the profile",
                     .x = "Spatial frequency, 1/mm",
                     .y = "Power",
                     .x_scale = PlotScale::logarithmic,
                     .y_scale = PlotScale::logarithmic});
    show_narrow(plot);
    plot.show_series({{.x = {0.15, high}, .y = {1e-3, 1.0}}});
    plot_in(plot).replot();
    EXPECT_GE(numbers_at(*plot_in(plot).xAxis), 2) << high;
  }
}

TEST(SignalPlot, WritesAMinusSignBeforeNegativeNumbers) {
  SignalPlot plot({.heading = "Profile", .x = "Position, mm", .y = "Height, µm"});
  show_narrow(plot);
  plot.show_series({{.x = {0.0, 100.0}, .y = {-200.0, 200.0}}});
  plot_in(plot).replot();
  const QVector<QString> labels = plot_in(plot).yAxis->tickVectorLabels();
  EXPECT_TRUE(labels.contains("−200")) << labels.toList().join(' ').toStdString();
}

TEST(SignalPlot, ReadsWholeWhatItAsksForHoweverNarrowItIs) {
  SignalPlot plot({.heading = "Force", .x = "Time, s", .y = "Force, N"});
  show_narrow(plot);
  plot.show_series({}, "Nach einer Viertelsekunde ist hier etwas zu sehen");
  plot_in(plot).replot();
  ASSERT_EQ(plot_in(plot).itemCount(), 1);
  const auto* words = qobject_cast<QCPItemText*>(plot_in(plot).item(0));
  ASSERT_NE(words, nullptr);
  EXPECT_EQ(words->text().simplified(), "Nach einer Viertelsekunde ist hier etwas zu sehen");
  const QFontMetrics metrics(words->font());
  for (const QString& line : words->text().split('\n')) {
    EXPECT_LE(metrics.horizontalAdvance(line), plot_in(plot).width()) << line.toStdString();
  }
}

}  // namespace
}  // namespace asperity

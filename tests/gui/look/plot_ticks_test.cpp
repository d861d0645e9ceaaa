// The numbers at a vertical axis, in plots from low to high.

#include "app/gui/look/plot_ticks.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtGui/QFontMetrics>
#include <gtest/gtest.h>
#include <qcustomplot.h>

namespace asperity {
namespace {

TEST(PlotTicks, KeepTheirLabelsApartAtEveryHeight) {
  for (const double highest : {2.4, 190.0, 55.0}) {
    QCustomPlot plot{};
    plot.axisRect()->setAutoMargins(QCP::msNone);
    plot.axisRect()->setMargins(QMargins(48, 4, 8, 8));
    plot.yAxis->setRange(0.0, highest);
    keep_labels_apart(*plot.yAxis, 3);
    plot.show();
    for (const int height : {200, 110, 80, 60, 48, 200}) {
      plot.resize(320, height);
      QCoreApplication::processEvents();
      for (int round = 0; round < 4; ++round) {
        plot.replot();
        QCoreApplication::processEvents();
      }
      int last = plot.height() + 100;
      int shown = 0;
      for (const double place : plot.yAxis->tickVector()) {
        if (!plot.yAxis->range().contains(place)) continue;
        const int pixel = static_cast<int>(plot.yAxis->coordToPixel(place));
        EXPECT_GE(last - pixel, QFontMetrics(plot.yAxis->tickLabelFont()).capHeight() - 1)
            << "to " << highest << " at a height of " << height;
        last = pixel;
        ++shown;
      }
      EXPECT_GE(shown, 2) << "to " << highest << " at a height of " << height;
    }
  }
}

TEST(PlotTicks, HaveAMinusSign) {
  for (const auto& ticker : {plain_ticker(), step_ticker(2.0)}) {
    QVector<double> places{};
    QVector<QString> labels{};
    ticker->generate(QCPRange(-4.0, 4.0), QLocale("de_DE"), 'g', 6, places, nullptr, &labels);
    EXPECT_TRUE(labels.contains("−2")) << labels.join(", ").toStdString();
    EXPECT_TRUE(labels.contains("2"));
  }
}

TEST(PlotTicks, AreWrittenAsPowersOfTenInEveryLanguage) {
  for (const char* language : {"en_US", "de_DE"}) {
    QVector<double> places{};
    QVector<QString> labels{};
    decade_ticker()->generate(QCPRange(0.5, 2e4), QLocale(language), 'e', 0, places, nullptr,
                              &labels);
    EXPECT_TRUE(labels.contains("1e+04")) << language << ": what the plot makes a power of";
  }
}

}  // namespace
}  // namespace asperity

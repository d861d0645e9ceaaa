// Derives tickers of QCustomPlot that write a minus sign, and limits ticks to the room of their labels.

#include "app/gui/look/plot_ticks.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QLocale>
#include <QtGui/QFontMetrics>
#include <qcustomplot.h>

namespace asperity {

namespace {

bool have_room(const QCPAxis& axis, int ticks) {
  QCPAxisTicker ticker{};
  ticker.setTickCount(ticks);
  QVector<double> places{};
  ticker.generate(axis.range(), QLocale::c(), 'g', axis.numberPrecision(), places, nullptr,
                  nullptr);
  if (places.size() < 2) return true;
  const double pixels = axis.axisRect()->height() * (places[1] - places[0]) / axis.range().size();
  return pixels >= QFontMetrics(axis.tickLabelFont()).capHeight();
}

/// Writes a minus sign where the locale has a hyphen.
template <typename Ticker>
class WithMinus final : public Ticker {
 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    // An exponent keeps its hyphen, by which the plot knows a power of ten.
    QString label = Ticker::getTickLabel(tick, locale, format, precision);
    if (label.startsWith('-')) label.replace(0, 1, "−");
    return label;
  }
};

class DecadeTicker final : public QCPAxisTickerLog {
 protected:
  QVector<double> createTickVector(double step, const QCPRange& range) override {
    const auto shown = [&range](const QVector<double>& ticks) {
      return std::count_if(ticks.begin(), ticks.end(),
                           [&](double at) { return range.contains(at); });
    };
    QVector<double> decades = QCPAxisTickerLog::createTickVector(step, range);
    if (shown(decades) >= 2 || !(range.lower > 0.0)) return decades;
    QVector<double> ticks{};
    for (double decade = std::pow(10.0, std::floor(std::log10(range.lower))); decade <= range.upper;
         decade *= 10.0) {
      for (const double factor : {1.0, 2.0, 5.0}) ticks.append(factor * decade);
    }
    return ticks;
  }

  // The plot looks for a small e to make a power of; most languages of Qt write a capital one.
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return QCPAxisTickerLog::getTickLabel(tick, format == 'e' ? QLocale::c() : locale, format,
                                          precision);
  }
};

}  // namespace

void keep_labels_apart(QCPAxis& axis, int most) {
  axis.setTicker(plain_ticker());
  QObject::connect(axis.parentPlot(), &QCustomPlot::afterLayout, &axis, [&axis, most] {
    int ticks = most;
    while (ticks > 1 && !have_room(axis, ticks)) --ticks;
    if (axis.ticker()->tickCount() == ticks) return;
    axis.ticker()->setTickCount(ticks);
    axis.parentPlot()->replot(QCustomPlot::rpQueuedReplot);  // this one has its ticks already
  });
}

QSharedPointer<QCPAxisTicker> plain_ticker() {
  return QSharedPointer<WithMinus<QCPAxisTicker>>::create();
}

QSharedPointer<QCPAxisTicker> step_ticker(double step) {
  auto ticker = QSharedPointer<WithMinus<QCPAxisTickerFixed>>::create();
  ticker->setTickStep(step);
  return ticker;
}

QSharedPointer<QCPAxisTicker> decade_ticker() { return QSharedPointer<DecadeTicker>::create(); }

}  // namespace asperity

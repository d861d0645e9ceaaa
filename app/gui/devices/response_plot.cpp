// Plots the response of each axis on logarithmic axes, with lines of different widths so that none is hidden.

#include "app/gui/devices/response_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QtWidgets/QBoxLayout>
#include <qcustomplot.h>

#include "app/gui/base/curve_color.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr double kResponseScale = 1000.0;  // millimetres per newton
constexpr int kResponseHeight = 260;
// Curves that lie on each other, as those of a device alike along x and y, are all seen.
constexpr std::array<double, 3> kCurveWidths{5.0, 3.0, 1.5};

int place_of_axis(const std::string& axis) { return axis == "x" ? 0 : axis == "y" ? 1 : 2; }

/// 8, 10, 20, 50, 100, 200: what is read on an axis of frequencies.
QSharedPointer<QCPAxisTickerText> frequency_ticks() {
  auto ticks = QSharedPointer<QCPAxisTickerText>::create();
  for (const int frequency_Hz : {5, 10, 20, 50, 100, 200, 500, 1000}) {
    ticks->addTick(frequency_Hz, QString::number(frequency_Hz));
  }
  return ticks;
}

/// 0.001, 0.01, 0.1, 1, 10: digits, as everywhere in the windows.
QSharedPointer<QCPAxisTickerText> response_ticks() {
  auto ticks = QSharedPointer<QCPAxisTickerText>::create();
  for (int exponent = -6; exponent <= 3; ++exponent) {
    const double value = std::pow(10.0, exponent);
    ticks->addTick(value, shown_number(value, 'f', std::max(0, -exponent)));
  }
  return ticks;
}

}  // namespace

ResponsePlot::ResponsePlot(QWidget* parent) : QFrame(parent) {
  setObjectName("response_plot");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  heading_ = new QLabel(this);
  heading_->setFont(text_font(TextSize::small, true));
  heading_->setTextFormat(Qt::RichText);
  heading_->setProperty("role", "muted");
  rows->addWidget(heading_);
  plot_ = new QCustomPlot(this);
  plot_->setFixedHeight(kResponseHeight);
  plot_->setAttribute(Qt::WA_TransparentForMouseEvents);
  plot_->setFocusPolicy(Qt::NoFocus);
  style_plot(*plot_);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->setScaleType(QCPAxis::stLogarithmic);
  plot_->xAxis->setTicker(frequency_ticks());
  plot_->yAxis->setTicker(response_ticks());
  plot_->xAxis->setLabel(tr("frequency, Hz"));
  plot_->axisRect()->setAutoMargins(QCP::msNone);
  plot_->axisRect()->setMargins(QMargins(64, 8, 16, 48));
  rows->addWidget(plot_);
  nothing_ = make_text({}, this, true);
  rows->addWidget(nothing_);
}

void ResponsePlot::show_profile(const DeviceProfile& profile) {
  plot_->clearGraphs();
  plot_->clearItems();
  QString keys{};
  double low_Hz = 8.0;
  double high_Hz = 200.0;
  double low = INFINITY;
  double high = 0.0;
  const DeviceItem* const resonance = profile.item("resonance_Hz");
  for (const AxisResponse& response : profile.responses) {
    const int place = place_of_axis(response.axis);
    const QColor color = curve_color(place);
    QCPGraph* graph = plot_->addGraph();
    graph->setPen(QPen(color, kCurveWidths[static_cast<std::size_t>(place)]));
    for (const FrequencyResponse& tone : response.tones) {
      const double value = kResponseScale * tone.response_m_per_N;
      if (!(value > 0.0) || !(tone.frequency_Hz > 0.0)) continue;
      graph->addData(tone.frequency_Hz, value);
      low_Hz = std::min(low_Hz, tone.frequency_Hz);
      high_Hz = std::max(high_Hz, tone.frequency_Hz);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    keys += curve_key(color, QString::fromStdString(response.axis));
    if (resonance == nullptr || resonance->by_axis.size() != 3) continue;
    auto* line = new QCPItemStraightLine(plot_);
    line->setPen(QPen(color, 1.0, Qt::DotLine));
    const double at_Hz = resonance->by_axis[static_cast<std::size_t>(place)];
    line->point1->setCoords(at_Hz, 1e-6);
    line->point2->setCoords(at_Hz, 1e6);
  }
  heading_->setText(tr("FREQUENCY RESPONSE mm/N, motion over force") + keys);
  const bool is_there = high > 0.0;
  plot_->setVisible(is_there);
  nothing_->setVisible(!is_there);
  if (!is_there) {
    nothing_->setText(profile.items.empty() ? QString()
                                            : tr("No frequency response is stored with this "
                                                 "profile; to measure it, test the device again."));
    return;
  }
  plot_->xAxis->setRange(0.9 * low_Hz, 1.1 * high_Hz);
  plot_->yAxis->setRange(0.7 * low, 1.4 * high);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

int ResponsePlot::points() const {
  int points = 0;
  for (int i = 0; i < plot_->graphCount(); ++i) points += plot_->graph(i)->dataCount();
  return points;
}

}  // namespace asperity

#include "moc_response_plot.cpp"

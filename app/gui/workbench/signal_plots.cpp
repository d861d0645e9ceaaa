#include "app/gui/workbench/signal_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtCore/QEvent>
#include <QtWidgets/QBoxLayout>
#include <qcustomplot.h>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

constexpr double kDecadesShown = 5.0;  // of a spectrum, below its highest line

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return !(low <= high); }
};

void set_scale(QCPAxis& axis, PlotScale scale) {
  if (scale == PlotScale::linear) return;
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
  axis.setNumberFormat("eb");
  axis.setNumberPrecision(0);
}

void fit(QCPAxis& axis, PlotScale scale, Extent extent, bool margin) {
  if (extent.is_empty()) return;
  if (scale == PlotScale::logarithmic) {
    if (margin) {
      // A silent stretch has a spectrum of rounding errors, which nobody wants to see.
      extent.low = std::max(extent.low, extent.high * std::pow(10.0, -kDecadesShown));
      extent = {extent.low / 1.5, extent.high * 2.0};
    }
    axis.setRange(extent.low, std::max(extent.high, extent.low * 10.0));
    return;
  }
  const double room =
      std::max(margin ? 0.08 * (extent.high - extent.low) : 0.0,
               extent.high > extent.low ? 0.0 : std::max(1e-3, 0.1 * std::abs(extent.high)));
  axis.setRange(extent.low - room, extent.high + room);
}

}  // namespace

SignalPlots::SignalPlots(const PlotAxes& signal, const PlotAxes& spectrum, QWidget* parent)
    : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kMargin);
  layout->addWidget(make_side(signal_, signal), 3);
  layout->addWidget(make_side(spectrum_, spectrum), 2);
}

QWidget* SignalPlots::make_side(Side& side, const PlotAxes& axes) {
  side.axes = axes;
  auto* box = new QFrame(this);
  box->setProperty("role", "card");
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid / 2);
  layout->setSpacing(0);
  side.heading = make_text(axes.heading, box);
  side.heading->setFont(text_font(TextSize::small));
  side.heading->setWordWrap(false);
  side.heading->setTextFormat(Qt::RichText);
  // Names that find no room are cut off, they do not widen the page.
  side.heading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->addWidget(side.heading);
  // Lying above its axis it is read whole however low the plot is; beside it, it would be cut off.
  QLabel* y = make_text(axes.y, box, true);
  y->setFont(text_font(TextSize::small));
  y->setWordWrap(false);
  y->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->addWidget(y);
  side.plot = new QCustomPlot(box);
  side.plot->setMinimumHeight(96);
  side.plot->xAxis->setLabel(axes.x);
  set_scale(*side.plot->xAxis, axes.x_scale);
  set_scale(*side.plot->yAxis, axes.y_scale);
  side.plot->axisRect()->setMinimumMargins(QMargins(56, 4, 8, 0));
  layout->addWidget(side.plot, 1);
  style_plot(*side.plot);
  return box;
}

void SignalPlots::show_signal(const std::vector<PlotSeries>& series, const QString& empty) {
  signal_.series = series;
  signal_.empty = empty;
  draw(signal_);
}

void SignalPlots::show_spectrum(const std::vector<PlotSeries>& series, const QString& empty) {
  spectrum_.series = series;
  spectrum_.empty = empty;
  draw(spectrum_);
}

void SignalPlots::draw(Side& side) {
  QCustomPlot& plot = *side.plot;
  plot.clearGraphs();
  plot.clearItems();
  Extent x{};
  Extent y{};
  QString heading = "<b>" + side.axes.heading.toHtmlEscaped() + "</b>";
  for (const PlotSeries& series : side.series) {
    QCPGraph* graph = plot.addGraph();
    graph->setPen(QPen(series.color, 1.5));
    graph->setData(series.x, series.y, true);
    for (qsizetype i = 0; i < series.x.size(); ++i) {
      x.include(series.x[i]);
      // A logarithm needs something to take it of.
      if (side.axes.y_scale == PlotScale::linear || series.y[i] > 0.0) y.include(series.y[i]);
    }
    if (!series.name.isEmpty()) {
      heading += QString("&nbsp;&nbsp; <span style='color:%1'>━</span> %2")
                     .arg(series.color.name(), series.name.toHtmlEscaped());
    }
  }
  side.heading->setText(heading);
  const bool nothing = side.series.empty() || x.is_empty();
  if (nothing && !side.empty.isEmpty()) {
    auto* label = new QCPItemText(&plot);
    label->position->setType(QCPItemPosition::ptAxisRectRatio);
    label->position->setCoords(0.5, 0.5);
    label->setText(side.empty);
    label->setColor(theme().muted);
    label->setFont(text_font(TextSize::small));
  }
  plot.xAxis->setTickLabels(!nothing);
  plot.yAxis->setTickLabels(!nothing);
  fit(*plot.xAxis, side.axes.x_scale, x, false);
  fit(*plot.yAxis, side.axes.y_scale, y, true);
  plot.replot(QCustomPlot::rpQueuedReplot);
}

void SignalPlots::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (Side* side : {&signal_, &spectrum_}) {
    if (side->plot == nullptr) continue;
    style_plot(*side->plot);
    draw(*side);
  }
}

}  // namespace asperity

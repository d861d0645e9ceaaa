// Fits linear or logarithmic axes to the series, with few ticks in a narrow plot.

#include "app/gui/workbench/signal_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtCore/QEvent>
#include <QtCore/QStringList>
#include <QtGui/QFontMetrics>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <qcustomplot.h>

#include "app/gui/look/controls.h"
#include "app/gui/look/plot_ticks.h"

namespace asperity {

namespace {

constexpr double kSignalDecades = 5.0;  // of a spectrum, below its highest line

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return !(low <= high); }
};

/// In lines that are no wider, where words allow it.
QString in_lines(const QString& text, const QFontMetrics& metrics, int width) {
  QStringList lines{};
  for (const QString& word : text.split(' ')) {
    const QString longer = lines.isEmpty() ? word : lines.last() + ' ' + word;
    if (lines.isEmpty() || metrics.horizontalAdvance(longer) > width) {
      lines << word;
    } else {
      lines.last() = longer;
    }
  }
  return lines.join('\n');
}

void set_scale(QCPAxis& axis, PlotScale scale) {
  if (scale == PlotScale::linear) {
    axis.setTicker(plain_ticker());
    return;
  }
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(decade_ticker());
  axis.setNumberFormat("eb");
  axis.setNumberPrecision(0);
}

void fit(QCPAxis& axis, PlotScale scale, Extent extent, bool margin) {
  if (extent.is_empty()) return;
  if (scale == PlotScale::logarithmic) {
    if (margin) {
      // A silent stretch has a spectrum of rounding errors, which nobody wants to see.
      extent.low = std::max(extent.low, extent.high * std::pow(10.0, -kSignalDecades));
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

SignalPlot::SignalPlot(const PlotAxes& axes, QWidget* parent) : QFrame(parent), axes_(axes) {
  setProperty("role", "card");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid / 2);
  layout->setSpacing(0);
  const auto add_line = [this, layout](const QString& text, TextSize size, bool muted) {
    QLabel* line = make_text(text, this, muted);
    line->setFont(text_font(size));
    line->setWordWrap(false);
    // What finds no room is cut off, it does not widen the page.
    line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    layout->addWidget(line);
    return line;
  };
  heading_ = add_line(axes.heading, TextSize::small, false);
  heading_->setTextFormat(Qt::RichText);
  heading_->setWordWrap(true);  // names of many models
  // Lying above its axis it is read whole however low the plot is; beside it, it would be cut off.
  add_line(axes.y, TextSize::small, true)->setWordWrap(true);
  if (axes.names_are_large) {
    large_names_ = add_line({}, TextSize::body, false);
    large_names_->setTextFormat(Qt::RichText);
    large_names_->setObjectName("large_names");
  }
  plot_ = new QCustomPlot(this);
  plot_->setMinimumHeight(axes.names_are_large ? 72 : 96);
  plot_->xAxis->setLabel(axes.x);
  set_scale(*plot_->xAxis, axes.x_scale);
  set_scale(*plot_->yAxis, axes.y_scale);
  plot_->axisRect()->setMinimumMargins(QMargins(56, 4, 8, 0));
  layout->addWidget(plot_, 1);
  style_plot(*plot_);
  write_names();
}

void SignalPlot::show_series(const std::vector<PlotSeries>& series, const QString& empty) {
  series_ = series;
  empty_ = empty;
  draw();
}

void SignalPlot::write_names() {
  QStringList names{};
  for (const PlotSeries& series : series_) {
    if (series.name.isEmpty()) continue;
    names << QString("<span style='color:%1'>━</span>&nbsp;%2")
                 .arg(series.color.name(), series.name.toHtmlEscaped().replace(' ', "&nbsp;"));
  }
  const QString written = names.join(large_names_ == nullptr ? "&nbsp;&nbsp; " : "&nbsp; ");
  const QString heading = "<b>" + axes_.heading.toHtmlEscaped() + "</b>";
  if (large_names_ == nullptr) {
    heading_->setText(names.isEmpty() ? heading : heading + "&nbsp;&nbsp; " + written);
    return;
  }
  heading_->setText(heading);
  // A line that is empty would be lower, and the plot would jump.
  large_names_->setText(names.isEmpty() ? QString("&nbsp;") : "<b>" + written + "</b>");
}

void SignalPlot::draw() {
  plot_->clearGraphs();
  plot_->clearItems();
  Extent x{};
  Extent y{};
  for (const PlotSeries& series : series_) {
    QCPGraph* graph = plot_->addGraph();
    graph->setPen(QPen(series.color, 1.5));
    graph->setData(series.x, series.y, true);
    for (qsizetype i = 0; i < series.x.size(); ++i) {
      x.include(series.x[i]);
      // A logarithm needs something to take it of.
      if (axes_.y_scale == PlotScale::linear || series.y[i] > 0.0) y.include(series.y[i]);
    }
  }
  write_names();
  const bool nothing = series_.empty() || x.is_empty();
  if (nothing && !empty_.isEmpty()) {
    auto* label = new QCPItemText(plot_);
    label->position->setType(QCPItemPosition::ptAxisRectRatio);
    label->position->setCoords(0.5, 0.5);
    label->setFont(text_font(TextSize::small));
    label->setText(in_lines(empty_, QFontMetrics(label->font()), plot_->axisRect()->width()));
    label->setClipToAxisRect(false);
    label->setColor(theme().muted);
    label->setObjectName("empty");
  }
  plot_->xAxis->setTickLabels(!nothing);
  plot_->yAxis->setTickLabels(!nothing);
  fit(*plot_->xAxis, axes_.x_scale, x, false);
  fit(*plot_->yAxis, axes_.y_scale, y, true);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void SignalPlot::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || plot_ == nullptr) return;
  style_plot(*plot_);
  choose_ticks();
  draw();
}

void SignalPlot::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  choose_ticks();
  if (series_.empty() && !empty_.isEmpty()) draw();  // in other lines
}

/// In a narrow plot four numbers of three digits would run into each other. Of three, steps are less
/// than half of what is shown, so that two numbers stand there at least.
void SignalPlot::choose_ticks() {
  constexpr int kNarrow = 256;
  const int ticks = width() < kNarrow ? 3 : 4;
  QCPAxisTicker& ticker = *plot_->xAxis->ticker();
  if (axes_.x_scale == PlotScale::logarithmic || ticker.tickCount() == ticks) return;
  ticker.setTickCount(ticks);
  // The plot has drawn itself in its new size already.
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

SignalPlots::SignalPlots(const PlotAxes& signal, const PlotAxes& spectrum, QWidget* parent)
    : QWidget(parent),
      signal_(new SignalPlot(signal, this)),
      spectrum_(new SignalPlot(spectrum, this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kMargin);
  layout->addWidget(signal_, 3);
  layout->addWidget(spectrum_, 2);
}

void SignalPlots::show_signal(const std::vector<PlotSeries>& series, const QString& empty) {
  signal_->show_series(series, empty);
}

void SignalPlots::show_spectrum(const std::vector<PlotSeries>& series, const QString& empty) {
  spectrum_->show_series(series, empty);
}

}  // namespace asperity

#include "moc_signal_plots.cpp"

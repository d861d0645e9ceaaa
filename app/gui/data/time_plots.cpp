// Draws strips on one time axis with bands, contacts and marks; zooming changes the stretch of all strips.

#include "app/gui/data/time_plots.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QtGui/QKeyEvent>
#include <qcustomplot.h>

#include "app/gui/base/curve_color.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/plot_ticks.h"

namespace asperity {

namespace {

constexpr double kMillimetres = 1000.0;  // per metre
constexpr double kShortest_s = 0.010;    // ten ticks fill the width
constexpr double kStep = 1.5;            // of a zoom by key
// Where marks stand, from the bottom to the top of their plot.
constexpr double kMissedAt = 0.94;
constexpr double kLimitedAt = 0.82;

QColor faint(QColor color, float alpha) {
  color.setAlphaF(alpha);
  return color;
}

QColor contact_color() { return faint(theme().muted, theme().dark ? 0.22F : 0.14F); }
QColor band_color() { return faint(theme().fine, theme().dark ? 0.24F : 0.16F); }

QString area_key(const QColor& color, const QString& name) {
  return QString("&nbsp; <span style='background:%1'>&nbsp;&nbsp;&nbsp;&nbsp;</span>&nbsp;%2")
      .arg(color.name(QColor::HexArgb), name.toHtmlEscaped());
}

QString mark_key(const QColor& color, const QString& mark, const QString& name) {
  return QString("&nbsp; <span style='color:%1'>%2</span>&nbsp;%3")
      .arg(color.name(), mark, name.toHtmlEscaped());
}

}  // namespace

struct TimePlots::Curve {
  const std::vector<double> RecordingCurves::*values = nullptr;
  double scale = 1.0;
  int color = 0;
  double width = 1.0;
  QString name{};
  QCPGraph* graph = nullptr;
};

struct TimePlots::Strip {
  QCustomPlot* plot = nullptr;
  QLabel* heading = nullptr;
  QString what{};
  std::vector<Curve> curves{};
  QCPGraph* contact = nullptr;
  QCPItemRect* band = nullptr;
  QCPGraph* missed = nullptr;   // of the first strip only
  QCPGraph* limited = nullptr;  // of the first strip only
};

TimePlots::TimePlots(QWidget* parent) : QFrame(parent) {
  setObjectName("time_plots");
  setFocusPolicy(Qt::StrongFocus);
  setStyleSheet(QString("asperity--TimePlots { background: %1; border: 2px solid %2; "
                        "border-radius: 6px; } asperity--TimePlots:focus { border-color: %3; }")
                    .arg(theme().panel.name(), theme().line.name(), theme().press.name()));
  setToolTip(tr("Wheel, + or −: zoom; drag, ← or →: move; Home: show all."));
  setAccessibleName(tr("Force, penetration, speed and position over time"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(kGrid, kGrid, kGrid, kGrid / 2);
  rows->setSpacing(0);
  using C = RecordingCurves;
  // What was sent lies on what was meant; where they differ, both are seen.
  add_strip("force_over_time", tr("NORMAL FORCE N"),
            {{&C::rendered_N, 1.0, 1, 3.0, tr("rendered")}, {&C::sent_N, 1.0, 0, 1.0, tr("sent")}});
  add_strip("penetration_over_time", tr("PENETRATION mm"),
            {{&C::penetration_m, kMillimetres, 0, 1.0, {}}});
  add_strip("speed_over_time", tr("SPEED mm/s, along the surface"),
            {{&C::speed_m_per_s, kMillimetres, 0, 1.0, {}}});
  add_strip("position_over_time", tr("POSITION mm"),
            {{&C::x_m, kMillimetres, 0, 1.0, tr("x")},
             {&C::y_m, kMillimetres, 1, 1.0, tr("y")},
             {&C::z_m, kMillimetres, 2, 1.0, tr("z, up")}});
  add_marks();
  QCPAxis& time = *strips_.back().plot->xAxis;
  time.setLabel(tr("time since the attempt began, s"));
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    const bool last = i + 1 == strips_.size();
    strips_[i].plot->xAxis->setTickLabels(last);
    strips_[i].plot->axisRect()->setMargins(QMargins(56, 4, 8, last ? 44 : 8));
    strips_[i].plot->setMinimumHeight(last ? 84 : 48);
    rows->setStretchFactor(strips_[i].plot, last ? 14 : 10);
  }
}

TimePlots::~TimePlots() = default;

void TimePlots::add_strip(const char* name, const QString& heading, std::vector<Curve> curves) {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  Strip strip{};
  strip.what = heading;
  strip.heading = make_text({}, this);
  strip.heading->setFont(text_font(TextSize::small));
  strip.heading->setTextFormat(Qt::RichText);
  strip.heading->setWordWrap(false);
  strip.heading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  rows->addWidget(strip.heading);
  strip.plot = new QCustomPlot(this);
  QCustomPlot& plot = *strip.plot;
  plot.setObjectName(name);
  plot.setFocusPolicy(Qt::ClickFocus);
  plot.setFocusProxy(this);
  plot.setNotAntialiasedElements(QCP::aeAll);
  plot.addLayer("areas", plot.layer("grid"), QCustomPlot::limBelow);
  style_plot(plot);
  keep_labels_apart(*plot.yAxis, 3);
  plot.yAxis2->setRange(0.0, 1.0);
  plot.axisRect()->setAutoMargins(QCP::msNone);
  plot.axisRect()->setRangeDrag(Qt::Horizontal);
  plot.axisRect()->setRangeZoom(Qt::Horizontal);
  plot.setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  strip.contact = plot.addGraph(plot.xAxis, plot.yAxis2);
  strip.contact->setLayer("areas");
  strip.contact->setPen(Qt::NoPen);
  strip.contact->setBrush(contact_color());
  strip.contact->setAdaptiveSampling(false);
  strip.band = new QCPItemRect(&plot);
  strip.band->setLayer("areas");
  strip.band->setPen(Qt::NoPen);
  strip.band->setBrush(band_color());
  for (Curve& curve : curves) {
    curve.graph = plot.addGraph();
    curve.graph->setPen(QPen(curve_color(curve.color), curve.width));
    curve.graph->setAdaptiveSampling(false);  // it is thinned already, and keeps its peaks
  }
  strip.curves = std::move(curves);
  rows->addWidget(strip.plot, 1);
  connect(plot.xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
          [this](const QCPRange& range) {
            if (!following_) see({range.lower, range.upper});
          });
  strips_.push_back(std::move(strip));
}

void TimePlots::add_marks() {
  Strip& force = strips_.front();
  const auto add = [&force](QCPScatterStyle::ScatterShape shape, const QColor& color) {
    QCPGraph* marks = force.plot->addGraph(force.plot->xAxis, force.plot->yAxis2);
    marks->setLineStyle(QCPGraph::lsNone);
    marks->setScatterStyle(QCPScatterStyle(shape, color, color, 7));
    return marks;
  };
  force.missed = add(QCPScatterStyle::ssTriangleInverted, theme().stop);
  force.limited = add(QCPScatterStyle::ssSquare, theme().look);
}

void TimePlots::show_curves(std::shared_ptr<const RecordingCurves> curves,
                            const AskedBands& bands) {
  curves_ = std::move(curves);
  QVector<QCPGraphData> contacts{};
  for (const TimeStretch& contact : curves_->contacts) {
    contacts << QCPGraphData(contact.begin_s, 0.0) << QCPGraphData(contact.begin_s, 1.0)
             << QCPGraphData(contact.end_s, 1.0) << QCPGraphData(contact.end_s, 0.0);
  }
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    Strip& strip = strips_[i];
    strip.contact->data()->set(contacts, true);
    AskedBand asked = i == 0 ? bands.force_N : i == 2 ? bands.speed_m_per_s : AskedBand{};
    const double scale = strip.curves.front().scale;
    for (std::optional<double>* end : {&asked.minimum, &asked.maximum}) {
      if (*end) **end *= scale;
    }
    fit_values(strip, asked);
  }
  const auto set_marks = [](QCPGraph& marks, const std::vector<double>& times_s, double place) {
    QVector<QCPGraphData> points{};
    for (const double time_s : times_s) points << QCPGraphData(time_s, place);
    marks.data()->set(points, true);
  };
  set_marks(*strips_.front().missed, curves_->missed_s, kMissedAt);
  set_marks(*strips_.front().limited, curves_->limited_s, kLimitedAt);
  write_headings();
  see(curves_->whole());
}

void TimePlots::write_headings() {
  for (Strip& strip : strips_) {
    QString text = QString("<b>%1</b>").arg(strip.what.toHtmlEscaped());
    for (const Curve& curve : strip.curves) {
      if (!curve.name.isEmpty()) text += curve_key(curve_color(curve.color), curve.name);
    }
    // In the force's there is no room for all of them.
    if (&strip == &strips_[1]) text += area_key(contact_color(), tr("in contact"));
    if (strip.band->visible()) text += area_key(band_color(), tr("requested"));
    if (strip.missed != nullptr) {
      text += mark_key(theme().stop, "▼", tr("%1 missed").arg(curves_->missed_s.size()));
      text += mark_key(theme().look, "■", tr("%1 limited").arg(curves_->limited_s.size()));
    }
    strip.heading->setText(text);
  }
}

void TimePlots::fit_values(Strip& strip, const AskedBand& asked) {
  double low = 0.0;
  double high = 0.0;
  for (const Curve& curve : strip.curves) {
    for (const double value : (*curves_).*curve.values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value * curve.scale);
      high = std::max(high, value * curve.scale);
    }
  }
  high = std::max({high, asked.maximum.value_or(high), asked.minimum.value_or(high)});
  const double room = 0.08 * std::max(high - low, 1e-6);
  strip.plot->yAxis->setRange(low < 0.0 ? low - room : low, high + room);
  strip.band->setVisible(asked.minimum || asked.maximum);
  constexpr double kFar = 1e9;  // an open end; what lies outside the axes is clipped
  strip.band->topLeft->setCoords(-kFar, asked.maximum.value_or(kFar));
  strip.band->bottomRight->setCoords(kFar, asked.minimum.value_or(-kFar));
}

void TimePlots::see(const TimeStretch& wanted) {
  if (curves_ == nullptr) return;
  const TimeStretch whole = curves_->whole();
  const double longest_s = std::max(whole.duration_s(), kShortest_s);
  const double duration_s = std::clamp(wanted.duration_s(), kShortest_s, longest_s);
  const double latest_s = whole.begin_s + (longest_s - duration_s);  // never before the beginning
  const double begin_s = std::clamp(wanted.begin_s, whole.begin_s, latest_s);
  seen_ = {begin_s, begin_s + duration_s};
  draw();
}

void TimePlots::zoom(double factor) {
  const double half_s = 0.5 * factor * seen_.duration_s();
  const double middle_s = 0.5 * (seen_.begin_s + seen_.end_s);
  see({middle_s - half_s, middle_s + half_s});
}

void TimePlots::draw() {
  if (curves_ == nullptr) return;
  following_ = true;
  for (Strip& strip : strips_) {
    strip.plot->xAxis->setRange(seen_.begin_s, seen_.end_s);
    const int columns = std::max(1, strip.plot->axisRect()->width());
    for (Curve& curve : strip.curves) {
      QVector<QCPGraphData> points{};
      for (const CurvePoint& point :
           envelope_of(curves_->time_s, (*curves_).*curve.values, seen_, columns)) {
        points << QCPGraphData(point.time_s, point.value * curve.scale);
      }
      curve.graph->data()->set(points, true);
    }
    strip.plot->replot(QCustomPlot::rpQueuedReplot);
  }
  following_ = false;
}

void TimePlots::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  draw();
}

void TimePlots::keyPressEvent(QKeyEvent* event) {
  const double step_s = 0.1 * seen_.duration_s();
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(1.0 / kStep);
    case Qt::Key_Minus:
      return zoom(kStep);
    case Qt::Key_Left:
      return see({seen_.begin_s - step_s, seen_.end_s - step_s});
    case Qt::Key_Right:
      return see({seen_.begin_s + step_s, seen_.end_s + step_s});
    case Qt::Key_Home:
      if (curves_ != nullptr) see(curves_->whole());
      return;
    default:
      QFrame::keyPressEvent(event);
  }
}

}  // namespace asperity

#include "moc_time_plots.cpp"

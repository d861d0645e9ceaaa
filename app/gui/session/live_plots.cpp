// Appends the bins of the monitor to curves, and redraws a plot as a whole only if an axis changes.

#include "app/gui/session/live_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QtCore/QEvent>
#include <QtWidgets/QBoxLayout>
#include <qcustomplot.h>

#include "analysis/signals/compliance.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/plot_ticks.h"
#include "app/gui/look/words.h"
#include "app/gui/look/fitted_label.h"

namespace asperity {

namespace {

constexpr double kLiveMillimetres = 1000.0;  // per metre
// Words that change sixty times a second cannot be read.
constexpr int kBinsPerWords = 15;
constexpr auto kBinsShown =
    static_cast<std::size_t>(LivePlots::kShown_s / SessionMonitor::kBin_s + 0.5);

/// The next of 1, 1.5, 2, 3, 5, 7.5, 10, … that is not below `value`: an axis that grows in steps.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5}) {
    if (step * decade >= value * (1.0 - 1e-9)) return step * decade;
  }
  return 10.0 * decade;
}

QString three_digits(double value) { return shown_number(value, 'g', 3); }

QString text_of_band(const Band& band, double scale, const QString& unit) {
  if (band.minimum && band.maximum) {
    return QString("%1–%2 %3")
        .arg(three_digits(*band.minimum * scale), three_digits(*band.maximum * scale), unit);
  }
  if (band.minimum) return QString("≥ %1 %2").arg(three_digits(*band.minimum * scale), unit);
  if (band.maximum) return QString("≤ %1 %2").arg(three_digits(*band.maximum * scale), unit);
  return {};
}

/// The heading of a plot: what and unit, what is asked, how it is met.
struct Heading {
  FittedLabel* band = nullptr;
  FittedLabel* compliance = nullptr;
};

Heading add_heading(QVBoxLayout& rows, const QString& what, QWidget* parent, const char* name) {
  Heading heading{};
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  auto* title = new QLabel(what, parent);
  title->setFont(text_font(TextSize::small, true));
  title->setProperty("role", "muted");
  heading.band = new FittedLabel(parent);
  heading.band->setFont(text_font(TextSize::small));
  heading.band->setProperty("role", "muted");
  heading.compliance = new FittedLabel(parent);
  heading.compliance->setObjectName(name);
  heading.compliance->setFont(text_font(TextSize::small));
  heading.compliance->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(title);
  row->addWidget(heading.band);
  row->addWidget(heading.compliance, 1);
  rows.addLayout(row);
  return heading;
}

QCustomPlot* make_plot(QWidget* parent, const char* name) {
  auto* plot = new QCustomPlot(parent);
  plot->setObjectName(name);
  plot->setNotAntialiasedElements(QCP::aeAll);
  plot->setMinimumHeight(56);
  plot->setFocusPolicy(Qt::NoFocus);
  plot->setAttribute(Qt::WA_TransparentForMouseEvents);
  // What moves is drawn into a buffer of its own: a frame leaves axes and bands as they are.
  plot->addLayer("bands", plot->layer("grid"), QCustomPlot::limBelow);
  plot->layer("main")->setMode(QCPLayer::lmBuffered);
  return plot;
}

/// A plot over time with a band.
struct Strip {
  QCustomPlot* plot = nullptr;
  Heading heading{};
  QCPGraph* lower = nullptr;
  QCPGraph* upper = nullptr;   ///< filled down to `lower`
  QCPGraph* middle = nullptr;  ///< what is judged: the pressing force, the speed of a stroke
  QCPItemRect* band = nullptr;
  Band asked{};  ///< in the units of the axis
  double top = 0.0;
  QVector<QCPGraphData> lower_points{};
  QVector<QCPGraphData> upper_points{};
  QVector<QCPGraphData> middle_points{};
};

void show_band(Strip& strip) {
  const bool any = strip.asked.minimum || strip.asked.maximum;
  strip.band->setVisible(any);
  if (!any) return;
  constexpr double kFar = 1e6;  // an open end; what lies outside the axes is clipped
  strip.band->topLeft->setCoords(-kFar, strip.asked.maximum.value_or(kFar));
  strip.band->bottomRight->setCoords(kFar, strip.asked.minimum.value_or(-kFar));
}

/// Draws what moves; all of it when the axis had to follow.
void draw(Strip& strip, double seen) {
  const double asked = strip.asked.maximum.value_or(2.0 * strip.asked.minimum.value_or(0.5));
  const double wanted = round_up(std::max({1.2 * asked, 1.05 * seen, 1e-3}));
  if (wanted > strip.top || wanted < 0.5 * strip.top) {
    strip.top = wanted;
    strip.plot->yAxis->setRange(0.0, strip.top);
    strip.plot->replot(QCustomPlot::rpQueuedReplot);
    return;
  }
  strip.plot->layer("main")->replot();
}

void set_points(QCPCurve& curve, const QVector<QCPCurveData>& points) {
  curve.data()->set(points, true);
}

}  // namespace

struct LivePlots::Drawing {
  Strip force{};
  Strip speed{};
  QCustomPlot* path = nullptr;
  Heading path_heading{};
  QLabel* stroke_words = nullptr;
  QCPItemRect* patch_area = nullptr;
  std::array<QCPCurve*, 2> turning{};  ///< where a stroke of the allowed length turns
  QCPCurve* hover = nullptr;
  QCPCurve* touch = nullptr;
  QCPCurve* here = nullptr;
  QVector<QCPCurveData> hover_points{};
  QVector<QCPCurveData> touch_points{};

  SurfacePatch patch{};
  std::optional<Exploration> exploration{};
  HandSoFar hand{};
  bool blind = true;
  std::uint64_t next_bin = 0;
  std::vector<LiveBin> fresh{};
  std::vector<LiveBin> shown{};
  std::size_t since_words = kBinsPerWords;
};

LivePlots::LivePlots(QWidget* parent) : QWidget(parent), drawing_(std::make_unique<Drawing>()) {
  Drawing& d = *drawing_;
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  d.force.heading = add_heading(*rows, tr("FORCE N"), this, "force_compliance");
  d.force.plot = make_plot(this, "force_plot");
  rows->addWidget(d.force.plot, 4);
  d.speed.heading = add_heading(*rows, tr("SPEED mm/s"), this, "speed_compliance");
  d.speed.plot = make_plot(this, "speed_plot");
  rows->addWidget(d.speed.plot, 5);  // has the numbers of the time axis as well
  for (Strip* strip : {&d.force, &d.speed}) {
    QCustomPlot& plot = *strip->plot;
    plot.xAxis->setRange(-kShown_s, 0.0);
    plot.xAxis->setTicker(step_ticker(2.0));
    strip->band = new QCPItemRect(&plot);
    strip->band->setLayer("bands");
    strip->band->setPen(Qt::NoPen);
    strip->lower = plot.addGraph();
    strip->upper = plot.addGraph();
    strip->upper->setChannelFillGraph(strip->lower);
    // An envelope has two points per bin; thinning would take its peaks away.
    strip->lower->setAdaptiveSampling(false);
    strip->upper->setAdaptiveSampling(false);
    plot.axisRect()->setAutoMargins(QCP::msNone);
    plot.axisRect()->setMargins(QMargins(48, 4, 8, strip == &d.force ? 8 : 40));
  }
  d.force.middle = d.force.plot->addGraph();
  d.speed.middle = d.speed.plot->addGraph();
  d.force.plot->xAxis->setTickLabels(false);
  d.speed.plot->xAxis->setLabel(tr("time, s"));

  for (const Strip* strip : {&d.force, &d.speed}) keep_labels_apart(*strip->plot->yAxis, 3);

  d.path_heading = add_heading(*rows, tr("PATH mm"), this, "path_compliance");
  d.path = make_plot(this, "path_plot");
  rows->addWidget(d.path, 7);
  d.path->axisRect()->setAutoMargins(QCP::msNone);
  d.path->axisRect()->setMargins(QMargins(48, 4, 8, 24));
  d.patch_area = new QCPItemRect(d.path);
  d.patch_area->setLayer("bands");
  for (QCPCurve*& zone : d.turning) {
    zone = new QCPCurve(d.path->xAxis, d.path->yAxis);
    zone->setLayer("bands");
    zone->setPen(Qt::NoPen);
  }
  d.hover = new QCPCurve(d.path->xAxis, d.path->yAxis);
  d.touch = new QCPCurve(d.path->xAxis, d.path->yAxis);
  d.here = new QCPCurve(d.path->xAxis, d.path->yAxis);
  d.here->setLineStyle(QCPCurve::lsNone);
  // A millimetre is as long across as along; the width shows more of the ground beside the patch.
  connect(d.path, &QCustomPlot::afterLayout, this,
          [this] { drawing_->path->xAxis->setScaleRatio(drawing_->path->yAxis, 1.0); });
  keep_labels_apart(*d.path->yAxis, 3);
  d.path->xAxis->setTicker(plain_ticker());

  restyle();
  set_exploration({});
}

LivePlots::~LivePlots() = default;

void LivePlots::set_patch(const SurfacePatch& patch) {
  drawing_->patch = patch;
  Drawing& d = *drawing_;
  const double x = kLiveMillimetres * patch.centre_m.x;
  const double y = kLiveMillimetres * patch.centre_m.y;
  const double half_x = 0.5 * kLiveMillimetres * patch.extent_m.x;
  const double half_y = 0.5 * kLiveMillimetres * patch.extent_m.y;
  d.patch_area->topLeft->setCoords(x - half_x, y + half_y);
  d.patch_area->bottomRight->setCoords(x + half_x, y - half_y);
  constexpr double kAround = 1.1;
  d.path->yAxis->setRange(y - kAround * half_y, y + kAround * half_y);
  d.path->xAxis->setRange(x - kAround * half_x, x + kAround * half_x);
  set_exploration(d.exploration);
}

void LivePlots::set_exploration(const std::optional<Exploration>& exploration) {
  Drawing& d = *drawing_;
  d.exploration = exploration;
  const Exploration asked = exploration.value_or(Exploration{});
  d.force.asked = asked.normal_force_N;
  d.speed.asked = asked.speed_m_per_s;
  for (std::optional<double>* value : {&d.speed.asked.minimum, &d.speed.asked.maximum}) {
    if (*value) **value *= kLiveMillimetres;
  }
  const auto write = [](const Heading& heading, const QString& band) {
    heading.band->show_text(band.isEmpty() ? tr("no band") : tr("band %1").arg(band));
  };
  write(d.force.heading, text_of_band(asked.normal_force_N, 1.0, tr("N")));
  write(d.speed.heading, text_of_band(asked.speed_m_per_s, kLiveMillimetres, tr("mm/s")));
  write(d.path_heading, text_of_band(asked.stroke_length_m, kLiveMillimetres, tr("mm")));
  show_band(d.force);
  show_band(d.speed);
  // Strokes about the middle of the patch: shaded is where their ends are to lie.
  const double minimum = 0.5 * asked.stroke_length_m.minimum.value_or(0.0);
  const double maximum = 0.5 * asked.stroke_length_m.maximum.value_or(0.0);
  const double along_x = std::cos(asked.direction_rad);
  const double along_y = std::sin(asked.direction_rad);
  const double half_width = 0.5 * std::min(d.patch.extent_m.x, d.patch.extent_m.y);
  for (std::size_t side = 0; side < d.turning.size(); ++side) {
    const double sign = side == 0 ? -1.0 : 1.0;
    QVector<QCPCurveData> corners{};
    const auto corner = [&](double along, double across) {
      corners.append(QCPCurveData(
          static_cast<double>(corners.size()),
          kLiveMillimetres * (d.patch.centre_m.x + along * along_x - across * along_y),
          kLiveMillimetres * (d.patch.centre_m.y + along * along_y + across * along_x)));
    };
    corner(sign * minimum, -half_width);
    corner(sign * maximum, -half_width);
    corner(sign * maximum, half_width);
    corner(sign * minimum, half_width);
    d.turning[side]->data()->set(corners, true);
    d.turning[side]->setVisible(maximum > minimum);
  }
  // The axes start anew at what is asked now.
  d.force.top = 0.0;
  d.speed.top = 0.0;
  d.since_words = kBinsPerWords;
  draw_bins();
  d.path->replot(QCustomPlot::rpQueuedReplot);
}

void LivePlots::set_hand(const HandSoFar& hand) { drawing_->hand = hand; }

void LivePlots::set_blind(bool blind) {
  if (blind == drawing_->blind) return;
  drawing_->blind = blind;
  drawing_->force.top = 0.0;
  draw_bins();
}

void LivePlots::take_bins(const SessionMonitor& monitor) {
  Drawing& d = *drawing_;
  d.next_bin = monitor.bins_from(d.next_bin, d.fresh);
  if (d.fresh.empty()) return;
  d.shown.insert(d.shown.end(), d.fresh.begin(), d.fresh.end());
  if (d.shown.size() > kBinsShown) {
    d.shown.erase(d.shown.begin(), d.shown.end() - static_cast<std::ptrdiff_t>(kBinsShown));
  }
  d.since_words += d.fresh.size();
  draw_bins();
}

void LivePlots::draw_bins() {
  Drawing& d = *drawing_;
  for (Strip* strip : {&d.force, &d.speed}) {
    strip->lower_points.clear();
    strip->upper_points.clear();
    strip->middle_points.clear();
  }
  d.touch_points.clear();
  d.hover_points.clear();
  double most_force = 0.0;
  double most_speed = 0.0;
  const std::int64_t end_ns = d.shown.empty() ? 0 : d.shown.back().time_ns;
  const double gap = std::nan("");
  bool touched = false;
  for (const LiveBin& bin : d.shown) {
    const double at_s = 1e-9 * static_cast<double>(bin.time_ns - end_ns);
    if (at_s < -kShown_s) continue;
    const auto add = [at_s](QVector<QCPGraphData>& points, double value) {
      points.append(QCPGraphData(at_s, value));
    };
    add(d.force.middle_points, bin.pressing_N);
    most_force = std::max(most_force, bin.pressing_N);
    if (!d.blind) {
      add(d.force.lower_points, static_cast<double>(bin.force_minimum_N));
      add(d.force.upper_points, static_cast<double>(bin.force_maximum_N));
      most_force = std::max(most_force, static_cast<double>(bin.force_maximum_N));
    }
    const double fastest = kLiveMillimetres * static_cast<double>(bin.speed_maximum_m_per_s);
    add(d.speed.lower_points, kLiveMillimetres * static_cast<double>(bin.speed_minimum_m_per_s));
    add(d.speed.upper_points, fastest);
    add(d.speed.middle_points,
        bin.stroking_m_per_s ? kLiveMillimetres * *bin.stroking_m_per_s : gap);
    most_speed = std::max(most_speed, fastest);

    const QCPCurveData place(at_s, kLiveMillimetres * static_cast<double>(bin.x_m),
                             kLiveMillimetres * static_cast<double>(bin.y_m));
    // Where one way of moving ends the other begins; a gap keeps their lines apart.
    if (bin.touching != touched) {
      QVector<QCPCurveData>& left = touched ? d.touch_points : d.hover_points;
      if (!left.isEmpty()) left.append(QCPCurveData(at_s, gap, gap));
    }
    touched = bin.touching;
    (touched ? d.touch_points : d.hover_points).append(place);
  }
  for (Strip* strip : {&d.force, &d.speed}) {
    strip->lower->data()->set(strip->lower_points, true);
    strip->upper->data()->set(strip->upper_points, true);
    strip->middle->data()->set(strip->middle_points, true);
  }
  draw(d.force, std::isfinite(most_force) ? most_force : 0.0);
  draw(d.speed, std::isfinite(most_speed) ? most_speed : 0.0);
  set_points(*d.touch, d.touch_points);
  set_points(*d.hover, d.hover_points);
  if (!d.shown.empty()) {
    const LiveBin& last = d.shown.back();
    d.here->data()->set({QCPCurveData(0.0, kLiveMillimetres * static_cast<double>(last.x_m),
                                      kLiveMillimetres * static_cast<double>(last.y_m))},
                        true);
  }
  d.path->layer("main")->replot();
  if (d.since_words >= kBinsPerWords) {
    d.since_words = 0;
    write_compliance();
  }
}

void LivePlots::write_compliance() {
  Drawing& d = *drawing_;
  std::vector<double> along_m{};
  std::vector<double> strokes_m{};
  const Exploration asked = d.exploration.value_or(Exploration{});
  const double along_x = std::cos(asked.direction_rad);
  const double along_y = std::sin(asked.direction_rad);
  const auto end_of_contact = [&] {
    for (const StrokePassage& stroke : strokes_along(along_m)) {
      strokes_m.push_back(std::abs(stroke.length_m));
    }
    along_m.clear();
  };
  for (const LiveBin& bin : d.shown) {
    if (!bin.touching) {
      end_of_contact();
      continue;
    }
    const double along =
        along_x * static_cast<double>(bin.x_m) + along_y * static_cast<double>(bin.y_m);
    if (!std::isfinite(along)) continue;
    along_m.push_back(along);
  }
  end_of_contact();
  const auto write = [this, &asked](FittedLabel& label, const QuantitySoFar& met,
                                    const QString& none) {
    if (met.samples == 0) return label.show_state(State::unknown, none);
    if (!met.fraction_in_band) return label.show_state(State::unknown, tr("no requirement"));
    const QString words =
        tr("in band %1 %").arg(static_cast<int>(std::lround(100.0 * *met.fraction_in_band)));
    label.show_state(
        *met.fraction_in_band >= asked.required_fraction_in_band ? State::fine : State::look,
        words);
  };
  write(*d.force.heading.compliance, d.hand.force_N, tr("no contact"));
  write(*d.speed.heading.compliance, d.hand.speed_m_per_s,
        d.hand.force_N.samples == 0 ? tr("no contact") : tr("no stroke yet"));
  if (strokes_m.empty()) {
    d.path_heading.compliance->show_state(State::unknown, tr("no stroke yet"));
    return;
  }
  const auto met =
      compliance_of(strokes_m, {asked.stroke_length_m.minimum, asked.stroke_length_m.maximum});
  const QString words = tr("strokes: %1, mean %2 mm")
                            .arg(strokes_m.size())
                            .arg(std::lround(kLiveMillimetres * met->summary.mean));
  const double mean = met->summary.mean;
  const bool inside = mean >= asked.stroke_length_m.minimum.value_or(mean) &&
                      mean <= asked.stroke_length_m.maximum.value_or(mean);
  d.path_heading.compliance->show_state(
      !met->fraction_inside ? State::unknown : (inside ? State::fine : State::look), words);
}

int LivePlots::sent_force_points() const { return drawing_->force.upper->dataCount(); }

int LivePlots::pressing_points() const { return drawing_->force.middle->dataCount(); }

void LivePlots::restyle() {
  Drawing& d = *drawing_;
  QColor band = theme().fine;
  band.setAlphaF(theme().dark ? 0.18F : 0.14F);
  // Lighter on dark ground: the first of the series is too near to it.
  const QColor line = theme().dark ? series_color(4) : series_color(0);
  const QColor envelope = series_color(1);
  QColor fill = envelope;
  fill.setAlphaF(0.45F);
  for (Strip* strip : {&d.force, &d.speed}) {
    style_plot(*strip->plot);
    strip->plot->axisRect()->setupFullAxesBox(false);
    strip->plot->xAxis2->setVisible(false);
    strip->plot->yAxis2->setVisible(false);
    strip->band->setBrush(band);
  }
  d.force.lower->setPen(Qt::NoPen);
  d.force.upper->setPen(Qt::NoPen);
  d.force.upper->setBrush(fill);
  d.force.middle->setPen(QPen(line, 0));
  QColor speed_fill = line;
  speed_fill.setAlphaF(0.5F);
  d.speed.lower->setPen(QPen(line, 0));
  d.speed.upper->setPen(QPen(line, 0));
  d.speed.upper->setBrush(speed_fill);
  d.speed.middle->setPen(QPen(theme().text, 0));

  style_plot(*d.path);
  d.path->xAxis->ticker()->setTickCount(3);
  d.patch_area->setPen(QPen(theme().muted, 0));
  d.patch_area->setBrush(Qt::NoBrush);
  for (QCPCurve* zone : d.turning) zone->setBrush(band);
  d.hover->setPen(QPen(theme().muted, 0, Qt::DotLine));
  d.touch->setPen(QPen(line, 0));
  d.here->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, line, line, 9));
  for (QCustomPlot* plot : {d.force.plot, d.speed.plot, d.path}) {
    plot->replot(QCustomPlot::rpQueuedReplot);
  }
  write_compliance();  // its shapes have colours
}

void LivePlots::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) restyle();
}

}  // namespace asperity

#include "moc_live_plots.cpp"

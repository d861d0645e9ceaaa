// Plots position and force over time, and the path of the handle from above and from the front.

#include "app/gui/devices/motion_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QStackedLayout>
#include <qcustomplot.h>

#include "app/gui/base/curve_color.h"
#include "app/gui/look/controls.h"

namespace asperity {

namespace {

constexpr double kMotionMillimetres = 1000.0;  // per metre
constexpr double kLeastAxis_mm = 1.0;          // an axis shows at least so much
constexpr double kLeast_N = 0.2;

QCustomPlot* make_motion_plot(QWidget* parent, const char* name) {
  auto* plot = new QCustomPlot(parent);
  plot->setObjectName(name);
  plot->setMinimumHeight(72);
  plot->setNotAntialiasedElements(QCP::aeAll);
  plot->setFocusPolicy(Qt::NoFocus);
  plot->setAttribute(Qt::WA_TransparentForMouseEvents);
  style_plot(*plot);
  plot->axisRect()->setAutoMargins(QCP::msNone);
  return plot;
}

QLabel* make_motion_heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setTextFormat(Qt::RichText);
  label->setFont(text_font(TextSize::small, true));
  label->setProperty("role", "muted");
  return label;
}

/// The next of 1, 2, 5, 10, … that is not below: an axis that grows in steps.
double next_step(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade >= value * (1.0 - 1e-9)) return step * decade;
  }
  return 10.0 * decade;
}

/// Three curves about zero over time.
struct MotionStrip {
  QCustomPlot* plot = nullptr;
  std::array<QCPGraph*, 3> curves{};
  double least = 1.0;

  void fit(double largest) {
    const double top = next_step(std::max(1.05 * largest, least));
    plot->yAxis->setRange(-top, top);
  }
};

/// The handle seen along one axis, in the workspace.
struct BorderView {
  QCustomPlot* plot = nullptr;
  QCPItemRect* workspace = nullptr;
  QCPCurve* path = nullptr;
  QCPCurve* here = nullptr;
  std::size_t across = 0;  ///< which axis is drawn to the right
  std::size_t up = 1;

  /// All of the workspace, a millimetre as long across as along.
  void fit() const {
    const QCPRange x(workspace->topLeft->key(), workspace->bottomRight->key());
    const QCPRange y(workspace->bottomRight->value(), workspace->topLeft->value());
    const QSize room = plot->axisRect()->size();
    if (room.isEmpty() || x.size() <= 0.0 || y.size() <= 0.0) return;
    constexpr double kAround = 1.15;
    const double mm = kAround * std::max(x.size() / room.width(), y.size() / room.height());
    plot->xAxis->setRange(x.center(), mm * room.width(), Qt::AlignCenter);
    plot->yAxis->setRange(y.center(), mm * room.height(), Qt::AlignCenter);
  }
};

}  // namespace

struct MotionPicture::Drawing {
  QStackedLayout* stack = nullptr;
  MotionStrip position{};
  MotionStrip force{};
  std::array<BorderView, 2> borders{};
  std::vector<MotionBin> shown{};  ///< positions from where their stage began
  int stage = 0;                   ///< of the last bin
  std::array<double, 3> zero_m{};  ///< where the handle was when that began
  int next = 0;                    ///< of the points of a path
};

MotionPicture::MotionPicture(QWidget* parent)
    : QWidget(parent), drawing_(std::make_unique<Drawing>()) {
  Drawing& d = *drawing_;
  setObjectName("motion_picture");
  QString keys{};
  for (int axis = 0; axis < 3; ++axis)
    keys += curve_key(curve_color(axis), QString("xyz").mid(axis, 1));
  d.stack = new QStackedLayout(this);
  auto* over_time = new QWidget(this);
  auto* rows = new QVBoxLayout(over_time);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  rows->addWidget(make_motion_heading(tr("MOTION mm") + keys, over_time));
  d.position.plot = make_motion_plot(over_time, "motion_plot");
  d.position.least = kLeastAxis_mm;
  rows->addWidget(d.position.plot, 5);
  rows->addWidget(make_motion_heading(tr("SENT FORCE N") + keys, over_time));
  d.force.plot = make_motion_plot(over_time, "motion_force_plot");
  d.force.least = kLeast_N;
  rows->addWidget(d.force.plot, 4);
  for (MotionStrip* strip : {&d.position, &d.force}) {
    const bool is_last = strip == &d.force;
    strip->plot->axisRect()->setMargins(QMargins(56, 4, 8, is_last ? 40 : 8));
    strip->plot->xAxis->setRange(-kShown_s, 0.0);
    strip->plot->xAxis->setTickLabels(is_last);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      strip->curves[axis] = strip->plot->addGraph();
      strip->curves[axis]->setPen(QPen(curve_color(static_cast<int>(axis)), 1.5));
      strip->curves[axis]->setAdaptiveSampling(false);  // each bin has its two extremes already
    }
    strip->fit(0.0);
  }
  d.force.plot->xAxis->setLabel(tr("time, s"));
  d.stack->addWidget(over_time);

  auto* in_space = new QWidget(this);
  auto* columns = new QHBoxLayout(in_space);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(kMargin);
  const auto add_view = [&](BorderView& view, const QString& heading, std::size_t up,
                            const char* name) {
    auto* column = new QVBoxLayout();
    column->setSpacing(kGrid / 2);
    column->addWidget(make_motion_heading(heading, in_space));
    view.plot = make_motion_plot(in_space, name);
    view.plot->axisRect()->setMargins(QMargins(56, 8, 8, 32));
    view.up = up;
    view.workspace = new QCPItemRect(view.plot);
    view.workspace->setPen(QPen(theme().muted, 1.0));
    view.workspace->setBrush(Qt::NoBrush);
    view.path = new QCPCurve(view.plot->xAxis, view.plot->yAxis);
    view.path->setPen(QPen(curve_color(0), 1.5));
    view.here = new QCPCurve(view.plot->xAxis, view.plot->yAxis);
    view.here->setLineStyle(QCPCurve::lsNone);
    view.here->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, curve_color(0), curve_color(0), 9));
    connect(view.plot, &QCustomPlot::afterLayout, view.plot, [&view] { view.fit(); });
    column->addWidget(view.plot, 1);
    columns->addLayout(column, 1);
  };
  add_view(d.borders[0], tr("TOP VIEW mm"), 1, "border_plot_above");
  add_view(d.borders[1], tr("FRONT VIEW mm"), 2, "border_plot_front");
  d.stack->addWidget(in_space);
}

MotionPicture::~MotionPicture() = default;

void MotionPicture::begin() {
  Drawing& d = *drawing_;
  d.shown.clear();
  d.stage = 0;
  d.next = 0;
  for (BorderView& view : d.borders) {
    view.path->data()->clear();
    view.here->data()->clear();
  }
  d.stack->setCurrentIndex(0);
  draw();
}

void MotionPicture::come_to(DeviceTestPart part) {
  drawing_->stack->setCurrentIndex(part == DeviceTestPart::workspace ? 1 : 0);
}

void MotionPicture::set_device(const DeviceCapability& device) {
  for (BorderView& view : drawing_->borders) {
    const auto across = static_cast<int>(view.across);
    const auto up = static_cast<int>(view.up);
    const glm::dvec3 low = kMotionMillimetres * device.workspace_minimum_m;
    const glm::dvec3 high = kMotionMillimetres * device.workspace_maximum_m;
    view.workspace->topLeft->setCoords(low[across], high[up]);
    view.workspace->bottomRight->setCoords(high[across], low[up]);
    view.fit();
  }
}

void MotionPicture::take(const std::vector<MotionBin>& bins) {
  if (bins.empty()) return;
  Drawing& d = *drawing_;
  for (const MotionBin& bin : bins) {
    const auto middle_m = [&bin](std::size_t axis) {
      return 0.5 * (bin.position_minimum_m[axis] + bin.position_maximum_m[axis]);
    };
    if (bin.part == DeviceTestPart::workspace) {
      for (BorderView& view : d.borders) {
        const double x_mm = kMotionMillimetres * middle_m(view.across);
        const double y_mm = kMotionMillimetres * middle_m(view.up);
        view.path->addData(d.next, x_mm, y_mm);
        view.here->data()->clear();
        view.here->addData(d.next, x_mm, y_mm);
      }
      ++d.next;
      continue;
    }
    // Time that goes back is another clock's.
    if (!d.shown.empty() && bin.begins_ns < d.shown.back().begins_ns) d.shown.clear();
    if (std::exchange(d.stage, bin.stage) != bin.stage) {
      for (std::size_t axis = 0; axis < 3; ++axis) d.zero_m[axis] = middle_m(axis);
    }
    d.shown.push_back(bin);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      d.shown.back().position_minimum_m[axis] -= d.zero_m[axis];
      d.shown.back().position_maximum_m[axis] -= d.zero_m[axis];
    }
  }
  if (!d.shown.empty()) {
    const std::int64_t from_ns =
        d.shown.back().begins_ns - static_cast<std::int64_t>(1e9 * kShown_s);
    std::erase_if(d.shown, [from_ns](const MotionBin& bin) { return bin.begins_ns < from_ns; });
  }
  draw();
}

void MotionPicture::draw() {
  Drawing& d = *drawing_;
  if (d.stack->currentIndex() == 1) {
    for (BorderView& view : d.borders) view.plot->replot(QCustomPlot::rpQueuedReplot);
    return;
  }
  const std::int64_t end_ns = d.shown.empty() ? 0 : d.shown.back().begins_ns;
  double farthest = 0.0;
  double strongest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    QVector<QCPGraphData> positions{};
    QVector<QCPGraphData> forces{};
    for (const MotionBin& bin : d.shown) {
      const double at_s = 1e-9 * static_cast<double>(bin.begins_ns - end_ns);
      const double low = kMotionMillimetres * bin.position_minimum_m[axis];
      const double high = kMotionMillimetres * bin.position_maximum_m[axis];
      positions << QCPGraphData(at_s, low) << QCPGraphData(at_s, high);
      forces << QCPGraphData(at_s, bin.force_minimum_N[axis])
             << QCPGraphData(at_s, bin.force_maximum_N[axis]);
      farthest = std::max({farthest, std::abs(low), std::abs(high)});
      strongest = std::max(
          {strongest, std::abs(bin.force_minimum_N[axis]), std::abs(bin.force_maximum_N[axis])});
    }
    d.position.curves[axis]->data()->set(positions, true);
    d.force.curves[axis]->data()->set(forces, true);
  }
  d.position.fit(farthest);
  d.force.fit(strongest);
  for (MotionStrip* strip : {&d.position, &d.force}) {
    strip->plot->replot(QCustomPlot::rpQueuedReplot);
  }
}

int MotionPicture::points() const { return drawing_->position.curves.front()->dataCount(); }

int MotionPicture::path_points() const { return drawing_->borders.front().path->dataCount(); }

}  // namespace asperity

#include "moc_motion_picture.cpp"

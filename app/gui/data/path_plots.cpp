// Plots the path of each surface with equal scales along x and y, and the spectrum of its force in decades.

#include "app/gui/data/path_plots.h"

#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "analysis/numbers/number_text.h"
#include "app/gui/base/curve_color.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/plot_ticks.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr double kPathMillimetres = 1000.0;  // per metre
constexpr double kPathDecades = 3.0;         // of a spectrum, below its highest line

QLabel* make_plot_heading(QWidget* parent) {
  QLabel* heading = make_text({}, parent);
  heading->setFont(text_font(TextSize::small));
  heading->setTextFormat(Qt::RichText);
  return heading;
}

QString number_key(const SurfaceCurves& surface) {
  return curve_key(curve_color(surface.position - 1), QString::number(surface.position));
}

void say(QCustomPlot& plot, const QString& words) {
  auto* text = new QCPItemText(&plot);
  text->position->setType(QCPItemPosition::ptAxisRectRatio);
  text->position->setCoords(0.5, 0.5);
  text->setText(words);
  text->setColor(theme().muted);
  text->setFont(text_font(TextSize::small));
}

}  // namespace

PathPlots::PathPlots(QWidget* parent) : QFrame(parent) {
  setProperty("role", "card");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(kGrid, kGrid, kGrid, kGrid / 2);
  rows->setSpacing(0);
  path_heading_ = make_plot_heading(this);
  path_heading_->setObjectName("path_heading");
  rows->addWidget(path_heading_);
  path_ = new QCustomPlot(this);
  path_->setObjectName("path_from_above");
  rows->addWidget(path_, 1);
  rows->addSpacing(kGrid);
  spectrum_heading_ = make_plot_heading(this);
  spectrum_heading_->setObjectName("spectrum_heading");
  rows->addWidget(spectrum_heading_);
  spectrum_ = new QCustomPlot(this);
  spectrum_->setObjectName("force_spectrum");
  rows->addWidget(spectrum_, 1);
  for (QCustomPlot* plot : {path_, spectrum_}) {
    plot->setFocusPolicy(Qt::NoFocus);
    plot->setMinimumHeight(96);
    style_plot(*plot);
    plot->axisRect()->setAutoMargins(QCP::msNone);
  }
  path_->xAxis->setLabel(tr("x, mm"));
  path_->xAxis->setTicker(plain_ticker());
  path_->axisRect()->setMargins(QMargins(56, 4, 8, 44));
  spectrum_->xAxis->setLabel(tr("frequency, Hz"));
  spectrum_->axisRect()->setMargins(QMargins(56, 4, 8, 44));
  for (QCPAxis* axis : {spectrum_->xAxis, spectrum_->yAxis}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(decade_ticker());
  }
  spectrum_->xAxis->setNumberFormat("g");
  spectrum_->xAxis->setNumberPrecision(4);
  spectrum_->yAxis->setNumberFormat("eb");
  spectrum_->yAxis->setNumberPrecision(0);
  connect(path_, &QCustomPlot::afterLayout, this, &PathPlots::fit_path);
  keep_labels_apart(*path_->yAxis, 5);
}

void PathPlots::show_surfaces(const RecordingCurves& curves, std::optional<int> position) {
  for (QCustomPlot* plot : {path_, spectrum_}) {
    plot->clearPlottables();
    plot->clearItems();
  }
  extent_.reset();
  highest_ = 0.0;
  QString path =
      QString("<b>%1</b>&nbsp;&nbsp; %2").arg(tr("PATH from above, y mm"), tr("surface"));
  const bool is_rendered = std::any_of(
      curves.surfaces.begin(), curves.surfaces.end(), [&position](const SurfaceCurves& surface) {
        return (!position || surface.position == *position) && surface.is_spectrum_of_rendered;
      });
  QString spectrum =
      QString("<b>%1</b>&nbsp;&nbsp; %2")
          .arg(is_rendered ? tr("SPECTRUM of the rendered force (no force was sent), "
                                "N/√Hz")
                           : tr("SPECTRUM of the sent force, N/√Hz"),
               tr("surface"));
  double longest_s = 0.0;
  for (const SurfaceCurves& surface : curves.surfaces) {
    if (position && surface.position != *position) continue;
    add_path(surface);
    path += number_key(surface);
    if (!surface.spectrum) continue;
    add_spectrum(surface);
    spectrum += number_key(surface);
    longest_s = std::max(longest_s, surface.longest_contact.duration_s());
  }
  if (longest_s > 0.0) {
    spectrum += position
                    ? tr(", in its longest contact of %1 s").arg(shown_number(longest_s, 'f', 1))
                    : tr(", each in its longest contact");
  }
  path_heading_->setText(path);
  spectrum_heading_->setText(spectrum);
  if (!extent_) say(*path_, tr("No surface was presented."));
  if (highest_ == 0.0) say(*spectrum_, tr("No contact was long enough for a spectrum."));
  spectrum_->yAxis->setRange(highest_ * std::pow(10.0, -kPathDecades), 2.0 * highest_);
  for (QCustomPlot* plot : {path_, spectrum_}) {
    const bool empty = plot->plottableCount() == 0;
    plot->xAxis->setTickLabels(!empty);
    plot->yAxis->setTickLabels(!empty);
    plot->replot(QCustomPlot::rpQueuedReplot);
  }
}

void PathPlots::add_path(const SurfaceCurves& surface) {
  const QColor color = curve_color(surface.position - 1);
  QVector<QCPCurveData> touching{};
  QVector<QCPCurveData> hovering{};
  const auto add = [](QVector<QCPCurveData>& points, double x, double y) {
    points << QCPCurveData(static_cast<double>(points.size()), x, y);
  };
  // Where one way of moving ends the other begins; a gap keeps their lines apart.
  std::optional<bool> before{};
  for (const PathPoint& point : surface.path) {
    const double x = kPathMillimetres * point.x_m;
    const double y = kPathMillimetres * point.y_m;
    if (before && *before != point.touching) {
      QVector<QCPCurveData>& left = *before ? touching : hovering;
      add(left, x, y);
      add(left, std::nan(""), std::nan(""));
    }
    before = point.touching;
    add(point.touching ? touching : hovering, x, y);
    if (!extent_) extent_ = Extent{x, x, y, y};
    extent_->low_x = std::min(extent_->low_x, x);
    extent_->high_x = std::max(extent_->high_x, x);
    extent_->low_y = std::min(extent_->low_y, y);
    extent_->high_y = std::max(extent_->high_y, y);
  }
  auto* air = new QCPCurve(path_->xAxis, path_->yAxis);
  air->setPen(QPen(theme().muted, 0, Qt::DotLine));
  air->data()->set(hovering, true);
  auto* contact = new QCPCurve(path_->xAxis, path_->yAxis);
  contact->setPen(QPen(color, 1));
  contact->data()->set(touching, true);
}

void PathPlots::add_spectrum(const SurfaceCurves& surface) {
  const PowerSpectrum& spectrum = *surface.spectrum;
  QCPGraph* graph = spectrum_->addGraph();
  graph->setPen(QPen(curve_color(surface.position - 1), 1));
  QVector<double> frequency_Hz{};
  QVector<double> amplitude{};
  // Line 0 is the mean, which was taken out.
  for (std::size_t line = 1; line < spectrum.density.size(); ++line) {
    frequency_Hz << spectrum.spacing_Hz * static_cast<double>(line);
    amplitude << std::sqrt(spectrum.density[line]);
    highest_ = std::max(highest_, amplitude.back());
  }
  graph->setData(frequency_Hz, amplitude, true);
  spectrum_->xAxis->setRange(frequency_Hz.front(), frequency_Hz.back());
}

/// A millimetre is as long across as along, and the whole path is seen.
void PathPlots::fit_path() {
  if (!extent_) return;
  constexpr double kAround = 1.1;
  constexpr double kLeast_mm = 1.0;  // a hand that rested
  const QCPRange before = path_->yAxis->range();
  const QRect pixels = path_->axisRect()->rect();
  const double width = std::max(1, pixels.width());
  const double height = std::max(1, pixels.height());
  const double mm_per_pixel =
      kAround * std::max({kLeast_mm / height, (extent_->high_x - extent_->low_x) / width,
                          (extent_->high_y - extent_->low_y) / height});
  path_->xAxis->setRange(0.5 * (extent_->low_x + extent_->high_x), mm_per_pixel * width,
                         Qt::AlignCenter);
  path_->yAxis->setRange(0.5 * (extent_->low_y + extent_->high_y), mm_per_pixel * height,
                         Qt::AlignCenter);
  // This layout has its ticks already.
  if (path_->yAxis->range() != before) path_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace asperity

#include "moc_path_plots.cpp"

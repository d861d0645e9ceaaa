// Draws bars with bands and ticks and the moving target, from the hand's measures that the monitor publishes.

#include "app/gui/participant/live_guide.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <QtCore/QLocale>
#include <QtGui/QPainter>
#include <QtGui/QPolygonF>

#include "analysis/signals/compliance.h"
#include "app/gui/participant/pages/guide_rows.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/participant_font.h"
#include "app/session/layout.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {

namespace {

// Okabe–Ito blue and vermilion: far apart for every eye, and in their lightness.
const QColor kInside("#0072B2");
const QColor kOutside("#D55E00");
const QColor kBandGround("#BFDDF2");

/// What a bar shows, and on which scale.
struct BarOrder {
  const Band& band;
  double end = 0.0;               ///< the value at the right end
  double shown_per_value = 1.0;   ///< of the numbers under it
  std::optional<double> value{};  ///< without one the mark waits at the left end
};

/// As much room as an arrow needs beyond the ends.
QRectF bar_in(const QRectF& row) {
  const double unit = row.height() / 88.0;
  return row.adjusted(28.0 * unit, 16.0 * unit, -28.0 * unit, -16.0 * unit);
}

void draw_numbers(QPainter& painter, const QRectF& row, const BarOrder& order,
                  const QLocale& locale, double size_px) {
  const ParticipantColors colors{};
  const QRectF bar = bar_in(row);
  const double shown_end = order.shown_per_value * order.end;
  painter.setPen(colors.text);
  painter.setFont(participant_font(static_cast<int>(std::ceil(size_px - 1e-9)), false));
  const double height = 1.2 * size_px;
  for (const double tick : guide_ticks(shown_end)) {
    const double x = bar.left() + bar.width() * tick / shown_end;
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, row.bottom()));
    painter.drawText(QRectF(x - 4.0 * size_px, row.bottom(), 8.0 * size_px, height),
                     Qt::AlignCenter, locale.toString(tick, 'g', 6));
  }
}

void draw_bar(QPainter& painter, const QRectF& row, const BarOrder& order) {
  const ParticipantColors colors{};
  const Band& band = order.band;
  const std::optional<double>& value = order.value;
  const double unit = row.height() / 88.0;
  const QRectF bar = bar_in(row);
  const double end = order.end;
  const auto x_of = [&](double at) {
    return bar.left() + bar.width() * std::clamp(at / end, 0.0, 1.0);
  };
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.panel);
  const QRectF groove(bar.left(), bar.center().y() - 12.0 * unit, bar.width(), 24.0 * unit);
  painter.drawRect(groove);
  const QRectF inside(QPointF(x_of(band.minimum.value_or(0.0)), bar.top()),
                      QPointF(x_of(band.maximum.value_or(end)), bar.bottom()));
  painter.setBrush(kBandGround);
  painter.drawRect(inside);
  painter.setPen(QPen(colors.muted, 2.0 * unit));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(groove);
  painter.setPen(QPen(kInside, 4.0 * unit, Qt::SolidLine, Qt::FlatCap));
  if (band.minimum) painter.drawLine(inside.topLeft(), inside.bottomLeft());
  if (band.maximum) painter.drawLine(inside.topRight(), inside.bottomRight());

  const QPointF at(x_of(value.value_or(0.0)), bar.center().y());
  const double size = 22.0 * unit;
  if (!value) {
    painter.setPen(QPen(colors.muted, 3.0 * unit));
    painter.setBrush(colors.panel);
    painter.drawEllipse(at, 0.6 * size, 0.6 * size);
    return;
  }
  painter.setPen(QPen(colors.panel, 3.0 * unit));
  if (is_inside({band.minimum, band.maximum}, *value)) {
    painter.setBrush(kInside);
    painter.drawEllipse(at, size, size);
    return;
  }
  // Points to where the band is.
  const double way = band.minimum && *value < *band.minimum ? 1.0 : -1.0;
  painter.setBrush(kOutside);
  painter.drawPolygon(QPolygonF({at + QPointF(way * size, 0.0), at + QPointF(-way * size, -size),
                                 at + QPointF(-way * size, size)}));
}

void draw_track(QPainter& painter, const QRectF& room, const Exploration& asked,
                const SurfacePatch& patch, const LiveGuide::Shown& shown) {
  const ParticipantColors colors{};
  const double unit = std::min(room.height() / 176.0, room.width() / 400.0);
  const QRectF ground = room.adjusted(8.0 * unit, 8.0 * unit, -8.0 * unit, -8.0 * unit);
  constexpr double kAround_m = 0.010;  // of the surface beside the stroke
  const QPointF along(std::cos(asked.direction_rad), std::sin(asked.direction_rad));
  const double half_m = 0.5 * asked.stroke_length_m.target.value_or(0.0);
  const double scale =
      std::min(ground.width() / (2.0 * (std::abs(along.x()) * half_m + kAround_m)),
               ground.height() / (2.0 * (std::abs(along.y()) * half_m + kAround_m)));
  const QPointF centre(patch.centre_m.x, patch.centre_m.y);
  const auto point_of = [&](QPointF at_m) {
    const QPointF from_m = at_m - centre;
    return ground.center() + QPointF(scale * from_m.x(), -scale * from_m.y());
  };
  painter.save();
  painter.setClipRect(ground);
  const QPointF corner_m(0.5 * patch.extent_m.x, 0.5 * patch.extent_m.y);
  painter.setPen(QPen(colors.line, 2.0 * unit));
  painter.setBrush(colors.panel);
  painter.drawRect(QRectF(point_of(centre - corner_m), point_of(centre + corner_m)).normalized());
  painter.setPen(QPen(colors.line, 6.0 * unit, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(point_of(centre - half_m * along), point_of(centre + half_m * along));
  if (shown.target_along_m) {
    painter.setPen(QPen(kInside, 5.0 * unit));
    painter.setBrush(kBandGround);
    painter.drawEllipse(point_of(centre + *shown.target_along_m * along), 28.0 * unit, 28.0 * unit);
  }
  QPointF probe = point_of(shown.probe_m);
  probe.setX(std::clamp(probe.x(), ground.left(), ground.right()));
  probe.setY(std::clamp(probe.y(), ground.top(), ground.bottom()));
  painter.setPen(QPen(shown.touching ? colors.text : colors.muted,
                      (shown.touching ? 7.0 : 3.0) * unit, Qt::SolidLine, Qt::FlatCap));
  const double arm = 20.0 * unit;
  painter.drawLine(probe - QPointF(arm, 0.0), probe + QPointF(arm, 0.0));
  painter.drawLine(probe - QPointF(0.0, arm), probe + QPointF(0.0, arm));
  painter.restore();
}

}  // namespace

double target_along_m(double elapsed_s, double stroke_length_m, double speed_m_per_s) {
  const double gone_m = std::fmod(std::max(0.0, elapsed_s) * speed_m_per_s, 2.0 * stroke_length_m);
  const double forth_m = gone_m <= stroke_length_m ? gone_m : 2.0 * stroke_length_m - gone_m;
  return forth_m - 0.5 * stroke_length_m;
}

LiveGuide::LiveGuide(const SessionMonitor& monitor, QWidget* parent)
    : QWidget(parent), monitor_(monitor) {
  setObjectName("live_guide");
  setFocusPolicy(Qt::NoFocus);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(static_cast<int>(SessionMonitor::kBin_s * 1000.0));
  connect(&timer_, &QTimer::timeout, this, &LiveGuide::look_again);
}

void LiveGuide::set_number_size(double size_px) {
  if (size_px == number_size_px_) return;
  number_size_px_ = size_px;
  update();
}

void LiveGuide::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  look_again();
  timer_.start();
}

void LiveGuide::hideEvent(QHideEvent* event) {
  timer_.stop();
  QWidget::hideEvent(event);
}

void LiveGuide::look_again() {
  const std::shared_ptr<const ParticipantScene> scene = monitor_.snapshot().scene;
  if (!scene->guide) return;
  asked_ = *scene->guide;
  scale_ = scene->guide_scale;
  language_ = scene->language;
  std::int64_t now_ns = monotonic_now_ns();
  if (const auto facts = monitor_.facts()) {
    now_ns += facts->clock_ahead_ns;
    if (facts->protocol) patch_ = Layout{facts->mirrored}.of(facts->protocol->patch);
  }
  next_bin_ = monitor_.bins_from(next_bin_, bins_);
  if (!bins_.empty()) {
    last_ = bins_.back();
    shown_.touching = last_.touching;
    shown_.probe_m = {static_cast<double>(last_.x_m), static_cast<double>(last_.y_m)};
  }
  // Where the hand is to lift, nothing leads it on and nothing asks for more.
  const bool is_to_lift = scene->text_message.what == ParticipantMessage::What::lift;
  shown_.pressing_N.reset();
  shown_.stroking_m_per_s.reset();
  if (last_.is_felt && !is_to_lift) {
    shown_.pressing_N = last_.pressing_N;
    shown_.stroking_m_per_s = last_.stroking_m_per_s;
  }
  const bool leads = asked_.guidance == Exploration::Guidance::moving_target && !is_to_lift;
  shown_.target_along_m.reset();
  if (leads) {
    shown_.target_along_m = target_along_m(static_cast<double>(now_ns - scene->shown_ns) * 1e-9,
                                           asked_.stroke_length_m.target.value_or(0.0),
                                           asked_.speed_m_per_s.target.value_or(0.0));
  }
  update();
}

void LiveGuide::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), ParticipantColors{}.ground);
  const GuideRows rows = guide_rows(asked_);
  if (rows.count() == 0) return;
  const double numbers = height_of_guide_numbers(number_size_px_);
  const double row = (static_cast<double>(height()) - rows.bars() * numbers) / rows.count();
  double top = 0.0;
  const auto take = [&](int many) {
    const QRectF room(0.0, top, width(), many * row);
    top = room.bottom();
    return room;
  };
  QLocale locale(QString::fromStdString(language_));
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  constexpr double kShortest = 1e-9;  // a band may end at 0
  const auto bar = [&](BarOrder order) {
    order.end = std::max(order.end, kShortest);
    const QRectF room = take(1);
    if (numbers > 0.0) draw_numbers(painter, room, order, locale, number_size_px_);
    draw_bar(painter, room, order);
    top += numbers;
  };
  constexpr double kMillimetresPerMetre = 1e3;
  if (rows.track > 0) draw_track(painter, take(rows.track), asked_, patch_, shown_);
  if (rows.force) {
    bar({.band = asked_.normal_force_N,
         .end = std::max(scale_.force_N, end_of_bar(asked_.normal_force_N)),
         .value = shown_.pressing_N});
  }
  if (rows.speed) {
    bar({.band = asked_.speed_m_per_s,
         .end = std::max(scale_.speed_m_per_s, end_of_bar(asked_.speed_m_per_s)),
         .shown_per_value = kMillimetresPerMetre,
         .value = shown_.stroking_m_per_s});
  }
}

}  // namespace asperity

#include "moc_live_guide.cpp"

// Draws the relief at two qualities, and maps mouse and keys to its view, its light or a stroke.

#include "app/gui/workbench/relief_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QtGui/QFocusEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>
#include <QtGui/QWheelEvent>

#include "app/gui/look/theme.h"

namespace asperity {

namespace {

constexpr int kRest_ms = 120;
constexpr double kRad_per_pixel = 0.008;
constexpr double kRad_per_key = 0.08;
constexpr double kFlattest_rad = 0.30;
constexpr double kLowestLight_rad = 0.10;
constexpr int kSun = 56;  // pixels of the little dome that shows where the light is

}  // namespace

ReliefView::ReliefView(QWidget* parent) : QWidget(parent) {
  setObjectName("relief");
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::NoContextMenu);
  setAccessibleName(tr("Relief"));
  set_mouse(MouseMeans::turning);
  rest_.setSingleShot(true);
  rest_.setInterval(kRest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] { draw(Quality::resting); });
}

void ReliefView::show_relief(std::shared_ptr<const ReliefMesh> fine,
                             std::shared_ptr<const ReliefMesh> coarse) {
  fine_ = std::move(fine);
  coarse_ = std::move(coarse);
  move();
}

void ReliefView::set_mouse(MouseMeans means) {
  mouse_ = means;
  setCursor(means == MouseMeans::turning ? Qt::OpenHandCursor : Qt::CrossCursor);
  setToolTip(means == MouseMeans::turning
                 ? tr("Drag to turn the relief. Drag with the right button to move the light. "
                      "The wheel zooms. Keys: arrows, Shift and arrows, + and −, Home.")
                 : tr("Drag over the relief to stroke it. Drag with the right button to move the "
                      "light. Arrow keys turn the relief."));
}

void ReliefView::set_line(std::optional<double> y_m) {
  line_y_m_ = y_m;
  update();
}

void ReliefView::set_trail(std::vector<glm::dvec2> trail_m) {
  trail_m_ = std::move(trail_m);
  update();
}

void ReliefView::set_dent(std::optional<SurfaceDent> dent) {
  if (!dent && !dent_) return;
  dent_ = std::move(dent);
  move();
}

void ReliefView::set_look(const ReliefLook& look) {
  look_ = look;
  move();
}

ReliefProjection ReliefView::projection() const {
  return {drawn_look_, coarse_->width_m, coarse_->length_m, size()};
}

QPointF ReliefView::position_of(const glm::dvec2& point_m) const {
  if (coarse_ == nullptr) return {};
  return projection().on_screen({point_m.x, point_m.y, 0.0});
}

double ReliefView::height_at(const glm::dvec2& point_m) const {
  const ReliefMesh& mesh = *coarse_;
  const auto cell = [](double share, std::size_t count) {
    return static_cast<std::size_t>(
        std::clamp(share * static_cast<double>(count), 0.0, static_cast<double>(count - 1)));
  };
  const auto height_m = static_cast<double>(
      mesh.heights_m[cell(0.5 - point_m.y / mesh.length_m, mesh.rows) * mesh.columns +
                     cell(0.5 + point_m.x / mesh.width_m, mesh.columns)]);
  return dent_ ? height_m - mesh.exaggeration * dent_->depth_at(point_m) : height_m;
}

void ReliefView::move() {
  if (coarse_ == nullptr) return;
  draw(Quality::moving);
  rest_.start();
}

void ReliefView::draw(Quality quality) {
  if (coarse_ == nullptr || width() < 2 || height() < 2) return;
  const auto mesh = quality == Quality::moving ? coarse_ : fine_;
  // At rest twice as many pixels a side, averaged down: smooth edges.
  const double pixels = devicePixelRatioF() * (quality == Quality::moving ? 1.0 : 2.0);
  const QSize target = size() * devicePixelRatioF();
  work_.ask(
      [this, mesh, look = look_, dent = dent_, pixels, target, ratio = devicePixelRatioF(),
       area = size()]() -> NewestWork::Delivery {
        QImage picture = draw_relief(dent ? pressed_in(*mesh, *dent) : *mesh, look, area * pixels);
        if (picture.size() != target) {
          picture = picture.scaled(target, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        }
        picture.setDevicePixelRatio(ratio);
        return [this, picture = std::move(picture), look] {
          picture_ = picture;
          drawn_look_ = look;
          update();
        };
      },
      [](const QString&) {});
}

void ReliefView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (picture_.isNull() || coarse_ == nullptr) return;
  painter.drawImage(0, 0, picture_);
  const ReliefProjection view = projection();
  const auto on_relief = [&](const glm::dvec2& point_m) {
    return view.on_screen({point_m.x, point_m.y, height_at(point_m)});
  };
  if (line_y_m_) {
    constexpr int kPoints = 256;
    QPolygonF line{};
    for (int k = 0; k <= kPoints; ++k) {
      line << on_relief({(static_cast<double>(k) / kPoints - 0.5) * coarse_->width_m, *line_y_m_});
    }
    painter.setPen(QPen(series_color(5), 2.0));
    painter.drawPolyline(line);
  }
  if (!trail_m_.empty()) {
    QPolygonF line{};
    for (const glm::dvec2& point_m : trail_m_) line << on_relief(point_m);
    painter.setPen(QPen(series_color(0), 2.0));
    painter.drawPolyline(line);
    painter.setPen(QPen(Qt::white, 2.0));
    painter.setBrush(series_color(0));
    painter.drawEllipse(line.back(), 7.0, 7.0);
  }

  // Where the light is: a dome seen from above, turned with the relief.
  const QPointF centre(width() - kSun / 2.0 - kMargin, kSun / 2.0 + kGrid);
  const double azimuth_rad = drawn_look_.light_azimuth_rad + drawn_look_.turn_rad;
  const double out = (kSun / 2.0 - 6.0) * std::cos(drawn_look_.light_elevation_rad);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme().line, 1.0));
  painter.drawEllipse(centre, kSun / 2.0 - 6.0, kSun / 2.0 - 6.0);
  painter.setBrush(QColor("#FFC107"));
  painter.setPen(QPen(QColor("#8A5300"), 1.0));
  painter.drawEllipse(centre + out * QPointF(std::cos(azimuth_rad), -std::sin(azimuth_rad)), 6.0,
                      6.0);
  painter.setFont(text_font(TextSize::small));
  painter.setPen(theme().muted);
  painter.drawText(QRectF(centre.x() - kSun, centre.y() + kSun / 2.0 - 4, 2.0 * kSun, 18.0),
                   Qt::AlignHCenter | Qt::AlignTop, tr("Light"));
  if (hasFocus() && focused_by_key_) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().press, 1.0, Qt::DotLine));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void ReliefView::resizeEvent(QResizeEvent*) { move(); }

void ReliefView::focusInEvent(QFocusEvent* event) {
  focused_by_key_ =
      event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  QWidget::focusInEvent(event);
}

void ReliefView::turn(QPointF by) {
  look_.turn_rad += by.x();
  look_.tilt_rad = std::clamp(look_.tilt_rad + by.y(), kFlattest_rad, std::numbers::pi / 2.0);
  move();
}

void ReliefView::move_light(QPointF by) {
  look_.light_azimuth_rad -= by.x();
  look_.light_elevation_rad =
      std::clamp(look_.light_elevation_rad - by.y(), kLowestLight_rad, std::numbers::pi / 2.0);
  move();
}

void ReliefView::mousePressEvent(QMouseEvent* event) {
  last_position_ = event->position();
  if (event->button() != Qt::LeftButton || coarse_ == nullptr) return;
  if (mouse_ == MouseMeans::turning) {
    setCursor(Qt::ClosedHandCursor);
  } else if (const auto point_m = projection().on_surface(event->position())) {
    stroking_ = true;
    emit strokeBegan(point_m->x, point_m->y);
  }
}

void ReliefView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_position_;
  last_position_ = event->position();
  if (coarse_ == nullptr) return;
  if ((event->buttons() & Qt::RightButton) != 0) {
    move_light(by * kRad_per_pixel);
    return;
  }
  if ((event->buttons() & Qt::LeftButton) != 0 && mouse_ == MouseMeans::turning) {
    turn(by * kRad_per_pixel);
    return;
  }
  const auto point_m = projection().on_surface(event->position());
  if (!point_m) return;  // beside the relief the hand stays at its border
  if (stroking_) emit strokeMoved(point_m->x, point_m->y);
  emit pointed(point_m->x, point_m->y);
}

void ReliefView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (std::exchange(stroking_, false)) emit strokeEnded();
  set_mouse(mouse_);
}

void ReliefView::wheelEvent(QWheelEvent* event) {
  look_.zoom = std::clamp(look_.zoom * std::pow(1.001, event->angleDelta().y()), 0.5, 8.0);
  move();
}

void ReliefView::keyPressEvent(QKeyEvent* event) {
  QPointF by{};
  switch (event->key()) {
    case Qt::Key_Left:
      by = {-kRad_per_key, 0.0};
      break;
    case Qt::Key_Right:
      by = {kRad_per_key, 0.0};
      break;
    case Qt::Key_Up:
      by = {0.0, -kRad_per_key};
      break;
    case Qt::Key_Down:
      by = {0.0, kRad_per_key};
      break;
    case Qt::Key_Home:
      set_look({});
      return;
    case Qt::Key_Plus:
      look_.zoom = std::min(8.0, look_.zoom * 1.1);
      move();
      return;
    case Qt::Key_Minus:
      look_.zoom = std::max(0.5, look_.zoom / 1.1);
      move();
      return;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  (event->modifiers() & Qt::ShiftModifier) != 0 ? move_light(by) : turn(by);
}

}  // namespace asperity

#include "moc_relief_view.cpp"

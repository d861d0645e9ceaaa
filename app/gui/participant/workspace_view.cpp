// Paints the tool at the probe, with its shadow, over the picture of the object.

#include "app/gui/participant/workspace_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QtCore/QEvent>
#include <QtGui/QLinearGradient>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>
#include <QtGui/QRadialGradient>
#include <glm/geometric.hpp>

#include "app/gui/look/theme.h"

namespace asperity {

namespace {

// In patches.
constexpr double kTipRadius = 0.012;
constexpr double kShaftRadius = 0.017;
constexpr double kTaper = 0.10;   // from the tip to where the shaft has its full width
constexpr double kLength = 0.62;  // of the tool
const glm::dvec3 kToolColour{0.46, 0.49, 0.53};  // linear: of steel
constexpr double kMostLift_m = 0.006;            // of a tool that is pressed into the surface
// Its shadow runs away from the light (as in the picture), this far for each unit of height.
const glm::dvec3 kShadow{0.66, -0.55, 0.0};

bool look_alike(const SurfacePatch& one, const SurfacePatch& other) {
  return one.centre_m == other.centre_m && one.extent_m == other.extent_m &&
         one.tiling == other.tiling && one.motion_scale == other.motion_scale;
}

QPainterPath along(QPointF from, double from_width, QPointF to, double to_width) {
  const QPointF way = to - from;
  const double length = std::max(1e-6, std::hypot(way.x(), way.y()));
  const QPointF side(-way.y() / length, way.x() / length);
  QPainterPath path{};
  path.moveTo(from + from_width * side);
  path.lineTo(to + to_width * side);
  path.lineTo(to - to_width * side);
  path.lineTo(from - from_width * side);
  path.closeSubpath();
  return path;
}

/// Across a rod: light on its left side, dark on its right.
QLinearGradient across(QPointF from, QPointF to, double width, const QColor& light,
                       const QColor& dark) {
  const QPointF way = to - from;
  const double length = std::max(1e-6, std::hypot(way.x(), way.y()));
  QPointF side(-way.y() / length, way.x() / length);
  if (side.x() > 0.0) side = -side;
  QLinearGradient gradient(from + width * side, from - width * side);
  gradient.setColorAt(0.0, dark.lighter(130));
  gradient.setColorAt(0.28, light);
  gradient.setColorAt(0.62, dark.lighter(115));
  gradient.setColorAt(1.0, dark);
  return gradient;
}

void soft_spot(QPainter& painter, QPointF at, double radius, double flatness, double darkness) {
  painter.save();
  painter.translate(at);
  painter.scale(1.0, flatness);
  QRadialGradient gradient(QPointF(0.0, 0.0), radius);
  for (int step = 0; step <= 8; ++step) {
    const double off = step / 8.0;
    const double fall = (1.0 - off * off) * (1.0 - off * off);
    gradient.setColorAt(off,
                        QColor::fromRgbF(0.0F, 0.0F, 0.0F, static_cast<float>(darkness * fall)));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(gradient);
  painter.drawEllipse(QPointF(0.0, 0.0), radius, radius);
  painter.restore();
}

/// A shadow that widens and fades on its way: spots, close enough to run into each other.
void soft_streak(QPainter& painter, QPointF from, double from_radius, QPointF to, double to_radius,
                 double darkness) {
  const QPointF way = to - from;
  const double length = std::hypot(way.x(), way.y());
  constexpr double kApart = 0.45;  // of a radius
  for (double at_px = 0.0; at_px < length;) {
    const double at = at_px / length;
    const double radius = from_radius + at * (to_radius - from_radius);
    soft_spot(painter, from + at * way, radius, 0.85, darkness * (1.0 - at) * (1.0 - at));
    at_px += std::max(1.0, kApart * radius);
  }
}

}  // namespace

WorkspaceView::WorkspaceView(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMinimumSize(320, 180);
}

void WorkspaceView::set_object(const SurfacePatch& patch, std::shared_ptr<const HeightField> relief,
                               SurfaceLook look) {
  // What is not to be seen is not even held.
  if (look != SurfaceLook::relief) relief = nullptr;
  if (camera_ && picture_.body == nullptr && picture_.look == look && picture_.relief == relief &&
      look_alike(patch_, patch)) {
    return;
  }
  patch_ = patch;
  thickness_m_ = WorkspaceCamera(patch, QSize(1, 1)).thickness_m();
  picture_.relief = std::move(relief);
  picture_.look = look;
  picture_.body = nullptr;
  surface_.reset();
  tool_.reset();
  draw_again();
}

void WorkspaceView::set_bodies(const SurfacePatch& patch,
                               std::shared_ptr<const TexturedMesh> surface,
                               std::shared_ptr<const TexturedMesh> tool, SurfaceLook look) {
  const SurfaceLook look_of_tool =
      look == SurfaceLook::relief ? SurfaceLook::relief : SurfaceLook::plain;
  if (!tool_ || &tool_->mesh() != tool.get() || picture_.look != look) {
    tool_.emplace(std::move(tool), look_of_tool, kToolColour);
    update();
  }
  if (camera_ && picture_.body == surface && picture_.look == look &&
      picture_.body_m == patch.centre_m) {
    return;
  }
  const SeenPatch seen = seen_patch_of(*surface, patch);
  patch_ = seen.patch;
  thickness_m_ = seen.thickness_m;
  picture_.relief = nullptr;
  picture_.look = look;
  picture_.body = surface;
  picture_.body_m = patch.centre_m;
  // Only to hide what is behind it: its relief is in the picture.
  surface_.emplace(std::move(surface), SurfaceLook::plain, glm::dvec3{1.0});
  draw_again();
}

void WorkspaceView::set_probe_orientation(const glm::dquat& orientation) {
  orientation_ = orientation;
  if (tool_) update();
}

void WorkspaceView::set_probe(double x_m, double y_m, double z_m, bool touching) {
  probe_ = Probe{.position_m = {x_m, y_m, z_m}, .touching = touching};
  update();
}

void WorkspaceView::take_probe_away() {
  probe_.reset();
  update();
}

std::optional<glm::dvec2> WorkspaceView::place_at(QPointF pixel) const {
  if (!camera_) return {};
  return glm::dvec2(patch_.centre_m + camera_->point_at(pixel, 0.0));
}

void WorkspaceView::set_mirrored(bool mirrored) {
  mirrored_ = mirrored;
  update();
}

void WorkspaceView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!camera_ || camera_->size() != size()) draw_again();
}

void WorkspaceView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) draw_again();
}

void WorkspaceView::draw_again() {
  picture_.ground = theme().ground;
  camera_.emplace(patch_, size(), thickness_m_);
  drawn_ = false;
  // At once: a quarter of the size, plain.
  const WorkspaceCamera coarse(patch_, (size() / 4).expandedTo(QSize(1, 1)), thickness_m_);
  image_ = draw_workspace(
      coarse, {.ground = picture_.ground, .body = picture_.body, .body_m = picture_.body_m});
  const QSize fine = size() * devicePixelRatioF();
  task_.run<QImage>(
      [patch = patch_, thickness_m = thickness_m_, picture = picture_, fine](
          const std::stop_token& stop, const BackgroundTask::Progress&) {
        return draw_workspace(WorkspaceCamera(patch, fine, thickness_m), picture, stop);
      },
      [this](QImage image) {
        image_ = std::move(image);
        image_.setDevicePixelRatio(devicePixelRatioF());
        drawn_ = true;
        update();
        emit drawn();
      },
      [](const QString&) {});
  update();
}

void WorkspaceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (drawn_) {
    painter.drawImage(QPointF(0.0, 0.0), image_);
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), image_);
  }
  if (probe_ && camera_) {
    painter.setRenderHint(QPainter::Antialiasing);
    if (tool_) {
      draw_tool_body(painter);
    } else {
      draw_tool(painter);
    }
  }
}

void WorkspaceView::draw_tool_body(QPainter& painter) const {
  SeenPose pose{.rotation = glm::mat3_cast(orientation_), .position_m = probe_->position_m};
  if (probe_->touching) {
    pose.position_m.z +=
        lift_above_m(tool_->mesh(), pose, surface_->mesh(), picture_.body_m, kMostLift_m);
  }
  const SeenPose surface_pose{.position_m = picture_.body_m};
  // Where it comes down: on the object's upper side, or on the table.
  const double patch_m = std::max(patch_.extent_m.x, patch_.extent_m.y);
  const glm::dvec3 from_centre = pose.position_m - patch_.centre_m;
  const bool is_over = std::abs(from_centre.x) <= 0.5 * patch_.extent_m.x &&
                       std::abs(from_centre.y) <= 0.5 * patch_.extent_m.y;
  const double floor_m = is_over ? 0.0 : -thickness_m_;
  const double height_m = std::max(0.0, from_centre.z - floor_m);
  const glm::dvec3 foot = patch_.centre_m + glm::dvec3{from_centre.x, from_centre.y, floor_m};
  const glm::dvec3 size_m = tool_->bounds().high_m - tool_->bounds().low_m;
  const double radius_px =
      0.5 * std::max({size_m.x, size_m.y, 0.02 * patch_m}) * camera_->scale_at(foot);
  const double high = std::min(1.0, height_m / (0.25 * patch_m));
  const QPointF shadow = camera_->project(foot + height_m * kShadow);
  const double spread_px = radius_px * (1.5 + 1.5 * high);
  const QRect spot =
      QRectF(shadow.x() - spread_px, shadow.y() - spread_px, 2.0 * spread_px, 2.0 * spread_px)
          .toAlignedRect() &
      rect();
  if (!spot.isEmpty()) {
    QImage dark(spot.size(), QImage::Format_ARGB32_Premultiplied);
    dark.fill(0);
    QPainter on_dark(&dark);
    soft_spot(on_dark, shadow - spot.topLeft(), spread_px, 0.72, 0.50 - 0.34 * high);
    on_dark.end();
    if (is_over) {
      BodyLayer surface(spot, 1);
      surface_->hide_behind(*camera_, surface_pose, surface);
      surface.keep_covered(dark);
    }
    painter.drawImage(spot.topLeft(), dark);
  }

  const QRect area = tool_->area(*camera_, pose);
  if (area.isEmpty()) return;
  // A tool that fills the picture would take too long twice as fine.
  constexpr int kManyPixels = 60'000;
  BodyLayer layer(area, area.width() * area.height() > kManyPixels ? 1 : 2);
  surface_->hide_behind(*camera_, surface_pose, layer);
  tool_->draw(*camera_, pose, layer);
  painter.drawImage(area.topLeft(), layer.image());
}

void WorkspaceView::draw_tool(QPainter& painter) const {
  const double patch_m = std::max(patch_.extent_m.x, patch_.extent_m.y);
  const glm::dvec3 from_centre = probe_->position_m - patch_.centre_m;
  const bool over_slab = std::abs(from_centre.x) <= 0.5 * patch_.extent_m.x &&
                         std::abs(from_centre.y) <= 0.5 * patch_.extent_m.y;
  const double floor_m = over_slab ? 0.0 : -camera_->thickness_m();
  const double height_m = std::max(0.0, from_centre.z - floor_m);
  const glm::dvec3 foot = patch_.centre_m + glm::dvec3{from_centre.x, from_centre.y, floor_m};
  const double radius_m = kTipRadius * patch_m;
  const glm::dvec3 tip = foot + glm::dvec3{0.0, 0.0, height_m + radius_m};
  const glm::dvec3 axis = glm::normalize(glm::dvec3{mirrored_ ? -0.42 : 0.42, -0.20, 1.0});

  const auto tool = [&](double way) { return tip + way * patch_m * axis; };
  const auto shadow_of = [&](const glm::dvec3& point) {
    const double above_m = point.z - patch_.centre_m.z - floor_m;
    return glm::dvec3{point.x, point.y, patch_.centre_m.z + floor_m} + above_m * kShadow;
  };

  // Shadows: of the tool, fainter the higher the part that throws it; of the tip.
  const double scale = camera_->scale_at(foot);
  const double tip_px = radius_m * scale;
  const double high = std::min(1.0, height_m / (0.25 * patch_m));
  const QPointF shadow_tip = camera_->project(shadow_of(tip));
  const QPointF shadow_end = camera_->project(shadow_of(tool(0.6 * kLength)));
  soft_streak(painter, shadow_tip, tip_px * (1.1 + 2.2 * high), shadow_end,
              tip_px * (4.5 + 3.0 * high), 0.15 - 0.09 * high);
  soft_spot(painter, camera_->project(shadow_of(foot + glm::dvec3{0.0, 0.0, height_m})),
            tip_px * (2.6 + 5.0 * high), 0.72, 0.50 - 0.34 * high);

  if (probe_->touching) {
    QPen ring(theme().press, std::max(1.5, 0.16 * tip_px));
    painter.setPen(ring);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(camera_->project(foot), 2.1 * tip_px, 2.1 * 0.72 * tip_px);
  }

  // The tool: shaft, cone, and the ball that is the probe.
  const QColor metal_light("#F2F4F6"), metal_dark("#6F7882");
  const QColor grip_light("#6B7680"), grip_dark("#23292F");
  const auto width_at = [&](double way, double radius) {
    return radius * patch_m * camera_->scale_at(tool(way));
  };
  const auto rod = [&](double from, double from_radius, double to, double to_radius,
                       const QColor& light, const QColor& dark) {
    const QPointF a = camera_->project(tool(from));
    const QPointF b = camera_->project(tool(to));
    painter.setPen(Qt::NoPen);
    painter.setBrush(
        across(a, b, std::max(width_at(from, from_radius), width_at(to, to_radius)), light, dark));
    painter.drawPath(along(a, width_at(from, from_radius), b, width_at(to, to_radius)));
  };
  rod(0.0, 0.45 * kTipRadius, kTaper, 0.75 * kShaftRadius, metal_light, metal_dark);
  rod(kTaper, kShaftRadius, kLength, kShaftRadius, grip_light, grip_dark);
  rod(kTaper, kShaftRadius * 1.06, kTaper + 0.014, kShaftRadius * 1.06, metal_light, metal_dark);
  const QPointF end = camera_->project(tool(kLength));
  const QPointF direction = end - camera_->project(tool(0.9 * kLength));
  const double end_px = width_at(kLength, kShaftRadius);
  painter.save();
  painter.translate(end);
  painter.rotate(std::atan2(direction.y(), direction.x()) * 180.0 / std::numbers::pi);
  painter.setPen(Qt::NoPen);
  painter.setBrush(grip_dark.lighter(170));
  painter.drawEllipse(QPointF(0.0, 0.0), 0.55 * end_px, end_px);
  painter.restore();

  const QPointF ball = camera_->project(tip);
  QRadialGradient shine(ball, tip_px, ball + QPointF(-0.4 * tip_px, -0.45 * tip_px));
  shine.setColorAt(0.0, QColor("#FFFFFF"));
  shine.setColorAt(0.35, QColor("#C9CFD6"));
  shine.setColorAt(1.0, QColor("#59626C"));
  painter.setBrush(shine);
  painter.drawEllipse(ball, tip_px, tip_px);
}

}  // namespace asperity

#include "moc_workspace_view.cpp"

// Filters mouse and pen events of the view, and converts positions to metres on the surface that is shown.

#include "app/gui/participant/pointer_feed.h"

#include <algorithm>

#include <QtGui/QMouseEvent>
#include <QtGui/QTabletEvent>

#include "app/gui/participant/live_workspace.h"
#include "app/gui/participant/participant_view.h"
#include "app/gui/participant/shown_surface.h"
#include "app/session/layout.h"

namespace asperity {

namespace {

constexpr double kTable = 1.2;  // in extents of the surface, while none is shown

/// What Qt makes of a pen for widgets that know no pens: the pen itself was told already.
bool is_of_a_pen(const QMouseEvent& event) {
  return event.pointerType() == QPointingDevice::PointerType::Pen;
}

}  // namespace

PointerFeed::PointerFeed(ParticipantView& view, const SessionMonitor& monitor,
                         LatestValue<PointerSample>& samples, QObject* parent)
    : QObject(parent), view_(view), monitor_(monitor), samples_(samples) {
  view_.setTabletTracking(true);
  view_.installEventFilter(this);
}

PointerFeed::~PointerFeed() {
  view_.removeEventFilter(this);
  lift();
}

bool PointerFeed::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
      const auto& mouse = static_cast<QMouseEvent&>(*event);
      if (is_of_a_pen(mouse) || mouse.button() != Qt::LeftButton) break;
      is_held_ = !view_.can_be_pressed(mouse.position());
      move_to(mouse.position(), 0.0);
      break;
    }
    case QEvent::MouseMove: {
      const auto& mouse = static_cast<QMouseEvent&>(*event);
      if (is_of_a_pen(mouse)) break;
      is_held_ = is_held_ && mouse.buttons().testFlag(Qt::LeftButton);
      move_to(mouse.position(), 0.0);
      break;
    }
    case QEvent::MouseButtonRelease: {
      const auto& mouse = static_cast<QMouseEvent&>(*event);
      if (is_of_a_pen(mouse) || mouse.button() != Qt::LeftButton) break;
      is_held_ = false;
      move_to(mouse.position(), 0.0);
      break;
    }
    case QEvent::TabletMove:
    case QEvent::TabletPress:
    case QEvent::TabletRelease: {
      const auto& pen = static_cast<QTabletEvent&>(*event);
      is_held_ = false;
      const bool is_down = event->type() != QEvent::TabletRelease;
      move_to(pen.position(), is_down ? pen.pressure() : 0.0);
      break;
    }
    case QEvent::Leave:
    case QEvent::Hide:
    case QEvent::WindowDeactivate:
      lift();
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void PointerFeed::move_to(QPointF at, double pressure) {
  last_ = {.position_m = place_of(at), .pressure = pressure, .is_held = is_held_};
  samples_.put(last_);
}

void PointerFeed::lift() {
  is_held_ = false;
  last_.pressure = 0.0;
  last_.is_held = false;
  samples_.put(last_);
}

const SurfacePatch& PointerFeed::patch() {
  const auto facts = monitor_.facts();
  if (facts == nullptr) return patch_;
  const PlannedPresentation* const surface = shown_surface(*facts, monitor_.snapshot());
  if (surface != nullptr) {
    // The whole workspace, also where the surface is one of several patches of it.
    patch_ = Layout{.mirrored = facts->mirrored}.of(surface->stimulus.patch);
    patch_.centre_m.z = surface->patch.centre_m.z;
  }
  return patch_;
}

glm::dvec2 PointerFeed::place_of(QPointF at) {
  const auto* workspace = view_.findChild<LiveWorkspace*>();
  if (workspace != nullptr && workspace->isVisible()) {
    const WorkspaceView& seen = workspace->view();
    if (const auto place_m = seen.place_at(seen.mapFrom(&view_, at))) return *place_m;
  }
  const SurfacePatch& felt = patch();
  const std::optional<QRectF> surface = view_.surface_rect();
  const QRectF place = surface.value_or(QRectF(view_.rect()));
  const double metres_per_px =
      (surface ? 1.0 : kTable) * std::max(felt.extent_m.x / std::max(1.0, place.width()),
                                          felt.extent_m.y / std::max(1.0, place.height()));
  return glm::dvec2(felt.centre_m) +
         metres_per_px * glm::dvec2(at.x() - place.center().x(), place.center().y() - at.y());
}

}  // namespace asperity

#include "moc_pointer_feed.cpp"

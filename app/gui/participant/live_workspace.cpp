// Reads the monitor by a timer, and loads the bodies of a surface in the background when it changes.

#include "app/gui/participant/live_workspace.h"

#include <stop_token>

#include <QtWidgets/QBoxLayout>

#include "app/gui/participant/shown_surface.h"

namespace asperity {

namespace {

/// Drawn in the place of a point, which has no size.
const BodyDescription kPoint{.name = "point", .shape = SphereShape{.diameter_m = 0.003}};

}  // namespace

LiveWorkspace::LiveWorkspace(const SessionMonitor& monitor, std::filesystem::path study,
                             SurfaceLook look, QWidget* parent)
    : QWidget(parent),
      monitor_(monitor),
      study_(study),
      look_(look),
      builder_(no_models_, std::move(study)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  view_ = new WorkspaceView(this);
  layout->addWidget(view_);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(static_cast<int>(SessionMonitor::kBin_s * 1000.0));
  connect(&timer_, &QTimer::timeout, this, &LiveWorkspace::look_again);
}

void LiveWorkspace::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  look_again();
  timer_.start();
}

void LiveWorkspace::hideEvent(QHideEvent* event) {
  timer_.stop();
  QWidget::hideEvent(event);
}

bool LiveWorkspace::is_settled() const {
  std::vector<LiveBin> newer{};
  monitor_.bins_from(next_bin_, newer);
  return newer.empty() && version_ == monitor_.snapshot().version && !reading_.is_running() &&
         view_->is_drawn();
}

void LiveWorkspace::look_again() {
  const auto facts = monitor_.facts();
  const SessionSnapshot now = monitor_.snapshot();
  version_ = now.version;
  bins_.clear();
  next_bin_ = monitor_.bins_from(next_bin_, bins_);
  if (!facts || !facts->plan || now.surface == 0) {
    view_->take_probe_away();
    return;
  }
  if (shown_ != std::pair(now.trial, now.surface)) {
    const PlannedPresentation* const surface = shown_surface(*facts, now);
    if (surface == nullptr) return;
    shown_ = {now.trial, now.surface};
    show_surface(*surface, facts->mirrored);
  }
  if (!bins_.empty()) {
    const LiveBin& last = bins_.back();
    view_->set_probe_orientation(glm::dquat(last.orientation));
    view_->set_probe(last.x_m, last.y_m, last.z_m, last.touching);
  }
}

void LiveWorkspace::show_surface(const PlannedPresentation& surface, bool mirrored) {
  SurfacePatch patch = surface.patch;
  if (mirrored) patch.centre_m.x = -patch.centre_m.x;  // as the session lays it out
  view_->set_mirrored(mirrored);
  if (surface.stimulus.surface) {
    show_bodies(surface, patch);
    return;
  }
  const auto& path = surface.stimulus.height_field;
  if (look_ != SurfaceLook::relief || !path) {
    view_->set_object(patch, nullptr, look_);
    return;
  }
  if (const auto known = reliefs_.find(*path); known != reliefs_.end()) {
    view_->set_object(patch, known->second, look_);
    return;
  }
  view_->set_object(patch, nullptr, SurfaceLook::plain);
  reading_.run<LoadedHeightField>(
      [file = study_ / *path](const std::stop_token&, const BackgroundTask::Progress&) {
        return load_height_field(file);
      },
      [this, patch, path = *path, wanted = shown_](LoadedHeightField loaded) {
        reliefs_[path] = loaded.field;
        if (shown_ == wanted) view_->set_object(patch, loaded.field, look_);
      },
      [this](const QString& what) { emit unreadable(what); });
}

void LiveWorkspace::show_bodies(const PlannedPresentation& surface, const SurfacePatch& patch) {
  using Bodies = std::pair<LoadedBody, LoadedBody>;
  reading_.run<Bodies>(
      [this, felt = *surface.stimulus.surface, held = surface.stimulus.tool.value_or(kPoint)](
          const std::stop_token&, const BackgroundTask::Progress&) {
        return Bodies{builder_.body(felt, BodyRole::surface), builder_.body(held, BodyRole::tool)};
      },
      [this, patch, wanted = shown_](Bodies bodies) {
        if (shown_ != wanted) return;
        view_->set_bodies(patch, bodies.first.mesh, bodies.second.mesh, look_);
      },
      [this](const QString& what) { emit unreadable(what); });
}

}  // namespace asperity

#include "moc_live_workspace.cpp"

// The workspace of a running session, as its participant may see it.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QString>
#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "app/gui/look/background_task.h"
#include "app/gui/participant/workspace_view.h"
#include "app/session/session_monitor.h"
#include "app/session/stimulus_builder.h"
#include "app/study_files/height_field_files.h"

namespace asperity {

/// Shows the surface that is felt and the probe on it, 60 times a second while it is visible.
///
/// A relief that is to be seen is read from the study in the background, once for each file; until
/// it is there the surface is plain. So are bodies, in the place of which the surface before stays
/// until they are there. Between surfaces the last one stays, without the probe.
class LiveWorkspace final : public QWidget {
  Q_OBJECT
 public:
  /// `monitor` must outlive the widget. `look` is the protocol's choice for the whole session.
  LiveWorkspace(const SessionMonitor& monitor, std::filesystem::path study, SurfaceLook look,
                QWidget* parent = nullptr);

  const WorkspaceView& view() const noexcept { return *view_; }
  /// Everything that the monitor knows by now is seen: nothing is still read or drawn.
  bool is_settled() const;

 signals:
  /// The relief of a surface could not be read, and why: the surface stays plain.
  void unreadable(const QString& what);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void look_again();
  void show_bodies(const PlannedPresentation& surface, const SurfacePatch& patch);
  void show_surface(const PlannedPresentation& surface, bool mirrored);

  const SessionMonitor& monitor_;
  std::filesystem::path study_{};
  SurfaceLook look_ = SurfaceLook::plain;
  WorkspaceView* view_ = nullptr;
  QTimer timer_{this};
  std::uint64_t version_ = 0;  ///< of the snapshot that was looked at
  std::uint64_t next_bin_ = 0;
  std::vector<LiveBin> bins_{};
  std::pair<int, int> shown_{};                                          ///< trial and surface
  std::map<std::string, std::shared_ptr<const HeightField>> reliefs_{};  ///< by path in the study
  const ModelRegistry no_models_{};
  StimulusBuilder builder_;  ///< of bodies, which need none
  BackgroundTask reading_{};
};

}  // namespace asperity

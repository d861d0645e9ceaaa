// The running tracks of a session whose levels a procedure chooses.

#pragma once

#include <optional>

#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

#include "app/session/running_track.h"

namespace asperity {

/// Levels by trial of each track of the present block, with the mean of the reversals, or the median of the posterior and
/// its 95 % credible interval. Filled marks lead to a lower level (correct responses), hollow ones to a higher level, and
/// hollow ones with a dot are the response "cannot tell". The tooltip has the lines of all tracks.
///
/// While blind nothing is shown: levels and responses show the condition and whether responses were correct. Its minimum
/// size does not depend on what it shows.
class TrackPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit TrackPanel(QWidget* parent = nullptr);

  /// Nothing: the present block has no tracks.
  void show_tracks(std::optional<RunningTracks> tracks);
  void set_blind(bool blind);

  /// One per track: "Track 1 (coarse): mean of the reversals 21 % (n = 4)". Those for which there is room are above the
  /// plot.
  QStringList lines() const;
  /// For tests: how many marks are drawn.
  int marks() const;

  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool shows_tracks() const;
  void write_words();
  QString instead() const;
  QString line_of(const RunningTrack& track) const;

  std::optional<RunningTracks> tracks_{};
  bool blind_ = true;
};

}  // namespace asperity

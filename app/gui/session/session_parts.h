// The parts of the session window, side by side or one at a time, as the width allows.

#pragma once

#include <array>
#include <optional>

#include <QtWidgets/QWidget>

#include "app/gui/session/session_form.h"

class QGridLayout;
class QPushButton;

namespace asperity {

/// Wide: plan, plots, and in a third column what the participant sees, the answers and the notes.
/// Medium: the same in two columns, without what the participant sees. Narrow: one part at a time,
/// each with its switch; answers and notes are one part.
///
/// The width decides and not what stands in it: no content can make the window wider.
class SessionParts final : public QWidget {
  Q_OBJECT
 public:
  enum class Part { plan, plots, tracks, notes, sight };

  /// Takes these as children.
  struct Widgets {
    QWidget* plan = nullptr;
    QWidget* plots = nullptr;
    QWidget* tracks = nullptr;  ///< below the plan; only in sessions with tracks
    QWidget* sight = nullptr;   ///< what the participant sees
    QWidget* answers = nullptr;
    QWidget* notes = nullptr;
  };
  SessionParts(const Widgets& widgets, QWidget* parent = nullptr);

  void set_form(SessionForm form);
  /// Whether the session has tracks; they have no place in other sessions.
  void set_has_tracks(bool has_tracks);
  /// Where one is shown at a time, this one.
  void show_part(Part part);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  static constexpr std::array kParts{Part::plan, Part::plots, Part::tracks, Part::notes,
                                     Part::sight};

  void make_switches();
  void show_parts();

  Widgets widgets_{};
  std::optional<SessionForm> form_{};
  Part part_ = Part::plan;
  bool has_tracks_ = false;
  QGridLayout* grid_ = nullptr;
  QWidget* switches_ = nullptr;
  std::array<QPushButton*, kParts.size()> switch_of_{};
};

}  // namespace asperity

// A study, the program's windows over it, and the two people who sit at them.

#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QtTest/QTest>

#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "results_schema/study.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/support/scripted_sound.h"

namespace asperity {

/// What a test changes in the protocol of the small study.
struct ProtocolWish {
  std::string name = "small";
  std::string kind = "selection";
  int trials = 2;  ///< of each block of a selection; a matching has two, a recognition three
  int blocks = 1;  ///< "main", "second"
  double minimum_contact_s = 0.3;
  std::string head{};      ///< members of the protocol, each with a comma before it
  std::string question{};  ///< members of the question, likewise
  std::string flow = R"({"run": "main"})";  ///< may ask for "comfort", "age" and "remarks"
};

/// The windows as `asperity` makes them, but for the loudspeaker. Everything is done by keys and
/// mouse.
class SessionRoom : public QuietHome {
 protected:
  using Scene = ParticipantScene;

  SessionRoom();
  ~SessionRoom() override;

  // --- the study ---
  std::filesystem::path folder() const { return home() / "studies" / "small"; }
  /// Three textures of 128 × 128 pixels (slate, cork, linen), no protocol.
  void make_study();
  void add_protocol(const ProtocolWish& wish);
  /// The newest session with its attempts.
  SessionRow stored_session() const;
  std::vector<AttemptRow> stored_attempts() const;
  /// Every event of the session, those of attempts too, in order of time.
  std::vector<EventRow> stored_events() const;
  std::vector<EventRow> stored_events(const std::string& kind) const;
  /// "1/1 answered", "1/2 aborted": trial, attempt and outcome, as stored.
  std::vector<std::string> stored_outcomes() const;

  // --- the windows ---
  void make_windows();
  void close_windows();
  void open();  ///< both, with the study
  SessionRunner& runner() { return *desk->runner(); }
  SessionMonitor& monitor() { return runner().monitor(); }
  SessionWindow& experimenter() { return *desk->session_window(); }
  ParticipantView& view() { return desk->participant_window()->view(); }
  bool is_in(SessionPhase phase);
  /// In `trial`.
  bool is_in(SessionPhase phase, int trial);

  /// A surface is under the hand and pushes back, in this trial.
  bool is_pushed(int trial);

  /// The scene has been there long enough to be answered.
  bool can_be_perceived();
  /// Until a request to feel again counts where feeling has ended without a request.
  void wait_until_feeling_again_counts();

  // --- hands ---
  /// To whichever window has the focus.
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  /// Counted; the widget has to be seen and enabled within a while.
  void click(QWidget& widget);
  template <class Widget>
  Widget& find(QWidget& in, const char* name) {
    return child<Widget>(in, name);
  }
  void click(QWidget& in, const char* name) { click(child<QWidget>(in, name)); }
  void click_row(QWidget& in, const char* table, const QString& with_text);
  QPoint place_of(ParticipantItem::Kind kind, const QString& key);
  void click_item(ParticipantItem::Kind kind, const QString& key);

  // --- what people do ---
  /// From the Protocols page over the start page into the session.
  void start(const QString& protocol, const char* mode = "mode_pilot");
  /// As `start`, with the mouse as the device: in a run as well, since the protocols of the room need no force.
  void start_by_mouse(const QString& protocol, const char* mode = "mode_pilot");
  /// Holds the mouse's button on the surface and strokes while it can be felt, until it was felt for so long; lifts when it
  /// cannot.
  void stroke_by_mouse(double contact_s = 0.6);
  /// The consent of the start page, seen by AB, who has measured the masking noise as well.
  void agree();
  /// Presses the start page's button once the checklist allows it.
  void press_start();
  /// Follows the session as a participant does (Return where something is read) and answers the
  /// questions of trials by `answer`, until `until` holds; without it, to the end.
  void take_part(const std::function<void(const Scene&)>& answer,
                 const std::function<bool()>& until = {});
  /// Presses A and Return.
  std::function<void(const Scene&)> chooses_a() {
    return [this](const Scene&) { choose(Qt::Key_A); };
  }
  /// Chooses by key and confirms.
  void choose(Qt::Key option);
  /// Waits, with events going on, until it holds; false when it did not for long.
  bool until(const std::function<bool()>& condition);
  /// The same; otherwise the test ends, and says what it waited for.
  void wait_for(const std::string& what, const std::function<bool()>& condition);
  static void require(bool holds, const std::string& what);
  void wait_for_end();

  int clicks = 0;
  SoundLog sound{};                                    ///< of every session's loudspeakers
  std::atomic<bool> sound_is_made_by_a_window{false};  ///< on the thread of the windows
  std::unique_ptr<StudyWindow> window{};
  std::unique_ptr<SessionDesk> desk{};

 private:
  // Of the mouse.
  int stroked_trial_ = 0;
  int enough_of_ = 0;  // which surface of that trial
  bool is_mouse_down_ = false;
  std::int64_t pressed_ns_ = 0;
  int mouse_steps_ = 0;
};

/// A table of an export: rows by column.
std::vector<std::map<std::string, std::string>> read_exported(const std::filesystem::path& file);

}  // namespace asperity

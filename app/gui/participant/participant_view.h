// What the participant sees, drawn from the session's monitor, and what they do to it.

#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <QtCore/QPointer>
#include <QtCore/QStringList>
#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "app/gui/participant/event_clock.h"
#include "app/gui/participant/participant_layout.h"
#include "app/gui/participant/picture_shelf.h"
#include "app/session/respondents/participant_input.h"
#include "app/session/session_monitor.h"

class QInputMethodEvent;
class QKeyEvent;
class QPlainTextEdit;

namespace asperity {

class LiveGuide;
class ParticipantPage;

/// Draws the scene of the monitor, one thing at a time. Everything in it can be done with the mouse
/// alone and, through `ResponseKeys`, with the keyboard alone.
///
/// The view keeps no rules of answering: whatever is done is told by `acted`, and what does not hold
/// is refused by the session, as a cue in the next scene. It only keeps what is not said yet: the
/// surface picked for the next picture, the option or number of a form before it is confirmed.
///
/// Words that do not fit in letters of 24 points come on pages (participant_layout.h). Return, → and
/// Page down go to the next one, ← and Page up back; on the last one Return is the scene's. An answer
/// that is pressed before that is taken, and its page shown.
///
/// Pictures of a scene appear together, once all are there, so that none has a start on the others;
/// those of the whole plan are prepared when the session begins.
///
/// As a mirror it is the same picture, laid out for the participant's window and scaled down; it
/// takes no input.
class ParticipantView final : public QWidget {
  Q_OBJECT
 public:
  enum class Role { participant, mirror };

  /// `monitor` must outlive the view.
  ParticipantView(const SessionMonitor& monitor, std::filesystem::path study, Role role,
                  QWidget* parent = nullptr);
  ~ParticipantView() override;

  /// The scene of object, tool and probe, shown where a scene asks for it. Taken as a child.
  void set_workspace(QWidget* workspace);
  /// A press where nothing can be pressed is then a touch of the surface, and no act of the participant's.
  void set_pointer_is_probe(bool is_probe) { pointer_is_probe_ = is_probe; }
  /// Something that can be pressed stands there, in the widget's pixels.
  bool can_be_pressed(QPointF at) const { return item_at(to_page(at)).has_value(); }
  /// Of a mirror: the view that it shows, with its size and what is begun in it. Without one it is
  /// laid out as for a screen of 1366 × 768.
  void follow(ParticipantView& original);

  const ParticipantScene& scene() const noexcept { return *scene_; }
  /// The scene waits for something that the participant does.
  bool waits() const;
  /// A confirmation would leave a question out: nothing has been answered yet.
  bool would_leave_out() const;
  /// Whether this key means something to the scene.
  bool has_use_for(const QKeyEvent& event) const;
  /// A key that is held acts again and again: an arrow on a scale.
  bool repeats(const QKeyEvent& event) const;
  /// Acts on it; `pressed_ns` is on the session's clock. False where the scene has no use for it.
  bool press(QKeyEvent& event, std::int64_t pressed_ns);
  /// The key of this name was let go.
  void release(const QString& key, std::int64_t pressed_ns, double held_s);
  /// The time of an event on the session's clock.
  std::int64_t time_of_ns(std::uint64_t stamp_ms);
  EventClock& event_clock() noexcept { return event_clock_; }

  /// Where things are now, in the widget's pixels; for tests and for people who write scripts.
  std::vector<ParticipantItem> items() const;
  /// Where a mouse or a pen feels the surface, in the widget's pixels; nothing where it is not shown.
  std::optional<QRectF> surface_rect() const;
  /// Every text that the last painting drew.
  QStringList drawn_texts() const { return drawn_texts_; }
  /// Pictures of the scene have all been loaded.
  bool pictures_are_there() const;

 signals:
  void acted(asperity::ParticipantInput input);
  void scene_changed();
  /// Things stand elsewhere or look different now.
  void arranged();
  /// Whether there are pages to come; told when it changes. Buttons of the device go through the
  /// session, which has to know whether one of them turns a page or goes on
  /// (PersonAtWindow::set_more_to_read).
  void more_to_read(bool more);
  /// For the record beside notes: "picture_unreadable".
  void remarked(const QString& kind, const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Press {
    ParticipantItem item{};  ///< as it was: cues come and go under a hand
    QPointF at{};
    std::int64_t time_ns = 0;
    QString letter{};  ///< of the surface that a drag from here carries; empty: none
    bool dragging = false;
    std::optional<double> set{};  ///< of an item that the pointer sets: the position told last
  };

  /// A question, by its scene, trial, attempt and name.
  using Asked = std::tuple<ParticipantScene::Kind, int, int, std::string>;

  void look();
  void keep_draft();
  void keep_page(const ParticipantScene& before, bool same);
  void arrange();
  void place(QWidget* widget, const ParticipantItem* item);
  ParticipantLayoutInputs layout_inputs() const;
  void prepare_pictures();
  double surface_aspect() const;
  int side_px(double side) const;
  QSizeF page_size() const;
  double letters_px() const;
  /// The item that turns the page by this key, if there is one.
  const ParticipantItem* turned_by(int key) const;
  void turn_to(int page);
  double page_scale() const;
  QPointF page_offset() const;
  std::int64_t session_now_ns() const;
  int rest_left_s() const;
  /// The pressed item, where the pointer is; told where that is another position of it.
  void set_by_pointer(QPointF at, std::int64_t time_ns);
  std::optional<std::size_t> item_at(QPointF page_point) const;
  QPointF to_page(QPointF point) const;
  void act(const ParticipantAction& action, std::int64_t time_ns, const char* source);
  void tell(ParticipantInput input, std::int64_t time_ns, const char* source);
  /// Releases of keys and buttons are not stored.
  bool keys_are_private() const;
  const ParticipantPage& scene_page() const;  ///< of the scene

  const SessionMonitor& monitor_;
  Role role_ = Role::participant;
  PictureShelf shelf_;
  EventClock event_clock_;
  QTimer timer_{};
  std::shared_ptr<const SessionFacts> facts_{};
  std::shared_ptr<const ParticipantScene> scene_ = std::make_shared<const ParticipantScene>();
  int trial_ = 0;
  int attempt_ = 0;
  ParticipantDraft draft_{};
  std::optional<Asked> drafted_{};  ///< what the draft answers
  int page_ = 1;                    ///< 0: where the answer stands
  double letters_shown_px_ = 0.0;
  bool told_more_ = false;
  std::vector<ParticipantItem> items_{};  ///< in page coordinates
  QPointer<ParticipantView> original_{};  ///< of a mirror
  QWidget* workspace_ = nullptr;
  LiveGuide* guide_ = nullptr;
  QPlainTextEdit* field_ = nullptr;
  std::optional<Press> press_{};
  QPointF pointer_{};
  bool pointer_is_probe_ = false;
  std::uint64_t cue_seen_ = 0;
  std::chrono::steady_clock::time_point cue_until_{};
  bool cue_shown_ = false;
  int rest_shown_s_ = 0;
  QString typed_{};  ///< the first digit of a key of two
  std::int64_t typed_ns_ = 0;
  QStringList drawn_texts_{};
};

}  // namespace asperity

Q_DECLARE_METATYPE(asperity::ParticipantInput)

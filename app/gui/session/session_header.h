// Which session it is, how far it has come, and what happens now.

#pragma once

#include <memory>
#include <optional>

#include <QtWidgets/QWidget>

#include "app/gui/session/session_form.h"
#include "app/session/session_monitor.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace asperity {

class FittedLabel;

/// Whether names are hidden, as the header says it.
struct Blindness {
  bool is_blind = true;
  bool is_run = true;       ///< to unblind asks for a reason
  bool can_change = false;  ///< not before the session is known
  QString unblinded_at{};   ///< when names were first shown in a run; empty: never
};

/// Its first corner has the emergency stop: at the same place in every form, where no other window of
/// a session that lies beside covers it, and far from the button that starts one.
class SessionHeader final : public QWidget {
  Q_OBJECT
 public:
  explicit SessionHeader(QWidget* parent = nullptr);

  void set_form(SessionForm form);
  /// False: there is nothing to be stopped any more.
  void set_running(bool running);
  void set_facts(std::shared_ptr<const SessionFacts> facts);
  /// Of the session, whole: what does not fit is cut in the line itself.
  QString title() const;
  void show_blindness(const Blindness& blindness);
  void show_progress(const SessionSnapshot& snapshot);
  /// Before there is a plan to be far in. `fraction`: absent while it is unknown.
  void show_preparation(std::optional<double> fraction);
  void show_now(const QString& text);
  void show_elapsed(double elapsed_s);
  /// How long it still takes; empty: it is over.
  void show_left(const QString& text);
  /// What was asked for and has not happened yet; empty: nothing.
  void show_pending(const QString& text);

 signals:
  void unblind_pressed();
  /// At the press, not the release.
  void emergency();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_emergency_stop();
  void make_labels();
  QString title_with(const QString& protocol) const;
  void write_title();

  std::shared_ptr<const SessionFacts> facts_{};
  std::optional<SessionForm> form_{};
  bool is_stopped_ = false;  ///< by a fault
  QGridLayout* grid_ = nullptr;
  QHBoxLayout* counts_ = nullptr;
  QPushButton* emergency_ = nullptr;
  QLabel* title_ = nullptr;
  FittedLabel* blindness_ = nullptr;
  QPushButton* unblind_ = nullptr;
  QLabel* block_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* trial_ = nullptr;
  QLabel* elapsed_ = nullptr;
  QLabel* left_ = nullptr;
  FittedLabel* now_ = nullptr;
  FittedLabel* pending_ = nullptr;
};

}  // namespace asperity

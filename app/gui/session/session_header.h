// Which session it is, how far it has come, and what happens now.

#pragma once

#include <memory>

#include <QtWidgets/QWidget>

#include "app/conductor/session_monitor.h"

class QLabel;
class QLayout;
class QProgressBar;
class QPushButton;

namespace asperity {

class StateLabel;

/// Whether names are hidden, as the header says it.
struct Blindness {
  bool is_blind = true;
  bool is_run = true;       ///< to unblind asks for a reason
  bool can_change = false;  ///< not before the session is known
  QString unblinded_at{};   ///< when names were first shown in a run; empty: never
};

class SessionHeader final : public QWidget {
  Q_OBJECT
 public:
  explicit SessionHeader(QWidget* parent = nullptr);

  void set_facts(std::shared_ptr<const SessionFacts> facts);
  /// Of the session, whole: what does not fit is cut in the line itself.
  QString title() const;
  void show_blindness(const Blindness& blindness);
  void show_progress(const SessionSnapshot& snapshot);
  void show_now(const QString& text);
  void show_elapsed(double elapsed_s);
  /// How long it still takes; empty: it is over.
  void show_left(const QString& text);
  /// What was asked for and has not happened yet; empty: nothing.
  void show_pending(const QString& text);

 signals:
  void unblind_pressed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLayout* make_title_line();
  QLayout* make_count_line();
  QLayout* make_now_line();
  QString title_with(const QString& protocol) const;
  void write_title();

  std::shared_ptr<const SessionFacts> facts_{};
  QLabel* title_ = nullptr;
  QLabel* blindness_ = nullptr;
  QPushButton* unblind_ = nullptr;
  QLabel* block_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* trial_ = nullptr;
  QLabel* elapsed_ = nullptr;
  QLabel* left_ = nullptr;
  QLabel* now_ = nullptr;
  StateLabel* pending_ = nullptr;
};

}  // namespace asperity

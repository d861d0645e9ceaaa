// The study's sessions: how each went, and which can be gone on with.

#pragma once

#include <vector>

#include "app/gui/base/session_wish.h"
#include "app/gui/base/study_page.h"
#include "app/tasks/study_overview.h"

class QLineEdit;

namespace asperity {

class StudyTable;

class SessionsPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit SessionsPage(OpenStudy& study, QWidget* parent = nullptr);

  void set_filter(const QString& words);

 signals:
  void session_opened(qlonglong id);
  void session_wanted(const asperity::SessionWish& wish);

 private:
  void show_sessions(const std::vector<SessionOverview>& sessions);
  void show_selected();
  const SessionOverview* selected() const;

  std::vector<SessionOverview> sessions_{};
  QLineEdit* filter_ = nullptr;
  StudyTable* table_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* resume_ = nullptr;
  QLabel* reason_ = nullptr;
};

/// "open here or elsewhere", "complete", …: a session's state as a shape and words.
QString text_of_session_state(const SessionOverview& session);
/// "Trials completed and stored: 7 of 12."; of a complete session also those that it did without.
QString text_of_trials(const SessionOverview& session);
State state_of_session(const SessionOverview& session);
QString text_of_mode(SessionMode mode);

}  // namespace asperity

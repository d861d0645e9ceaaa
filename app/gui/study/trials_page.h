// One session: its trials, attempt by attempt, and what happened in between.

#pragma once

#include <cstdint>
#include <vector>

#include "app/gui/base/study_page.h"
#include "app/tasks/study_overview.h"

class QLineEdit;
class QTabWidget;

namespace asperity {

class DecisionForm;
class StudyTable;

/// While a run is under way it shows how far it is, and no answer: whoever runs it is blind.
class TrialsPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit TrialsPage(OpenStudy& study, QWidget* parent = nullptr);

  void show_session(std::int64_t id);
  std::int64_t session() const noexcept { return session_id_; }

 signals:
  void back_wanted();
  void attempt_opened(qlonglong id);

 private:
  void ask_to_exclude();
  void show_detail(const SessionDetail& detail);
  void show_selected();

  std::int64_t session_id_ = 0;
  SessionDetail detail_{};
  ModeBand* band_ = nullptr;
  QLabel* summary_ = nullptr;
  QLineEdit* filter_ = nullptr;
  StateLabel* standing_ = nullptr;
  DecisionForm* form_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* exclude_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  StudyTable* trials_ = nullptr;
  QLabel* selected_ = nullptr;  ///< the trial that is selected, in full
  StudyTable* events_ = nullptr;
};

}  // namespace asperity

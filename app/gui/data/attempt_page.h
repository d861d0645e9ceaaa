// One attempt: what was felt and answered, how, and whether it counts.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/gui/base/study_page.h"
#include "app/records/attempt_detail.h"

class QTabWidget;

namespace asperity {

class DecisionForm;
class HistoryTables;
class MeasureTables;
class RecordingView;
class TaskLine;

/// Shows by name what was a code in the session, but for a run that is under way: whoever runs it is
/// blind, and the page waits for its end. What is decided here is written beside the data; nothing
/// is ever taken away.
class AttemptPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit AttemptPage(OpenStudy& study, QWidget* parent = nullptr);

  void show_attempt(qlonglong attempt_id);
  /// Nothing before one was shown.
  std::optional<qlonglong> attempt() const noexcept { return attempt_; }

 signals:
  void back_wanted();

 private:
  void add_actions();
  void show_detail(const AttemptDetail& detail);
  void show_blind(const AttemptDetail& detail);
  void show_actions();
  void read_recording_of(const AttemptRow& attempt);
  void ask_to_flag();
  void ask_to_exclude();
  void ask_where_to_export();
  void export_to(const QString& file);

  std::optional<qlonglong> attempt_{};
  std::optional<AttemptDetail> detail_{};
  std::optional<std::int64_t> recording_of_{};  ///< the attempt whose recording is shown or read
  ModeBand* band_ = nullptr;
  QLabel* place_ = nullptr;
  QPushButton* previous_ = nullptr;
  QPushButton* next_ = nullptr;
  QLabel* summary_ = nullptr;
  StateLabel* names_ = nullptr;
  StateLabel* standing_ = nullptr;
  QPushButton* flag_ = nullptr;
  QPushButton* exclude_ = nullptr;
  QLabel* why_not_ = nullptr;
  DecisionForm* form_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  RecordingView* recording_ = nullptr;
  MeasureTables* measures_ = nullptr;
  HistoryTables* history_ = nullptr;
  TaskLine* reading_line_ = nullptr;
  TaskLine* writing_line_ = nullptr;
  BackgroundTask reading_{};
  BackgroundTask exporting_{};
};

}  // namespace asperity

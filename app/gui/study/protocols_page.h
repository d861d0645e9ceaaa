// The study's protocols: what each asks, whether it can be run, and how far it has come.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "app/gui/base/commands_button.h"
#include "app/gui/base/session_wish.h"
#include "app/gui/base/study_page.h"
#include "app/session/new_seed.h"
#include "app/tasks/interrupted_sessions.h"
#include "app/tasks/protocol_templates.h"
#include "app/tasks/study_overview.h"

class QComboBox;
class QFileSystemWatcher;
class QSplitter;
class QStackedWidget;

namespace asperity {

class PlanPreview;
class ProtocolFileActions;
class StudyTable;

class ProtocolsPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit ProtocolsPage(OpenStudy& study, QWidget* parent = nullptr);

  /// Selects the protocol of this file, now or once it is in the list.
  void select_file(const QString& file);

 signals:
  void session_wanted(const asperity::SessionWish& wish);
  void edit_wanted(const QString& file);
  void sessions_wanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  enum Below { what_it_asks, problems, plan };

  QWidget* make_detail();
  void share_height();
  void choose_template();
  void add_from_template(const TemplateChoice& choice);
  void show_protocols(const std::vector<ProtocolOverview>& protocols);
  void show_interrupted(const std::vector<InterruptedSession>& sessions);
  void examine_stimuli();
  void take_examination(const std::string& source, const StimulusExaminer::Result& result);
  void show_whether_examined();
  ProtocolOverview with_examination(const ProtocolOverview& overview) const;
  void show_selected();
  void show_groups(const ProtocolOverview& overview);
  void show_below(Below below);
  const ProtocolOverview* selected() const;
  SimulationInputs simulation_of(const ProtocolOverview& protocol);
  std::vector<ShownCommand> commands();
  void watch_files();

  std::vector<ProtocolOverview> read_{};       ///< as read from the study
  std::vector<ProtocolOverview> protocols_{};  ///< the same with the examinations of their stimuli
  /// By the text of a protocol; the last ones, until the examiner confirms or replaces them.
  std::map<std::string, StimulusExaminer::Result> examined_{};
  QFileSystemWatcher* watcher_ = nullptr;
  BackgroundTask write_task_{};
  QString select_next_{};  ///< a file that was made just now
  /// What was reported of an interrupted session: its id, whether it can be resumed, its progress.
  std::tuple<std::int64_t, bool, int> reported_{};
  QLabel* examining_ = nullptr;
  Banner* interrupted_ = nullptr;
  StudyTable* table_ = nullptr;
  QSplitter* splitter_ = nullptr;  ///< the table above, one of its protocols below
  bool is_shared_by_hand_ = false;
  QWidget* detail_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* facts_ = nullptr;
  QLabel* last_run_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* edit_ = nullptr;
  QPushButton* preview_ = nullptr;
  QPushButton* simulate_ = nullptr;
  QPushButton* simulate_several_ = nullptr;
  QPushButton* by_mouse_ = nullptr;
  QComboBox* mouse_group_ = nullptr;  ///< of the participant of a trial with the mouse
  std::uint64_t seed_ = new_seed();   ///< of the next simulation
  ProtocolFileActions* file_actions_ = nullptr;
  QPushButton* close_ = nullptr;  ///< of the plan below
  QLabel* reason_ = nullptr;
  QStackedWidget* below_ = nullptr;
  QLabel* description_ = nullptr;
  StudyTable* problems_ = nullptr;
  PlanPreview* plan_ = nullptr;
  QString planned_{};  ///< the file whose plan is shown, or can be
};

}  // namespace asperity

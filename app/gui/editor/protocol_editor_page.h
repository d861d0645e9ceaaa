// Declares the page on which a protocol is edited, as a form or as text, next to its plan and its precision.

#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtGui/QTextDocument>

#include "app/gui/base/study_page.h"
#include "app/gui/editor/live_check.h"
#include "app/gui/editor/protocol_views.h"
#include "app/gui/look/background_task.h"
#include "app/gui/plan/plan_preview.h"
#include "app/tasks/warnings/session_warnings.h"

class QButtonGroup;
class QFileSystemWatcher;
class QStackedWidget;

namespace asperity {

class FittedLabel;
class LiveExamination;
class PrecisionView;
class ProtocolTextEdit;
class QuestionBar;
class ScreenPreview;
class StudyTable;

/// The text is checked while it is typed, and the stimuli of a valid one are examined once it has been still for a
/// while.
///
/// What is typed is in one of three places: in the file, in the field, or a step of its undo. A file
/// that somebody else has changed is never written over without asking; a file that the field could
/// not give back byte for byte is shown, but cannot be changed here.
class ProtocolEditorPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit ProtocolEditorPage(OpenStudy& study, QWidget* parent = nullptr);

  /// Shows the file; asks first when there are unsaved changes of another.
  void open(const std::filesystem::path& protocol);
  /// The same, then `after` in place of the text `before`, as one step of the undo that is not saved. `news` is shown.
  void open_changed(const std::filesystem::path& protocol, const std::string& before,
                    const std::string& after, const QString& news);

  /// What is shown and what is unsaved, for a page that is made anew, as in another language.
  struct Shown {
    std::filesystem::path file{};
    std::string on_disk{};
    bool dos_lines = false;
    bool byte_order_mark = false;
    bool as_it_is = false;
    std::unique_ptr<QTextDocument> text{};  ///< with its undo
    ProtocolViews::Shown views{};
    int side = 0;  ///< the plan, the screen or the precision
    PlanPreview::Choice plan{};
  };
  /// This page has nothing any more.
  Shown hand_over();
  void resume(Shown shown);
  /// What was typed in a field and is not in the text yet. False where it is refused: the banner states why.
  bool commit();
  /// Empty while none is open.
  const std::filesystem::path& file() const noexcept { return file_; }
  bool has_unsaved_changes() const;

  /// False with unsaved changes: then the page asks what is to become of them, and does `then` when
  /// they are saved or discarded (later, so that it may delete the page).
  bool may_leave(std::function<void()> then = {});

  /// What would be written.
  std::string content() const;
  /// Null while no text of the file was checked.
  const LiveCheck::Result& result() const noexcept { return result_; }
  bool is_checked() const { return check_->is_settled(); }

 signals:
  void saved(const QString& file);
  void back_wanted();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  enum class Agreed { nothing, version };
  enum class Then { nothing, save };
  struct Saving;

  void make_head();
  QWidget* make_edit_side();
  QWidget* make_plan_side();
  void choose_side(QWidget* side);
  void show_name(const std::filesystem::path& file);
  void show_content(const std::string& bytes);
  void show_why_read_only();
  void take_content(const std::string& bytes);
  QString decoded(const std::string& bytes);
  /// Whether saving what is in the field, with the mark that it had, would write these bytes.
  bool gives_back(const std::string& bytes) const;
  void show_whether_saved();
  void take_checked(const LiveCheck::Result& result);
  void show_checking();
  void show_not_known(const QString& why);
  void show_checked();
  void list_problems();
  void show_problems_of_saved();
  void go_to_problem(const QString& key);
  void save(Agreed agreed);
  void end_saving(const Saving& saving);
  void ask_about_theirs(const std::string& theirs, Then then);
  void ask_about_version(const VersionUse& use);
  void raise_version();
  void leave();
  void watch_file();
  void look_at_disk();

  std::filesystem::path file_{};
  std::string on_disk_{};         ///< as last read or written
  bool dos_lines_ = false;        ///< lines end in "\r\n"
  bool byte_order_mark_ = false;  ///< there was one; it is not written again
  bool as_it_is_ = false;         ///< the field cannot hold the file: not to be changed
  std::function<void()> then_{};  ///< what waits for the changes to be saved or discarded
  LiveCheck::Result result_{};
  std::vector<Diagnostic> found_problems_{};  ///< of the result and the examination
  std::vector<Diagnostic> found_warnings_{};
  QFileSystemWatcher* watcher_ = nullptr;
  QuestionBar* question_ = nullptr;
  FittedLabel* name_ = nullptr;  ///< of the file, in place of the title of the page
  FittedLabel* note_ = nullptr;
  QPushButton* save_ = nullptr;
  ProtocolViews* views_ = nullptr;
  ProtocolTextEdit* edit_ = nullptr;  ///< of the views
  StateLabel* state_ = nullptr;
  StudyTable* problems_ = nullptr;
  QStackedWidget* plan_side_ =
      nullptr;                      ///< the plan, the screen, the precision, or why there is none
  QButtonGroup* sides_ = nullptr;   ///< the buttons of the sides, in their order
  QWidget* chosen_side_ = nullptr;  ///< the one that is shown of a valid text
  PlanPreview* plan_ = nullptr;
  ScreenPreview* screen_ = nullptr;
  PrecisionView* precision_ = nullptr;
  QLabel* why_no_plan_ = nullptr;
  LiveCheck* check_ = nullptr;
  LiveExamination* examination_ = nullptr;
  BackgroundTask save_task_{};
  QString until_edit_{};  ///< what the banner states until the next edit; may be empty
  /// What the banner states of a file that was saved, until its problems are known or it is edited.
  std::optional<QString> saved_news_{};
};

}  // namespace asperity

// What the study's answers come to: the question, the answer in a sentence, the figure, the tables.

#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/exports/export_options.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/gui/base/commands_button.h"
#include "app/gui/look/background_task.h"

class QListWidget;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace asperity {

class Banner;
class FigureSaver;
class OpenStudy;
class ReportSaving;
class TaskLine;

/// One entry per protocol, version and group of participants; the groups never mix. Read anew
/// whenever the study changes while the page is seen. Under a modal dialog what is shown stays until the dialog is closed.
class AnalysisPage final : public QWidget {
  Q_OBJECT
 public:
  explicit AnalysisPage(OpenStudy& study, QWidget* parent = nullptr);

  const std::vector<AnalysisOutcome>& outcomes() const noexcept { return outcomes_; }
  /// Shows the first outcome of the latest version of this protocol in sessions of this mode, as soon as it is there; under a
  /// dialog a button that shows it.
  void choose(const std::string& protocol, SessionMode mode);

 signals:
  void refreshed();  ///< the responses have been counted

 protected:
  void showEvent(QShowEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void refresh();
  struct Analysis {
    std::vector<AnalysisOutcome> outcomes{};
    /// Protocols with a session in mode run that is running now: nobody who runs it is to see counts
    /// by name.
    std::set<std::string> running{};
  };
  void show_analysis(Analysis analysis);
  bool is_under_dialog() const { return is_blocked_ && isVisible(); }
  void show_whether_exportable();
  void show_outcome(int index);
  void select_wanted();
  /// Instead of the results of another protocol, while those of the chosen one are being counted.
  void show_counting();
  /// Of the protocol that was shown before the chosen one.
  void show_previous_results();
  void ask_where_to_export();
  void export_to(const QString& folder, const ExportOptions& options);
  std::vector<ShownCommand> commands() const;

  OpenStudy& study_;
  bool outdated_ = true;
  bool is_blocked_ = false;         ///< by a modal dialog
  std::optional<Analysis> held_{};  ///< what was counted under a dialog
  std::string wanted_{};  ///< the protocol to show next
  SessionMode wanted_mode_ = SessionMode::run;
  int row_before_counting_ = 0;
  /// Of the last export; before the first one, what the dialog suggests.
  QString exported_to_ = "tables";
  ExportOptions exported_{};
  std::vector<AnalysisOutcome> outcomes_{};
  std::set<std::string> running_{};
  Banner* banner_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  QWidget* unknown_ = nullptr;  ///< until the responses have been counted once
  QWidget* none_ = nullptr;
  QWidget* both_ = nullptr;
  QListWidget* list_ = nullptr;
  QScrollArea* area_ = nullptr;
  ReportSaving* report_ = nullptr;
  QPushButton* export_ = nullptr;
  FigureSaver* figure_saver_ = nullptr;
  TaskLine* analysing_ = nullptr;
  TaskLine* writing_ = nullptr;
  BackgroundTask analysis_{};
  BackgroundTask exporting_{};
};

}  // namespace asperity

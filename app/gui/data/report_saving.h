// Saving a study's report from a page: the button, the file dialog, the line that shows how far it is.

#pragma once

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/gui/look/background_task.h"
#include "results_schema/files/atomic_file.h"

class QPushButton;

namespace asperity {

class Banner;
class OpenStudy;
class TaskLine;

/// A button; its page places the task line and lends its banner, where every end is told. A file that
/// is there already is replaced only when somebody says so on the banner.
///
/// The names of its parts: "save_report", "report_dialog", "saving_report".
class ReportSaving final : public QWidget {
  Q_OBJECT
 public:
  /// `banner` outlives it.
  ReportSaving(OpenStudy& study, Banner& banner, QWidget* parent);

  TaskLine* line() const noexcept { return line_; }
  /// The file of the last report; before the first one, the name that the dialog suggests.
  const QString& file() const noexcept { return file_; }
  QString verb() const;
  /// Whether there is anything to report.
  void set_any(bool any);

 private:
  void show_whether_possible();
  void ask_where();
  void save_to(const QString& file, Overwrite overwrite);

  OpenStudy& study_;
  Banner& banner_;
  QString file_{};
  bool any_ = false;
  QPushButton* button_ = nullptr;
  TaskLine* line_ = nullptr;
  BackgroundTask saving_{};
};

}  // namespace asperity

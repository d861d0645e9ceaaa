// Writes the report in a background task, with a banner for its result.

#include "app/gui/data/report_saving.h"

#include <filesystem>

#include <QtCore/QUrl>
#include <QtGui/QDesktopServices>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QPushButton>

#include "app/gui/base/open_study.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/look/words.h"
#include "app/report/pages/report_file.h"
#include "app/study_files/study_outputs.h"

namespace asperity {

namespace {

struct Saved {
  bool is_written = false;
  std::optional<Phrase> unrecorded{};  ///< why the study does not list it
};

}  // namespace

ReportSaving::ReportSaving(OpenStudy& study, Banner& banner, QWidget* parent)
    : QWidget(parent),
      study_(study),
      banner_(banner),
      file_(text(study.study().name()) + "-report.pdf") {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  button_ = make_button(tr("Save a report…"), ButtonRole::plain, this);
  button_->setObjectName("save_report");
  layout->addWidget(button_);
  line_ = new TaskLine(saving_, parent);
  line_->setObjectName("saving_report");
  connect(button_, &QPushButton::clicked, this, &ReportSaving::ask_where);
  connect(line_, &TaskLine::cancelWanted, &saving_, &BackgroundTask::cancel);
  connect(&saving_, &BackgroundTask::started, this, &ReportSaving::show_whether_possible);
  connect(&saving_, &BackgroundTask::finished, this, &ReportSaving::show_whether_possible);
  show_whether_possible();
}

QString ReportSaving::verb() const { return button_->text(); }

void ReportSaving::set_any(bool any) {
  any_ = any;
  show_whether_possible();
}

void ReportSaving::show_whether_possible() {
  button_->setEnabled(any_ && !saving_.is_running());
  button_->setToolTip(!any_                  ? tr("There are no sessions to report yet.")
                      : saving_.is_running() ? tr("The report is being written.")
                                             : tr("Methods, tables, tests and figures, as PDF or "
                                                  "HTML."));
}

void ReportSaving::ask_where() {
  auto* dialog = new QFileDialog(this, tr("File for the report"));
  dialog->setObjectName("report_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  // Whether to replace a file is asked on the banner, not by a box on top of a dialog.
  dialog->setOption(QFileDialog::DontConfirmOverwrite);
  const QString web_page = tr("Web page (*.html)");
  dialog->setNameFilters({tr("PDF for print (*.pdf)"), web_page});
  dialog->setDefaultSuffix("pdf");
  const QString name = text(study_.study().name()) + "-report";
  dialog->selectFile(name + ".pdf");
  connect(dialog, &QFileDialog::filterSelected, dialog,
          [dialog, web_page, name](const QString& filter) {
            const bool is_web_page = filter == web_page;
            dialog->setDefaultSuffix(is_web_page ? "html" : "pdf");
            dialog->selectFile(name + (is_web_page ? ".html" : ".pdf"));
          });
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& file) { save_to(file, Overwrite::refuse); });
  dialog->open();
}

void ReportSaving::save_to(const QString& file, Overwrite overwrite) {
  if (saving_.is_running()) return;
  const std::filesystem::path path = path_of_text(file);
  if (overwrite == Overwrite::refuse && std::filesystem::exists(path)) {
    banner_.show_news(State::look,
                      tr("%1 already exists; nothing was written. Replace it, or save the report "
                         "under another name.")
                          .arg(file),
                      tr("Replace it"), [this, file] { save_to(file, Overwrite::allow); });
    return;
  }
  file_ = file;
  line_->set_words(tr("Writing the report to %1 …").arg(file));
  saving_.run<Saved>(
      [study = study_.folder(), path, overwrite](const std::stop_token& stop,
                                                 const BackgroundTask::Progress& progress) {
        const Study own = Study::open(study, Access::read_only);
        require_report_path(path, overwrite);
        ListedOutput listed(own, OutputKind::report, path);
        Saved saved{.is_written = write_report(own, path, overwrite, {}, stop, progress)};
        if (saved.is_written) saved.unrecorded = listed.complete();
        return saved;
      },
      [this, file](const Saved& saved) {
        if (!saved.is_written) {
          banner_.show_news(State::look, tr("Writing the report was cancelled, and no report was "
                                            "written. To write it, save the report again."));
          return;
        }
        banner_.show_news(saved.unrecorded ? State::look : State::fine,
                          with_remark(tr("The report is in %1.").arg(file), saved.unrecorded),
                          tr("Open it"),
                          [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(file)); });
      },
      [this](const QString& what) { banner_.show_news(State::stop, what); });
}

}  // namespace asperity

#include "moc_report_saving.cpp"

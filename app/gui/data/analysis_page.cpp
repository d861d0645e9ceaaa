// Computes the outcomes in the background, shows the chosen one, and exports the tables and figures.

#include "app/gui/data/analysis_page.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QStackedWidget>

#include "app/exports/export_study.h"
#include "app/findings/study/analyze_study.h"
#include "app/gui/base/command_lines.h"
#include "app/gui/base/open_study.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/data/figure_saver.h"
#include "app/gui/data/outcome_view.h"
#include "app/gui/data/report_saving.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/look/words.h"
#include "app/study_files/study_metadata.h"
#include "app/study_files/study_outputs.h"
#include "app/tasks/study_overview.h"
#include "renderers/built_in_models.h"

namespace asperity {

namespace {

/// The tables need the rest of a small screen.
constexpr int kListWidth = 208;

struct Exported {
  std::size_t files = 0;               ///< none: it was cancelled
  std::optional<Phrase> unrecorded{};  ///< why the study does not list it
  std::optional<Phrase> missing{};     ///< what archives of data will ask for
  std::vector<Phrase> incomplete{};    ///< what of the study could not be exported

  bool has_remarks() const { return unrecorded || missing || !incomplete.empty(); }
};

/// The first of them, and how many more README.txt has; a banner holds no list.
QString incomplete_text(const std::vector<Phrase>& incomplete) {
  if (incomplete.empty()) return {};
  const int more = static_cast<int>(incomplete.size()) - 1;
  const QString first = ' ' + words_of(incomplete.front());
  if (more == 0) return first;
  return first + ' ' +
         AnalysisPage::tr("README.txt contains %n further warning(s).", nullptr, more);
}

QString group_text(AnswerGroup group) {
  switch (group) {
    case AnswerGroup::people:
      return AnalysisPage::tr("human participants");
    case AnswerGroup::pilot:
      return AnalysisPage::tr("pilot sessions");
    case AnswerGroup::virtual_participants:
      return AnalysisPage::tr("virtual participants");
  }
  return {};
}

AnswerGroup group_of(SessionMode mode) {
  switch (mode) {
    case SessionMode::run:
      return AnswerGroup::people;
    case SessionMode::pilot:
      return AnswerGroup::pilot;
    case SessionMode::simulate:
      return AnswerGroup::virtual_participants;
  }
  return AnswerGroup::people;
}

/// Whether the responses to this version of a protocol are of several kinds, each with its outcome.
bool is_one_of_several_kinds(const AnalysisOutcome& outcome,
                             const std::vector<AnalysisOutcome>& all) {
  return std::any_of(all.begin(), all.end(), [&outcome](const AnalysisOutcome& other) {
    return other.protocol == outcome.protocol && other.version == outcome.version &&
           other.group == outcome.group && other.kind != outcome.kind;
  });
}

/// Whether both are of the same responses, of which one can have more.
bool is_of_same(const AnalysisOutcome& one, const AnalysisOutcome& other) {
  return one.protocol == other.protocol && one.version == other.version &&
         one.group == other.group && one.kind == other.kind;
}

}  // namespace

AnalysisPage::AnalysisPage(OpenStudy& study, QWidget* parent) : QWidget(parent), study_(study) {
  setObjectName("analysis_page");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kMargin);
  auto* header = new QHBoxLayout();
  header->addWidget(make_title(tr("Analysis"), this), 1);
  banner_ = new Banner(this);
  report_ = new ReportSaving(study, *banner_, this);
  export_ = make_button(tr("Export tables…"), ButtonRole::plain, this);
  export_->setObjectName("export_tables");
  header->addWidget(report_);
  header->addWidget(export_);
  header->addWidget(make_commands_button([this] { return commands(); }, this));
  layout->addLayout(header);
  layout->addWidget(banner_);
  figure_saver_ = new FigureSaver(*banner_, *this);
  layout->addWidget(report_->line());
  analysing_ = new TaskLine(analysis_, this);
  analysing_->setObjectName("analysing");
  analysing_->set_words(tr("Counting the responses…"));
  layout->addWidget(analysing_);
  writing_ = new TaskLine(exporting_, this);
  writing_->setObjectName("exporting");
  layout->addWidget(writing_);
  stack_ = new QStackedWidget(this);
  layout->addWidget(stack_, 1);
  // The study may have thousands: what it has is unknown until they have been counted.
  unknown_ = new EmptyState(
      tr("The responses have not been counted yet"),
      tr("The questions, answers and figures of the study appear here when they have been."),
      stack_);
  unknown_->setObjectName("analysis_unknown");
  stack_->addWidget(unknown_);
  none_ =
      new EmptyState(tr("No responses yet"),
                     tr("When a session has been run or simulated, its responses are counted and "
                        "tested here. Start a session on the Protocols page."),
                     stack_);
  none_->setObjectName("analysis_none");
  stack_->addWidget(none_);
  both_ = new QWidget(stack_);
  auto* columns = new QHBoxLayout(both_);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(kMargin);
  list_ = new QListWidget(both_);
  list_->setObjectName("outcomes");
  list_->setFixedWidth(kListWidth);
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_ = new QScrollArea(both_);
  area_->setWidgetResizable(true);
  columns->addWidget(list_);
  columns->addWidget(area_, 1);
  stack_->addWidget(both_);
  connect(list_, &QListWidget::currentRowChanged, this, &AnalysisPage::show_outcome);
  // What the user selects stays when the responses have been counted.
  connect(list_, &QListWidget::itemClicked, this, [this] { wanted_.clear(); });
  connect(export_, &QPushButton::clicked, this, &AnalysisPage::ask_where_to_export);
  connect(analysing_, &TaskLine::cancelWanted, this, [this] {
    analysis_.abandon();
    show_previous_results();
    banner_->show_news(
        State::look,
        stack_->currentWidget() == unknown_
            ? tr("Counting the responses was cancelled. Count again to see the results.")
            : tr("Counting the responses was cancelled; the previous results are shown. "
                 "Count again to update them."),
        tr("Count again"), [this] { refresh(); });
  });
  connect(writing_, &TaskLine::cancelWanted, &exporting_, &BackgroundTask::cancel);
  connect(&exporting_, &BackgroundTask::started, this, &AnalysisPage::show_whether_exportable);
  connect(&exporting_, &BackgroundTask::finished, this, &AnalysisPage::show_whether_exportable);
  connect(&study_, &OpenStudy::changed, this, [this] {
    outdated_ = true;
    if (isVisible()) refresh();
  });
}

void AnalysisPage::choose(const std::string& protocol, SessionMode mode) {
  if (is_under_dialog()) {
    banner_->show_news(State::fine,
                       tr("There are new results of %1.").arg(QString::fromStdString(protocol)),
                       tr("Show the results"), [this, protocol, mode] { choose(protocol, mode); });
    return;
  }
  wanted_ = protocol;
  wanted_mode_ = mode;
  if (outdated_ || analysis_.is_running()) {
    show_counting();
  } else {
    select_wanted();
  }
}

void AnalysisPage::show_counting() {
  if (list_->count() == 0) return;  // nothing is shown
  if (list_->currentRow() >= 0) {
    row_before_counting_ = list_->currentRow();
    list_->setCurrentRow(-1);
  }
  auto* counting = new EmptyState(
      tr("Counting the responses…"),
      tr("The results of %1 appear here when its responses have been counted. To see those of "
         "another protocol, select it.")
          .arg(QString::fromStdString(wanted_)));
  counting->setObjectName("analysis_counting");
  area_->setWidget(counting);
}

void AnalysisPage::show_previous_results() {
  if (list_->currentRow() < 0) list_->setCurrentRow(row_before_counting_);
}

void AnalysisPage::select_wanted() {
  std::string version{};
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    const AnalysisOutcome& outcome = outcomes_[i];
    if (outcome.protocol != wanted_ || outcome.group != group_of(wanted_mode_) ||
        outcome.version == std::exchange(version, outcome.version)) {
      continue;
    }
    list_->setCurrentRow(static_cast<int>(i));
  }
}

void AnalysisPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (outdated_) refresh();
}

bool AnalysisPage::event(QEvent* event) {
  if (event->type() == QEvent::WindowBlocked) is_blocked_ = true;
  if (event->type() == QEvent::WindowUnblocked) {
    is_blocked_ = false;
    if (held_) show_analysis(std::move(*held_));
  }
  return QWidget::event(event);
}

void AnalysisPage::refresh() {
  outdated_ = false;
  analysis_.run<Analysis>(
      [folder = study_.folder()](const std::stop_token& stop, const BackgroundTask::Progress&) {
        const Study study = Study::open(folder, Access::read_only);
        Analysis analysis{analyze_study(study, {}, stop), {}};
        for (const SessionRow& session : study.sessions()) {
          if (!is_blind(study, session)) continue;
          analysis.running.insert(study.protocol(session.protocol_id).name);
        }
        return analysis;
      },
      [this](Analysis analysis) { show_analysis(std::move(analysis)); },
      [this](const QString& what) {
        show_previous_results();
        banner_->show_news(State::stop, what, tr("Try again"), [this] { refresh(); });
      });
}

void AnalysisPage::show_analysis(Analysis analysis) {
  if (is_under_dialog()) {
    held_ = std::move(analysis);
    emit refreshed();
    return;
  }
  held_.reset();
  int shown = list_->currentRow() < 0 ? row_before_counting_ : list_->currentRow();
  for (std::size_t i = 0, before = static_cast<std::size_t>(shown);
       before < outcomes_.size() && i < analysis.outcomes.size(); ++i) {
    if (is_of_same(analysis.outcomes[i], outcomes_[before])) shown = static_cast<int>(i);
  }
  outcomes_ = std::move(analysis.outcomes);
  running_ = std::move(analysis.running);
  list_->clear();
  for (const AnalysisOutcome& outcome : outcomes_) {
    const QString responses = answers_text(static_cast<int>(outcome.answers));
    auto* item =
        new QListWidgetItem(tr("%1\n%2 %3\n%4 · %5")
                                .arg(text(outcome.title), text(outcome.protocol),
                                     text(outcome.version), group_text(outcome.group),
                                     is_one_of_several_kinds(outcome, outcomes_)
                                         ? tr("%1 · %2").arg(text_of_kind(outcome.kind), responses)
                                         : responses)
                                .trimmed(),  // of a protocol without a title
                            list_);
    item->setToolTip(item->text());  // a long name is elided
  }
  stack_->setCurrentWidget(outcomes_.empty() ? none_ : both_);
  show_whether_exportable();
  list_->setCurrentRow(std::min(shown, list_->count() - 1));
  select_wanted();
  wanted_.clear();
  emit refreshed();
}

void AnalysisPage::show_whether_exportable() {
  report_->set_any(!outcomes_.empty());
  export_->setEnabled(!outcomes_.empty() && !exporting_.is_running());
  export_->setToolTip(outcomes_.empty()         ? tr("There are no sessions to export yet.")
                      : exporting_.is_running() ? tr("The tables are being written.")
                                                : QString());
}

void AnalysisPage::show_outcome(int index) {
  if (index < 0) return;
  const AnalysisOutcome& outcome = outcomes_.at(static_cast<std::size_t>(index));
  if (outcome.group == AnswerGroup::people && running_.contains(outcome.protocol)) {
    area_->setWidget(new EmptyState(
        tr("Blinding during a session"),
        tr("A session of the protocol %1 is running. The protocol's results are shown by name once "
           "the session has ended.")
            .arg(QString::fromStdString(outcome.protocol))));
    return;
  }
  const std::string kind =
      is_one_of_several_kinds(outcome, outcomes_) ? '_' + outcome.kind : std::string();
  const auto name_of = [start = outcome.protocol + '_' + outcome.version +
                                kind](const Figure& figure) { return start + '_' + figure.name; };
  area_->setWidget(make_outcome(
      outcome, {.save =
                    [this, name_of](const Figure& figure, double width_mm) {
                      figure_saver_->ask_where_to_save(figure, width_mm, name_of(figure));
                    },
                .copy = [this](const Figure& figure) { figure_saver_->copy(figure); }}));
}

std::vector<ShownCommand> AnalysisPage::commands() const {
  const std::filesystem::path& study = study_.folder();
  std::optional<std::string> protocol{};
  if (const int shown = list_->currentRow(); shown >= 0) {
    protocol = outcomes_.at(static_cast<std::size_t>(shown)).protocol;
  }
  return {{.action = tr("Analysis"), .line = analyze_line(study, protocol)},
          {.action = report_->verb(), .line = report_line(study, path_of_text(report_->file()))},
          {.action = export_->text(),
           .line = export_line(study, path_of_text(exported_to_), exported_)}};
}

void AnalysisPage::ask_where_to_export() {
  auto* dialog = new QFileDialog(this, tr("New folder for the tables"));
  dialog->setObjectName("export_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->selectFile("tables");
  auto* for_public =
      new QCheckBox(tr("For publication: without dates, free text and questionnaires"), dialog);
  for_public->setObjectName("export_public");
  auto* relabel = new QCheckBox(tr("New random labels for the participants"), dialog);
  relabel->setObjectName("export_relabel");
  auto* age_bands = new QCheckBox(tr("Ages in bands of at least five participants"), dialog);
  age_bands->setObjectName("export_age_bands");
  for (QCheckBox* const option : {relabel, age_bands}) {
    option->setEnabled(false);
    connect(for_public, &QCheckBox::toggled, option, &QWidget::setEnabled);
  }
  auto* recordings = new QCheckBox(tr("With tick-by-tick recordings (large files)"), dialog);
  recordings->setObjectName("export_recordings");
  if (auto* grid = qobject_cast<QGridLayout*>(dialog->layout())) {
    for (QCheckBox* const option : {for_public, relabel, age_bands, recordings}) {
      grid->addWidget(option, grid->rowCount(), 0, 1, grid->columnCount());
    }
  }
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, for_public, relabel, age_bands, recordings](const QString& folder) {
            ExportOptions options{};
            if (for_public->isChecked()) {
              options.audience =
                  relabel->isChecked() ? ExportAudience::relabelled : ExportAudience::published;
              options.random_bits = random_bits_of_this_machine();
              options.has_age_bands = age_bands->isChecked();
            }
            if (recordings->isChecked()) options.formats.insert(ExportFormat::physio);
            export_to(folder, options);
          });
  dialog->open();
}

void AnalysisPage::export_to(const QString& folder, const ExportOptions& options) {
  exported_to_ = folder;
  exported_ = options;
  writing_->set_words(tr("Writing the tables to %1 …").arg(folder));
  exporting_.run<Exported>(
      [study = study_.folder(), to = std::filesystem::path(folder.toStdString()), options](
          const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        const Study own = Study::open(study, Access::read_only);
        const ModelRegistry models = built_in_models();
        refuse_export(own, to, options);  // before it is listed
        ListedOutput listed(
            own, is_public(options.audience) ? OutputKind::public_export : OutputKind::export_, to);
        ExportOutcome outcome = export_study(own, models, to, options, stop, progress);
        Exported exported{.files = outcome.files.size(), .incomplete = std::move(outcome.warnings)};
        if (exported.files > 0) {
          exported.unrecorded = listed.complete();
          if (const auto missing = missing_metadata(own.metadata())) {
            exported.missing =
                phrase("AnalysisPage", "%1 Enter them with Study → Metadata…").with(*missing);
          }
        }
        return exported;
      },
      [this, folder](const Exported& exported) {
        if (exported.files == 0) {
          banner_->show_news(
              State::look,
              tr("Writing the tables was cancelled. No part of them remains in %1. To write them, "
                 "export the tables again.")
                  .arg(folder));
          return;
        }
        banner_->show_news(
            exported.has_remarks() ? State::look : State::fine,
            with_remark(with_remark(tr("%n files are in %1; codebook.tsv describes every column.",
                                       nullptr, static_cast<int>(exported.files))
                                            .arg(folder) +
                                        incomplete_text(exported.incomplete),
                                    exported.unrecorded),
                        exported.missing));
      },
      [this](const QString& what) { banner_->show_news(State::stop, what); });
}

}  // namespace asperity

#include "moc_analysis_page.cpp"

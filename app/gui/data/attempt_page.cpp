// Reads the recording in the background, and writes flags and exclusions of the attempt through a form.

#include "app/gui/data/attempt_page.h"

#include <memory>
#include <utility>

#include <QtWidgets/QFileDialog>
#include <QtWidgets/QTabBar>
#include <QtWidgets/QTabWidget>

#include "app/gui/data/attempt_tables.h"
#include "app/gui/data/attempt_words.h"
#include "app/gui/data/decision_form.h"
#include "app/gui/data/recording_view.h"
#include "app/gui/look/task_line.h"
#include "app/records/recording_curves.h"
#include "app/session/rig/recording_columns.h"
#include "app/tasks/study_overview.h"
#include "app/words/offered_reasons.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

struct Reading {
  AttemptDetail detail{};
  bool is_blind = false;  ///< the session is a run, and under way
};

/// The bands that the attempt was judged by; they are those of its trial, whatever the surface.
AskedBands bands_of(const AttemptRow& attempt) {
  AskedBands bands{};
  for (const ComplianceRow& row : attempt.compliance) {
    if (row.quantity == "normal_force_N") bands.force_N = {row.minimum, row.maximum};
    if (row.quantity == "speed_m_per_s") bands.speed_m_per_s = {row.minimum, row.maximum};
  }
  return bands;
}

std::vector<RecordingView::Surface> recorded_surfaces(const AttemptRow& attempt) {
  std::vector<RecordingView::Surface> surfaces{};
  for (const PresentationRow& row : attempt.presentations) {
    surfaces.push_back({row.position, AttemptWords::of_surface(row)});
  }
  return surfaces;
}

}  // namespace

AttemptPage::AttemptPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Attempt"), parent) {
  setObjectName("attempt_page");
  previous_ = make_button(tr("← Previous"), ButtonRole::plain, this);
  previous_->setObjectName("attempt_previous");
  next_ = make_button(tr("Next →"), ButtonRole::plain, this);
  next_->setObjectName("attempt_next");
  place_ = make_text({}, this, true);
  place_->setObjectName("attempt_place");
  place_->setWordWrap(false);
  QPushButton* back = make_button(tr("All trials of the session"), ButtonRole::link, this);
  back->setObjectName("attempt_back");
  head().addWidget(previous_);
  head().addWidget(place_);
  head().addWidget(next_);
  head().addSpacing(kMargin);
  head().addWidget(back);
  body().setSpacing(kGrid);
  band_ = new ModeBand(this);
  body().addWidget(band_);
  summary_ = make_text({}, this, true);
  summary_->setObjectName("attempt_summary");
  body().addWidget(summary_);
  names_ = new StateLabel(this);
  names_->setObjectName("attempt_names");
  names_->hide();  // until an attempt is shown that it is true of
  names_->set_state(State::look,
                    tr("Textures and models are shown by name, although the session is not "
                       "complete: an experimenter who resumes it is no longer blind to them."));
  body().addWidget(names_);
  add_actions();
  reading_line_ = new TaskLine(reading_, this);
  reading_line_->set_words(tr("Reading the recording…"));
  body().addWidget(reading_line_);
  writing_line_ = new TaskLine(exporting_, this);
  writing_line_->setObjectName("recording_writing");
  body().addWidget(writing_line_);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("attempt_tabs");
  tabs_->setAccessibleName(tr("Parts of the attempt"));
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setDrawBase(false);
  recording_ = new RecordingView(tabs_);
  measures_ = new MeasureTables(tabs_);
  history_ = new HistoryTables(tabs_);
  tabs_->addTab(recording_, tr("Recording"));
  tabs_->addTab(measures_, tr("Responses and measures"));
  tabs_->addTab(history_, tr("Events and decisions"));
  body().addWidget(tabs_, 1);
  connect(back, &QPushButton::clicked, this, &AttemptPage::back_wanted);
  connect(previous_, &QPushButton::clicked, this, [this] {
    if (detail_ && detail_->previous_id) show_attempt(*detail_->previous_id);
  });
  connect(next_, &QPushButton::clicked, this, [this] {
    if (detail_ && detail_->next_id) show_attempt(*detail_->next_id);
  });
  connect(recording_, &RecordingView::export_wanted, this, &AttemptPage::ask_where_to_export);
  connect(reading_line_, &TaskLine::cancelWanted, this, [this] {
    reading_.abandon();
    recording_of_.reset();
    recording_->show_reason(
        State::look, tr("Reading the recording was cancelled. Open the attempt again to read it."));
  });
  connect(writing_line_, &TaskLine::cancelWanted, &exporting_, &BackgroundTask::cancel);
}

void AttemptPage::add_actions() {
  auto* actions = new QHBoxLayout();
  actions->setSpacing(kGrid);
  standing_ = new StateLabel(this);
  standing_->setObjectName("attempt_standing");
  why_not_ = make_text({}, this, true);
  why_not_->setObjectName("attempt_why_not");
  why_not_->setWordWrap(false);
  flag_ = make_button(tr("Flag…"), ButtonRole::plain, this);
  flag_->setObjectName("attempt_flag");
  exclude_ = make_button(tr("Exclude…"), ButtonRole::plain, this);
  exclude_->setObjectName("attempt_exclude");
  actions->addWidget(standing_, 1);
  actions->addWidget(why_not_);
  actions->addWidget(flag_);
  actions->addWidget(exclude_);
  body().addLayout(actions);
  form_ = new DecisionForm(study(), this);
  body().addWidget(form_);
  connect(flag_, &QPushButton::clicked, this, &AttemptPage::ask_to_flag);
  connect(exclude_, &QPushButton::clicked, this, &AttemptPage::ask_to_exclude);
}

void AttemptPage::show_attempt(qlonglong attempt_id) {
  attempt_ = attempt_id;
  form_->cancel();
  forget_readings();
  read_with<Reading>(
      Need::always,
      [attempt_id](const Study& own, const std::stop_token&) {
        Reading reading{};
        reading.detail = attempt_detail(own, attempt_id);
        reading.is_blind = is_blind(own, reading.detail.session);
        return reading;
      },
      [this](const Reading& reading) {
        if (reading.is_blind) {
          show_blind(reading.detail);
        } else {
          show_detail(reading.detail);
        }
      });
}

void AttemptPage::show_blind(const AttemptDetail& detail) {
  detail_.reset();
  recording_of_.reset();
  form_->cancel();
  title().setText(AttemptWords::title(detail));
  place_->clear();
  band_->set_mode(detail.session.mode);
  summary_->clear();
  names_->hide();
  tabs_->hide();
  standing_->set_state(State::look, tr("The session is running, and its experimenter is blind: "
                                       "stimuli and responses are shown here once it has ended."));
  why_not_->clear();
  for (QPushButton* button : {previous_, next_, flag_, exclude_}) button->setEnabled(false);
}

void AttemptPage::show_detail(const AttemptDetail& detail) {
  detail_ = detail;
  tabs_->show();
  flag_->setEnabled(true);
  title().setText(AttemptWords::title(detail));
  place_->setText(tr("%1 of %2").arg(detail.ordinal).arg(detail.count));
  previous_->setEnabled(detail.previous_id.has_value());
  next_->setEnabled(detail.next_id.has_value());
  band_->set_mode(detail.session.mode);
  summary_->setText(AttemptWords::summary(detail));
  names_->setVisible(detail.session.state != SessionState::completed);
  show_actions();
  measures_->show_attempt(detail);
  history_->show_attempt(detail);
  tabs_->setTabText(
      2,
      tr("Events and decisions (%1)").arg(detail.attempt.events.size() + detail.decisions.size()));
  read_recording_of(detail.attempt);
}

void AttemptPage::show_actions() {
  const AttemptDetail& detail = *detail_;
  standing_->set_state(AttemptWords::state(detail), AttemptWords::standing(detail));
  const bool excluded = detail.is_excluded_itself();
  exclude_->setText(excluded ? tr("Include again…") : tr("Exclude…"));
  QString why_not{};
  if (!excluded && detail.session.excluded) {
    why_not = tr("The whole session is excluded; it can be included again on its page.");
  } else if (!excluded && !detail.attempt.valid) {
    why_not = tr("There is nothing to exclude: the attempt is not counted.");
  }
  exclude_->setEnabled(why_not.isEmpty());
  why_not_->setText(why_not);
}

void AttemptPage::read_recording_of(const AttemptRow& attempt) {
  if (recording_of_ == attempt.id) return;  // a recording never changes
  recording_of_ = attempt.id;
  if (!attempt.recording) {
    recording_->show_reason(State::unknown, tr("This attempt has no recording. Its responses and "
                                               "measures are on the next page."));
    return;
  }
  recording_->show_reason(State::unknown, tr("Reading the recording…"));
  reading_.run<std::shared_ptr<const RecordingCurves>>(
      [folder = study().folder(), row = *attempt.recording, begin_ns = attempt.onset_ns](
          const std::stop_token&, const BackgroundTask::Progress&) {
        const Recording recording = recording_of(folder, row);
        return std::make_shared<const RecordingCurves>(curves_of(
            records_of(recording, folder / row.path), recording.header.rate_Hz, begin_ns));
      },
      [this, id = attempt.id](std::shared_ptr<const RecordingCurves> curves) {
        if (recording_of_ != id) return;  // another attempt is shown by now
        if (curves->time_s.empty()) {
          recording_->show_reason(State::unknown, tr("The recording of this attempt is empty: "
                                                     "the attempt ended before the first tick."));
          return;
        }
        recording_->show_recording(std::move(curves), recorded_surfaces(detail_->attempt),
                                   bands_of(detail_->attempt));
      },
      [this, id = attempt.id](const QString& what) {
        if (recording_of_ != id) return;
        recording_->show_reason(
            State::stop, tr("The recording cannot be shown: %1. The responses and measures of "
                            "the attempt are stored and not affected.")
                             .arg(what));
      });
}

void AttemptPage::ask_to_flag() {
  if (!detail_) return;
  DecisionForm::Question question{};
  question.session_id = detail_->session.id;
  question.draft = {.trial = detail_->attempt.trial,
                    .attempt = detail_->attempt.attempt,
                    .verdict = Verdict::flag};
  question.text = tr("Reason for flagging the attempt. It remains in the analyses.");
  question.offered = offered_reasons(ReasonFor::flagging);
  question.verb = tr("Flag attempt");
  form_->ask(question);
}

void AttemptPage::ask_to_exclude() {
  if (!detail_) return;
  const bool excluded = detail_->is_excluded_itself();
  DecisionForm::Question question{};
  question.session_id = detail_->session.id;
  question.draft = {.trial = detail_->attempt.trial,
                    .attempt = detail_->attempt.attempt,
                    .verdict = excluded ? Verdict::include : Verdict::exclude};
  if (excluded) {
    question.text = tr("Reason for including the attempt in the analyses again");
    question.offered = offered_reasons(ReasonFor::including);
    question.verb = tr("Include attempt");
  } else {
    question.text =
        tr("Reason for excluding the attempt from the analyses. It remains in the study and can be "
           "included again.");
    question.offered = offered_reasons(ReasonFor::excluding_attempt);
    question.verb = tr("Exclude attempt");
  }
  form_->ask(question);
}

void AttemptPage::ask_where_to_export() {
  auto* dialog = new QFileDialog(this, tr("File for the table"));
  dialog->setObjectName("recording_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->setNameFilter(tr("Tab-separated table (*.tsv)"));
  dialog->setDefaultSuffix("tsv");
  const std::filesystem::path recording(detail_->attempt.recording->path);
  dialog->selectFile(QString::fromStdString(recording.stem().string()) + ".tsv");
  connect(dialog, &QFileDialog::fileSelected, this, &AttemptPage::export_to);
  dialog->open();
}

void AttemptPage::export_to(const QString& file) {
  writing_line_->set_words(tr("Writing %1 …").arg(file));
  exporting_.run<std::optional<std::size_t>>(
      [folder = study().folder(), row = *detail_->attempt.recording,
       to = std::filesystem::path(file.toStdString())](
          const std::stop_token& stop,
          const BackgroundTask::Progress& progress) -> std::optional<std::size_t> {
        const Table table = table_of(recording_of(folder, row));
        progress(0.3);
        const std::string text = tsv_of(table);
        progress(0.9);
        if (stop.stop_requested()) return {};
        write_file(to, text, Overwrite::allow);  // the dialog has asked
        return table.rows.size();
      },
      [this, file](const std::optional<std::size_t>& ticks) {
        if (!ticks) {
          banner().show_news(
              State::look,
              tr("Writing %1 was cancelled. To write the table, export the recording again.")
                  .arg(file));
          return;
        }
        banner().show_news(
            State::fine,
            tr("%n tick(s) are in %1; docs/formats/recording.md describes the columns.", nullptr,
               static_cast<int>(*ticks))
                .arg(file));
      },
      [this](const QString& what) { banner().show_news(State::stop, what); });
}

}  // namespace asperity

#include "moc_attempt_page.cpp"

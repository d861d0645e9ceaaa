// Fills a table with one row per attempt; a blind session shows only its progress.

#include "app/gui/study/trials_page.h"

#include <algorithm>

#include <QtCore/QRegularExpression>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QTabBar>
#include <QtWidgets/QTabWidget>
#include <nlohmann/json.hpp>

#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/data/attempt_words.h"
#include "app/gui/data/decision_form.h"
#include "app/gui/look/outcome_words.h"
#include "app/gui/look/words.h"
#include "app/gui/study/sessions_page.h"
#include "app/words/offered_reasons.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr int kAnswerColumnWidth = 120;
constexpr int kConditionWidth = 144;
constexpr int kAfterContactColumn = 7;
constexpr int kAfterCueColumn = 8;
constexpr int kBeganColumn = 9;
constexpr int kTrackColumn = 10;
constexpr int kRoomForAll = 1480;  // of the table

double since_start_s(const SessionDetail& detail, std::int64_t time_ns) {
  return static_cast<double>(time_ns - detail.overview.row.clock_zero_ns) * 1e-9;
}

/// "18:42", minutes and seconds of the session.
QString text_of_clock(double time_s) {
  const auto whole_s = static_cast<long>(std::max(0.0, time_s));
  return QString("%1:%2").arg(whole_s / 60).arg(whole_s % 60, 2, 10, QChar('0'));
}

QStandardItem* clock_cell(double time_s) { return number_cell(text_of_clock(time_s), time_s); }

QStandardItem* seconds_cell(const std::optional<double>& time_s) {
  return time_s ? number_cell(shown_number(*time_s, 'f', 2), *time_s) : empty_number_cell();
}

QString text_of_outcome(const SessionOverview& session, const TrialOverview& trial) {
  if (!trial.attempt) {
    return session.row.state == SessionState::completed ? TrialsPage::tr("not needed")
                                                        : TrialsPage::tr("pending");
  }
  return OutcomeWords::of(trial.attempt->outcome);
}

/// What is to be said of the attempt beside its outcome.
QString text_of_remarks(const PlannedTrialRow& planned, const AttemptRow& attempt) {
  QStringList remarks{};
  if (planned.is_catch) {
    remarks.append(TrialsPage::tr("catch trial"));
  } else if (planned.repetition == 0) {
    remarks.append(TrialsPage::tr("anchor"));
  }
  if (attempt.purpose == AttemptPurpose::refresher) {
    remarks.append(TrialsPage::tr("repeated practice"));
  }
  if (!attempt.valid) {
    remarks.append(
        TrialsPage::tr("not valid: %1").arg(OutcomeWords::of_reason(attempt.invalid_reason)));
  }
  if (attempt.flagged) {
    remarks.append(TrialsPage::tr("flagged: %1").arg(OutcomeWords::of_reason(attempt.flag_reason)));
  }
  if (attempt.excluded) {
    remarks.append(TrialsPage::tr("excluded: %1").arg(OutcomeWords::of_reason(attempt.excluded)));
  }
  return remarks.join("; ");
}

/// "column 1, texture metal", "amplitude 87.5 µm": the levels of the trial's factors.
QString text_of_condition(const PlannedTrialRow& planned) {
  QStringList levels{};
  const auto factors = nlohmann::ordered_json::parse(planned.factors_json, nullptr, false);
  for (const auto& [name, level] : factors.items()) {
    levels.append(
        level.is_number()
            ? text_of_level(name, level.get<double>())
            : text(name + ' ' + (level.is_string() ? level.get<std::string>() : level.dump())));
  }
  return levels.join(", ");
}

/// "2, step 5"
QStandardItem* track_cell(const PlannedTrialRow& planned) {
  if (!planned.track || !planned.step) return text_cell(QString("–"), 0);
  QStandardItem* cell =
      text_cell(TrialsPage::tr("%1, step %2").arg(*planned.track).arg(*planned.step),
                1000 * *planned.track + *planned.step);
  cell->setToolTip(TrialsPage::tr("Track %1 of the procedure, trial %2 of the track")
                       .arg(*planned.track)
                       .arg(*planned.step));
  return cell;
}

constexpr const char* kHidden = "▒▒▒";

/// What is known before the session has ended: how far it is.
StudyTable::Row blind_row_of(const SessionDetail& detail, const TrialOverview& trial) {
  const auto& attempt = trial.attempt;
  const auto hidden_if = [](bool there) { return text_cell(there ? QString(kHidden) : QString()); };
  QStandardItem* outcome = text_cell(text_of_outcome(detail.overview, trial));
  if (!attempt) outcome->setForeground(theme().muted);
  return {attempt ? QString::number(attempt->id) : QString{},
          {number_cell(trial.planned.trial),
           attempt ? number_cell(attempt->attempt) : empty_number_cell(),
           text_cell(TrialsPage::tr("block %1").arg(trial.planned.block_ordinal)),
           hidden_if(!text_of_condition(trial.planned).isEmpty()), outcome,
           hidden_if(attempt && !attempt->responses.empty()), text_cell(QString("–")),
           empty_number_cell(), empty_number_cell(),
           attempt ? clock_cell(since_start_s(detail, attempt->onset_ns)) : empty_number_cell(),
           empty_number_cell(), hidden_if(attempt && (!attempt->valid || attempt->flagged))}};
}

StudyTable::Row trial_row(const SessionDetail& detail, const TrialOverview& trial) {
  const auto& attempt = trial.attempt;
  const std::optional<bool> correct = trial.correct();
  const QString right = !correct   ? QString("–")
                        : *correct ? TrialsPage::tr("yes")
                                   : TrialsPage::tr("no");
  std::optional<double> from_contact_s{};
  std::optional<double> from_cue_s{};
  if (attempt && !attempt->responses.empty()) {
    from_contact_s = attempt->responses.back().from_contact_s;
    from_cue_s = attempt->responses.back().from_cue_s;
  }
  QStandardItem* outcome = text_cell(text_of_outcome(detail.overview, trial));
  if (!attempt) outcome->setForeground(theme().muted);
  const QString remarks = attempt ? text_of_remarks(trial.planned, *attempt) : QString{};
  QStandardItem* remark_cell = text_cell(remarks);
  remark_cell->setForeground(theme().look);
  StudyTable::Row row{
      attempt ? QString::number(attempt->id) : QString{},
      {number_cell(trial.planned.trial),
       attempt ? number_cell(attempt->attempt) : empty_number_cell(),
       text_cell(text(trial.planned.block)), text_cell(text_of_condition(trial.planned)), outcome,
       text_cell(attempt ? OutcomeWords::of_responses(attempt->responses) : QString()),
       text_cell(right), seconds_cell(from_contact_s), seconds_cell(from_cue_s),
       attempt ? clock_cell(since_start_s(detail, attempt->onset_ns)) : empty_number_cell(),
       track_cell(trial.planned)}};
  if (attempt && attempt->excluded) strike_through(row.cells);
  row.cells << remark_cell;
  return row;
}

}  // namespace

TrialsPage::TrialsPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Session"), parent) {
  setObjectName("trials_page");
  QPushButton* back = make_button(tr("← All sessions"), ButtonRole::link, this);
  back->setObjectName("trials_back");
  filter_ = new QLineEdit(this);
  filter_->setObjectName("trials_filter");
  filter_->setAccessibleName(tr("Filter"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setClearButtonEnabled(true);
  filter_->setFixedWidth(240);
  head().addWidget(filter_);
  head().addWidget(back);
  setTabOrder(filter_, back);

  band_ = new ModeBand(this);
  body().addWidget(band_);
  summary_ = make_text({}, this, true);
  summary_->setObjectName("trials_summary");
  body().addWidget(summary_);
  standing_ = new StateLabel(this);
  standing_->setObjectName("trials_standing");
  body().addWidget(standing_);
  form_ = new DecisionForm(study, this);
  body().addWidget(form_);
  tabs_ = new QTabWidget(this);
  tabs_->setAccessibleName(tr("Parts of the session"));
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setDrawBase(false);
  using Align = StudyTable::Align;
  trials_ = new StudyTable({{tr("Trial"), 80, Align::number},
                            {tr("Attempt"), 96, Align::number},
                            {tr("Block"), 112, Align::text},
                            {tr("Condition"), kConditionWidth, Align::text},
                            {tr("Outcome"), 120, Align::text},
                            {tr("Response"), kAnswerColumnWidth, Align::text},
                            {tr("Correct"), 64, Align::text},
                            {AttemptWords::after_contact(), 152, Align::number},
                            {AttemptWords::after_cue(), 120, Align::number},
                            {tr("Began"), 88, Align::number},
                            {tr("Track"), 88, Align::text},
                            {tr("Remarks"), 0, Align::text}},
                           tabs_);
  trials_->setObjectName("trials_table");
  trials_->setAccessibleName(tr("Trials"));
  AttemptWords::explain_times(*trials_->model(), kAfterContactColumn, kAfterCueColumn);
  // A matching has an answer per surface: they go on in the next line, and where there is little room
  // what the page of the attempt says as well makes way for them.
  trials_->wrap_texts();
  for (const int column : {kAfterContactColumn, kAfterCueColumn, kBeganColumn}) {
    trials_->hide_when_narrower(column, kRoomForAll);
  }
  tabs_->addTab(trials_, tr("Trials"));
  events_ = new StudyTable({{tr("Time"), 88, Align::number},
                            {tr("Event"), 200, Align::text},
                            {tr("Text"), 0, Align::text}},
                           tabs_);
  events_->setObjectName("trials_events");
  events_->setAccessibleName(tr("Notes and events"));
  tabs_->addTab(events_, tr("Notes and events"));
  body().addWidget(tabs_, 1);
  selected_ = make_text({}, this, true);
  selected_->setObjectName("trials_selected");
  open_ = make_button(tr("Show attempt"), ButtonRole::primary, this);
  open_->setObjectName("trials_open");
  exclude_ = make_button(tr("Exclude session…"), ButtonRole::plain, this);
  exclude_->setObjectName("trials_exclude");
  exclude_->setEnabled(study.can_be_written());
  auto* below = new QHBoxLayout();
  below->setSpacing(kMargin);
  below->addWidget(open_);
  below->addWidget(selected_, 1);
  if (!study.can_be_written()) {
    below->addWidget(make_text(
        tr("This study is read-only; copy it to a folder that you may write to."), this, true));
  }
  below->addWidget(exclude_);
  body().addLayout(below);

  connect(trials_, &StudyTable::row_selected, this, &TrialsPage::show_selected);
  connect(back, &QPushButton::clicked, this, &TrialsPage::back_wanted);
  connect(filter_, &QLineEdit::textChanged, trials_, &StudyTable::set_filter);
  connect(filter_, &QLineEdit::textChanged, events_, &StudyTable::set_filter);
  connect(trials_, &StudyTable::row_opened, this, [this](const QString& key) {
    if (!key.isEmpty() && open_->isEnabled()) emit attempt_opened(key.toLongLong());
  });
  connect(open_, &QPushButton::clicked, this,
          [this] { emit attempt_opened(trials_->selected_key().toLongLong()); });
  connect(exclude_, &QPushButton::clicked, this, &TrialsPage::ask_to_exclude);
}

void TrialsPage::show_session(std::int64_t id) {
  session_id_ = id;
  form_->cancel();
  filter_->clear();
  forget_readings();
  read_with<SessionDetail>(
      Need::always,
      [id](const Study& own, const std::stop_token&) { return session_detail(own, id); },
      [this](const SessionDetail& detail) { show_detail(detail); });
}

// Answers to several questions and reasons are longer than their columns.
void TrialsPage::show_selected() {
  const std::int64_t id = trials_->selected_key().toLongLong();
  const auto found = std::find_if(
      detail_.trials.begin(), detail_.trials.end(),
      [id](const TrialOverview& trial) { return trial.attempt && trial.attempt->id == id; });
  open_->setEnabled(found != detail_.trials.end() && !detail_.overview.is_blind());
  if (detail_.overview.is_blind()) {
    selected_->setText(tr("Stimuli and responses are shown once the session has ended."));
    return;
  }
  if (found == detail_.trials.end()) {
    selected_->setText(tr("To show details, select a trial that has begun."));
    return;
  }
  const QString remarks = text_of_remarks(found->planned, *found->attempt);
  selected_->setText(
      tr("Trial %1, attempt %2: %3")
          .arg(found->planned.trial)
          .arg(found->attempt->attempt)
          .arg(QStringList{text_of_outcome(detail_.overview, *found),
                           OutcomeWords::of_responses(found->attempt->responses), remarks}
                   .filter(QRegularExpression("."))
                   .join("; ")));
}

void TrialsPage::ask_to_exclude() {
  const bool excluded = detail_.overview.row.excluded.has_value();
  DecisionForm::Question question{};
  question.session_id = detail_.overview.row.id;
  question.draft.verdict = excluded ? Verdict::include : Verdict::exclude;
  if (excluded) {
    question.text = tr("Reason for including the session in the analyses again");
    question.offered = offered_reasons(ReasonFor::including);
    question.verb = tr("Include session");
  } else {
    question.text =
        tr("Reason for excluding the whole session from the analyses. It remains in the study and "
           "can be included again.");
    question.offered = offered_reasons(ReasonFor::excluding_session);
    question.verb = tr("Exclude session");
  }
  form_->ask(question);
}

void TrialsPage::show_detail(const SessionDetail& detail) {
  detail_ = detail;
  const SessionOverview& session = detail.overview;
  title().setText(
      tr("Session %1 of %2").arg(session.row.session).arg(text(session.row.participant)));
  band_->set_mode(session.row.mode);
  const QString started = has_made_up_dates(session.row)
                              ? tr("on a simulated clock")
                              : tr("started %1").arg(text_of_time(session.row.started_utc));
  const QString trials =
      session.trials_not_needed() > 0
          ? tr("%1 (%2 not needed)").arg(session.done_trials).arg(session.trials_not_needed())
          : tr("%1 of %2").arg(session.done_trials).arg(session.planned_trials);
  summary_->setText(tr("%1 %2 · %3 · trials: %4 in %5 · %6 · device %7 · asperity %8")
                        .arg(text(session.protocol_name), text(session.protocol_version),
                             text_of_session_state(session), trials)
                        .arg(text_of_duration(session.duration_s), started,
                             text(session.row.device), text(session.row.program_version)));
  const bool blind = session.is_blind();
  const auto& excluded = session.row.excluded;
  standing_->setVisible(blind || excluded);
  if (blind) {
    standing_->set_state(State::look,
                         tr("The session is running, and its experimenter is blind: until it ends, "
                            "only its own window shows its data, as far as the blinding permits."));
  } else if (excluded) {
    standing_->set_state(State::stop, tr("The whole session is excluded from analyses: %1")
                                          .arg(OutcomeWords::of_reason(excluded)));
  }
  exclude_->setText(excluded ? tr("Include session again…") : tr("Exclude session…"));
  std::vector<StudyTable::Row> rows{};
  for (const TrialOverview& trial : detail.trials) {
    rows.push_back(blind ? blind_row_of(detail, trial) : trial_row(detail, trial));
  }
  trials_->setColumnHidden(kTrackColumn,
                           blind || std::none_of(detail.trials.begin(), detail.trials.end(),
                                                 [](const TrialOverview& trial) {
                                                   return trial.planned.track.has_value();
                                                 }));
  trials_->fill(rows);
  rows.clear();
  for (std::size_t i = 0; i < detail.events.size(); ++i) {
    const EventRow& event = detail.events[i];
    const bool is_hidden = blind && event.kind != "note" && !event.text.empty();
    rows.push_back({QString::number(i),
                    {clock_cell(since_start_s(detail, event.time_ns)), text_cell(text(event.kind)),
                     text_cell(is_hidden ? QString(kHidden) : OutcomeWords::of_event(event))}});
  }
  events_->fill(rows);
  tabs_->setTabText(1, tr("Notes and events (%1)").arg(detail.events.size()));
}

}  // namespace asperity

#include "moc_trials_page.cpp"

// Fills a table with one row per session, and offers actions for the selected one.

#include "app/gui/study/sessions_page.h"

#include <algorithm>

#include <QtGui/QPainter>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QStyledItemDelegate>

#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/outcome_words.h"

namespace asperity {

namespace {

/// A style sheet for items leaves out the ground that a cell asks for.
class BandDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const QVariant band = index.data(Qt::BackgroundRole);
    if (band.isValid()) painter->fillRect(option.rect, band.value<QBrush>());
    QStyledItemDelegate::paint(painter, option, index);
  }
};

/// In the colour of the band that the session's windows had.
QStandardItem* mode_cell(SessionMode mode) {
  QStandardItem* cell = text_cell(text_of_mode(mode));
  if (mode != SessionMode::run) {
    cell->setBackground(mode == SessionMode::pilot ? theme().pilot : theme().simulated);
    cell->setForeground(theme().on_band);
  }
  return cell;
}

QStandardItem* session_state_cell(const SessionOverview& session) {
  if (session.row.excluded) {
    const QString excluded = SessionsPage::tr("excluded");
    QStandardItem* cell = text_cell(shape_of(State::stop) + ' ' + excluded, excluded);
    cell->setForeground(theme().stop);
    cell->setToolTip(
        SessionsPage::tr("%1; excluded from analyses: %2")
            .arg(text_of_session_state(session), OutcomeWords::of_reason(session.row.excluded)));
    return cell;
  }
  const State state = state_of_session(session);
  const QString text = text_of_session_state(session);
  QStandardItem* cell = text_cell(shape_of(state) + ' ' + text, text);
  if (state == State::look) cell->setForeground(theme().look);
  return cell;
}

}  // namespace

QString text_of_mode(SessionMode mode) {
  switch (mode) {
    case SessionMode::run:
      return SessionsPage::tr("Run");
    case SessionMode::pilot:
      return SessionsPage::tr("Pilot");
    case SessionMode::simulate:
      break;
  }
  return SessionsPage::tr("Simulated");
}

QString text_of_trials(const SessionOverview& session) {
  if (session.trials_not_needed() > 0) {
    return SessionsPage::
        tr("Trials completed and stored: %1. Further trials in the plan: %2, not needed, because "
           "the criterion of their block was reached or could no longer be.")
            .arg(session.done_trials)
            .arg(session.trials_not_needed());
  }
  return (session.planned_is_estimated
              ? SessionsPage::tr("Trials completed and stored: %1 of about %2.")
              : SessionsPage::tr("Trials completed and stored: %1 of %2."))
      .arg(session.done_trials)
      .arg(session.planned_trials);
}

QString text_of_session_state(const SessionOverview& session) {
  if (session.is_running) {
    return SessionsPage::tr("running now");
  }
  switch (session.row.state) {
    case SessionState::completed:
      return SessionsPage::tr("complete");
    case SessionState::stopped:
      return SessionsPage::tr("stopped");
    case SessionState::open:  // nobody holds it: whoever ran it is gone
    case SessionState::crashed:
      break;
  }
  return SessionsPage::tr("interrupted");
}

State state_of_session(const SessionOverview& session) {
  if (session.is_running) return State::unknown;
  return session.row.state == SessionState::completed ? State::fine : State::look;
}

SessionsPage::SessionsPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Sessions"), parent) {
  setObjectName("sessions_page");
  set_empty_state(new EmptyState(
      tr("No sessions yet"),
      tr("Choose a protocol on the Protocols page and press “Start session…”. To preview the "
         "results, press “Simulate…” there: a simulation takes minutes, a session about an hour."),
      this));
  filter_ = new QLineEdit(this);
  filter_->setObjectName("sessions_filter");
  filter_->setAccessibleName(tr("Filter"));
  filter_->setPlaceholderText(tr("Filter: participant, protocol, state"));
  filter_->setClearButtonEnabled(true);
  filter_->setFixedWidth(320);
  head().addWidget(filter_);

  using Align = StudyTable::Align;
  table_ = new StudyTable({{tr("Participant"), 112, Align::text},
                           {tr("No."), 56, Align::number},
                           {tr("Protocol"), 0, Align::text},
                           {tr("Mode"), 104, Align::text},
                           {tr("State"), 128, Align::text},
                           {tr("Started"), 176, Align::text},
                           {tr("Duration"), 96, Align::number},
                           {tr("Trials"), 96, Align::number},
                           {tr("Notes"), 72, Align::number}},
                          this);
  table_->setObjectName("sessions_table");
  table_->setAccessibleName(tr("Sessions"));
  table_->leave_out_when_tight({6, 8});  // the page of the session's trials says them as well
  table_->sortByColumn(5, Qt::DescendingOrder);
  table_->setItemDelegateForColumn(3, new BandDelegate(table_));
  body().addWidget(table_, 1);

  auto* below = new QHBoxLayout();
  below->setSpacing(kGrid);
  open_ = make_button(tr("Show trials"), ButtonRole::primary, this);
  open_->setObjectName("sessions_open");
  resume_ = make_button(tr("Resume this session…"), ButtonRole::plain, this);
  resume_->setObjectName("sessions_resume");
  reason_ = make_text({}, this, true);
  reason_->setObjectName("sessions_reason");
  below->addWidget(open_);
  below->addWidget(resume_);
  below->addSpacing(kGrid);
  below->addWidget(reason_, 1);
  body().addLayout(below);

  connect(filter_, &QLineEdit::textChanged, table_, &StudyTable::set_filter);
  connect(table_, &StudyTable::row_selected, this, &SessionsPage::show_selected);
  connect(table_, &StudyTable::row_opened, this, [this] { open_->click(); });
  connect(open_, &QPushButton::clicked, this,
          [this] { emit session_opened(table_->selected_key().toLongLong()); });
  connect(resume_, &QPushButton::clicked, this, [this] {
    const SessionOverview* session = selected();
    if (session == nullptr || !session->protocol_file) return;
    emit session_wanted({.protocol = *session->protocol_file,
                         .participant = session->row.participant,
                         .session = session->row.id});
  });
  read_with<std::vector<SessionOverview>>(
      Need::always,
      [](const Study& own, const std::stop_token& stop) { return session_overviews(own, stop); },
      [this](const std::vector<SessionOverview>& sessions) { show_sessions(sessions); });
}

void SessionsPage::set_filter(const QString& words) { filter_->setText(words); }

void SessionsPage::show_sessions(const std::vector<SessionOverview>& sessions) {
  sessions_ = sessions;
  std::vector<StudyTable::Row> rows{};
  for (const SessionOverview& session : sessions_) {
    QStandardItem* trials =
        number_cell(session.trials_not_needed() > 0
                        ? QString::number(session.done_trials)
                        : (session.planned_is_estimated ? tr("%1 of about %2") : tr("%1 of %2"))
                              .arg(session.done_trials)
                              .arg(session.planned_trials),
                    session.done_trials);
    if (session.trials_not_needed() > 0) trials->setToolTip(text_of_trials(session));
    rows.push_back(
        {QString::number(session.row.id),
         {text_cell(QString::fromStdString(session.row.participant)),
          number_cell(session.row.session),
          text_cell(QString::fromStdString(session.protocol_name + ' ' + session.protocol_version)),
          mode_cell(session.row.mode), session_state_cell(session),
          text_cell(text_of_start(session.row), order_of_start(session.row)),
          number_cell(text_of_duration(session.duration_s), session.duration_s), trials,
          number_cell(session.notes)}});
  }
  table_->fill(rows);
  show_empty(sessions_.empty());
  // As the participants are counted.
  const auto simulated = std::count_if(
      sessions_.begin(), sessions_.end(),
      [](const SessionOverview& session) { return session.row.mode == SessionMode::simulate; });
  const auto of_people = static_cast<std::ptrdiff_t>(sessions_.size()) - simulated;
  emit counted(of_people == 0 && simulated > 0 ? tr("%1 virtual").arg(simulated)
                                               : QString::number(of_people));
}

const SessionOverview* SessionsPage::selected() const {
  const auto found =
      std::find_if(sessions_.begin(), sessions_.end(),
                   [id = table_->selected_key().toLongLong()](const SessionOverview& session) {
                     return session.row.id == id;
                   });
  return found == sessions_.end() ? nullptr : &*found;
}

void SessionsPage::show_selected() {
  const SessionOverview* session = selected();
  const bool is_blind = session != nullptr && session->is_blind();
  open_->setEnabled(session != nullptr && !is_blind);
  resume_->setEnabled(session != nullptr && session->is_unfinished() && session->protocol_file &&
                      study().can_be_written());
  if (session == nullptr) {
    reason_->setText(tr("Select a session."));
  } else if (is_blind) {
    reason_->setText(
        tr("The session is running: until it ends, only its own window shows its data, as far as "
           "the blinding permits."));
  } else if (session->is_running) {
    reason_->setText(
        tr("The session is running, here or in another program; wait until it has ended, or stop "
           "it there."));
  } else if (session->row.state == SessionState::completed) {
    const QString complete = tr("The session is complete: there is nothing to resume.");
    reason_->setText(session->trials_not_needed() > 0 ? text_of_trials(*session) + ' ' + complete
                                                      : complete);
  } else if (session->ended_by_rule) {
    reason_->setText(
        tr("The session has ended as its protocol specifies: there is nothing to resume."));
  } else if (!session->protocol_file) {
    reason_->setText(tr("None of the study's protocols has the text that the session began with. "
                        "Restore %1 version %2 to resume.")
                         .arg(QString::fromStdString(session->protocol_name),
                              QString::fromStdString(session->protocol_version)));
  } else if (!study().can_be_written()) {
    reason_->setText(
        tr("This study is read-only: no session can be stored. Copy it to a folder that you may "
           "write to."));
  } else {
    reason_->setText(text_of_trials(*session));
  }
}

}  // namespace asperity

#include "moc_sessions_page.cpp"

// Updates labels only if their text is new, and shortens the protocol's title to the width.

#include "app/gui/session/session_header.h"

#include <algorithm>
#include <utility>

#include <QtCore/QEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/look/fitted_label.h"
#include "app/gui/session/session_text.h"

namespace asperity {

namespace {

constexpr int kEmergencyHeight = 54;

void set_if_new(QLabel& label, const QString& text) {
  if (label.text() != text) label.setText(text);
}

}  // namespace

SessionHeader::SessionHeader(QWidget* parent) : QWidget(parent) {
  grid_ = new QGridLayout(this);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(kMargin);
  grid_->setVerticalSpacing(kGrid / 2);
  make_emergency_stop();
  make_labels();
  counts_ = new QHBoxLayout();
  counts_->addWidget(block_);
  counts_->addWidget(progress_, 1);
  for (QLabel* label : {trial_, elapsed_, left_}) counts_->addWidget(label);
  set_form(SessionForm::wide);
}

void SessionHeader::make_emergency_stop() {
  emergency_ = make_button(QString("%1\n%2").arg(tr("■ EMERGENCY STOP"), tr("F12 from any window")),
                           ButtonRole::danger, this);
  emergency_->setObjectName("emergency_stop");
  emergency_->setFont(text_font(TextSize::small));
  emergency_->setStyleSheet("padding: 0 8px;");
  emergency_->setMinimumHeight(kEmergencyHeight);
  emergency_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  emergency_->setFocusPolicy(Qt::NoFocus);  // a key that goes astray does not press it
  emergency_->setToolTip(
      tr("Sets the force to zero at once, from any window. F12, Pause/Break and Ctrl+Space do the "
         "same."));
  connect(emergency_, &QPushButton::pressed, this, &SessionHeader::emergency);
}

void SessionHeader::make_labels() {
  title_ = make_heading(tr("Session"), this);
  title_->setObjectName("session_title");
  title_->setWordWrap(false);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  title_->installEventFilter(this);
  blindness_ = new FittedLabel(this);
  blindness_->setObjectName("blindness");
  unblind_ = make_button({}, ButtonRole::plain, this);
  unblind_->setObjectName("unblind");
  unblind_->setFocusPolicy(Qt::TabFocus);
  connect(unblind_, &QPushButton::clicked, this, &SessionHeader::unblind_pressed);
  progress_ = new QProgressBar(this);
  progress_->setTextVisible(false);
  progress_->setObjectName("progress");
  progress_->setMinimumWidth(kGroupGap);
  const auto add_count = [this](const char* name) {
    auto* label = new QLabel(this);
    label->setObjectName(name);
    return label;
  };
  block_ = add_count("block");
  trial_ = add_count("trial");
  elapsed_ = add_count("elapsed");
  left_ = add_count("left");
  now_ = new FittedLabel(this);
  now_->setObjectName("now");
  pending_ = new FittedLabel(this);
  pending_->setObjectName("pending");
  now_->setFont(text_font(TextSize::heading, true));
  now_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  now_->set_smaller_font(text_font(TextSize::body, true));
}

void SessionHeader::set_form(SessionForm form) {
  if (form == form_) return;
  form_ = form;
  const bool wide = form == SessionForm::wide;
  const bool narrow = form == SessionForm::narrow;
  // Whatever stands in the grid is taken out of it first: a cell keeps what it had.
  while (QLayoutItem* item = grid_->takeAt(0)) {
    if (item != counts_) delete item;
  }
  for (QLabel* label : {block_, trial_, elapsed_, left_}) {
    label->setFont(text_font(narrow ? TextSize::small : TextSize::body));
  }
  unblind_->setFont(text_font(narrow ? TextSize::small : TextSize::body));
  counts_->setSpacing(narrow ? kMargin : kGroupGap);
  blindness_->setAlignment((wide ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  pending_->setFont(text_font(narrow ? TextSize::body : TextSize::heading, true));
  pending_->setAlignment(wide ? Qt::AlignRight | Qt::AlignVCenter
                              : Qt::AlignLeft | Qt::AlignVCenter);
  grid_->addWidget(emergency_, 0, 0, 3, 1);
  if (wide) {
    grid_->setRowMinimumHeight(3, 0);
    // The title has the room of its row.
    grid_->addWidget(title_, 0, 1);
    grid_->addWidget(unblind_, 0, 2);
    grid_->addLayout(counts_, 1, 1, 1, 2);
    auto* states = new QHBoxLayout();
    states->setSpacing(kMargin);
    states->addWidget(now_, 1);
    states->addWidget(pending_);
    states->addWidget(blindness_);
    grid_->addLayout(states, 2, 1, 1, 2);
  } else {
    grid_->addWidget(title_, 0, 1, 1, 2);
    grid_->addWidget(now_, 1, 1, 1, 2);
    grid_->addWidget(blindness_, 2, 1);
    grid_->addWidget(unblind_, 2, 2);
    grid_->setRowMinimumHeight(3, kGrid / 2);
    grid_->addLayout(counts_, 4, 0, 1, 3);
    // Its place is kept: what is under it does not move when something is asked for.
    grid_->addWidget(pending_, 5, 0, 1, 3);
  }
  grid_->setColumnStretch(1, 1);
}

void SessionHeader::set_running(bool running) { emergency_->setEnabled(running); }

void SessionHeader::set_facts(std::shared_ptr<const SessionFacts> facts) {
  facts_ = std::move(facts);
  write_title();
}

QString SessionHeader::title_with(const QString& protocol) const {
  const SessionRow& row = facts_->row;
  return tr("Session %1 · %2 · %3 · %4")
      .arg(row.session)
      .arg(QString::fromStdString(row.participant), protocol, SessionText::of_mode(row.mode));
}

QString SessionHeader::title() const { return title_->toolTip(); }

/// In smaller letters where a line is too short, then in two lines; in one where a small window needs the room to state
/// what has stopped the session. Whole in the tool tip: the protocol's title is what is cut.
void SessionHeader::write_title() {
  if (facts_ == nullptr || facts_->protocol == nullptr) return;
  const QString protocol = QString::fromStdString(facts_->protocol->title);
  const QString whole = title_with(protocol);
  const int lines = form_ == SessionForm::narrow && is_stopped_ ? 1 : 2;
  const QRect room(0, 0, title_->width(), QWIDGETSIZE_MAX);
  QFont font{};
  const auto fits = [&](int in_lines) {
    for (const TextSize size : {TextSize::heading, TextSize::body, TextSize::small}) {
      font = text_font(size, true);
      const QFontMetrics letters(font);
      const QRect needed = letters.boundingRect(room, Qt::TextWordWrap, whole);
      if (needed.height() <= in_lines * letters.height()) return true;
    }
    return false;
  };
  const bool is_whole = fits(1) || (lines > 1 && fits(lines));
  title_->setFont(font);
  title_->setWordWrap(lines > 1);
  title_->setToolTip(whole);
  if (is_whole) return set_if_new(*title_, whole);
  const QFontMetrics letters(font);
  // A line ends with a word, and so before its end.
  const int width = lines * room.width() - (lines - 1) * room.width() / 4;
  const int left = width - letters.horizontalAdvance(title_with({}));
  set_if_new(*title_, title_with(letters.elidedText(protocol, Qt::ElideRight, std::max(left, 0))));
}

bool SessionHeader::eventFilter(QObject* watched, QEvent* event) {
  if (watched == title_ && event->type() == QEvent::Resize) write_title();
  return QWidget::eventFilter(watched, event);
}

void SessionHeader::show_blindness(const Blindness& blindness) {
  const bool marked = !blindness.unblinded_at.isEmpty();
  QString words{};
  if (marked) {
    words = blindness.is_blind ? tr("▲ Blind again; UNBLINDED at %1").arg(blindness.unblinded_at)
                               : tr("▲ UNBLINDED at %1").arg(blindness.unblinded_at);
  } else {
    words = blindness.is_blind ? tr("Blind: conditions are shown as codes") : tr("Names are shown");
  }
  blindness_->show_text(words);
  blindness_->setFont(text_font(TextSize::body, marked));
  blindness_->set_smaller_font(text_font(TextSize::small, marked));
  blindness_->setStyleSheet(
      QString("color: %1").arg((marked ? theme().look : theme().muted).name()));
  if (blindness.is_blind) {
    unblind_->setText(blindness.is_run ? tr("Unblind…") : tr("Show names"));
  } else {
    unblind_->setText(blindness.is_run ? tr("Blind again") : tr("Hide names"));
  }
  unblind_->setEnabled(blindness.can_change);
}

void SessionHeader::show_progress(const SessionSnapshot& snapshot) {
  const SessionSnapshot& s = snapshot;
  if (const bool stopped = s.phase == SessionPhase::fault; stopped != is_stopped_) {
    is_stopped_ = stopped;
    write_title();
  }
  set_if_new(*block_, s.block > 0 ? tr("Block %1 of %2").arg(s.block).arg(s.blocks)
                                  : tr("Blocks: %1").arg(s.blocks));
  progress_->setMaximum(std::max(1, s.trials));
  progress_->setValue(s.trials_done);
  const QString all =
      s.trials_are_estimated ? tr("about %1").arg(s.trials) : QString::number(s.trials);
  const bool is_refresher = s.purpose == AttemptPurpose::refresher;
  // The trial that the feedback is about is stored, and the snapshot has the next one.
  const int trial =
      s.phase == SessionPhase::feedback && s.last_done > 0 && !is_refresher ? s.last_done : s.trial;
  set_if_new(*trial_, is_refresher ? tr("repeated practice, trial %1").arg(s.trial)
                      : trial > 0  ? tr("trial %1 of %2").arg(trial).arg(all)
                                   : tr("trials: %1").arg(all));
}

void SessionHeader::show_preparation(std::optional<double> fraction) {
  constexpr int kPreparationSteps = 100;
  progress_->setMaximum(fraction ? kPreparationSteps : 0);  // 0: to and fro
  progress_->setValue(fraction ? static_cast<int>(kPreparationSteps * *fraction) : 0);
}

void SessionHeader::show_left(const QString& text) {
  set_if_new(*left_, text);
  left_->setHidden(text.isEmpty());
}

void SessionHeader::show_now(const QString& text) { now_->show_text(text); }

void SessionHeader::show_elapsed(double elapsed_s) {
  set_if_new(*elapsed_, tr("%1 elapsed").arg(SessionText::of_duration(elapsed_s)));
}

void SessionHeader::show_pending(const QString& text) { pending_->show_state(State::look, text); }

}  // namespace asperity

#include "moc_session_header.cpp"

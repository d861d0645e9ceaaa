// Writes verb, key and reason of each button by the state of the session, at a width that does not change.

#include "app/gui/session/session_controls.h"

#include <algorithm>

#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

/// Its width is that of the longest text it has had: its neighbours do not move to and fro.
void set_words(QPushButton& button, const QString& verb, const QString& key) {
  button.setText(key.isEmpty() ? verb : QString("%1\n%2").arg(verb, key));
  button.setMinimumWidth(std::max(button.minimumWidth(), button.sizeHint().width()));
}

}  // namespace

QPushButton* SessionControls::add(const QString& name) {
  QPushButton* button = make_button({}, ButtonRole::plain, this);
  button->setObjectName(name);
  button->setFont(text_font(TextSize::small));
  // By Tab, not by a click: what was clicked would hear the next Space of the participant.
  button->setFocusPolicy(Qt::TabFocus);
  button->setStyleSheet("padding: 0 8px; min-height: 42px; max-height: 42px;");
  return button;
}

SessionControls::SessionControls(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  upper_ = new QHBoxLayout();
  lower_ = new QHBoxLayout();
  auto* buttons = new QVBoxLayout();
  buttons->setSpacing(kGrid);
  for (QHBoxLayout* row : {upper_, lower_}) {
    row->setSpacing(kGrid);
    buttons->addLayout(row);
  }
  upper_->addStretch(1);
  pause_ = add("pause");
  stop_trial_ = add("stop_after_trial");
  stop_block_ = add("stop_after_block");
  repeat_ = add("repeat_last");
  skip_ = add("skip");
  note_ = add("note_button");
  abort_ = add("abort");
  their_window_ = add("their_window");
  their_window_->setToolTip(
      tr("Brings the participant's window back to its place, in front of the others."));
  their_window_->hide();
  rows->addLayout(buttons);
  reason_ = make_text({}, this, true);
  reason_->setObjectName("why_disabled");
  reason_->setFont(text_font(TextSize::small));
  reason_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  reason_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  rows->addWidget(reason_);

  const auto ask = [this](SessionVerb verb) { return [this, verb] { emit wanted(verb); }; };
  connect(pause_, &QPushButton::clicked, this, [this] {
    const bool resumes = state_.paused || state_.pause_pending;
    emit wanted(resumes ? SessionVerb::start_or_resume : SessionVerb::pause);
  });
  connect(stop_trial_, &QPushButton::clicked, this, ask(SessionVerb::stop_after_trial));
  connect(stop_block_, &QPushButton::clicked, this, ask(SessionVerb::stop_after_block));
  connect(repeat_, &QPushButton::clicked, this, ask(SessionVerb::repeat_last));
  connect(note_, &QPushButton::clicked, this, ask(SessionVerb::note));
  connect(abort_, &QPushButton::clicked, this, ask(SessionVerb::abort));
  connect(skip_, &QPushButton::clicked, this, &SessionControls::skip_wanted);
  connect(their_window_, &QPushButton::clicked, this, ask(SessionVerb::show_participant));
  set_form(SessionForm::wide);
  write();
}

void SessionControls::set_form(SessionForm form) {
  const bool wide = form == SessionForm::wide;
  int place = 0;
  for (QPushButton* button :
       {pause_, stop_trial_, stop_block_, their_window_, repeat_, skip_, note_, abort_}) {
    constexpr int kInARow = 4;
    QHBoxLayout& row = wide || place < kInARow ? *upper_ : *lower_;
    // One row ends where its buttons do; two are as wide as the window.
    row.insertWidget(wide ? place : place % kInARow, button, wide ? 0 : 1);
    ++place;
  }
  upper_->setStretch(upper_->count() - 1, wide ? 1 : 0);
  reason_->setFixedHeight((wide ? 1 : 2) * reason_->fontMetrics().lineSpacing());
}

void SessionControls::set_participant_window(bool there) { their_window_->setVisible(there); }

void SessionControls::show_state(const ControlState& state) {
  if (state == state_) return;
  state_ = state;
  write();
}

void SessionControls::write() {
  const ControlState& s = state_;
  if (s.paused) {
    set_words(*pause_, tr("Resume"), tr("F5"));
  } else if (s.pause_pending) {
    set_words(*pause_, tr("Do not pause"), tr("F5"));
  } else {
    set_words(*pause_, tr("Pause"), tr("Esc or F6"));
  }
  set_words(*stop_trial_,
            s.stop_pending == StopAfter::trial ? tr("Do not stop") : tr("Stop after trial"),
            tr("F7"));
  set_words(*stop_block_,
            s.stop_pending == StopAfter::block ? tr("Do not stop") : tr("Stop after block"),
            tr("F8"));
  set_words(*repeat_, s.only_tried ? tr("Repeat last") : tr("Repeat last…"), tr("Ctrl+R"));
  set_words(*skip_, s.only_tried ? tr("Skip") : tr("Skip…"), {});
  set_words(*note_, tr("Note"), tr("F2"));
  set_words(*abort_,
            s.preparing    ? tr("Cancel")
            : s.only_tried ? tr("End")
                           : tr("Abort…"),
            tr("Ctrl+Shift+Q"));
  abort_->setToolTip(s.only_tried ? tr("Ends the trial with the mouse. Nothing is stored.")
                                  : QString());
  set_words(*their_window_, tr("Show participant's window"), tr("F9"));

  for (QPushButton* button : {pause_, stop_trial_, stop_block_}) button->setEnabled(s.running);
  abort_->setEnabled(s.running || (s.preparing && !s.cancelling));
  // A fault is cleared or the session ended, first.
  if (s.in_fault) pause_->setEnabled(false);
  repeat_->setEnabled(s.running && s.trial_done && !s.repeat_pending && !s.refreshing);
  skip_->setEnabled(s.running && s.in_trial);
  note_->setEnabled(s.running && !s.note_locked);

  QStringList why{};
  if (s.cancelling) {
    why += tr("The preparation is being cancelled.");
  } else if (s.preparing) {
    why +=
        tr("The session has not begun: its files are being read and the device is being opened.");
  } else if (!s.running) {
    why += tr("No session is under way.");
  } else {
    if (s.in_fault) why += tr("Pause: the session is already stopped.");
    if (s.repeat_pending) {
      why += tr("Repeat: the last trial is repeated next.");
    } else if (s.refreshing) {
      why += tr("Repeat: practice is being repeated, which does not count.");
    } else if (!s.trial_done) {
      why += tr("Repeat: no trial has been completed yet.");
    }
    if (!s.in_trial) why += tr("Skip: no trial is under way.");
    if (s.note_locked) why += tr("Note: the keys are reserved for the response; use a phrase.");
  }
  reason_->setText(why.join("  "));
}

}  // namespace asperity

#include "moc_session_controls.cpp"

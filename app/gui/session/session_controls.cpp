#include "app/gui/session/session_controls.h"

#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

void set_words(QPushButton& button, const QString& verb, const QString& key) {
  button.setText(key.isEmpty() ? verb : QString("%1\n%2").arg(verb, key));
}

}  // namespace

QPushButton* SessionControls::add(const QString& name) {
  QPushButton* button = make_button({}, ButtonRole::plain, this);
  button->setObjectName(name);
  button->setFont(text_font(TextSize::small));
  // By Tab, not by a click: what was clicked would hear the next Space of the participant.
  button->setFocusPolicy(Qt::TabFocus);
  button->setStyleSheet("padding: 0 8px; min-height: 46px; max-height: 46px;");
  return button;
}

SessionControls::SessionControls(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  pause_ = add("pause");
  stop_trial_ = add("stop_after_trial");
  stop_block_ = add("stop_after_block");
  repeat_ = add("repeat_last");
  skip_ = add("skip");
  note_ = add("note_button");
  abort_ = add("abort");
  for (QPushButton* button : {pause_, stop_trial_, stop_block_}) row->addWidget(button);
  row->addSpacing(kMargin);
  for (QPushButton* button : {repeat_, skip_, note_, abort_}) row->addWidget(button);
  row->addStretch(1);
  emergency_ = make_button({}, ButtonRole::danger, this);
  emergency_->setObjectName("emergency_stop");
  emergency_->setStyleSheet("padding: 0 16px; min-height: 54px; max-height: 54px;");
  emergency_->setFocusPolicy(Qt::NoFocus);  // a key that goes astray does not press it
  emergency_->setToolTip(tr(
      "Sets the force to zero at once, from any window. F12, Pause/Break and Ctrl+Space all do."));
  set_words(*emergency_, tr("■ EMERGENCY STOP"), tr("F12 from any window"));
  row->addWidget(emergency_);
  rows->addLayout(row);
  reason_ = make_text({}, this, true);
  reason_->setObjectName("why_disabled");
  reason_->setFont(text_font(TextSize::small));
  reason_->setWordWrap(false);
  reason_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  reason_->setText(" ");
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
  connect(emergency_, &QPushButton::pressed, this, &SessionControls::emergency);
  write();
}

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
  set_words(*repeat_, tr("Repeat last…"), tr("Ctrl+R"));
  set_words(*skip_, tr("Skip…"), {});
  set_words(*note_, tr("Note"), tr("F2"));
  set_words(*abort_, tr("Abort…"), tr("Ctrl+Shift+Q"));

  for (QPushButton* button : {pause_, stop_trial_, stop_block_, abort_, emergency_}) {
    button->setEnabled(s.running);
  }
  // A fault is cleared or the session ended, first.
  if (s.in_fault) pause_->setEnabled(false);
  repeat_->setEnabled(s.running && s.trial_done && !s.repeat_pending);
  skip_->setEnabled(s.running && s.in_trial);
  note_->setEnabled(s.running && !s.note_locked);

  QStringList why{};
  if (!s.running) {
    why += tr("There is no session under way.");
  } else {
    if (s.in_fault) why += tr("Pause: the session is stopped already.");
    if (s.repeat_pending) {
      why += tr("Repeat: the last trial is asked again next.");
    } else if (!s.trial_done) {
      why += tr("Repeat: no trial is finished yet.");
    }
    if (!s.in_trial) why += tr("Skip: no trial is under way.");
    if (s.note_locked) why += tr("Note: the keys answer the trial now, use a phrase.");
  }
  reason_->setText(why.isEmpty() ? " " : why.join("  "));
}

}  // namespace asperity

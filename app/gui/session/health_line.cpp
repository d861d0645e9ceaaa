// Composes device, rate, lateness, losses and masking noise into one line with a state.

#include "app/gui/session/health_line.h"

#include <cmath>

#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>

#include "app/gui/look/controls.h"

namespace asperity {

HealthLine::HealthLine(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGroupGap);
  health_ = new StateLabel(this);
  health_->setObjectName("health");
  health_->setFont(text_font(TextSize::small));
  health_->setWordWrap(false);
  stored_ = new QLabel(this);
  stored_->setObjectName("stored");
  stored_->setFont(text_font(TextSize::small));
  row->addWidget(health_, 1);
  row->addWidget(stored_);
  set_form(SessionForm::wide);
}

void HealthLine::set_form(SessionForm form) {
  const bool wide = form == SessionForm::wide;
  const bool narrow = form == SessionForm::narrow;
  auto& row = static_cast<QBoxLayout&>(*layout());
  row.setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  row.setSpacing(narrow ? 0 : kGroupGap);
  health_->setWordWrap(!wide);
  for (QLabel* label : {static_cast<QLabel*>(health_), stored_}) {
    // Always as high: nothing moves when a number gets longer.
    const bool two_lines = label == health_ && !wide;
    label->setFixedHeight((two_lines ? 2 : 1) * label->fontMetrics().lineSpacing());
    label->setSizePolicy(label == health_ ? QSizePolicy::Ignored : QSizePolicy::Preferred,
                         QSizePolicy::Fixed);
  }
}

void HealthLine::show_health(const SessionSnapshot& snapshot, const SessionFacts* facts,
                             bool only_tried) {
  stored_->setText(only_tried ? tr("nothing is stored in the study")
                              : tr("study.sqlite · attempts stored: %1").arg(snapshot.rows_stored));
  const LoopHealth& h = snapshot.health;
  if (h.rate_Hz <= 0.0) {
    return health_->set_state(State::unknown, tr("The servo loop has not run yet"));
  }
  constexpr double kRateTolerance = 0.02;
  const double asked_Hz = facts == nullptr ? h.rate_Hz : facts->row.rate_Hz;
  const bool is_heard =
      snapshot.masking != MaskingState::silent && snapshot.masking != MaskingState::no_card;
  const bool fine = is_heard && h.missed_deadlines == 0 && h.lost_records == 0 &&
                    snapshot.fault == Fault::none && !snapshot.is_inside &&
                    std::abs(h.rate_Hz - asked_Hz) <= kRateTolerance * asked_Hz;
  QStringList parts{
      tr("%1 · %2 Hz · p99 %3 µs late · %4 missed · %5 lost · %6 saturated")
          .arg(facts == nullptr ? QString() : QString::fromStdString(facts->row.device))
          .arg(std::lround(h.rate_Hz))
          .arg(std::lround(1e6 * h.lateness_p99_s))
          .arg(h.missed_deadlines)
          .arg(h.lost_records)
          .arg(h.saturated_ticks)};
  if (snapshot.is_inside) {
    parts += tr("the probe is inside the surface: no force until it has left the surface");
  }
  if (const QString noise = text_of(snapshot.masking); !noise.isEmpty()) parts += noise;
  health_->set_state(fine ? State::fine : State::look, parts.join(" · "));
}

QString HealthLine::text_of(MaskingState masking) {
  switch (masking) {
    case MaskingState::none:
      break;
    case MaskingState::off:
      return tr("masking noise off");
    case MaskingState::on:
      return tr("masking noise on");
    case MaskingState::silent:
      return tr("the sound card produces no sound: no masking noise");
    case MaskingState::no_card:
      return tr("no sound output: no masking noise");
    case MaskingState::elsewhere:
      return tr("masking noise from another source (measured)");
  }
  return {};
}

}  // namespace asperity

#include "moc_health_line.cpp"

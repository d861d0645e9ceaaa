#include "app/gui/session/end_summary.h"

#include <algorithm>
#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

EndSummary::EndSummary(std::filesystem::path study, QWidget* parent)
    : QWidget(parent), study_(std::move(study)) {
  setObjectName("end_summary");
  auto* outer = new QHBoxLayout(this);
  outer->addStretch(1);
  QVBoxLayout* rows = nullptr;
  QFrame* card = make_card(this, rows);
  card->setMinimumWidth(80 * kGrid);
  rows->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  rows->setSpacing(kMargin);
  title_ = make_title({}, card);
  title_->setObjectName("end_title");
  text_ = make_text({}, card);
  text_->setObjectName("end_text");
  place_ = make_text({}, card, true);
  place_->setObjectName("end_place");
  place_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  rows->addWidget(title_);
  rows->addWidget(text_);
  rows->addWidget(place_);
  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  const auto add = [&](const QString& verb, ButtonRole role, const char* name, auto signal) {
    QPushButton* button = make_button(verb, role, card);
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this, signal);
    buttons->addWidget(button);
  };
  add(tr("See the table"), ButtonRole::primary, "see_table", &EndSummary::results_wanted);
  add(tr("See the trials"), ButtonRole::plain, "see_trials", &EndSummary::trials_wanted);
  add(tr("Close"), ButtonRole::plain, "close", &EndSummary::close_wanted);
  buttons->addStretch(1);
  rows->addLayout(buttons);
  auto* middle = new QVBoxLayout();
  middle->addStretch(1);
  middle->addWidget(card);
  middle->addStretch(2);
  outer->addLayout(middle, 2);
  outer->addStretch(1);
}

void EndSummary::show_end(const SessionSnapshot& snapshot, const SessionRow& row, bool complete,
                          const QString& why) {
  const bool began = row.session > 0;
  title_->setText(!began     ? tr("✕ The session did not begin")
                  : complete ? tr("✓ The session is complete")
                             : tr("▲ The session was stopped"));
  place_->setVisible(began);
  for (const char* name : {"see_table", "see_trials"}) {
    findChild<QPushButton*>(name)->setVisible(began);
  }
  const auto& attempts = *snapshot.attempts;
  const auto flagged = std::count_if(attempts.begin(), attempts.end(),
                                     [](const AttemptSummary& each) { return each.flagged; });
  const auto skipped = std::count_if(
      attempts.begin(), attempts.end(),
      [](const AttemptSummary& each) { return each.outcome == AttemptOutcome::skipped; });
  const auto invalid =
      std::count_if(attempts.begin(), attempts.end(), [](const AttemptSummary& each) {
        return !each.valid && each.outcome != AttemptOutcome::skipped;
      });
  QString text = tr("%1 of %2 trials are done. Of %3 attempts, %4 are flagged, %5 do not count and "
                    "%6 were skipped.")
                     .arg(snapshot.trials_done)
                     .arg(snapshot.trials)
                     .arg(attempts.size())
                     .arg(flagged)
                     .arg(invalid)
                     .arg(skipped);
  if (snapshot.trials == 0) text = began ? tr("No trial was begun.") : tr("Nothing was stored.");
  if (!why.isEmpty()) text = tr("%1\n\n%2").arg(why, text);
  if (!complete && snapshot.trials > 0) {
    text = tr("%1\n\nThe session can be gone on with: start it again with the same participant.")
               .arg(text);
  }
  text_->setText(text);
  place_->setText(tr("Everything is stored in %1, session %2 of %3.")
                      .arg(QString::fromStdString((study_ / "study.sqlite").string()))
                      .arg(row.session)
                      .arg(QString::fromStdString(row.participant)));
}

}  // namespace asperity

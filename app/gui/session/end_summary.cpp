// Counts the reasons for flagged and invalid attempts, and offers the next actions as buttons.

#include "app/gui/session/end_summary.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/session/session_text.h"

namespace asperity {

namespace {

/// The one filled button of the page, or not.
void fill(QPushButton& button, bool is_filled) {
  set_role(button, is_filled ? ButtonRole::primary : ButtonRole::plain);
}

/// Why attempts are flagged or invalid, the most frequent reason first.
QString reasons_of(const std::vector<AttemptSummary>& attempts) {
  constexpr std::size_t kMost = 3;
  std::vector<std::pair<QString, int>> reasons{};
  for (const AttemptSummary& attempt : attempts) {
    if (attempt.outcome == AttemptOutcome::skipped) continue;
    if (attempt.valid && !attempt.flagged) continue;
    const QString reason = words_of(attempt.reason);
    if (reason.isEmpty()) continue;
    const auto known = std::find_if(reasons.begin(), reasons.end(),
                                    [&reason](const auto& one) { return one.first == reason; });
    if (known == reasons.end()) {
      reasons.emplace_back(reason, 1);
    } else {
      ++known->second;
    }
  }
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  QStringList lines{};
  for (std::size_t i = 0; i < std::min(kMost, reasons.size()); ++i) {
    lines += EndSummary::tr("%1 × %2").arg(reasons[i].second).arg(reasons[i].first);
  }
  if (reasons.size() > kMost) {
    lines += EndSummary::tr("further reasons: %1").arg(reasons.size() - kMost);
  }
  return lines.join("; ");
}

}  // namespace

EndSummary::EndSummary(std::filesystem::path study, QWidget* parent)
    : QWidget(parent), study_(std::move(study)) {
  setObjectName("end_summary");
  auto* outer = new QHBoxLayout(this);
  outer->addStretch(1);
  QVBoxLayout* rows = nullptr;
  QFrame* card = make_card(this, rows);
  card->setMinimumWidth(70 * kGrid);
  rows->setContentsMargins(kGroupGap, kMargin, kGroupGap, kMargin);
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
  auto* ways_on = new QHBoxLayout();
  auto* buttons = new QHBoxLayout();
  for (QHBoxLayout* line : {ways_on, buttons}) {
    line->setSpacing(kGrid);
    rows->addLayout(line);
  }
  const auto add = [&](QHBoxLayout* line, const QString& verb, const char* name, auto&& on_click) {
    QPushButton* button = make_button(verb, ButtonRole::plain, card);
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this, on_click);
    line->addWidget(button);
    return button;
  };
  const auto add_way_on = [&](AfterFailure way, const char* name) {
    return add(ways_on, SessionText::of_way_on(way), name,
               [this, way] { emit way_on_wanted(way); });
  };
  go_on_ = add_way_on(AfterFailure::go_on, "resume");
  start_again_ = add_way_on(AfterFailure::start_again, "start_again");
  check_again_ = add_way_on(AfterFailure::check_again, "check_everything_again");
  see_table_ = add(buttons, tr("Show the table"), "see_table", &EndSummary::results_wanted);
  see_trials_ = add(buttons, tr("Show the trials"), "see_trials", &EndSummary::trials_wanted);
  add(buttons, tr("Close"), "close", &EndSummary::close_wanted);
  for (QHBoxLayout* line : {ways_on, buttons}) line->addStretch(1);
  auto* middle = new QVBoxLayout();
  middle->addStretch(1);
  middle->addWidget(card);
  middle->addStretch(2);
  outer->addLayout(middle, 2);
  outer->addStretch(1);
}

void EndSummary::show_end(const SessionSnapshot& snapshot, const SessionRow& row,
                          const SessionOutcome& outcome) {
  const bool began = row.session > 0;
  title_->setText(!began                ? tr("✕ The session did not begin")
                  : outcome.is_complete ? tr("✓ The session is complete")
                                        : tr("▲ The session was stopped"));
  place_->setVisible(began);
  see_table_->setVisible(began);
  see_trials_->setVisible(began);
  go_on_->setVisible(outcome.can_go_on);
  start_again_->setVisible(!began);
  check_again_->setVisible(!began);
  fill(*go_on_, outcome.can_go_on);
  fill(*start_again_, !began);
  fill(*see_table_, began && !outcome.can_go_on);
  std::vector<AttemptSummary> attempts = *snapshot.attempts;
  const auto refreshers = std::erase_if(attempts, [](const AttemptSummary& each) {
    return each.purpose == AttemptPurpose::refresher;
  });
  const auto flagged = std::count_if(attempts.begin(), attempts.end(),
                                     [](const AttemptSummary& each) { return each.flagged; });
  const auto skipped = std::count_if(
      attempts.begin(), attempts.end(),
      [](const AttemptSummary& each) { return each.outcome == AttemptOutcome::skipped; });
  const auto invalid =
      std::count_if(attempts.begin(), attempts.end(), [](const AttemptSummary& each) {
        return !each.valid && each.outcome != AttemptOutcome::skipped;
      });
  const int taken = snapshot.trials_done - snapshot.trials_not_needed;
  QString text = tr("Trials completed: %1 of %2.").arg(taken).arg(snapshot.trials);
  if (snapshot.trials_not_needed > 0) {
    text += ' ' + tr("Trials not needed, because the criterion of their block was reached or could "
                     "no longer be: %1.")
                      .arg(snapshot.trials_not_needed);
  }
  text += ' ' + tr("Attempts: %1 (%2 flagged, %3 invalid, %4 skipped).")
                    .arg(attempts.size())
                    .arg(flagged)
                    .arg(invalid)
                    .arg(skipped);
  if (refreshers > 0) {
    text += ' ' + tr("Practice trials made again: %1.").arg(refreshers);
  }
  const QString reasons = reasons_of(attempts);
  if (!reasons.isEmpty()) text += '\n' + reasons;
  for (const QString& anchors : outcome.anchors) text += '\n' + anchors;
  if (snapshot.trials == 0) text = began ? tr("No trial was begun.") : tr("Nothing was stored.");
  if (!outcome.why.isEmpty()) text = tr("%1\n\n%2").arg(outcome.why, text);
  if (outcome.can_go_on) {
    text = tr("%1\n\nResume the session now, or later on the Sessions page.").arg(text);
  }
  text_->setText(text);
  // Of one that was stopped a trial may have been under way.
  place_->setText((outcome.is_complete
                       ? tr("Everything is stored in %1, session %2 of %3.")
                       : tr("Every completed trial is stored in %1, session %2 of %3."))
                      .arg(QString::fromStdString((study_ / "study.sqlite").string()))
                      .arg(row.session)
                      .arg(QString::fromStdString(row.participant)));
}

}  // namespace asperity

#include "moc_end_summary.cpp"

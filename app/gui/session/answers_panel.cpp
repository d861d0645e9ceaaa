#include "app/gui/session/answers_panel.h"

#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>

#include "app/gui/look/controls.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/session_text.h"

namespace asperity {

AnswersPanel::AnswersPanel(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  last_ = new QLabel(this);
  last_->setObjectName("last_answer");
  last_->setFont(text_font(TextSize::heading, true));
  earlier_ = new QLabel(this);
  earlier_->setObjectName("earlier_answers");
  earlier_->setFont(text_font(TextSize::small));
  earlier_->setProperty("role", "muted");
  earlier_->setWordWrap(true);
  earlier_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  earlier_->setFixedHeight(2 * QFontMetrics(earlier_->font()).lineSpacing());
  for (QLabel* label : {last_, earlier_}) {
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    rows->addWidget(label);
  }
}

void AnswersPanel::show_answers(const std::vector<AttemptSummary>& attempts,
                                const PlanModel& plan) {
  constexpr int kEarlier = 4;
  QString last{};
  QStringList earlier{};
  for (auto attempt = attempts.rbegin(); attempt != attempts.rend() && earlier.size() < kEarlier;
       ++attempt) {
    if (attempt->outcome != AttemptOutcome::answered) continue;
    QString answer = SessionText::of_answers(*attempt);
    if (attempt->correct && plan.tells_right(*attempt)) {
      answer = *attempt->correct ? tr("%1, right").arg(answer) : tr("%1, wrong").arg(answer);
    }
    if (!last.isEmpty()) {
      earlier += tr("%1: %2").arg(attempt->trial).arg(answer);
    } else if (attempt->from_cue_s) {
      last =
          tr("Last answer  %1  in %2 s").arg(answer, QString::number(*attempt->from_cue_s, 'f', 1));
    } else {
      last = tr("Last answer  %1").arg(answer);
    }
  }
  last_->setText(last.isEmpty() ? tr("No answer yet") : last);
  earlier_->setText(earlier.isEmpty() ? QString()
                                      : tr("Before, by trial: %1").arg(earlier.join(" · ")));
  earlier_->setToolTip(earlier.join("\n"));
}

}  // namespace asperity

// Writes the last response in large letters and up to four earlier ones in a muted line.

#include "app/gui/session/answers_panel.h"

#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/session_text.h"

namespace asperity {

AnswersPanel::AnswersPanel(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  last_ = new QLabel(this);
  last_->setObjectName("last_answer");
  last_->setFont(text_font(TextSize::small));
  last_->setTextFormat(Qt::RichText);
  last_->setFixedHeight(QFontMetrics(text_font(TextSize::heading, true)).height());
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
  QString when{};
  QStringList earlier{};
  for (auto attempt = attempts.rbegin(); attempt != attempts.rend() && earlier.size() < kEarlier;
       ++attempt) {
    if (attempt->outcome != AttemptOutcome::answered) continue;
    QString answer = SessionText::of_answers(*attempt);
    if (attempt->correct && plan.tells_right(*attempt)) {
      answer = *attempt->correct ? tr("%1, correct").arg(answer) : tr("%1, incorrect").arg(answer);
    }
    if (!last.isEmpty()) {
      earlier += tr("%1: %2").arg(attempt->trial).arg(answer);
    } else {
      last = answer;
      if (attempt->from_cue_s) {
        when = tr("%1 s after the cue").arg(shown_number(*attempt->from_cue_s, 'f', 1));
      }
    }
  }
  if (last.isEmpty()) {
    last_->setText(QString("<b>%1</b>").arg(tr("No response yet").toHtmlEscaped()));
  } else {
    // The answer is read from afar; what it is, and when it came, from nearby: few words, as the
    // line has little room on a small screen.
    last_->setText(QString("%1&nbsp; <b><span style='font-size:%2pt'>%3</span></b>&nbsp; %4")
                       .arg(tr("Last:").toHtmlEscaped())
                       .arg(static_cast<int>(TextSize::heading))
                       .arg(last.toHtmlEscaped(), when.toHtmlEscaped()));
  }
  // One with an answer for each of many surfaces is longer than its place.
  last_->setToolTip(QStringList{last, when}.join('\n').trimmed());
  earlier_->setText(earlier.isEmpty()
                        ? QString()
                        : tr("Earlier responses, by trial: %1").arg(earlier.join(" · ")));
  earlier_->setToolTip(earlier.join("\n"));
}

}  // namespace asperity

#include "moc_answers_panel.cpp"

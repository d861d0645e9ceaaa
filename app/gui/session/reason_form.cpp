// Offers the ready-made reasons as buttons, and passes the chosen or typed reason to the caller.

#include "app/gui/session/reason_form.h"

#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"

namespace asperity {

ReasonForm::ReasonForm(QWidget* parent) : QFrame(parent) {
  setObjectName("reason_form");
  setProperty("role", "card");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(kMargin, kGrid, kMargin, kGrid);
  rows->setSpacing(kGrid);
  auto* top = new QHBoxLayout();
  question_ = make_text({}, this);
  top->addWidget(question_, 1);
  why_locked_ = make_text({}, this, true);
  why_locked_->setFont(text_font(TextSize::small));
  why_locked_->setWordWrap(false);
  top->addWidget(why_locked_);
  rows->addLayout(top);
  ready_made_ = new WrappingRow(nullptr, kGrid);
  rows->addLayout(ready_made_);
  auto* bottom = new QHBoxLayout();
  bottom->setSpacing(kGrid);
  field_ = new QLineEdit(this);
  field_->setObjectName("reason");
  field_->setAccessibleName(tr("Reason"));
  field_->setPlaceholderText(tr("Choose a reason above or enter one"));
  act_ = make_button({}, ButtonRole::plain, this);
  act_->setObjectName("reason_given");
  auto* cancel_button = make_button(tr("Cancel"), ButtonRole::link, this);
  cancel_button->setObjectName("reason_cancel");
  bottom->addWidget(field_, 1);
  bottom->addWidget(act_);
  bottom->addWidget(cancel_button);
  rows->addLayout(bottom);
  connect(field_, &QLineEdit::textChanged, this,
          [this](const QString& text) { act_->setEnabled(!text.trimmed().isEmpty()); });
  connect(field_, &QLineEdit::returnPressed, this, &ReasonForm::finish);
  connect(act_, &QPushButton::clicked, this, &ReasonForm::finish);
  connect(cancel_button, &QPushButton::clicked, this, &ReasonForm::cancel);
  hide();
}

void ReasonForm::ask(const QString& question, const std::vector<Phrase>& ready_made,
                     const QString& verb, std::function<void(Phrase)> on_reason) {
  question_->setText(question);
  act_->setText(verb);
  act_->setEnabled(false);
  field_->clear();
  offered_ = ready_made;
  on_reason_ = std::move(on_reason);
  clear_layout(*ready_made_);
  for (const Phrase& offered : ready_made) {
    const QString reason = words_of(offered);
    QPushButton* button = make_button(reason, ButtonRole::plain, this);
    button->setFont(text_font(TextSize::small));
    button->setFocusPolicy(Qt::NoFocus);
    connect(button, &QPushButton::clicked, field_, [this, reason] { field_->setText(reason); });
    ready_made_->addWidget(button);
    button->show();  // now, because the form may be shown already
  }
  show();
  if (field_->isEnabled()) field_->setFocus();
}

void ReasonForm::lock(const QString& why) {
  why_locked_->setText(why);
  field_->setEnabled(why.isEmpty());
}

void ReasonForm::finish() {
  const QString reason = field_->text().trimmed();
  if (reason.isEmpty()) return;
  hide();
  const auto act = std::exchange(on_reason_, nullptr);  // may ask something else
  if (act) act(offered_or_typed(reason, offered_));
}

void ReasonForm::cancel() {
  on_reason_ = nullptr;
  hide();
  emit cancelled();
}

}  // namespace asperity

#include "moc_reason_form.cpp"

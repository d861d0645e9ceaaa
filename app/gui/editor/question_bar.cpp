// Makes a button for each answer when a question is asked, and hides the bar after one is pressed.

#include "app/gui/editor/question_bar.h"

#include "app/gui/look/controls.h"

namespace asperity {

QuestionBar::QuestionBar(QWidget* parent) : QFrame(parent) {
  setObjectName("editor_question");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kGrid, kMargin, kGrid);
  layout->setSpacing(kGrid);
  auto* words = new QHBoxLayout();
  words->setSpacing(kMargin);
  auto* shape = new QLabel(shape_of(State::look), this);
  shape->setFont(text_font(TextSize::heading, true));
  shape->setStyleSheet("color: " + theme().look.name());
  question_ = make_text({}, this);
  words->addWidget(shape);
  words->addWidget(question_, 1);
  layout->addLayout(words);
  buttons_ = new QHBoxLayout();
  buttons_->setSpacing(kGrid);
  layout->addLayout(buttons_);
  setStyleSheet(QString("asperity--QuestionBar { background: %1; border: 1px solid %2; "
                        "border-left: 6px solid %2; border-radius: 4px; }")
                    .arg(theme().panel.name(), theme().look.name()));
  hide();
}

void QuestionBar::ask(const QString& question, const std::vector<Answer>& answers) {
  question_->setText(question);
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->setObjectName({});
      item->widget()->deleteLater();  // may be what was pressed just now
    }
    delete item;
  }
  QPushButton* first = nullptr;
  for (const Answer& answer : answers) {
    QPushButton* button = make_button(answer.verb, ButtonRole::plain, this);
    button->setObjectName(answer.name);
    connect(button, &QPushButton::clicked, this, [this, act = answer.act] {
      hide();
      if (act) act();
    });
    buttons_->addWidget(button);
    if (first == nullptr) first = button;
  }
  buttons_->addStretch(1);
  show();
  if (first != nullptr) first->setFocus();
}

QString QuestionBar::question() const { return question_->text(); }

}  // namespace asperity

#include "moc_question_bar.cpp"

// Builds a row with a suitable field for each question; the mouse wheel scrolls the page, not a field.

#include "app/gui/base/question_form.h"

#include <algorithm>
#include <tuple>

#include <QtCore/QEvent>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLineEdit>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "app/session/respondents/typed_answer.h"

namespace asperity {

namespace {

constexpr int kQuestionFieldWidth = 240;

/// Swallows nothing: the event goes on to the parent, which scrolls.
class WheelToParent final : public QObject {
 public:
  explicit WheelToParent(QObject* field) : QObject(field) {}
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    event->ignore();
    return true;
  }
};

QString field_name(const Question& question) {
  return "question_" + QString::fromStdString(question.name);
}

/// So that two forms can be compared.
auto comparable(const Question& question) {
  return std::tie(question.name, question.prompt, question.form, question.options,
                  question.optional);
}

}  // namespace

void ignore_wheel(QWidget& field) {
  field.setFocusPolicy(Qt::StrongFocus);
  field.installEventFilter(new WheelToParent(&field));
}

QuestionForm::QuestionForm(QWidget* parent) : QWidget(parent) {
  grid_ = new QGridLayout(this);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(kMargin);
  grid_->setVerticalSpacing(kGrid);
  grid_->setColumnStretch(0, 1);
}

void QuestionForm::set_questions(const std::vector<Question>& questions) {
  const bool same = std::equal(
      questions.begin(), questions.end(), questions_.begin(), questions_.end(),
      [](const Question& a, const Question& b) { return comparable(a) == comparable(b); });
  if (same) return;
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  questions_ = questions;
  int row = 0;
  for (const Question& question : questions_) add_row(question, row++);
  const bool any_required = std::any_of(questions_.begin(), questions_.end(),
                                        [](const Question& q) { return !q.optional; });
  if (any_required) {
    grid_->addWidget(make_text(tr("* required"), this, true), row, 0, 1, 2);
  }
}

void QuestionForm::add_row(const Question& question, int row) {
  QString text = QString::fromStdString(question.prompt);
  const auto* const number = std::get_if<NumberForm>(&question.form);
  if (number != nullptr && !number->unit.empty()) {
    text += " (" + QString::fromStdString(number->unit) + ')';
  }
  // The star never begins a line of its own.
  const QString starred = tr("%1 *").replace(' ', QChar::Nbsp).arg(text);
  QLabel* prompt = make_text(question.optional ? text : starred, this);
  QWidget* field = nullptr;
  if (question.is_answered_by<ChoiceForm>()) {
    auto* box = new ChoiceBox(this);
    for (const Option& option : question.options) {
      box->addItem(QString::fromStdString(option.text), QString::fromStdString(option.value));
    }
    box->setPlaceholderText(tr("Choose"));
    box->setCurrentIndex(-1);
    ignore_wheel(*box);
    connect(box, &QComboBox::currentIndexChanged, this, &QuestionForm::answered);
    field = box;
  } else {
    auto* line = new QLineEdit(this);
    if (number != nullptr) line->setAlignment(Qt::AlignRight);
    connect(line, &QLineEdit::textChanged, this, &QuestionForm::answered);
    field = line;
  }
  field->setObjectName(field_name(question));
  field->setAccessibleName(text);
  field->setFixedWidth(kQuestionFieldWidth);
  prompt->setBuddy(field);
  grid_->addWidget(prompt, row, 0, Qt::AlignVCenter);
  grid_->addWidget(field, row, 1, Qt::AlignTop);
}

ParticipantAnswers QuestionForm::answers() const {
  ParticipantAnswers answers{};
  for (const Question& question : questions_) {
    QString text{};
    if (const auto* box = findChild<QComboBox*>(field_name(question))) {
      if (box->currentIndex() >= 0) text = box->currentData().toString();
    } else if (const auto* line = findChild<QLineEdit*>(field_name(question))) {
      text = line->text().trimmed();
    }
    const bool is_number = question.is_answered_by<NumberForm>();
    answers[question.name] =
        is_number ? with_decimal_point(text.toStdString()) : text.toStdString();
  }
  return answers;
}

void QuestionForm::set_answers(const ParticipantAnswers& answers) {
  for (const auto& [question, answer] : answers) {
    const QString name = "question_" + QString::fromStdString(question);
    const QString text = QString::fromStdString(answer);
    if (auto* box = findChild<QComboBox*>(name)) {
      box->setCurrentIndex(box->findData(text));
    } else if (auto* line = findChild<QLineEdit*>(name)) {
      line->setText(text);
    }
  }
}

std::vector<QString> QuestionForm::complaints() const {
  const ParticipantAnswers given = answers();
  std::vector<QString> complaints{};
  for (const Question& question : questions_) {
    const std::string& answer = given.at(question.name);
    if (const auto complaint = complaint_about_answer(question, answer)) {
      complaints.push_back(words_of(*complaint));
    }
  }
  return complaints;
}

std::vector<QWidget*> QuestionForm::fields() const {
  std::vector<QWidget*> fields{};
  for (const Question& question : questions_) {
    fields.push_back(findChild<QWidget*>(field_name(question)));
  }
  return fields;
}

void QuestionForm::clear_answers() {
  for (auto* box : findChildren<QComboBox*>()) box->setCurrentIndex(-1);
  for (auto* line : findChildren<QLineEdit*>()) line->clear();
}

}  // namespace asperity

#include "moc_question_form.cpp"

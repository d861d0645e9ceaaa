// Enables the button only with a reason, and adds the decision to the study in a background task.

#include "app/gui/data/decision_form.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>

#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/words/coded_phrases.h"

namespace asperity {

DecisionForm::DecisionForm(OpenStudy& study, QWidget* parent) : QFrame(parent), study_(study) {
  setObjectName("decision_form");
  setProperty("role", "card");
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(kMargin, kGrid, kMargin, kGrid);
  rows->setSpacing(kGrid);
  text_ = make_text({}, this);
  rows->addWidget(text_);
  auto* fields = new QHBoxLayout();
  fields->setSpacing(kGrid);
  reason_ = new QComboBox(this);
  reason_->setObjectName("decision_reason");
  reason_->setEditable(true);
  reason_->setInsertPolicy(QComboBox::NoInsert);
  reason_->lineEdit()->setPlaceholderText(tr("Choose a reason or enter one"));
  reason_->setAccessibleName(tr("Reason"));
  by_ = new QLineEdit(this);
  by_->setObjectName("decision_by");
  by_->setPlaceholderText(tr("Decided by"));
  by_->setAccessibleName(tr("Decided by"));
  by_->setFixedWidth(200);
  write_ = make_button({}, ButtonRole::primary, this);
  write_->setObjectName("decision_write");
  QPushButton* cancel_button = make_button(tr("Cancel"), ButtonRole::link, this);
  cancel_button->setObjectName("decision_cancel");
  fields->addWidget(reason_, 1);
  fields->addWidget(by_);
  fields->addWidget(write_);
  fields->addWidget(cancel_button);
  rows->addLayout(fields);
  note_ = new StateLabel(this);
  note_->setObjectName("decision_note");
  rows->addWidget(note_);
  connect(reason_, &QComboBox::editTextChanged, this, &DecisionForm::show_what_is_missing);
  for (const QLineEdit* field : {reason_->lineEdit(), by_}) {
    connect(field, &QLineEdit::returnPressed, this, [this] {
      if (write_->isEnabled()) write();
    });
  }
  connect(write_, &QPushButton::clicked, this, &DecisionForm::write);
  connect(cancel_button, &QPushButton::clicked, this, &DecisionForm::cancel);
  hide();
}

void DecisionForm::ask(const Question& question) {
  question_ = question;
  text_->setText(question.text);
  write_->setText(question.verb);
  reason_->clear();
  for (const Phrase& offered : question.offered) reason_->addItem(words_of(offered));
  reason_->setCurrentIndex(-1);
  reason_->clearEditText();
  show_what_is_missing();
  show();
  reason_->setFocus();
}

void DecisionForm::cancel() { hide(); }

void DecisionForm::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    cancel();
    return;
  }
  QFrame::keyPressEvent(event);
}

void DecisionForm::show_what_is_missing() {
  if (!study_.can_be_written()) {
    write_->setEnabled(false);
    note_->set_state(State::look, tr("This study is read-only: no decision can be stored. Copy it "
                                     "to a folder that you may write to."));
    return;
  }
  const bool given = !reason_->currentText().trimmed().isEmpty();
  write_->setEnabled(given);
  note_->set_state(
      State::unknown,
      given ? tr("The decision is stored with the time; the data remain unchanged.")
            : tr("Choose or enter a reason, so that the decision can be understood later."));
}

void DecisionForm::write() {
  DecisionRow decision = question_.draft;
  decision.reason = stored(offered_or_typed(reason_->currentText().trimmed(), question_.offered));
  decision.decided_by = by_->text().trimmed().toStdString();
  write_->setEnabled(false);
  writing_.run<bool>(
      [folder = study_.folder(), id = question_.session_id, decision](
          const std::stop_token&, const BackgroundTask::Progress&) {
        Study::open(folder, Access::read_write).add_decision(id, decision);
        return true;
      },
      [this](bool) {
        hide();
        study_.announce_change();
      },
      [this](const QString& what) {
        write_->setEnabled(true);
        note_->set_state(State::stop, tr("The decision could not be stored: %1").arg(what));
      });
}

}  // namespace asperity

#include "moc_decision_form.cpp"

// Counts the data, lists outputs that contain them, and keeps or deletes the data as chosen.

#include "app/gui/study/withdraw_dialog.h"

#include <algorithm>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QRadioButton>

#include "app/gui/base/open_study.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/dialog_buttons.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

/// "2 sessions, 36 attempts, 40 responses, 36 recordings"
QString text_of_counts(const WithdrawalRow& row) {
  return QStringList{WithdrawDialog::tr("%n session(s)", nullptr, row.sessions),
                     WithdrawDialog::tr("%n attempt(s)", nullptr, row.attempts),
                     WithdrawDialog::tr("%n response(s)", nullptr, row.answers),
                     WithdrawDialog::tr("%n recording(s)", nullptr, row.recordings)}
      .join(", ");
}

QString text_of_outputs(const std::vector<OutputRow>& outputs) {
  QStringList lines{};
  for (const OutputRow& output : outputs) {
    lines << WithdrawDialog::tr("%2, %1: %3")
                 .arg(words_of(kind_words(output.kind)),
                      output.made_utc.empty() ? WithdrawDialog::tr("not complete")
                                              : text_of_time(output.made_utc),
                      output.path.empty()
                          ? WithdrawDialog::tr("(path with the label of another participant)")
                          : text(output.path));
  }
  return lines.join('\n');
}

}  // namespace

WithdrawDialog::WithdrawDialog(OpenStudy& study, const std::string& label, QWidget* parent)
    : QDialog(parent), study_(study), label_(label) {
  const WithdrawalRow counts = study.study().counts_of_participant(label);
  const bool has_withdrawn = study.study().participant(label)->withdrawn;
  setObjectName("withdraw_dialog");
  setWindowTitle(tr("Withdraw a participant"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(640);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Withdrawal of %1").arg(text(label)), this));
  question_ = new QWidget(this);
  auto* rows = new QVBoxLayout(question_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid);
  rows->addWidget(make_text(
      tr("Data of %1 in the study: %2.").arg(text(label), text_of_counts(counts)), question_));
  keep_ = new QRadioButton(tr("Keep the data but exclude them from all analyses"), question_);
  keep_->setObjectName("withdraw_keep");
  delete_ = new QRadioButton(tr("Delete all data of this participant from the study's folder"),
                             question_);
  delete_->setObjectName("withdraw_delete");
  rows->addWidget(keep_);
  rows->addWidget(make_text(has_withdrawn
                                ? tr("This has already been done.")
                                : tr("All sessions are excluded permanently, none can be begun or "
                                     "resumed, and the counterbalancing row is free again."),
                            question_, true));
  rows->addWidget(delete_);
  rows->addWidget(
      make_text(tr("Rows, recordings and stored older versions of the study are deleted and cannot "
                   "be restored. Only the fact, time and reason of the withdrawal remain stored."),
                question_, true));
  keep_->setEnabled(!has_withdrawn);
  (has_withdrawn ? delete_ : keep_)->setChecked(true);

  auto* form = new QFormLayout();
  form->setSpacing(kGrid);
  form->setHorizontalSpacing(kMargin);
  form->setContentsMargins(0, kGrid, 0, 0);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  reason_ = new ChoiceBox(question_);
  reason_->setObjectName("withdraw_reason");
  const auto add_reason = [this](const QString& words, WithdrawalReason reason) {
    reason_->addItem(words, static_cast<int>(reason));
  };
  add_reason(tr("Consent withdrawn"), WithdrawalReason::consent_withdrawn);
  add_reason(tr("Not eligible"), WithdrawalReason::not_eligible);
  add_reason(tr("Other"), WithdrawalReason::other);
  reason_->setCurrentIndex(reason_->findData(static_cast<int>(counts.reason)));
  form->addRow(tr("Reason"), reason_);
  by_ = new QLineEdit(question_);
  by_->setObjectName("withdraw_by");
  form->addRow(tr("Decided by"), by_);
  label_caption_ = new QLabel(tr("Label for confirmation"), question_);
  typed_ = new QLineEdit(question_);
  typed_->setObjectName("withdraw_label");
  typed_->setAccessibleName(label_caption_->text());
  typed_->setPlaceholderText(text(label));
  form->addRow(label_caption_, typed_);
  rows->addLayout(form);
  layout->addWidget(question_);

  outputs_caption_ = make_text(tr("These exports, reports and copies of the study are not "
                                  "changed. Each may contain data of %1:")
                                   .arg(text(label)),
                               this);
  layout->addWidget(outputs_caption_);
  outputs_ = new QPlainTextEdit(this);
  outputs_->setObjectName("withdraw_outputs");
  outputs_->setAccessibleName(tr("Exports, reports and copies"));
  outputs_->setReadOnly(true);
  outputs_->setLineWrapMode(QPlainTextEdit::NoWrap);
  outputs_->setTabChangesFocus(true);
  outputs_->setFixedHeight(88);
  layout->addWidget(outputs_);
  show_outputs(outputs_of_participant(study.study(), label));
  state_ = new StateLabel(this);
  state_->setObjectName("withdraw_state");
  state_->setWordWrap(true);
  layout->addWidget(state_);
  layout->addStretch(1);

  do_ = make_button({}, ButtonRole::primary, this);
  do_->setObjectName("withdraw_do");
  cancel_ = add_dialog_buttons(*this, *layout, do_);

  connect(keep_, &QRadioButton::toggled, this, &WithdrawDialog::show_what_is_missing);
  connect(by_, &QLineEdit::textChanged, this, &WithdrawDialog::show_what_is_missing);
  connect(typed_, &QLineEdit::textChanged, this, &WithdrawDialog::show_what_is_missing);
  connect(do_, &QPushButton::clicked, this, &WithdrawDialog::withdraw);
  show_what_is_missing();
  fit_height();
}

// The size hint of words that wrap is that of a narrower dialog.
void WithdrawDialog::fit_height() {
  setMinimumHeight(0);
  const int height = layout()->totalHeightForWidth(std::max(width(), minimumWidth()));
  setMinimumHeight(height);
  resize(std::max(width(), minimumWidth()), height);
}

void WithdrawDialog::show_outputs(const std::vector<OutputRow>& outputs) {
  outputs_->setPlainText(text_of_outputs(outputs));
  outputs_caption_->setVisible(!outputs.empty());
  outputs_->setVisible(!outputs.empty());
}

void WithdrawDialog::show_what_is_missing() {
  const bool deletes = delete_->isChecked();
  label_caption_->setEnabled(deletes);
  typed_->setEnabled(deletes);
  do_->setText(deletes ? tr("Delete the data") : tr("Withdraw"));
  set_role(*do_, deletes ? ButtonRole::danger : ButtonRole::primary);
  QString missing{};
  if (!study_.can_be_written()) {
    missing = tr("This study is read-only; copy it to a folder that you may write to.");
  } else if (by_->text().trimmed().isEmpty()) {
    missing = tr("Enter who decided this; the name is stored with the time.");
  } else if (deletes && typed_->text() != text(label_)) {
    missing = tr("Enter %1 to confirm the deletion.").arg(text(label_));
  }
  do_->setEnabled(missing.isEmpty());
  state_->set_state(State::unknown, missing.isEmpty() ? tr("This cannot be undone.") : missing);
}

void WithdrawDialog::withdraw() {
  const WithdrawalRow wanted{
      .data = delete_->isChecked() ? WithdrawnData::deleted : WithdrawnData::kept,
      .reason = static_cast<WithdrawalReason>(reason_->currentData().toInt()),
      .decided_by = by_->text().trimmed().toStdString()};
  question_->setEnabled(false);
  do_->setEnabled(false);
  cancel_->setEnabled(false);
  state_->set_state(State::unknown, wanted.data == WithdrawnData::deleted
                                        ? tr("Deleting the data…")
                                        : tr("Storing the withdrawal…"));
  work_.run<Withdrawal>(
      [folder = study_.folder(), label = label_, wanted](const std::stop_token&,
                                                         const BackgroundTask::Progress&) {
        Withdrawal done = Study::open(folder, Access::read_write).withdraw(label, wanted);
        // With those that were begun since the dialog opened.
        done.outputs = outputs_of_withdrawal(done, label);
        return done;
      },
      [this](const Withdrawal& done) { show_done(done); },
      [this](const QString& what) {
        question_->setEnabled(true);
        cancel_->setEnabled(true);
        show_what_is_missing();
        state_->set_state(State::stop, what);
        study_.announce_change();  // a deletion may have ended half way
      });
}

void WithdrawDialog::show_done(const Withdrawal& done) {
  const WithdrawalRow& row = done.row;
  question_->hide();
  do_->hide();
  cancel_->setEnabled(true);
  cancel_->setText(tr("Close"));
  cancel_->setFocus();
  show_outputs(done.outputs);
  const QString counts = text_of_counts(row);
  state_->set_state(State::fine,
                    row.data == WithdrawnData::deleted
                        ? tr("Deleted: %1.").arg(counts)
                        : tr("Kept and excluded from every analysis: %1.").arg(counts));
  fit_height();
  study_.announce_change();
}

// What has begun is brought to its end before the dialog closes.
void WithdrawDialog::reject() {
  if (!work_.is_running()) QDialog::reject();
}

}  // namespace asperity

#include "moc_withdraw_dialog.cpp"

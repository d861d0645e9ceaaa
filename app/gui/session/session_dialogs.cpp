// Builds both dialogs; the one for aborting contains the form for the reason.

#include "app/gui/session/session_dialogs.h"

#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/session/reason_form.h"
#include "app/words/offered_reasons.h"

namespace asperity {

namespace {

constexpr int kDialogTextWidth = 512;

QVBoxLayout* prepare_dialog(QDialog& dialog, const QString& title, const QString& text) {
  dialog.setAttribute(Qt::WA_DeleteOnClose);
  dialog.setWindowTitle(title);
  auto* rows = new QVBoxLayout(&dialog);
  // Never smaller than what is in it: a width that is set by hand would stand in for that.
  rows->setSizeConstraint(QLayout::SetMinimumSize);
  rows->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  rows->setSpacing(kMargin);
  rows->addWidget(make_heading(title, &dialog));
  QLabel* words = make_text(text, &dialog);
  words->setMinimumWidth(kDialogTextWidth);
  rows->addWidget(words);
  return rows;
}

/// Qt would limit the width of a dialog to two thirds of the screen, without the height that its texts then need.
void fit(QDialog& dialog) {
  dialog.ensurePolished();
  dialog.resize(dialog.layout()->totalSizeHint());
}

}  // namespace

AbortDialog::AbortDialog(QWidget* parent, std::function<void(Phrase)> on_abort) : QDialog(parent) {
  setObjectName("abort_dialog");
  QVBoxLayout* rows = prepare_dialog(
      *this, tr("Abort the session?"),
      tr("Nothing is lost: every completed trial is stored. The trial under way is stored as "
         "aborted and will be presented again when the session is resumed."));
  form_ = new ReasonForm(this);
  form_->setProperty("role", "plain");
  form_->layout()->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(form_);
  connect(form_, &ReasonForm::cancelled, this, &QDialog::reject);
  form_->ask(tr("Reason for aborting the session"), offered_reasons(ReasonFor::aborting),
             tr("Abort session"), [this, on_abort = std::move(on_abort)](const Phrase& reason) {
               on_abort(reason);
               accept();
             });
  // What it says to do is read whole, in every language.
  auto* field = form_->findChild<QLineEdit*>("reason");
  constexpr int kAround = 32;
  field->setMinimumWidth(field->fontMetrics().horizontalAdvance(field->placeholderText()) +
                         kAround);
  fit(*this);
}

void AbortDialog::lock(const QString& why) { form_->lock(why); }

CloseDialog::CloseDialog(QWidget* parent, std::function<void(Leaving)> on_leave) : QDialog(parent) {
  setObjectName("close_dialog");
  QVBoxLayout* rows =
      prepare_dialog(*this, tr("Session under way"),
                     tr("No data are lost: every completed trial is stored, and the session can be "
                        "resumed. The window closes once the session has ended."));
  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  auto* abort = make_button(tr("Abort now"), ButtonRole::plain, this);
  abort->setObjectName("close_abort");
  auto* stop = make_button(tr("Stop after this trial"), ButtonRole::plain, this);
  stop->setObjectName("close_stop");
  auto* keep = make_button(tr("Keep running"), ButtonRole::primary, this);
  keep->setObjectName("close_keep");
  keep->setDefault(true);
  buttons->addWidget(abort);
  buttons->addStretch(1);
  buttons->addWidget(stop);
  buttons->addWidget(keep);
  rows->addLayout(buttons);
  const auto leave = [this, on_leave = std::move(on_leave)](Leaving how) {
    on_leave(how);
    accept();
  };
  connect(keep, &QPushButton::clicked, this, &QDialog::reject);
  connect(stop, &QPushButton::clicked, this, [leave] { leave(Leaving::stop_after_trial); });
  connect(abort, &QPushButton::clicked, this, [leave] { leave(Leaving::abort_now); });
  fit(*this);
}

}  // namespace asperity

#include "moc_session_dialogs.cpp"

// Shows the statement, a checkbox with its time, and the name of the person who saw the consent.

#include "app/gui/start/consent_card.h"

#include <QtCore/QLocale>
#include <QtCore/QSettings>
#include <QtCore/QTime>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"

namespace asperity {

namespace {

constexpr const char* kSeenBy = "start/consent_seen_by";
constexpr int kNameWidth = 240;

}  // namespace

ConsentCard::ConsentCard(QWidget* parent) : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* layout = nullptr;
  outer->addWidget(make_card(this, layout));
  layout->addWidget(make_heading(tr("Consent"), this));
  statement_ = make_text({}, this, true);
  statement_->setObjectName("consent_statement");
  layout->addWidget(statement_);
  given_ = new QCheckBox(this);
  given_->setObjectName("consent_given");
  layout->addWidget(given_);
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  auto* label = make_text(tr("Witnessed by *"), this);
  label->setWordWrap(false);
  seen_by_ = new QLineEdit(QSettings().value(kSeenBy).toString(), this);
  seen_by_->setObjectName("consent_seen_by");
  seen_by_->setFixedWidth(kNameWidth);
  label->setBuddy(seen_by_);
  when_ = make_text({}, this, true);
  when_->setObjectName("consent_when");
  row->addWidget(label);
  row->addWidget(seen_by_);
  row->addWidget(when_, 1);
  layout->addLayout(row);
  connect(given_, &QCheckBox::toggled, this, [this] {
    show_time();
    emit changed();
  });
  connect(seen_by_, &QLineEdit::textChanged, this, &ConsentCard::changed);
  connect(seen_by_, &QLineEdit::editingFinished, this,
          [this] { QSettings().setValue(kSeenBy, seen_by_->text().trimmed()); });
}

void ConsentCard::set_statement(const QString& statement, const QString& version) {
  given_->setText(tr("The participant has agreed to this statement (version %1)").arg(version));
  if (statement == statement_->text()) return;
  statement_->setText(statement);
  forget();
}

void ConsentCard::forget() { given_->setChecked(false); }

void ConsentCard::fill_in(bool has_consented, const std::string& seen_by) {
  given_->setChecked(has_consented);
  seen_by_->setText(QString::fromStdString(seen_by));
}

bool ConsentCard::is_given() const { return given_->isChecked(); }

std::string ConsentCard::seen_by() const { return seen_by_->text().trimmed().toStdString(); }

std::vector<QString> ConsentCard::complaints() const {
  std::vector<QString> complaints{};
  if (!is_given())
    complaints.push_back(
        tr("The participant has not agreed to the statement yet; tick the box when the participant "
           "agrees."));
  if (seen_by().empty())
    complaints.push_back(
        tr("The witness of the participant's consent has not been entered; enter the name."));
  return complaints;
}

void ConsentCard::show_time() {
  when_->setText(is_given() ? tr("at %1").arg(QLocale().toString(QTime::currentTime(), "hh:mm"))
                            : QString());
}

}  // namespace asperity

#include "moc_consent_card.cpp"

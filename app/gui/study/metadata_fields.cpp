// Adds the fields to a form; an empty field is stored as no statement.

#include "app/gui/study/metadata_fields.h"

#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLineEdit>

namespace asperity {

namespace {

std::optional<std::string> stated_in(const QString& field) {
  const QString text = field.trimmed();
  return text.isEmpty() ? std::nullopt : std::optional(text.toStdString());
}

}  // namespace

MetadataFields::MetadataFields(QFormLayout& form, QWidget* dialog) : QObject(dialog) {
  authors_ = new QLineEdit(dialog);
  authors_->setObjectName("metadata_authors");
  authors_->setPlaceholderText(tr("Family, Given; Family, Given"));
  form.addRow(tr("Authors"), authors_);
  license_ = new QComboBox(dialog);
  license_->setObjectName("metadata_license");
  license_->setEditable(true);
  license_->addItems({{}, "CC0-1.0", "CC-BY-4.0", "CC-BY-SA-4.0", "CC-BY-NC-4.0"});
  license_->lineEdit()->setPlaceholderText(tr("for example: CC-BY-4.0"));
  form.addRow(tr("Licence of the data"), license_);
  ethics_ = new QLineEdit(dialog);
  ethics_->setObjectName("metadata_ethics");
  ethics_->setPlaceholderText(tr("committee and number of the approval"));
  form.addRow(tr("Ethics approval"), ethics_);
}

void MetadataFields::fill(const StudyMetadata& metadata) {
  QStringList authors{};
  for (const std::string& author : metadata.authors) authors << QString::fromStdString(author);
  authors_->setText(authors.join("; "));
  license_->setCurrentText(QString::fromStdString(metadata.license.value_or("")));
  ethics_->setText(QString::fromStdString(metadata.ethics_approval.value_or("")));
}

StudyMetadata MetadataFields::metadata() const {
  StudyMetadata metadata{};
  for (const QString& author : authors_->text().split(';')) {
    if (const auto name = stated_in(author)) metadata.authors.push_back(*name);
  }
  metadata.license = stated_in(license_->currentText());
  metadata.ethics_approval = stated_in(ethics_->text());
  return metadata;
}

}  // namespace asperity

#include "moc_metadata_fields.cpp"

// Composes the folder from name and place, and states why a study cannot be created there.

#include "app/gui/study/new_study_dialog.h"

#include <system_error>

#include <QtWidgets/QFileDialog>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLineEdit>

#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/dialog_buttons.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/study.h"

namespace asperity {

NewStudyDialog::NewStudyDialog(const std::filesystem::path& place, QWidget* parent)
    : QDialog(parent) {
  setObjectName("new_study_dialog");
  setWindowTitle(tr("Create a study"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(640);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Create a study"), this));
  layout->addWidget(make_text(
      tr("A study is a folder with its protocols, its stimuli, and all responses and recordings."),
      this, true));

  auto* form = new QFormLayout();
  form->setSpacing(kGrid);
  form->setHorizontalSpacing(kMargin);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  name_ = new QLineEdit(this);
  name_->setObjectName("new_study_name");
  name_->setPlaceholderText(tr("for example: Rough surfaces 2026"));
  form->addRow(tr("Name"), name_);
  place_ = new QLineEdit(text_of_path(place), this);
  place_->setObjectName("new_study_place");
  place_->setAccessibleName(tr("Parent folder"));
  QPushButton* browse = make_button(tr("Choose…"), ButtonRole::plain, this);
  auto* place_row = new QHBoxLayout();
  place_row->setSpacing(kGrid);
  place_row->addWidget(place_, 1);
  place_row->addWidget(browse);
  form->addRow(tr("Parent folder"), place_row);
  metadata_ = new MetadataFields(*form, this);
  layout->addLayout(form);

  what_follows_ = make_text({}, this, true);
  what_follows_->setObjectName("new_study_what_follows");
  layout->addWidget(what_follows_);
  layout->addStretch(1);

  create_ = make_button(tr("Create study"), ButtonRole::primary, this);
  create_->setObjectName("new_study_create");
  create_->setDefault(true);
  add_dialog_buttons(*this, *layout, create_);

  connect(name_, &QLineEdit::textChanged, this, &NewStudyDialog::show_what_follows);
  connect(place_, &QLineEdit::textChanged, this, &NewStudyDialog::show_what_follows);
  connect(create_, &QPushButton::clicked, this, [this] {
    emit wanted(folder(), metadata_->metadata());
    accept();
  });
  connect(browse, &QPushButton::clicked, this, [this] {
    auto* chooser = new QFileDialog(this, tr("Folder for the study"), place_->text());
    chooser->setAttribute(Qt::WA_DeleteOnClose);
    chooser->setFileMode(QFileDialog::Directory);
    chooser->setOption(QFileDialog::ShowDirsOnly);
    connect(chooser, &QFileDialog::fileSelected, place_, &QLineEdit::setText);
    chooser->open();
  });
  show_what_follows();
}

std::filesystem::path NewStudyDialog::folder() const {
  return path_of_text(place_->text().trimmed()) / name_->text().trimmed().toStdString();
}

QString NewStudyDialog::complaint(std::filesystem::file_status in_place) const {
  const QString name = name_->text().trimmed();
  if (name.isEmpty()) return tr("Enter a name for the study.");
  if (name.contains('/') || name == "." || name == "..") {
    return tr("The study's folder cannot be named “%1”; choose another name.").arg(name);
  }
  if (!path_of_text(place_->text().trimmed()).is_absolute()) {
    return tr("Enter the full path of the folder, beginning with “/” or “~”.");
  }
  if (!std::filesystem::exists(in_place)) return {};
  if (Study::exists(folder())) {
    return tr("%1 is already a study. Open it, or choose another name.")
        .arg(text_of_path(folder()));
  }
  try {
    if (std::filesystem::is_directory(in_place) && is_free(folder())) return {};
  } catch (const ResultsError&) {
    return tr("%1 already exists and cannot be read, so that it is unknown whether it is empty. "
              "Choose another name or another parent folder.")
        .arg(text_of_path(folder()));
  }
  return tr("%1 already exists and is not an empty folder. Choose another name or another parent "
            "folder, or move the other files out of that folder.")
      .arg(text_of_path(folder()));
}

void NewStudyDialog::show_what_follows() {
  std::error_code ignored{};
  const std::filesystem::file_status in_place = std::filesystem::status(folder(), ignored);
  const bool exists = std::filesystem::exists(in_place);
  const QString wrong = complaint(in_place);
  const bool is_possible = wrong.isEmpty();
  create_->setEnabled(is_possible);
  create_->setText(is_possible && exists ? tr("Create here") : tr("Create study"));
  what_follows_->setText(
      !is_possible ? wrong
      : exists ? tr("%1 is an empty folder. It will become the study.").arg(text_of_path(folder()))
               : tr("The study will be created in %1.").arg(text_of_path(folder())));
}

}  // namespace asperity

#include "moc_new_study_dialog.cpp"

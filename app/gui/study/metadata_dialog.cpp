// Puts the fields into a form with Cancel and Save, and emits the metadata when they are saved.

#include "app/gui/study/metadata_dialog.h"

#include <QtWidgets/QFormLayout>

#include "app/gui/look/controls.h"
#include "app/gui/look/dialog_buttons.h"

namespace asperity {

MetadataDialog::MetadataDialog(const StudyMetadata& metadata, QWidget* parent) : QDialog(parent) {
  setObjectName("metadata_dialog");
  setWindowTitle(tr("Metadata of the study"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(640);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Metadata of the study"), this));
  layout->addWidget(
      make_text(tr("Exports include the metadata: data archives require authors and a licence."),
                this, true));
  auto* form = new QFormLayout();
  form->setSpacing(kGrid);
  form->setHorizontalSpacing(kMargin);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  fields_ = new MetadataFields(*form, this);
  fields_->fill(metadata);
  layout->addLayout(form);
  layout->addStretch(1);

  QPushButton* save = make_button(tr("Save"), ButtonRole::primary, this);
  save->setObjectName("metadata_save");
  save->setDefault(true);
  add_dialog_buttons(*this, *layout, save);

  connect(save, &QPushButton::clicked, this, [this] {
    emit wanted(fields_->metadata());
    accept();
  });
}

}  // namespace asperity

#include "moc_metadata_dialog.cpp"

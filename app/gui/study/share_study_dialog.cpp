// States who can read the study at present, and offers the groups of the user in a list.

#include "app/gui/study/share_study_dialog.h"

#include <string>

#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>

#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/dialog_buttons.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

/// Who has the study before anything is changed here.
QString access_text(const std::filesystem::path& study) {
  if (is_shared_with_group(study)) {
    return ShareStudyDialog::tr("At present the study is shared with the group “%1”.")
        .arg(QString::fromStdString(group_of(study)));
  }
  return is_readable_by_others(study)
             ? ShareStudyDialog::tr("At present every user of this computer can read the study.")
             : ShareStudyDialog::tr("At present the study is not shared.");
}

}  // namespace

ShareStudyDialog::ShareStudyDialog(const std::filesystem::path& study, QWidget* parent)
    : QDialog(parent) {
  setObjectName("share_study_dialog");
  setWindowTitle(tr("Share the study"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(560);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Share the study"), this));
  auto* at_present = make_text(access_text(study), this);
  at_present->setObjectName("share_study_now");
  layout->addWidget(at_present);
  layout->addWidget(make_text(
      tr("Members of the group can read and change everything in %1 and run sessions. Other "
         "users of this computer cannot read it.")
          .arg(text_of_path(study)),
      this, true));

  group_ = new ChoiceBox(this);
  group_->setObjectName("share_study_group");
  for (const std::string& name : own_groups()) group_->addItem(QString::fromStdString(name));
  const QString now = QString::fromStdString(group_of(study));
  if (group_->findText(now) < 0) group_->addItem(now);
  group_->setCurrentText(now);
  auto* form = new QFormLayout();
  form->setHorizontalSpacing(kMargin);
  form->addRow(tr("Group"), group_);
  layout->addLayout(form);
  layout->addStretch(1);

  QPushButton* share = make_button(tr("Share"), ButtonRole::primary, this);
  share->setObjectName("share_study_share");
  share->setDefault(true);
  add_dialog_buttons(*this, *layout, share);

  connect(share, &QPushButton::clicked, this, [this] {
    emit wanted(group_->currentText());
    accept();
  });
}

}  // namespace asperity

#include "moc_share_study_dialog.cpp"

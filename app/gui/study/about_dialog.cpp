// Builds the dialog from labels with version, licence and the folder of the documents.

#include "app/gui/study/about_dialog.h"

#include <QtWidgets/QBoxLayout>

#include "app/gui/base/documents.h"
#include "app/gui/look/controls.h"
#include "app/study_files/program.h"

namespace asperity {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("about_dialog");
  setWindowTitle(tr("About Asperity"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(560);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_title(tr("Asperity"), this));
  layout->addWidget(make_text(tr("Psychophysics experiments on haptic texture."), this));
  QLabel* version = make_text(QString::fromStdString(version_line()), this, true);
  version->setObjectName("about_version");
  version->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  layout->addWidget(version);
  layout->addWidget(make_text(
      tr("Free software under the GNU General Public License, version 3 or later, without any "
         "warranty."),
      this, true));
  const QString documents = documents_folder();
  layout->addWidget(make_text(documents.isEmpty()
                                  ? tr("The documents are not installed on this computer.")
                                  : tr("The documents are in %1.").arg(documents),
                              this, true));
  auto* row = new QHBoxLayout();
  QPushButton* close = make_button(tr("Close"), ButtonRole::plain, this);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  row->addStretch(1);
  row->addWidget(close);
  layout->addLayout(row);
}

}  // namespace asperity

#include "moc_about_dialog.cpp"

// Makes "Cancel" and keeps it before the other button in the order of the keyboard.

#include "app/gui/look/dialog_buttons.h"

#include <QtCore/QCoreApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QDialog>

#include "app/gui/look/controls.h"

namespace asperity {

QPushButton* add_dialog_buttons(QDialog& dialog, QBoxLayout& layout, QPushButton* accept,
                                std::initializer_list<QWidget*> left) {
  QPushButton* const cancel = make_button(
      QCoreApplication::translate("asperity::DialogButtons", "Cancel"), ButtonRole::plain, &dialog);
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  for (QWidget* const widget : left) row->addWidget(widget);
  row->addStretch(1);
  row->addWidget(cancel);
  row->addWidget(accept);
  layout.addLayout(row);
  QWidget::setTabOrder(cancel, accept);
  QObject::connect(cancel, &QPushButton::clicked, &dialog, &QDialog::reject);
  return cancel;
}

}  // namespace asperity

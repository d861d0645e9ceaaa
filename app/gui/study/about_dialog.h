// Which program this is, under which licence, and where its documents are.

#pragma once

#include <QtWidgets/QDialog>

namespace asperity {

class AboutDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

}  // namespace asperity

// Which program this is, under which licence, and where its documents are.

#pragma once

#include <QtWidgets/QDialog>

namespace asperity {

/// Where the documents of this program lie on this machine; empty when they were not installed.
QString documents_folder();

class AboutDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

}  // namespace asperity

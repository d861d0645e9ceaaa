// The fields for a study's authors, license and ethics approval.

#pragma once

#include <QtWidgets/QWidget>

#include "results_schema/rows.h"

class QComboBox;
class QFormLayout;
class QLineEdit;

namespace asperity {

/// Adds its three rows to a form and reads them. Belongs to the dialog that shows them.
class MetadataFields final : public QObject {
  Q_OBJECT
 public:
  MetadataFields(QFormLayout& form, QWidget* dialog);

  void fill(const StudyMetadata& metadata);
  StudyMetadata metadata() const;

 private:
  QLineEdit* authors_ = nullptr;  ///< with semicolons between
  QComboBox* license_ = nullptr;
  QLineEdit* ethics_ = nullptr;
};

}  // namespace asperity

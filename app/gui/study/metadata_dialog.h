// Asks for the authors, the license and the ethics approval of a study.

#pragma once

#include <QtWidgets/QDialog>

#include "app/gui/study/metadata_fields.h"

namespace asperity {

/// Shows what the study states. Changes nothing itself.
class MetadataDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit MetadataDialog(const StudyMetadata& metadata, QWidget* parent = nullptr);

 signals:
  void wanted(const StudyMetadata& metadata);

 private:
  MetadataFields* fields_ = nullptr;
};

}  // namespace asperity

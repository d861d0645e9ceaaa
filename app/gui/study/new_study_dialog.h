// Asks for the name and the place of a study to make.

#pragma once

#include <filesystem>

#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>

#include "app/gui/study/metadata_fields.h"

class QLineEdit;

namespace asperity {

/// The study's folder is called as the study is. What cannot become one is said beside the button.
class NewStudyDialog final : public QDialog {
  Q_OBJECT
 public:
  /// `place`: where new studies lie, as a suggestion.
  NewStudyDialog(const std::filesystem::path& place, QWidget* parent = nullptr);

 signals:
  void wanted(const std::filesystem::path& folder, const StudyMetadata& metadata);

 private:
  std::filesystem::path folder() const;
  /// Why the study cannot be made, with what is in its place; empty when it can.
  QString complaint(std::filesystem::file_status in_place) const;
  void show_what_follows();

  QLineEdit* name_ = nullptr;
  QLineEdit* place_ = nullptr;
  MetadataFields* metadata_ = nullptr;
  QLabel* what_follows_ = nullptr;
  QPushButton* create_ = nullptr;
};

}  // namespace asperity

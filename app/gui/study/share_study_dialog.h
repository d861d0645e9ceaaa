// Asks which group a study is to be shared with.

#pragma once

#include <filesystem>

#include <QtWidgets/QDialog>

class QComboBox;

namespace asperity {

/// Offers the groups of the user and chooses the one that the folder has. Changes nothing itself.
class ShareStudyDialog final : public QDialog {
  Q_OBJECT
 public:
  ShareStudyDialog(const std::filesystem::path& study, QWidget* parent = nullptr);

 signals:
  void wanted(const QString& group);

 private:
  QComboBox* group_ = nullptr;
};

}  // namespace asperity

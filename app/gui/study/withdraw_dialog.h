// Asks what becomes of the data of a participant who withdraws, and does it.

#pragma once

#include <string>
#include <vector>

#include <QtWidgets/QDialog>

#include "app/gui/look/background_task.h"
#include "app/study_files/study_outputs.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QRadioButton;
class QWidget;

namespace asperity {

class OpenStudy;
class StateLabel;

/// Keeps the data without using them, or deletes them once the label has been typed again. Afterwards it names what was
/// made of the study and may still hold the data.
///
/// The names of its parts: "withdraw_keep", "withdraw_delete", "withdraw_reason", "withdraw_by", "withdraw_label",
/// "withdraw_do", "withdraw_state", "withdraw_outputs".
class WithdrawDialog final : public QDialog {
  Q_OBJECT
 public:
  /// Errors: ResultsError for a label that is not there. `study` outlives it.
  WithdrawDialog(OpenStudy& study, const std::string& label, QWidget* parent = nullptr);

 private:
  void show_outputs(const std::vector<OutputRow>& outputs);
  void show_what_is_missing();
  void fit_height();
  void withdraw();
  void show_done(const Withdrawal& done);
  void reject() override;

  OpenStudy& study_;
  std::string label_{};
  QWidget* question_ = nullptr;  ///< hidden once it is done
  QRadioButton* keep_ = nullptr;
  QRadioButton* delete_ = nullptr;
  QComboBox* reason_ = nullptr;
  QLineEdit* by_ = nullptr;
  QLabel* label_caption_ = nullptr;
  QLineEdit* typed_ = nullptr;
  QLabel* outputs_caption_ = nullptr;  ///< hidden, like the list, where there are none
  QPlainTextEdit* outputs_ = nullptr;
  StateLabel* state_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* do_ = nullptr;
  BackgroundTask work_{};
};

}  // namespace asperity

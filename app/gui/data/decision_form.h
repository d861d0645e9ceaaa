// Asks why, and writes a decision about data into the study.

#pragma once

#include <cstdint>
#include <vector>

#include <QtWidgets/QFrame>

#include "analysis/words/phrase.h"
#include "app/gui/look/background_task.h"
#include "results_schema/rows.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace asperity {

class OpenStudy;
class StateLabel;

/// A question in place. Nothing is written before there is a reason; what is written takes nothing
/// away. Afterwards everybody who shows the study is told.
class DecisionForm final : public QFrame {
  Q_OBJECT
 public:
  struct Question {
    std::int64_t session_id = 0;
    DecisionRow draft{};  ///< what it is about, and the verdict
    QString text{};
    std::vector<Phrase> offered{};  ///< see offered_reasons
    QString verb{};
  };

  explicit DecisionForm(OpenStudy& study, QWidget* parent = nullptr);

  /// Shows itself, in place of a question that was not answered.
  void ask(const Question& question);
  void cancel();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show_what_is_missing();
  void write();

  OpenStudy& study_;
  Question question_{};
  QLabel* text_ = nullptr;
  QComboBox* reason_ = nullptr;
  QLineEdit* by_ = nullptr;
  QPushButton* write_ = nullptr;
  StateLabel* note_ = nullptr;
  BackgroundTask writing_{};
};

}  // namespace asperity

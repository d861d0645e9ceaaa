// What was answered last, and before that.

#pragma once

#include <QtWidgets/QWidget>

#include "app/session/session_monitor.h"

class QLabel;

namespace asperity {

class PlanModel;

/// Answers by the labels that the participant saw. Whether they were right is told where the plan
/// tells it.
class AnswersPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit AnswersPanel(QWidget* parent = nullptr);
  void show_answers(const std::vector<AttemptSummary>& attempts, const PlanModel& plan);

 private:
  QLabel* last_ = nullptr;
  QLabel* earlier_ = nullptr;
};

}  // namespace asperity

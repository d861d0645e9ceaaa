// The steps of a session as a protocol would lay them out: for one seed, row and group of participants.

#pragma once

#include <memory>

#include <QtWidgets/QWidget>

#include "app/gui/look/newest_work.h"
#include "protocols/plan/plan.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QSpinBox;

namespace asperity {

class StudyTable;

class PlanPreview final : public QWidget {
  Q_OBJECT
 public:
  /// What there is room for: a wide table alone, or a narrow one with the chosen step below it.
  enum class Shape { wide, tall };

  explicit PlanPreview(Shape shape, QWidget* parent = nullptr);

  /// A protocol without problems.
  void show_protocol(const Protocol& protocol);
  /// Of the seed, row and group that are set.
  Allocation allocation() const;

 private:
  void add_choice(QHBoxLayout& row);
  void make_plan_anew();
  void show_plan();
  void show_step(int step);

  std::shared_ptr<const Protocol> protocol_{};
  std::shared_ptr<const Plan> plan_{};
  QSpinBox* seed_ = nullptr;
  QSpinBox* row_ = nullptr;
  QLabel* rows_ = nullptr;
  QComboBox* group_ = nullptr;
  QLabel* words_ = nullptr;
  StudyTable* table_ = nullptr;
  QLabel* detail_ = nullptr;  ///< null in the wide shape
  NewestWork work_{};
};

}  // namespace asperity

// The steps of a session as a protocol would lay them out: for one seed, row and group of participants.

#pragma once

#include <memory>
#include <optional>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/gui/look/newest_work.h"
#include "protocols/plan/plan.h"

class QComboBox;
class QLabel;
class QLayout;
class QSpinBox;

namespace asperity {

class PlanBars;
class StudyTable;

class PlanPreview final : public QWidget {
  Q_OBJECT
 public:
  /// What there is room for: a wide table alone, or bars of the blocks and a narrow table with the chosen step below it.
  enum class Shape { wide, tall };

  explicit PlanPreview(Shape shape, QWidget* parent = nullptr);

  /// A protocol without problems.
  void show_protocol(const Protocol& protocol);
  /// The next protocol is another one, and nothing of the plan before stays until its plan has been made.
  void forget();
  /// Of the seed, row and group that are set.
  Allocation allocation() const;
  /// Another box that shows and sets the group, for another view of the plan.
  QComboBox* make_group_choice(QWidget* parent);
  /// Selects a step of a plan in the tall shape.
  void select_step(int step);

  /// What is set and selected.
  struct Choice {
    Allocation allocation{};
    QString step{};  ///< empty: none
  };
  Choice choice() const;
  /// The same again, of the next protocol that is shown, as far as it has the row, the group and the step.
  void resume(const Choice& choice) { resumed_ = choice; }

 signals:
  /// A step of the tall shape is selected, or is another after a change of the plan. Its texts are as participants read them.
  void step_shown(const std::shared_ptr<const asperity::Protocol>& protocol,
                  const std::shared_ptr<const asperity::Plan>& plan, int step);

 private:
  void add_choice(QLayout& row);
  QComboBox* make_group_box(QWidget* parent);
  void show_group();
  void make_plan_anew();
  void show_plan();
  void show_step(int step);

  std::shared_ptr<const Protocol> protocol_{};
  std::shared_ptr<const Protocol>
      planned_{};  ///< the protocol of `plan_`, which can be an earlier one
  std::shared_ptr<const Plan> plan_{};
  std::optional<Choice> resumed_{};
  QSpinBox* seed_ = nullptr;
  QSpinBox* row_ = nullptr;
  QComboBox* group_ = nullptr;
  QComboBox* other_group_ = nullptr;  ///< in another view; null: none
  QLabel* words_ = nullptr;
  PlanBars* bars_ = nullptr;  ///< null in the wide shape, of which the list has the height
  StudyTable* table_ = nullptr;
  QLabel* detail_ = nullptr;  ///< null in the wide shape
  NewestWork work_{};
};

}  // namespace asperity

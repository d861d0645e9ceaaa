// Declares the participant's screen at each step of a plan.

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/session/session_monitor.h"

class QHBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace asperity {

class FittedLabel;
class ParticipantView;

/// What a participant reads, sees and is asked at a step, drawn by the participant's window and scaled down, without input.
class ScreenPreview final : public QWidget {
  Q_OBJECT
 public:
  /// `study`: the folder of the pictures.
  explicit ScreenPreview(std::filesystem::path study, QWidget* parent = nullptr);
  ~ScreenPreview() override;

  /// Shows the choice of the group above the number of the step, which then does not name the group.
  void add_group_choice(QWidget* choice);

  /// Shows the screens of a step, once it is visible. The texts of the steps are as participants read them.
  void show_step(std::shared_ptr<const Protocol> protocol, std::shared_ptr<const Plan> plan,
                 std::size_t step);
  /// Nothing of the plan before stays until a step is shown.
  void forget();

 signals:
  /// ← or → beyond the screens of the step.
  void step_wanted(int step);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void make_view();
  void show_wanted();
  void turn(int by);
  void show_screen();

  std::filesystem::path study_{};
  std::shared_ptr<const Protocol> protocol_{};
  std::shared_ptr<const Plan> plan_{};
  std::size_t step_ = 0;
  bool is_shown_ = false;                    ///< the step and its plan are those on the screen
  bool from_the_end_ = false;                ///< the next step was wanted by going back
  std::shared_ptr<const Plan> viewed_{};     ///< of the view
  std::vector<ParticipantScene> screens_{};  ///< of the step
  std::size_t screen_ = 0;
  std::unique_ptr<SessionMonitor> monitor_{};
  ParticipantView* view_ = nullptr;
  QVBoxLayout* layout_ = nullptr;
  QHBoxLayout* row_ = nullptr;
  bool has_group_choice_ = false;
  FittedLabel* words_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* next_ = nullptr;
};

/// The screens of one step of a plan. The check of the device has none.
std::vector<ParticipantScene> screens_of(const Protocol& protocol, const Plan& plan,
                                         std::size_t step);

}  // namespace asperity

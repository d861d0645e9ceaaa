// The answer to a trial's question while it is being made.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/session/respondents/participant_scene.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// What is chosen or assigned so far. Surfaces and options count from 0, as they stand in the
/// trial; numbers that are not there must not be asked for.
///
/// A choice has one option, the last one chosen. In an assignment each option belongs to one
/// surface at most: given to another, it moves. There is always a surface whose turn it is; after
/// an option was given it is the next one that has none, and when all have one, the next in order,
/// so that an assignment can be changed until it is confirmed.
///
/// Without sight one option after the other is pointed at. In a choice that chooses it; in an
/// assignment it is given by `take_pointed`. Where surfaces may be felt again, that wish comes after
/// the last option, and the first option after it; in a choice nothing is chosen then. Whatever
/// changes the answer forgets the wish.
class AnswerSheet final {
 public:
  explicit AnswerSheet(const Trial& trial);

  std::size_t options() const noexcept { return options_; }
  std::size_t surfaces() const noexcept { return given_.size(); }
  bool is_assignment() const noexcept { return is_assignment_; }

  /// In an assignment: to the surface whose turn it is.
  void choose(std::size_t option);
  void assign(std::size_t option, std::size_t surface);
  void take_back(std::size_t option);
  void turn_to(std::size_t surface);
  std::size_t turn() const noexcept { return turn_; }

  /// Points at the next option and returns it; nothing when it is the wish to feel a surface again.
  std::optional<std::size_t> point();
  bool points_at_feeling_again() const noexcept { return points_at_feeling_again_; }
  void forget_feeling_again() noexcept { points_at_feeling_again_ = false; }
  /// Gives what is pointed at to the surface whose turn it is; false where nothing is.
  bool take_pointed();

  bool is_complete() const noexcept;
  /// The first surface without an option.
  std::optional<std::size_t> free_surface() const noexcept;
  /// One per item of the question. Only of a complete answer.
  std::vector<std::size_t> answer() const;

  /// Puts the marks on a scene of this question.
  void mark(ParticipantScene& scene) const;

 private:
  void pass_turn();

  bool is_assignment_ = false;
  bool may_feel_again_ = false;
  std::size_t options_ = 0;
  /// Of each surface, or the one answer of a choice.
  std::vector<std::optional<std::size_t>> given_{};
  std::size_t turn_ = 0;
  std::optional<std::size_t> pointed_{};
  bool points_at_feeling_again_ = false;
};

}  // namespace asperity

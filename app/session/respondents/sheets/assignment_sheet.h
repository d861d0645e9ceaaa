// Stores an assignment while it is composed: one option for each surface.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

/// Each option belongs to at most one surface: when given to another, it moves. One surface is
/// always current: after it receives an option, the next one without an option becomes current, and
/// when all have one, the next in order, so that an assignment can be changed until it is
/// confirmed.
///
/// The device's first button selects one option after another, and a confirmation by button gives
/// the selected option to the current surface. Where surfaces may be felt again, that request
/// follows the last option. Every change of the answer cancels the request.
class AssignmentSheet final : public AnswerSheet {
 public:
  AssignmentSheet(const Trial& trial, const Question& question);

  SheetResult take(const ParticipantInput& input) override;
  void mark(ParticipantScene& scene) const override;
  void forget_feeling_again() override { points_at_feeling_again_ = false; }

 private:
  SheetResult take_assignment(const ParticipantInput& input);
  SheetResult point();
  SheetResult confirm();
  void assign(std::size_t option, std::size_t surface);
  void take_back(std::size_t option);
  void advance();
  std::optional<std::size_t> first_without_option() const noexcept;

  std::size_t options_ = 0;
  bool may_feel_again_ = false;
  std::vector<std::string> codes_{};                 ///< of the surfaces
  std::vector<std::optional<std::size_t>> given_{};  ///< option by surface
  std::size_t current_ = 0;
  std::optional<std::size_t> pointed_{};
  bool points_at_feeling_again_ = false;
};

}  // namespace asperity

// Stores the marks on a page of scales while they are set.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

/// One or more scales, which are confirmed together once each has a mark.
///
/// A scale has no mark before it is first touched, so that no position suggests an answer. A pointer
/// sets the mark where it presses. A key or button has to begin somewhere: the first step shows a
/// mark in the middle that is not an answer, and later steps move it, by a point or by a hundredth of
/// the line; what they reach is one. A digit sets the mark at that point. One scale is always current:
/// keys and buttons refer to it, and after a digit the next scale without a mark becomes current.
///
/// The device's first button steps to the right, and from the right end to the left one, in tenths
/// where the scale has no points; a confirmation by button goes on to the next scale without a mark,
/// and confirms the page when there is none. Where surfaces may be felt again, that request follows the
/// right end of the last scale.
///
/// The response time of a scale is that of the last change of its mark; that of a page with a single
/// scale is the confirmation, as for other forms. Every change is stored as an event with its time.
class ScaleSheet final : public AnswerSheet {
 public:
  ScaleSheet(const Trial& trial, std::span<const Question> page);

  SheetResult take(const ParticipantInput& input) override;
  void mark(ParticipantScene& scene) const override;
  void forget_feeling_again() override { points_at_feeling_again_ = false; }

 private:
  struct Mark {
    ScaleForm form{};
    std::optional<int> step{};
    bool counts = false;  ///< it is an answer
    bool is_optional = false;
    std::int64_t changed_ns = 0;
  };

  SheetResult set(std::size_t scale, int step, const ParticipantInput& input);
  SheetResult move(const ParticipantInput& input);
  SheetResult choose_point(const ParticipantInput& input);
  SheetResult select(const ParticipantInput& input);
  SheetResult step_by_button(const ParticipantInput& input);
  SheetResult confirm(const ParticipantInput& input);
  /// The next scale without an answer, beginning after the current one.
  std::optional<std::size_t> next_without_answer() const noexcept;

  std::vector<Mark> marks_{};
  std::size_t current_ = 0;
  std::size_t surfaces_ = 0;
  bool may_feel_again_ = false;
  bool points_at_feeling_again_ = false;
};

}  // namespace asperity

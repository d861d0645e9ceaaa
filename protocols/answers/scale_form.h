// A point on a scale: labelled points, a semantic differential, or a visual analogue scale.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/answers/number_range.h"

namespace asperity {

struct AnsweredItem;
struct Question;

/// The answer is a position on a line from `minimum` to `maximum`.
///
/// With `points`, the positions are that many equally spaced points, both ends included: a Likert
/// scale where every point has a label, a semantic differential where only the ends have one.
/// Without, every position can be given, in thousandths of the line: a visual analogue scale.
struct ScaleForm {
  static constexpr std::string_view kName = "scale";
  /// Positions of a line without points, less one.
  static constexpr int kFineSteps = 1000;

  double minimum = 0.0;               ///< the value of the left end
  double maximum = 100.0;             ///< the value of the right end; above `minimum`
  int points = 0;                     ///< 0, or at least 2
  std::vector<std::string> labels{};  ///< none, of the two ends, or one for every point

  int steps() const noexcept { return points > 0 ? points - 1 : kFineSteps; }
  bool labels_every_point() const noexcept {
    return points > 2 && labels.size() == static_cast<std::size_t>(points);
  }
  /// The value that is stored for a step from 0 to steps().
  double value_at(int step) const noexcept {
    // The division comes last: whole values stay whole. Rounding must not exceed the right end.
    return step == steps() ? maximum : minimum + (maximum - minimum) * step / steps();
  }
  /// The step whose value is next to a value from `minimum` to `maximum`; nothing outside them.
  std::optional<int> step_near(double value) const noexcept;
  /// The same for a number that a participant typed: a scale with points takes only their values.
  std::optional<int> step_of(double typed) const noexcept;
  NumberRange numbers() const noexcept { return {minimum, maximum}; }
  bool can_be_stored_as(const std::string& text) const { return stored_step(text).has_value(); }
  /// The step whose value is stored as this text.
  std::optional<int> stored_step(const std::string& text) const;
  /// A stored number, followed by the label of its point where every point has one.
  std::string label_of(const std::string& stored) const;
  bool operator==(const ScaleForm&) const = default;
};

struct ScalePoint {
  int step = 0;  ///< from 0 at the left end to ScaleForm::steps()
};

std::vector<AnsweredItem> items_of(const Question& question, const ScaleForm& form,
                                   const ScalePoint& answer);

}  // namespace asperity

// Answers that are a formula of participant, trial and question.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocols/answers/question.h"
#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"

namespace asperity::test {

/// Who answers, and when.
struct FormulaPlace {
  int participant = 1;
  int session = 1;
  int trial = 0;  ///< 0 of what belongs to the session
};

/// A number in [0, 1), the same on every machine: a hash of the place and the text.
double formula_number(const FormulaPlace& place, std::string_view text);

/// The answers of made-up participants to the questions of a protocol. They use no generator and no mathematical function of the C
/// library, so that nothing but the protocol and the plan changes them.
///
/// The intensity of a surface is the mean of its numbers that differ within the protocol (parameters, stiffness, spacing of its
/// texture), each from 0 to 1. Responses depend on it so that analyses have an effect to find: the
/// proportion correct increases with the difference of intensities, and so do ratings, numbers and lines with the intensity.
class FormulaAnswers final {
 public:
  explicit FormulaAnswers(const Protocol& protocol);

  Answer answer(const Trial& trial, const Question& question, const FormulaPlace& place) const;
  /// None of an optional question.
  std::optional<Answer> answer(const Question& question, const FormulaPlace& place) const;

 private:
  using Numbers = std::map<std::string, double, std::less<>>;

  Numbers numbers_of(const PlannedPresentation& surface) const;
  double intensity(const PlannedPresentation& surface) const;
  double difference(const Trial& trial) const;
  double rank(const std::string& item) const;
  double sensation(const Trial& trial, const Question& question, const FormulaPlace& place) const;
  bool is_correct(const Trial& trial, const Question& question, const FormulaPlace& place) const;
  std::size_t chosen_option(const Trial& trial, const Question& question,
                            const FormulaPlace& place) const;
  std::vector<std::size_t> assigned_options(const Trial& trial, const Question& question,
                                            const FormulaPlace& place) const;

  const Protocol& protocol_;
  std::map<std::string, std::pair<double, double>, std::less<>> ranges_{};
  std::vector<std::string> items_{};  ///< sorted
};

}  // namespace asperity::test

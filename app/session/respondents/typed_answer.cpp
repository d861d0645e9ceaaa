// Accepts options by value, text or number, and numbers with either decimal separator.

#include "app/session/respondents/typed_answer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "results_schema/tables/table.h"

namespace asperity {

std::optional<std::size_t> whole_number(const std::string& text) {
  std::size_t number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) return {};
  return number;
}

bool is_unclear_estimate(const std::string& text) {
  const std::string typed = trimmed(text);
  const auto is_digit = [](char sign) { return sign >= '0' && sign <= '9'; };
  const std::size_t mark = typed.find_first_of(".,");
  if (mark == std::string::npos || mark < 1 || mark > 3 || typed.size() != mark + 4) return false;
  if (typed.front() == '0') return false;
  return std::all_of(typed.begin(), typed.begin() + static_cast<std::ptrdiff_t>(mark), is_digit) &&
         std::all_of(typed.begin() + static_cast<std::ptrdiff_t>(mark) + 1, typed.end(), is_digit);
}

std::optional<double> estimate_in(const std::string& text) {
  if (is_unclear_estimate(text)) return {};
  std::string with_point = trimmed(text);
  // Several of these would be thousands separators, whose meaning is ambiguous.
  if (std::count_if(with_point.begin(), with_point.end(),
                    [](char sign) { return sign == '.' || sign == ','; }) > 1) {
    return {};
  }
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const std::optional<double> number = number_in(with_point);
  if (!number || !std::isfinite(*number) || *number <= 0.0) return {};
  return number;
}

std::string trimmed(const std::string& text) {
  constexpr const char* kBlank = " \t\r\n";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string with_decimal_point(const std::string& typed) {
  std::string with_point = typed;
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const bool is_clear = with_point == typed || !is_unclear_estimate(typed);
  return is_clear && number_in(with_point) ? with_point : typed;
}

namespace {

/// The position of the option that was typed by its number, or in the questionnaire by its value or text.
std::optional<std::size_t> typed_option(const Question& question, const std::string& typed) {
  // The participant of a trial sees numbers, and the values are hidden: they can be other numbers.
  const bool is_of_trial = !question.options.empty() && !question.options.front().label.empty();
  if (!is_of_trial) {
    // An option may itself be a number: a literal match takes precedence.
    if (const auto option = question.option_of(typed)) return option;
    const auto found = std::ranges::find(question.options, typed, &Option::text);
    if (found != question.options.end()) {
      return static_cast<std::size_t>(found - question.options.begin());
    }
  }
  const std::optional<std::size_t> number = whole_number(typed);
  if (number && *number >= 1 && *number <= question.options.size()) return *number - 1;
  return {};
}

/// The positions of the options that were typed as numbers, or one that was typed as a text; none
/// where a part of the text is not an option.
std::set<std::size_t> typed_options(const Question& question, const std::string& typed) {
  if (const auto only = typed_option(question, typed)) return {*only};
  std::set<std::size_t> chosen{};
  std::string separated = typed;
  std::replace(separated.begin(), separated.end(), ',', ' ');
  std::istringstream parts(separated);
  for (std::string part{}; parts >> part;) {
    const std::optional<std::size_t> number = whole_number(part);
    if (!number || *number < 1 || *number > question.options.size()) return {};
    chosen.insert(*number - 1);
  }
  return chosen;
}

/// Reads one form each.
struct TypedAnswerReader {
  const Question& question;
  const std::string& typed;

  TypedAnswer operator()(const TextForm&) const { return WrittenText{typed}; }
  TypedAnswer operator()(const NumberForm& form) const {
    if (form.is_estimate) return estimate();
    const std::optional<double> number = number_in(with_decimal_point(typed));
    if (number && form.accepts(*number)) return GivenNumber{*number};
    return number_needed(form.numbers());
  }
  TypedAnswer operator()(const ScaleForm& form) const {
    const std::optional<double> number = number_in(with_decimal_point(typed));
    const std::optional<int> step = number ? form.step_of(*number) : std::nullopt;
    if (step) return ScalePoint{*step};
    return number_needed(form.numbers());
  }
  TypedAnswer operator()(const LineForm&) const {
    const bool is_line = !typed.empty() && typed.size() <= kLongestTypedLine &&
                         std::all_of(typed.begin(), typed.end(), [](char s) { return s == '-'; });
    if (is_line) {
      return DrawnLength{static_cast<int>(typed.size() * LineForm::kSteps / kLongestTypedLine)};
    }
    return ParticipantMessage{.what = ParticipantMessage::What::line_needed};
  }
  TypedAnswer operator()(const ChoiceForm&) const {
    if (const auto option = typed_option(question, typed)) return ChosenOption{*option};
    return message_of_options(ParticipantMessage::What::option_needed);
  }
  TypedAnswer operator()(const MultipleChoiceForm&) const {
    const std::set<std::size_t> chosen = typed_options(question, typed);
    if (!chosen.empty()) return ChosenOptions{{chosen.begin(), chosen.end()}};
    return message_of_options(ParticipantMessage::What::options_needed);
  }
  TypedAnswer operator()(const AssignmentForm&) const {
    throw std::logic_error("an assignment is not typed as one text; use AssignmentDialogue");
  }

 private:
  TypedAnswer estimate() const {
    if (const std::optional<double> number = estimate_in(typed)) return GivenNumber{*number};
    if (!is_unclear_estimate(typed)) {
      return ParticipantMessage{.what = ParticipantMessage::What::estimate_needed};
    }
    return ParticipantMessage{.what = ParticipantMessage::What::estimate_unclear, .code = typed};
  }
  static TypedAnswer number_needed(const NumberRange& range) {
    return ParticipantMessage{.what = ParticipantMessage::What::number_needed,
                              .minimum = range.minimum,
                              .maximum = range.maximum};
  }
  TypedAnswer message_of_options(ParticipantMessage::What what) const {
    return ParticipantMessage{.what = what, .number = static_cast<int>(question.options.size())};
  }
};

}  // namespace

TypedAnswer typed_answer(const Question& question, const std::string& text) {
  const std::string typed = trimmed(text);
  if (typed.empty() && question.optional) return std::optional<Answer>{};
  const auto* const number = std::get_if<NumberForm>(&question.form);
  const bool has_own_message =
      question.is_answered_by<LineForm>() || (number != nullptr && number->is_estimate);
  if (typed.empty() && !has_own_message) {
    return ParticipantMessage{.what = ParticipantMessage::What::answer_needed};
  }
  return std::visit(TypedAnswerReader{question, typed}, question.form);
}

}  // namespace asperity

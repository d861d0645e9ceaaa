// Accepts options by value, text or number, and numbers with either decimal separator.

#include "app/session/respondents/form_answer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <utility>

#include "analysis/numbers/number_text.h"
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

/// The position of the option that was typed by its value, its text or its number.
std::optional<std::size_t> typed_option(const Question& question, const std::string& typed) {
  // An option may itself be a number: a literal match takes precedence.
  for (const auto* const texts : {&question.options, &question.option_texts}) {
    const auto found = std::find(texts->begin(), texts->end(), typed);
    if (found != texts->end()) return static_cast<std::size_t>(found - texts->begin());
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

}  // namespace

std::variant<ParticipantMessage, FormAnswer> form_answer(const Question& question,
                                                         const std::string& typed) {
  if (typed.empty()) {
    if (question.optional) return FormAnswer{};
    return ParticipantMessage{.what = ParticipantMessage::What::answer_needed};
  }
  switch (question.form) {
    case Question::Form::text:
      return FormAnswer{typed};
    case Question::Form::number: {
      std::string answer = with_decimal_point(typed);
      const std::optional<double> number = number_in(answer);
      const bool low = number && question.minimum && *number < *question.minimum;
      const bool high = number && question.maximum && *number > *question.maximum;
      if (number && !low && !high) return FormAnswer{std::move(answer)};
      return ParticipantMessage{.what = ParticipantMessage::What::number_needed,
                                .minimum = question.minimum,
                                .maximum = question.maximum};
    }
    case Question::Form::scale: {
      const std::optional<double> number = number_in(with_decimal_point(typed));
      const std::optional<int> step = number ? question.scale.step_of(*number) : std::nullopt;
      if (step) return FormAnswer{number_text(question.scale.value_at(*step))};
      return ParticipantMessage{.what = ParticipantMessage::What::number_needed,
                                .minimum = question.scale.minimum,
                                .maximum = question.scale.maximum};
    }
    case Question::Form::choice: {
      if (const auto option = typed_option(question, typed)) {
        return FormAnswer{question.options[*option]};
      }
      return ParticipantMessage{.what = ParticipantMessage::What::option_needed,
                                .number = static_cast<int>(question.options.size())};
    }
    case Question::Form::multiple_choice: {
      FormAnswer chosen{};
      for (const std::size_t option : typed_options(question, typed)) {
        chosen.push_back(question.options[option]);
      }
      if (!chosen.empty()) return chosen;
      return ParticipantMessage{.what = ParticipantMessage::What::options_needed,
                                .number = static_cast<int>(question.options.size())};
    }
  }
  return FormAnswer{};
}

}  // namespace asperity

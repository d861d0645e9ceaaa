#include "app/session/respondents/form_answer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "results_schema/table.h"

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

std::optional<Saying> refusal_of(const Question& question, std::string& answer) {
  if (answer.empty()) {
    if (question.optional) return {};
    return Saying{.what = Saying::What::answer_needed};
  }
  switch (question.form) {
    case Question::Form::text:
      return {};
    case Question::Form::number: {
      answer = with_decimal_point(answer);
      const std::optional<double> number = number_in(answer);
      const bool low = number && question.minimum && *number < *question.minimum;
      const bool high = number && question.maximum && *number > *question.maximum;
      if (number && !low && !high) return {};
      return Saying{.what = Saying::What::number_needed,
                    .minimum = question.minimum,
                    .maximum = question.maximum};
    }
    case Question::Form::choice: {
      // An option may itself be a number: a literal match takes precedence.
      if (std::find(question.options.begin(), question.options.end(), answer) !=
          question.options.end()) {
        return {};
      }
      const auto& texts = question.option_texts;
      if (const auto text = std::find(texts.begin(), texts.end(), answer); text != texts.end()) {
        answer = question.options[static_cast<std::size_t>(text - texts.begin())];
        return {};
      }
      const std::optional<std::size_t> number = whole_number(answer);
      if (number && *number >= 1 && *number <= question.options.size()) {
        answer = question.options[*number - 1];
        return {};
      }
      return Saying{.what = Saying::What::option_needed,
                    .number = static_cast<int>(question.options.size())};
    }
  }
  return {};
}

}  // namespace asperity

#include "protocols/answers/number_form.h"

#include <charconv>
#include <optional>
#include <system_error>

#include "analysis/number_text.h"
#include "protocols/answers/trial_question.h"

namespace asperity {

namespace {

/// The number that a whole text is; nothing where it is not one.
std::optional<double> stored_number(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || read != end) return {};
  return number;
}

}  // namespace

std::vector<AnsweredItem> items_of(const TrialQuestion&, const NumberForm&,
                                   const GivenNumber& answer) {
  return {{.answer = number_text(answer.number), .number = answer.number}};
}

std::vector<std::string> problems_with(const TrialQuestion&, const NumberForm&,
                                       const AnsweredItem& stored) {
  const std::optional<double> number = stored_number(stored.answer);
  if (number && *number > 0.0 && number == stored.number) return {};
  return {"the response is not a number above 0, or differs from the number stored with it"};
}

std::string label_of(const TrialQuestion&, const NumberForm&, const std::string& stored) {
  return stored;
}

}  // namespace asperity

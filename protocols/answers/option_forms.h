// The forms that are answered with options: a choice of one, a choice of several, and one for each surface.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace asperity {

struct AnsweredItem;
struct Question;

/// The answer is one option.
struct ChoiceForm {
  static constexpr std::string_view kName = "choice";
  bool operator==(const ChoiceForm&) const = default;
};
struct ChosenOption {
  std::size_t option = 0;  ///< index in Question::options
};

/// The answer is one or more of the options.
struct MultipleChoiceForm {
  static constexpr std::string_view kName = "multiple_choice";
  static constexpr bool kIsSeen = true;  ///< see is_seen
  bool operator==(const MultipleChoiceForm&) const = default;
};
struct ChosenOptions {
  std::vector<std::size_t> options{};  ///< indices in Question::options, ascending
};

/// Every surface is assigned one option, and every option belongs to one surface at most.
struct AssignmentForm {
  static constexpr std::string_view kName = "assignment";
  bool operator==(const AssignmentForm&) const = default;
};
struct AssignedOptions {
  std::vector<std::size_t> options{};  ///< indices in Question::options, by position of the surface
};

template <class Form>
concept FormWithOptions = std::is_same_v<Form, ChoiceForm> ||
    std::is_same_v<Form, MultipleChoiceForm> || std::is_same_v<Form, AssignmentForm>;

std::vector<AnsweredItem> items_of(const Question& question, const ChoiceForm&,
                                   const ChosenOption& answer);
/// The item of an option is its place in the list of options, from 1.
std::vector<AnsweredItem> items_of(const Question& question, const MultipleChoiceForm&,
                                   const ChosenOptions& answer);
std::vector<AnsweredItem> items_of(const Question& question, const AssignmentForm&,
                                   const AssignedOptions& answer);

std::vector<std::string> problems_with_option(const Question& question, const AnsweredItem& stored);
/// The label of the option of that value; "?" where there is none.
std::string label_of_option(const Question& question, const std::string& value);

}  // namespace asperity

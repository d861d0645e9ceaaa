// Defines the keys of a question of the questionnaire, of the forms of answer, and of conditions on answers.

#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "protocols/keys/answer_keys.h"
#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr TextShape kOptionText{};

constexpr auto kOptionKeys =
    keys_of(required_key(member_key<&Option::value>(
                "value", "Value",
                "The value that is stored and exported: the same in all languages of a protocol.",
                kOptionText)),
            required_key(member_key<&Option::text>(
                "text", "Text", "The text that is shown for this option.", kShownText)));

constexpr ValueShape kPlainOption = TextShape{.translated = Translated::always, .is_value = true};
constexpr std::array kOptionForms{kPlainOption, kObjectOf<kOptionTable>};
constexpr ValueShape kOption = FormsShape{kOptionForms};

void store_options(const json& value, Question& question) {
  for (const json& entry : value) {
    Option& option = question.options.emplace_back();
    if (entry.is_object()) {
      read_keys(kOptionTable, entry, &option);
    } else {
      option.value = option.text = entry.get<std::string>();
    }
  }
}

void store_form(const json& value, Question& question) {
  question.form = form_named(value.get<std::string>());
}

constexpr auto kAskedKeys = keys_of(
    required_key(member_key<&Question::prompt>("prompt", "Question", "Text of the question.",
                                               kShownParagraph)),
    required_key(listing_words(
        custom_key<&store_form>("form", "Form", "Form of the response.", WordShape{kForms}))),
    when(
        custom_key<&store_options>(
            "options", "Options", "The options of a choice or a multiple choice.",
            ListShape{.entry = &kOption,
                      .meaning = "An option: the text that is shown and stored, or a stored value "
                                 "and another text that is shown, for example in another language.",
                      .shortest = 2,
                      .longest = 32}),
        where("form", {ChoiceForm::kName, MultipleChoiceForm::kName})));
constexpr auto kOptionalKey = keys_of(member_key<&Question::optional>(
    "optional", "Optional", "Whether the question may be left unanswered.", TruthShape{}));

constexpr auto kQuestionKeys =
    joined(joined(kAskedKeys, joined(kNumberKeys, joined(kScaleKey, kLineKey))),
           joined(condition_key(kConditionTable), kOptionalKey));

constexpr ValueShape kScaleLabel = kShownText;

constexpr auto kScaleKeys = keys_of(
    member_key<&ScaleForm::minimum>("minimum", "Minimum (left end)", "The value at the left end.",
                                    NumberShape{}),
    member_key<&ScaleForm::maximum>("maximum", "Maximum (right end)", "The value at the right end.",
                                    NumberShape{}),
    member_key<&ScaleForm::points>("points", "Points",
                                   "Number of equally spaced points, both ends included; absent: "
                                   "every position of the line is a response.",
                                   NumberShape{.minimum = 2.0, .maximum = 101.0, .is_whole = true}),
    member_key<&ScaleForm::labels>(
        "labels", "Labels", "Labels of the two ends, or one for every point; absent: none.",
        ListShape{.entry = &kScaleLabel, .meaning = "One label.", .shortest = 2, .longest = 11}));

constexpr auto kLineKeys = keys_of(member_key<&LineForm::longest>(
    "longest", "Longest line", "The longest line, as a proportion of the width of the screen.",
    NumberShape{.minimum = 0.2, .maximum = 0.9}));

constexpr ValueShape kNumberAnswer = NumberShape{};
constexpr ValueShape kTextAnswer = TextShape{};
constexpr std::array kAnswerForms{kNumberAnswer, kTextAnswer};
constexpr FormsShape kAnswer{kAnswerForms};
constexpr ValueShape kAnswerEntry = kAnswer;

// Exactly one of the tests is stated, which the check of meaning demands.
void store_question(const json& value, AnswerCondition& condition) {
  condition = {.question = value.get<std::string>(), .test = AnswerWithin{}};
}
void store_is(const json& value, AnswerCondition& condition) {
  store_value(kAnswer, value, condition.test.emplace<AnswerIsOneOf>().values.emplace_back());
}
void store_in(const json& value, AnswerCondition& condition) {
  store_value(ListShape{.entry = &kAnswerEntry}, value,
              condition.test.emplace<AnswerIsOneOf>().values);
}

void store_includes(const json& value, AnswerCondition& condition) {
  condition.test = AnswerIncludes{value.get<std::string>()};
}
template <auto limit>
void store_limit(const json& value, AnswerCondition& condition) {
  if (auto* const range = std::get_if<AnswerWithin>(&condition.test)) {
    range->*limit = value.get<double>();
  }
}

constexpr auto kTestKeys = keys_of(
    custom_key<&store_is>("is", "Answer", "The answer: an option, or a number.", kAnswer),
    custom_key<&store_in>("in", "One of", "Several possible answers.",
                          ListShape{.entry = &kAnswerEntry,
                                    .meaning = "One possible answer: an option, or a number.",
                                    .shortest = 1,
                                    .longest = 32}),
    custom_key<&store_includes>("includes", "Includes",
                                "An option that is among those chosen in a multiple choice.",
                                TextShape{}),
    custom_key<&store_limit<&AnswerWithin::minimum>>(
        "at_least", "At least", "Smallest answer, of a number or a scale.", NumberShape{}),
    custom_key<&store_limit<&AnswerWithin::maximum>>(
        "at_most", "At most", "Largest answer, of a number or a scale.", NumberShape{}));

constexpr auto kConditionKeys =
    joined(keys_of(required_key(custom_key<&store_question>(
               "question", "Question", "The question, which the flow asks earlier.",
               NameShape{"questions"}))),
           kTestKeys);
constexpr auto kTrialConditionKeys =
    joined(keys_of(required_key(custom_key<&store_question>(
               "question", "Question", "The question, which the trial asks earlier.",
               NameShape{kAnswerNames}))),
           kTestKeys);

}  // namespace

constexpr KeyTableOf<Question> kQuestionTable = table_of(
    "A question of the questionnaire, or about the participant.", kQuestionKeys, "question");

constexpr KeyTableOf<Option> kOptionTable =
    table_of("An option whose text differs from its stored value.", kOptionKeys);

constexpr KeyTableOf<ScaleForm> kScaleTable = table_of(
    "A scale on which the response is a point: with labelled points (Likert), with labelled ends "
    "(semantic differential), or a line without points (visual analogue scale).",
    kScaleKeys, "scale");

constexpr KeyTableOf<LineForm> kLineTable = table_of(
    "The response is the length of a line that the participant draws, for a magnitude in place of "
    "a number. It is stored as a proportion of the width of the participant's screen.",
    kLineKeys);

constexpr KeyTableOf<AnswerCondition> kConditionTable = table_of(
    "The answer to an earlier question of the questionnaire on which a question or a screen "
    "depends. Exactly one of `is`, `in`, `includes`, or a range.",
    kConditionKeys, "condition");

constexpr KeyTableOf<AnswerCondition> kTrialConditionTable = table_of(
    "The answer to an earlier question of the same trial on which a question depends. Exactly one "
    "of `is`, `in`, `includes`, or a range.",
    kTrialConditionKeys, "condition");

}  // namespace asperity

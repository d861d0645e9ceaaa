// The keys of the forms of answer, which the questions of trials and of the questionnaire have in common.

#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

/// A parameter of a form as a key of the question, without effect on another form. Their conditions state which form they
/// belong to.
template <auto member, class ShapeOfValue>
consteval KeyOf<Question> form_key(std::string_view name, std::string_view label,
                                   std::string_view meaning, const ShapeOfValue& shape) {
  KeyOf<Question> row{};
  static_cast<ProtocolKey&>(row) = member_key<member>(name, label, meaning, shape);
  row.store = [](const ProtocolKey& self, const nlohmann::json& value, void* question) {
    using Form = typename MemberOf<decltype(member)>::Owner;
    auto* const form = std::get_if<Form>(&static_cast<Question*>(question)->form);
    if (form != nullptr) store_value(std::get<ShapeOfValue>(self.shape), value, form->*member);
  };
  row.standard = [](const ProtocolKey&) { return nlohmann::json(nullptr); };
  return row;
}

/// The object with the parameters of a form states the form as well.
inline void store_scale(const nlohmann::json& value, Question& question) {
  read_keys(kScaleTable, value, &question.form.emplace<ScaleForm>());
}
inline void store_line(const nlohmann::json& value, Question& question) {
  read_keys(kLineTable, value, &question.form.emplace<LineForm>());
}

inline constexpr std::array kForms{
    KeyWord{ChoiceForm::kName, 0, "one of the options"},
    KeyWord{MultipleChoiceForm::kName, 1, "one or more of the options"},
    KeyWord{NumberForm::kName, 2, "a number"},
    KeyWord{ScaleForm::kName, 3, "a point on a scale"},
    KeyWord{LineForm::kName, 4, "the length of a line"},
    KeyWord{TextForm::kName, 5, "a text"}};

inline constexpr auto kNumberKeys =
    keys_of(when(form_key<&NumberForm::minimum>("minimum", "At least", "Smallest number accepted.",
                                                NumberShape{}),
                 where("form", {NumberForm::kName})),
            when(form_key<&NumberForm::maximum>("maximum", "At most", "Largest number accepted.",
                                                NumberShape{}),
                 where("form", {NumberForm::kName})),
            when(form_key<&NumberForm::unit>("unit", "Unit",
                                             "Unit of the number, shown next to it and exported.",
                                             TextShape{.longest = 32}),
                 where("form", {NumberForm::kName})));
inline constexpr auto kScaleKey =
    keys_of(when(custom_key<&store_scale>("scale", "Scale", "", ObjectShape{&kScaleTable}),
                 where("form", {kAbsent, ScaleForm::kName})));
inline constexpr auto kLineKey =
    keys_of(when(custom_key<&store_line>("line", "Line", "", ObjectShape{&kLineTable}),
                 without("scale"), where("form", {kAbsent, LineForm::kName})));
/// `table`: of the conditions on the questions among which this one is.
consteval auto condition_key(const KeyTableOf<AnswerCondition>& table) {
  return keys_of(member_key<&Question::condition>(
      "if", "Only if", table, "The condition under which the question is asked."));
}

}  // namespace asperity

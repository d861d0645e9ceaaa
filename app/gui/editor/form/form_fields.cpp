// Chooses the field for a shape.

#include "app/gui/editor/form/form_fields.h"

#include <algorithm>
#include <span>
#include <variant>

#include <QtCore/QCoreApplication>
#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/base/parameter_unit.h"
#include "app/gui/base/parameter_words.h"
#include "app/gui/editor/form/choice_fields.h"
#include "app/gui/editor/form/typed_fields.h"
#include "app/gui/look/words.h"
#include "protocols/form/form_entries.h"

namespace asperity {

namespace {

bool is_level(const FormsShape& shape) {
  for (const ValueShape& form : shape.forms) {
    const bool is_text = std::holds_alternative<TextShape>(form);
    if (!is_text && !std::holds_alternative<NumberShape>(form)) return false;
  }
  return true;
}

/// The user names its levels next.
void make_factor_of_groups(FormContext& context) {
  std::string factor{};
  context.edit(
      [&factor](const JsonDocument& document) {
        FormEdit edit = with_factor_of_groups(document);
        factor = edit.pointer;
        return edit;
      },
      {});
  if (!factor.empty()) context.go_to(factor + "/levels/0");
}

bool is_declared_level(const FormsShape& shape) {
  return std::ranges::any_of(shape.forms, [](const ValueShape& form) {
    const auto* const text = std::get_if<TextShape>(&form);
    return text != nullptr && text->name.is_declared;
  });
}

/// As `shape_of`, and the number where text is in its place: what was typed there and cannot be read.
const ValueShape* shape_of_field(const ValueShape& shape, const nlohmann::json& value) {
  if (const ValueShape* const found = shape_of(shape, value)) return found;
  if (!value.is_string()) return nullptr;
  if (std::holds_alternative<NumberShape>(shape)) return &shape;
  if (const auto* const bound = std::get_if<BoundShape>(&shape)) {
    return shape_of_field(*bound->value, value);
  }
  const auto* const choice = std::get_if<FormsShape>(&shape);
  for (const ValueShape& form : choice == nullptr ? std::span<const ValueShape>{} : choice->forms) {
    if (std::holds_alternative<NumberShape>(form)) return &form;
  }
  return nullptr;
}

class FieldMaker final {
 public:
  FieldMaker(FormContext& context, const FieldOf& of, const std::string& pointer, QWidget* parent)
      : context_(context), of_(of), pointer_(pointer), parent_(parent) {}

  FormPart* operator()(const NumberShape& shape) const {
    return new NumbersField(context_, displayed_shape(shape, pointer_), NumbersField::Count::one,
                            of_, pointer_, parent_);
  }
  FormPart* operator()(const TruthShape&) const {
    return new TruthField(context_, of_, pointer_, parent_);
  }
  FormPart* operator()(const WordShape& shape) const {
    return new ChoiceField(
        context_,
        [words = shape.words] {
          std::vector<ChoiceField::Choice> choices{};
          for (const KeyWord& word : words) {
            choices.push_back({std::string(word.name), shown_word(word), name_of_word(word.name)});
          }
          return choices;
        },
        of_, pointer_, parent_);
  }
  FormPart* operator()(const TextShape& shape) const {
    if (shape.name.is_declared && !shape.is_formula) {
      return new DeclaredNameField(context_, Named::by_value, TextField::Values::texts, of_,
                                   pointer_, parent_);
    }
    if (shape.name.registry == kGroupNames) return (*this)(shape.name);
    if (shape.is_long) return new ParagraphField(context_, of_, pointer_, parent_);
    auto* field = new TextField(context_, shape.is_formula ? NameShape{} : shape.name,
                                TextField::Values::texts, of_, pointer_, parent_);
    if (shape.is_file && context_.files) field->offer(context_.files);
    return field;
  }
  FormPart* operator()(const NameShape& shape) const {
    if (shape.is_declared) {
      return new DeclaredNameField(context_, Named::by_value, TextField::Values::texts, of_,
                                   pointer_, parent_);
    }
    if (shape.registry.empty()) {
      return new TextField(context_, {}, TextField::Values::texts, of_, pointer_, parent_);
    }
    auto* field = new ChoiceField(
        context_,
        [&context = context_, shape, pointer = pointer_] {
          std::vector<ChoiceField::Choice> choices{};
          for (const QString& name : context.source->names_for(shape, pointer)) {
            const std::string value = name.toStdString();
            const bool is_role = shape.registry == kRoleNames;
            const QString shown = is_role ? name_of_word(value) : name;
            const QString meaning = context.source->meaning_of_name(shape, name);
            choices.push_back({value, meaning.isEmpty() ? shown : shown + ": " + meaning,
                               meaning.isEmpty() ? QString() : shown});
          }
          return choices;
        },
        of_, pointer_, parent_);
    if (shape.levels == kGroupNames) {
      field->offer(QCoreApplication::translate("asperity::ChoiceField", "New factor…"),
                   [&context = context_] { make_factor_of_groups(context); });
    }
    return field;
  }
  FormPart* operator()(const ListShape& shape) const {
    const auto& number = std::get<NumberShape>(*shape.entry);
    return new NumbersField(context_, displayed_shape(number, pointer_), NumbersField::Count::list,
                            of_, pointer_, parent_);
  }
  FormPart* operator()(const BoundShape& shape) const {
    return new BoundField(context_, *shape.value, of_, pointer_, parent_);
  }
  FormPart* operator()(const FormsShape& shape) const {
    if (!is_level(shape))
      return std::visit(*this, *shape_of_field(shape, *context_.source->find(pointer_)));
    if (is_declared_level(shape)) {
      return new DeclaredNameField(context_, Named::by_value, TextField::Values::levels, of_,
                                   pointer_, parent_);
    }
    const Parameter* const parameter = context_.source->parameter_at(pointer_);
    if (parameter == nullptr) {
      return new TextField(context_, {}, TextField::Values::levels, of_, pointer_, parent_);
    }
    if (parameter->kind != ParameterKind::choice) return (*this)(number_shape(*parameter));
    return new ChoiceField(
        context_,
        [parameter] {
          std::vector<ChoiceField::Choice> choices{};
          for (const std::string& choice : parameter->choices) {
            choices.push_back({choice, choice_with_word(*parameter, choice)});
          }
          return choices;
        },
        of_, pointer_, parent_);
  }
  FormPart* operator()(const MapShape&) const { return nullptr; }
  FormPart* operator()(const ObjectShape&) const { return nullptr; }

 private:
  FormContext& context_;
  const FieldOf& of_;
  const std::string& pointer_;
  QWidget* parent_ = nullptr;
};

}  // namespace

nlohmann::json FieldOf::standard() const {
  return key == nullptr ? nlohmann::json(nullptr) : default_of(*key);
}

bool has_field(const ValueShape& shape, const nlohmann::json* value) {
  if (value != nullptr && shape_of_field(shape, *value) == nullptr) return false;
  if (const auto* const list = std::get_if<ListShape>(&shape)) {
    return std::holds_alternative<NumberShape>(*list->entry);
  }
  if (const auto* const bound = std::get_if<BoundShape>(&shape)) {
    return has_field(*bound->value, nullptr);
  }
  if (const auto* const forms = std::get_if<FormsShape>(&shape)) {
    return is_level(*forms) ||
           (value != nullptr && has_field(*shape_of_field(shape, *value), value));
  }
  return !std::holds_alternative<MapShape>(shape) && !std::holds_alternative<ObjectShape>(shape);
}

QString shown_word(const KeyWord& word) {
  const QString name = name_of_word(word.name);
  return word.meaning.empty() ? name : name + ": " + text_of_keys(word.meaning);
}

NumberShape number_shape(const Parameter& parameter) {
  return {.minimum = parameter.minimum,
          .maximum = parameter.maximum,
          .is_whole = parameter.kind == ParameterKind::integer,
          .unit = parameter.unit,
          .display = display_unit_of(parameter)};
}

FormPart* make_field(FormContext& context, const ValueShape& shape, const FieldOf& of,
                     const std::string& pointer, QWidget* parent) {
  return std::visit(FieldMaker(context, of, pointer, parent), shape);
}

FormPart* make_key_field(FormContext& context, const std::string& pointer, QWidget* parent) {
  return new DeclaredNameField(context, Named::by_key, TextField::Values::texts, {}, pointer,
                               parent);
}

}  // namespace asperity

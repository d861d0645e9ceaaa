// Implements the text that a form shows.

#include "app/gui/editor/form/form_source.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/editor/form/form_fields.h"
#include "app/gui/look/words.h"
#include "protocols/design/json_pointer.h"
#include "protocols/editing/text_entries.h"
#include "protocols/form/new_values.h"
#include "protocols/form/offered_names.h"

namespace asperity {

namespace {

/// "/stimuli/NAME/parameters/PARAMETER"
constexpr std::size_t kPartsOfParameter = 4;

std::vector<std::string> parts_of(const std::string& pointer) {
  std::vector<std::string> parts{};
  for (nlohmann::json::json_pointer path(pointer); !path.empty(); path.pop_back()) {
    parts.insert(parts.begin(), path.back());
  }
  return parts;
}

void add_new(QStringList& names, const std::string& name) {
  const QString added = text(name);
  if (!names.contains(added)) names.append(added);
}

/// Whether the object or list at the pointer has this part.
bool is_member(const JsonDocument& document, const std::string& container,
               const std::string& part) {
  const nlohmann::json::json_pointer path(container);
  return document.root().contains(path) && document.root().at(path).is_structured() &&
         document.root().contains(path / part);
}

/// The key that has replaced one of the object; nullopt if more than its name has changed.
std::optional<std::string> key_in_place(const JsonDocument& before, const std::string& object,
                                        const JsonDocument& after, const std::string& object_after,
                                        const std::string& key) {
  const nlohmann::json::json_pointer path(object_after);
  if (!after.root().contains(path) || !after.root().at(path).is_object()) return {};
  const TextContainer old_entries(before, object);
  const TextContainer entries(after, object_after);
  if (!old_entries.is_object() || old_entries.entries().size() != entries.entries().size()) {
    return {};
  }
  const std::string& renamed = entries.entries()[old_entries.index_of(key)].key;
  return old_entries.has(renamed) ? std::nullopt : std::optional(renamed);
}

}  // namespace

FormSource::FormSource(std::string text, const std::vector<ModelDeclaration>& models)
    : text_(std::move(text)),
      document_(text_, {}),
      names_(names_of_form(document_)),
      models_(models) {}

const nlohmann::json* FormSource::find(const std::string& pointer) const {
  const nlohmann::json::json_pointer path(pointer);
  return document_.root().contains(path) ? &document_.root().at(path) : nullptr;
}

std::string_view FormSource::characters(const std::string& pointer) const {
  const auto place = document_.place_of(pointer);
  return place ? document_.text().substr(place->value, place->end - place->value)
               : std::string_view();
}

QStringList FormSource::names_for(const NameShape& shape, const std::string& pointer) const {
  QStringList names{};
  if (shape.registry == kModelNames) {
    for (const ModelDeclaration& model : models_) add_new(names, model.id);
    return names;
  }
  std::string registry(shape.registry);
  if (registry == kLevelNames) {
    for (const NameUse& use : names_.uses) {
      if (use.pointer != pointer) continue;
      if (use.is_declared) return names_of_level(use.registry);
      registry = use.registry;
    }
  }
  if (const auto* const offered = offered_in(names_, shape)) {
    for (const ProtocolNames::Offered& name : *offered) add_new(names, name.name);
    return names;
  }
  for (const std::string& name : declared_names(names_, registry)) add_new(names, name);
  for (const NameUse& use : names_.uses) {  // roles and levels are named where they are used
    if (use.registry == registry) add_new(names, use.name);
  }
  return names;
}

QString FormSource::meaning_of_name(const NameShape& shape, const QString& name) const {
  QStringList meanings{};
  const auto* const offered = offered_in(names_, shape);
  if (offered == nullptr) return {};
  for (const ProtocolNames::Offered& one : *offered) {
    if (text(one.name) != name) continue;
    for (const std::string_view meaning : one.meanings) meanings.append(meaning_in_form(meaning));
  }
  return meanings.join("; ");
}

std::size_t FormSource::references_to(const std::string& pointer) const {
  const NameUse* const declared = declaration_at(names_, pointer, false);
  return declared == nullptr ? 0 : uses_of(names_, declared->registry, declared->name).size() - 1;
}

QStringList FormSource::names_of_level(const std::string& levels) const {
  QStringList names{};
  for (const auto& [linked, registry] : names_.links) {
    if (linked != levels) continue;
    for (const std::string& name : declared_names(names_, registry)) add_new(names, name);
  }
  return names;
}

std::vector<const Parameter*> FormSource::parameters_of(const std::string& stimulus) const {
  const nlohmann::json* const model = find(stimulus + "/model");
  std::vector<const Parameter*> parameters{};
  for (const ModelDeclaration& declared : models_) {
    if (model == nullptr || (model->is_string() && *model != declared.id)) continue;
    for (const Parameter& parameter : declared.parameters) {
      const bool is_known = std::any_of(parameters.begin(), parameters.end(), [&](const auto* one) {
        return one->name == parameter.name;
      });
      if (!is_known) parameters.push_back(&parameter);
    }
  }
  return parameters;
}

const Parameter* FormSource::parameter_at(const std::string& pointer) const {
  const std::vector<std::string> parts = parts_of(pointer);
  if (parts.size() != kPartsOfParameter || parts[0] != "stimuli" || parts[2] != "parameters") {
    return nullptr;
  }
  const std::size_t end = pointer.rfind("/parameters/");
  for (const Parameter* const parameter : parameters_of(pointer.substr(0, end))) {
    if (parameter->name == parts.back()) return parameter;
  }
  return nullptr;
}

std::string renamed_pointer(const JsonDocument& before, const JsonDocument& after,
                            const std::string& pointer) {
  const nlohmann::json::json_pointer path(pointer);
  if (after.root().contains(path)) return pointer;
  std::string there{};
  std::string here{};
  bool is_same = true;  // so far both texts have the value
  for (const std::string& part : parts_of(pointer)) {
    std::string key = part;
    is_same = is_same && is_member(before, here, part);
    if (is_same && !is_member(after, there, part)) {
      const auto renamed = key_in_place(before, here, after, there, part);
      if (renamed) key = *renamed;
      is_same = renamed.has_value();
    }
    here = pointer_to(here, part);
    there = pointer_to(there, key);
  }
  return there;
}

QString meaning_of_key(const ProtocolKey& key) {
  QString meaning = meaning_in_form(meaning_of(key));
  if (!key.lists_words) return meaning;
  for (const KeyWord& word : std::get<WordShape>(key.shape).words) {
    meaning += '\n' + shown_word(word);
  }
  return meaning;
}

}  // namespace asperity

// Follows the place of a key through the references of the JSON schema, and composes type, range and default.

#include "app/gui/editor/schema_help.h"

#include <algorithm>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/gui/look/words.h"
#include "protocols/file/library_protocols.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

/// A value as it would be typed, texts without quotation marks.
QString text_of_value(const nlohmann::json& value) {
  return text(value.is_string() ? value.get<std::string>() : value.dump());
}

QString joined(const nlohmann::json& values) {
  QStringList texts{};
  for (const nlohmann::json& value : values) texts.append(text_of_value(value));
  return texts.join(", ");
}

QString name_of_type(const std::string& type) {
  if (type == "object") return SchemaHelp::tr("object {…}");
  if (type == "array") return SchemaHelp::tr("list […]");
  if (type == "integer") return SchemaHelp::tr("whole number");
  if (type == "number") return SchemaHelp::tr("number");
  if (type == "boolean") return SchemaHelp::tr("true or false");
  return SchemaHelp::tr("text");
}

QString type_of(const nlohmann::json& node) {
  if (node.contains("const")) return SchemaHelp::tr("always %1").arg(text_of_value(node["const"]));
  if (node.contains("enum")) return SchemaHelp::tr("one of: %1").arg(joined(node["enum"]));
  if (!node.contains("type")) return {};
  const nlohmann::json& type = node["type"];
  if (type.is_string()) return name_of_type(type.get<std::string>());
  QStringList names{};
  for (const nlohmann::json& one : type) names.append(name_of_type(one.get<std::string>()));
  return names.join(SchemaHelp::tr(" or "));
}

/// "from 0 to 85", "above 0", "2 to 32 entries"
QStringList ranges_of(const nlohmann::json& node) {
  const auto said = [&node](const char* key) {
    return node.contains(key) ? text_of_value(node[key]) : QString{};
  };
  QStringList ranges{};
  const QString least = said("minimum");
  const QString most = said("maximum");
  if (!least.isEmpty() && !most.isEmpty()) {
    ranges.append(SchemaHelp::tr("from %1 to %2").arg(least, most));
  } else if (!least.isEmpty()) {
    ranges.append(SchemaHelp::tr("%1 or more").arg(least));
  } else if (!most.isEmpty()) {
    ranges.append(SchemaHelp::tr("%1 or less").arg(most));
  }
  if (const QString above = said("exclusiveMinimum"); !above.isEmpty()) {
    ranges.append(SchemaHelp::tr("above %1").arg(above));
  }
  const QString fewest = said("minItems");
  const QString entries = said("maxItems");
  if (!fewest.isEmpty() && fewest == entries) {
    ranges.append(SchemaHelp::tr("%1 entries").arg(entries));
  } else if (!fewest.isEmpty() && !entries.isEmpty()) {
    ranges.append(SchemaHelp::tr("%1 to %2 entries").arg(fewest, entries));
  }
  return ranges;
}

bool requires_key(const nlohmann::json& parent, const std::string& key) {
  if (!parent.contains("required")) return false;
  const nlohmann::json& required = parent["required"];
  return std::find(required.begin(), required.end(), key) != required.end();
}

QString text_of_parameter(const ParameterValue& value) {
  const auto* number = std::get_if<double>(&value);
  return text(number != nullptr ? text_of_number(*number) : std::get<std::string>(value));
}

}  // namespace

SchemaHelp::SchemaHelp(std::vector<ModelDeclaration> models) : models_(std::move(models)) {}

const nlohmann::json& SchemaHelp::resolved(const nlohmann::json& node) const {
  if (!node.contains("$ref")) return node;
  // "#/definitions/texture"
  return protocol_schema().at(
      nlohmann::json::json_pointer(node["$ref"].get<std::string>().substr(1)));
}

const nlohmann::json* SchemaHelp::below(const nlohmann::json& node, const std::string& key) const {
  if (node.contains("properties") && node["properties"].contains(key)) {
    return &node["properties"][key];
  }
  if (key.starts_with("x-") || key == "$comment") return nullptr;
  for (const char* others : {"additionalProperties", "items"}) {
    if (node.contains(others) && node[others].is_object()) return &node[others];
  }
  return nullptr;
}

std::optional<KeyHelp> SchemaHelp::of(const QStringList& place) const {
  if (place.isEmpty()) return {};
  if (place.size() == 4 && place[0] == "stimuli" && place[2] == "parameters") {
    return of_parameter(place[3]);
  }
  const nlohmann::json* parent = nullptr;
  const nlohmann::json* node = &protocol_schema();
  for (const QString& key : place) {
    parent = &resolved(*node);
    node = below(*parent, key.toStdString());
    if (node == nullptr) {
      if (key.startsWith("x-") || key == "$comment") {
        return KeyHelp{key, tr("A comment: the program ignores it."), {}};
      }
      return {};
    }
  }
  const nlohmann::json& said = resolved(*node);
  KeyHelp help{place.back(), {}, {}};
  for (const nlohmann::json* from : {node, &said}) {
    if (help.meaning.isEmpty() && from->contains("description")) {
      help.meaning = text((*from)["description"].get<std::string>());
    }
  }
  QStringList form{};
  if (const QString type = type_of(said); !type.isEmpty()) form.append(type);
  form.append(ranges_of(said));
  if (requires_key(*parent, place.back().toStdString())) form.append(tr("required"));
  if (said.contains("default")) form.append(tr("default %1").arg(text_of_value(said["default"])));
  help.form = form.join(" · ");
  return help;
}

std::optional<KeyHelp> SchemaHelp::of_parameter(const QString& name) const {
  QStringList models{};
  KeyHelp help{name, {}, {}};
  for (const ModelDeclaration& model : models_) {
    for (const Parameter& parameter : model.parameters) {
      if (text(parameter.name) != name) continue;
      models.append(text(model.id));
      if (models.size() > 1) continue;  // the first one's; defaults of the others may differ
      help.meaning = words_of(parameter.meaning);
      QStringList form{};
      if (parameter.kind == ParameterKind::choice) {
        QStringList choices{};
        for (const std::string& choice : parameter.choices) choices.append(text(choice));
        form.append(tr("one of: %1").arg(choices.join(", ")));
      } else {
        form.append(tr("from %1 to %2 %3")
                        .arg(text(text_of_number(parameter.minimum)),
                             text(text_of_number(parameter.maximum)), text(parameter.unit)));
      }
      form.append(tr("default %1").arg(text_of_parameter(parameter.default_value)));
      help.form = form.join(" · ");
    }
  }
  if (models.isEmpty()) return {};
  help.form = tr("%1 · parameter of %2").arg(help.form, models.join(", "));
  return help;
}

}  // namespace asperity

// Implements the check by the tables of keys, and that by valijson, whose findings become the same sentences.

#include "protocols/file/schema_check.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/schema_nodes.h"
#include "protocols/keys/device_keys.h"
#include "protocols/keys/form_sentences.h"
#include "protocols/keys/valid_part.h"
#include "stimuli/properties/unit_of_name.h"

namespace asperity {

namespace {

using nlohmann::json;

/// The objects whose keys are declared in tables, which check their form in place of the schema.
struct ObjectWithTable {
  const char* name = nullptr;
  const KeyTable& (*table)() = nullptr;
};
constexpr std::array kTables{
    ObjectWithTable{"device", []() -> const KeyTable& { return device_keys(); }},
};

std::vector<std::string> keys_of(const json& object) {
  std::vector<std::string> keys{};
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

/// Checks keys without valijson, which reports only one per object and does not name unknown keys. Returns false if a
/// name is too long for valijson: it matches names with std::regex, which recurses once per character.
bool check_keys(const JsonDocument& document, const json& root, const json& schema,
                const json& value, const std::string& pointer, std::vector<Diagnostic>& found) {
  constexpr std::size_t kLongestName = 256;
  if (value.is_string() && schema.contains("pattern") &&
      value.get_ref<const std::string&>().size() > kLongestName) {
    found.push_back(document.at(pointer, "this name is longer than " +
                                             schema.value("maxLength", json(kLongestName)).dump() +
                                             " characters; shorten it"));
    return false;
  }
  bool is_short = true;
  if (value.is_array()) {
    const auto items = schema.find("items");
    if (items == schema.end()) return true;
    for (std::size_t i = 0; i < value.size(); ++i) {
      is_short = check_keys(document, root, resolved_node(root, *items), value[i],
                            pointer_to(pointer, i), found) &&
                 is_short;
    }
    return is_short;
  }
  if (!value.is_object()) return true;
  const bool closed = schema.value("additionalProperties", json(true)) == json(false);
  for (const auto& [key, member] : value.items()) {
    const std::string at = pointer_to(pointer, key);
    if (is_comment(key)) continue;
    const json* const inner = member_schema(root, schema, key);
    if (inner == nullptr) {
      if (!closed) continue;
      found.push_back(document.at_key(at, unknown_key(key, keys_of(schema.at("properties")))));
      continue;
    }
    const auto names = schema.find("propertyNames");
    if (names != schema.end() && names->contains("pattern") && !is_name(key)) {
      found.push_back(document.at_key(at, not_a_name(key)));
    }
    is_short = check_keys(document, root, *inner, member, at, found) && is_short;
  }
  return is_short;
}

/// The unit that the name of the key at the pointer ends with; of an entry of a list and of an interval, that of its key.
std::string unit_at(const std::string& pointer) {
  std::string of_key = pointer;
  const std::string name = pointer.substr(pointer.rfind('/') + 1);
  if (name == "shortest" || name == "longest" ||
      name.find_first_not_of("0123456789") == std::string::npos) {
    of_key = pointer.substr(0, pointer.rfind('/'));
  }
  return unit_at_end_of(of_key).value_or("");
}

NumberShape number_shape(const json& schema, std::string_view unit) {
  const auto limit = [&schema](const char* key) {
    const auto found = schema.find(key);
    return found == schema.end() ? std::nullopt : std::optional(found->get<double>());
  };
  return {.minimum = limit("minimum"),
          .above = limit("exclusiveMinimum"),
          .maximum = limit("maximum"),
          .below = limit("exclusiveMaximum"),
          .unit = unit};
}

/// One of valijson's findings as a sentence; empty for those that only repeat a more specific one. `unit` is that of a
/// number.
std::string sentence(const std::string& description, const json& schema, const json& value,
                     std::string_view unit) {
  const auto starts = [&description](std::string_view text) {
    return description.starts_with(text);
  };
  if (starts("Failed to validate") && description.find("oneOf") == std::string::npos &&
      !starts("Failed to validate against exactly one")) {
    return {};
  }
  if (starts("Object contains a property")) return {};  // check_keys reports it in more detail
  const std::string meaning = schema.value("description", std::string{});
  if (description.find("oneOf") != std::string::npos ||
      starts("Failed to validate against exactly one")) {
    std::vector<std::string> keys{};
    for (const json& branch : schema.at("oneOf")) keys.push_back(branch.at("required").at(0));
    return undecided_object(keys);
  }
  if (starts("Missing required property '")) {
    const std::string key = description.substr(27, description.rfind('\'') - 27);
    std::string what{};
    if (const auto properties = schema.find("properties");
        properties != schema.end() && properties->contains(key)) {
      what = properties->at(key).value("description", std::string{});
    }
    return missing_key(key, what);
  }
  if (starts("Missing dependency '")) {
    return missing_companion(description.substr(20, description.rfind('\'') - 20));
  }
  if (starts("Failed to match against any enum")) return wrong_word(value, schema.at("enum"));
  if (starts("Failed to match expected value set by 'const'")) {
    return wrong_word(value, {schema.at("const").get<std::string>()});
  }
  if (starts("Value type not permitted")) {
    const json& type = schema.at("type");
    return wrong_type(value,
                      type.is_array() ? type.get<std::vector<std::string>>()
                                      : std::vector<std::string>{type.get<std::string>()},
                      meaning);
  }
  if (starts("Expected number")) {
    return wrong_number(value, number_shape(schema, unit), meaning);
  }
  if (starts("Failed to match regex")) return wrong_pattern(value, meaning);
  if (starts("Array should contain")) {
    const bool few = schema.contains("minItems") && value.size() < schema.at("minItems");
    return few ? too_few_entries(value.size(), schema.at("minItems"), meaning)
               : too_many_entries(value.size(), schema.at("maxItems"), meaning);
  }
  if (starts("String should be no fewer")) return empty_text(meaning);
  if (starts("String should be no more")) return long_text(schema.at("maxLength"));
  if (starts("Object should have no fewer")) return empty_object(meaning);
  if (starts("Object should have no more")) {
    const json& most = schema.at("maxProperties");
    const auto properties = schema.find("properties");
    if (most == json(1) && properties != schema.end()) {
      return undecided_object(keys_of(*properties)) + "; remove the other" + expected_here(meaning);
    }
    return too_many_entries(value.size(), most, meaning);
  }
  return description + expected_here(meaning);
}

/// The schema in valijson's form; its conversion takes longer than the check of a document.
const valijson::Schema& schema_rules() {
  static const std::unique_ptr<const valijson::Schema> kRules = [] {
    auto rules = std::make_unique<valijson::Schema>();
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_root()), *rules);
    return rules;
  }();
  return *kRules;
}

bool validate(const json& document, valijson::ValidationResults* results) {
  valijson::Validator validator{};
  return validator.validate(schema_rules(), valijson::adapters::NlohmannJsonAdapter(document),
                            results);
}

}  // namespace

const json& schema_root() {
  static const json kRoot = json::parse(protocol_schema());
  return kRoot;
}

const json& resolved_node(const json& root, const json& schema) {
  const auto reference = schema.find("$ref");
  if (reference == schema.end()) return schema;
  return root.at(json::json_pointer(reference->get<std::string>().substr(1)));
}

const json* member_schema(const json& root, const json& schema, const std::string& key) {
  if (is_comment(key)) return nullptr;
  if (const auto properties = schema.find("properties"); properties != schema.end()) {
    if (const auto found = properties->find(key); found != properties->end()) {
      return &resolved_node(root, *found);
    }
  }
  const auto additional = schema.find("additionalProperties");
  return additional != schema.end() && additional->is_object() ? &resolved_node(root, *additional)
                                                               : nullptr;
}

bool follows_schema(const json& document) { return validate(document, nullptr); }

std::vector<Diagnostic> check_by_schema(const JsonDocument& document) {
  const json& root = schema_root();
  std::vector<Diagnostic> found{};
  if (!document.root().is_object()) {
    return {document.at("", quoted_value(document.root()) +
                                " is not a protocol; a protocol is an object "
                                "{…} that begins with \"format\": "
                                "\"asperity.protocol/1\"")};
  }
  if (!check_keys(document, root, root, document.root(), "", found)) return found;

  valijson::ValidationResults results{};
  validate(document.root(), &results);

  const auto place_of = [](const valijson::ValidationResults::Error& error) {
    std::string pointer{};
    for (std::size_t i = 1; i < error.context.size(); ++i) {  // the first is "<root>"
      pointer = pointer_to(pointer, error.context[i].substr(1, error.context[i].size() - 2));
    }
    return pointer;
  };
  // If none of several forms matches, valijson lists what each of them lacks. This is reported once, and not if another
  // problem of the same object explains it.
  const auto is_about_choice = [](const valijson::ValidationResults::Error& error) {
    return error.description.find("oneOf") != std::string::npos ||
           error.description.starts_with("Failed to validate against exactly one");
  };
  std::set<std::string> choices{};
  std::set<std::string> explained{};
  for (const Diagnostic& unknown_key : found) {
    explained.insert(unknown_key.pointer.substr(0, unknown_key.pointer.rfind('/')));
  }
  for (const auto& error : results) {
    if (is_about_choice(error)) choices.insert(place_of(error));
    if (error.description.starts_with("Missing dependency") ||
        error.description.starts_with("Value type not permitted")) {
      explained.insert(place_of(error));
    }
  }
  std::set<std::pair<std::string, std::string>> said{};
  for (const auto& error : results) {
    const std::string pointer = place_of(error);
    const json* node = &root;
    const json* value = &document.root();
    for (std::size_t i = 1; i < error.context.size() && node != nullptr; ++i) {
      const std::string key = error.context[i].substr(1, error.context[i].size() - 2);
      if (value->is_array()) {
        node = &resolved_node(root, node->at("items"));
        value = &value->at(static_cast<std::size_t>(std::stoul(key)));
      } else {
        node = member_schema(root, *node, key);
        value = &value->at(key);
      }
    }
    if (node == nullptr) continue;
    if (is_about_choice(error) && explained.contains(pointer)) continue;
    if (choices.contains(pointer) && error.description.starts_with("Missing required")) {
      // Keys that only one of the forms requires are skipped.
      const std::string key = error.description.substr(27, error.description.rfind('\'') - 27);
      const json required = node->value("required", json::array());
      if (std::find(required.begin(), required.end(), json(key)) == required.end()) continue;
    }
    std::string message = sentence(error.description, *node, *value, unit_at(pointer));
    if (message.empty() || !said.emplace(pointer, message).second) continue;
    found.push_back(document.at(pointer, std::move(message)));
  }
  return found;
}

std::vector<Diagnostic> check_schema(const JsonDocument& document) {
  std::vector<Diagnostic> found = check_by_schema(document);
  for (const auto& [name, table] : kTables) {
    const auto value = document.root().find(name);
    if (value == document.root().end()) continue;
    const std::string place = pointer_to("", name);
    std::erase_if(found, [&place](const Diagnostic& problem) {
      return problem.pointer == place || problem.pointer.starts_with(place + '/');
    });
    for (FormProblem& problem : valid_part(*value, table(), place).problems) {
      found.push_back(problem.is_at_key ? document.at_key(problem.pointer, problem.message)
                                        : document.at(problem.pointer, problem.message));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return found;
}

}  // namespace asperity

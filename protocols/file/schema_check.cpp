// Implements validation by valijson and the conversion of its findings to sentences that quote the schema.

#include "protocols/file/schema_check.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/schema_nodes.h"

namespace asperity {

namespace {

using nlohmann::json;

bool is_id(const std::string& key) {
  if (key.empty() || key.size() > 64 || key[0] < 'a' || key[0] > 'z') return false;
  return std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::vector<std::string> keys_of(const json& object) {
  std::vector<std::string> keys{};
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

std::string shown(const json& value) {
  switch (value.type()) {
    case json::value_t::string:
      return in_quotes(value.get_ref<const std::string&>());
    case json::value_t::object:
      return "an object {…}";
    case json::value_t::array:
      return "a list […]";
    case json::value_t::number_float:
      return digits(value.get<double>());
    case json::value_t::null:
    case json::value_t::boolean:
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
    case json::value_t::binary:
    case json::value_t::discarded:
      break;
  }
  return value.dump();
}

std::string shown_bound(const json& bound) { return digits(bound.get<double>()); }

std::string type_in_words(const std::string& type) {
  if (type == "object") return "an object {…}";
  if (type == "array") return "a list […]";
  if (type == "string") return "text in quotation marks";
  if (type == "integer") return "a whole number";
  if (type == "boolean") return "true or false";
  return "a number";
}

bool is_quoted_number(const json& value) {
  return value.is_string() &&
         json::parse(value.get_ref<const std::string&>(), nullptr, false).is_number();
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
      const std::vector<std::string> known = keys_of(schema.at("properties"));
      const std::string guess = did_you_mean(key, known);
      found.push_back(
          document.at_key(at, "there is no key " + in_quotes(key) + " here" +
                                  (guess.empty() ? "; it could be " + one_of(known) : guess)));
      continue;
    }
    const auto names = schema.find("propertyNames");
    if (names != schema.end() && names->contains("pattern") && !is_id(key)) {
      found.push_back(document.at_key(
          at, in_quotes(key) + " is not a name: use lower-case letters, digits and underscores, "
                               "starting with a letter, at most 64 characters"));
    }
    is_short = check_keys(document, root, *inner, member, at, found) && is_short;
  }
  return is_short;
}

/// One of valijson's findings as a sentence; empty for those that only repeat a more specific one.
std::string sentence(const std::string& description, const json& schema, const json& value) {
  const auto starts = [&description](std::string_view text) {
    return description.starts_with(text);
  };
  if (starts("Failed to validate") && description.find("oneOf") == std::string::npos &&
      !starts("Failed to validate against exactly one")) {
    return {};
  }
  if (starts("Object contains a property")) return {};  // check_keys reports it in more detail
  const std::string meaning = schema.value("description", std::string{});
  const std::string purpose = meaning.empty() ? "" : ". Expected here: " + meaning;
  if (description.find("oneOf") != std::string::npos ||
      starts("Failed to validate against exactly one")) {
    std::vector<std::string> keys{};
    for (const json& branch : schema.at("oneOf")) keys.push_back(branch.at("required").at(0));
    return "write exactly one of the keys " + one_of(keys) + " here";
  }
  if (starts("Missing required property '")) {
    const std::string key = description.substr(27, description.rfind('\'') - 27);
    std::string what{};
    if (const auto properties = schema.find("properties");
        properties != schema.end() && properties->contains(key)) {
      what = properties->at(key).value("description", std::string{});
    }
    return "the key " + in_quotes(key) + " is missing; add it" +
           (what.empty() ? "" : ". Expected here: " + what);
  }
  if (starts("Missing dependency '")) {
    return "another key here requires the key " +
           in_quotes(description.substr(20, description.rfind('\'') - 20)) +
           ", which is missing; add it";
  }
  if (starts("Failed to match against any enum")) {
    const std::vector<std::string> choices = schema.at("enum");
    return shown(value) + " is not permitted here: write " + one_of(choices) +
           (value.is_string() ? did_you_mean(value.get<std::string>(), choices) : "");
  }
  if (starts("Failed to match expected value set by 'const'")) {
    return shown(value) + " is not supported: write " + shown(schema.at("const"));
  }
  if (starts("Value type not permitted")) {
    std::string wanted{};
    const json& type = schema.at("type");
    if (type.is_array()) {
      for (const json& each : type) {
        wanted += (wanted.empty() ? "" : " or ") + type_in_words(each.get<std::string>());
      }
    } else {
      wanted = type_in_words(type.get<std::string>());
    }
    const bool is_number = wanted.find("number") != std::string::npos && is_quoted_number(value);
    return shown(value) + " is not permitted here: write " + wanted +
           (is_number ? ", without quotation marks" : "") + purpose;
  }
  if (starts("Expected number")) {
    const bool low = description.find("greater") != std::string::npos;
    const bool open = schema.contains(low ? "exclusiveMinimum" : "exclusiveMaximum") &&
                      !schema.contains(low ? "minimum" : "maximum");
    const json& bound = schema.at(open ? (low ? "exclusiveMinimum" : "exclusiveMaximum")
                                       : (low ? "minimum" : "maximum"));
    return shown(value) + (low ? " is too small: it must be " : " is too large: it must be ") +
           (open ? (low ? "greater than " : "less than ") : (low ? "at least " : "at most ")) +
           shown_bound(bound) + purpose;
  }
  if (starts("Failed to match regex")) {
    return shown(value) + " does not have the required form; correct it" + purpose;
  }
  if (starts("Array should contain")) {
    const bool few = schema.contains("minItems") && value.size() < schema.at("minItems");
    return std::to_string(value.size()) +
           (value.size() == 1 ? " entry is too " : " entries are too ") +
           (few ? "few: write at least " + schema.at("minItems").dump()
                : "many: write at most " + schema.at("maxItems").dump()) +
           purpose;
  }
  if (starts("String should be no fewer")) return "this text is empty; enter a text" + purpose;
  if (starts("String should be no more")) {
    return "this text is longer than " + schema.at("maxLength").dump() + " characters; shorten it";
  }
  if (starts("Object should have no fewer")) return "this object is empty; add an entry" + purpose;
  if (starts("Object should have no more")) {
    const json& most = schema.at("maxProperties");
    const auto properties = schema.find("properties");
    if (most == json(1) && properties != schema.end()) {
      return "write exactly one of the keys " + one_of(keys_of(*properties)) +
             " here; remove the other" + purpose;
    }
    return std::to_string(value.size()) + " entries are too many: write at most " + most.dump() +
           purpose;
  }
  return description + purpose;
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

bool is_comment(const std::string& key) { return key.starts_with("x-") || key == "$comment"; }

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

std::vector<Diagnostic> check_schema(const JsonDocument& document) {
  const json& root = schema_root();
  std::vector<Diagnostic> found{};
  if (!document.root().is_object()) {
    return {document.at("", shown(document.root()) + " is not a protocol; a protocol is an object "
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
    std::string message = sentence(error.description, *node, *value);
    if (message.empty() || !said.emplace(pointer, message).second) continue;
    found.push_back(document.at(pointer, std::move(message)));
  }
  std::stable_sort(found.begin(), found.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return found;
}

}  // namespace asperity

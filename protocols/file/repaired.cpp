// Implements the replacement of values that do not have the form of their keys.

#include "protocols/file/repaired.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/follow_ups.h"
#include "protocols/file/form_check.h"
#include "protocols/keys/tables.h"
#include "protocols/keys/valid_part.h"

namespace asperity {

namespace {

using nlohmann::json;

/// "stone_2" for "Stone 2".
std::string name_like(std::string text) {
  for (char& c : text) {
    const auto letter = static_cast<unsigned char>(c);
    c = std::isalnum(letter) != 0 ? static_cast<char>(std::tolower(letter)) : '_';
  }
  return text;
}

/// The names of the keys that an object may still receive.
std::vector<std::string> further_keys(const KeyTable& table, const json& object) {
  std::vector<std::string> keys{};
  for (const ProtocolKey& key : table.keys) {
    if (!object.contains(key.name)) keys.emplace_back(key.name);
  }
  return keys;
}

/// One way of repairing a document. `variant` determines arbitrary choices, such as the word of several.
class Repairer final {
 public:
  Repairer(const json& document, std::size_t variant)
      : document_(document), names_(declared_names(document)), variant_(variant) {}

  std::optional<json> whole() { return fitted(document_, ObjectShape{&kProtocolTable}, ""); }
  const std::set<std::string>& places() const { return places_; }
  std::size_t choices() const { return choices_; }

 private:
  /// The value if it has the shape; otherwise a replacement; nullopt if there is no neutral replacement. `standard`: the
  /// default of its key.
  std::optional<json> fitted(const json& value, const ValueShape& shape, const std::string& pointer,
                             const json& standard = {}) {
    const ValueShape* const applied = shape_of(shape, value);
    auto made =
        applied == nullptr
            ? std::nullopt
            : std::visit([&](const auto& one) { return part_of(value, one, pointer); }, *applied);
    return made ? made : replaced(shape, pointer, standard);
  }

  std::optional<json> replaced(const ValueShape& shape, const std::string& pointer,
                               const json& standard) {
    places_.insert(pointer);
    return any(shape, standard);
  }

  // What remains of a value of the right type; nullopt for one that is replaced.

  template <class Scalar>
  std::optional<json> part_of(const json& value, const Scalar& shape, const std::string&) {
    return valid_part(value, shape, "", "").problems.empty() ? std::optional(value) : std::nullopt;
  }

  std::optional<json> part_of(const json& list, const ListShape& shape,
                              const std::string& pointer) {
    json made = json::array();
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (auto entry = fitted(list[i], *shape.entry, pointer_to(pointer, i))) {
        made.push_back(std::move(*entry));
      }
    }
    const bool has_size =
        made.size() >= shape.shortest && made.size() <= shape.longest.value_or(made.size());
    return has_size ? std::optional(std::move(made)) : std::nullopt;
  }

  std::optional<json> part_of(const json& object, const MapShape& shape,
                              const std::string& pointer) {
    json made = json::object();
    for (const auto& [name, entry] : object.items()) {
      if (is_comment(name)) continue;
      const std::string at = pointer_to(pointer, name);
      const std::string meant = shape.has_names ? name_like(name) : name;
      if (meant != name) places_.insert(at);
      if (shape.has_names && !is_name(meant)) continue;
      if (auto fit = fitted(entry, *shape.entry, at)) made[meant] = std::move(*fit);
    }
    return made.size() < shape.shortest ? std::nullopt : std::optional(std::move(made));
  }

  std::optional<json> part_of(const json& object, const ObjectShape& shape,
                              const std::string& pointer) {
    const KeyTable& table = *shape.table;
    json made = json::object();
    for (const auto& [name, member] : object.items()) {
      const std::string at = pointer_to(pointer, name);
      const ProtocolKey* key = table.find(name);
      if (key == nullptr) {
        if (is_comment(name) || table.is_open) {
          made[name] = member;
          continue;
        }
        places_.insert(at);
        const auto nearest = nearest_name(name, further_keys(table, object));
        if (!nearest) continue;
        key = table.find(*nearest);
      }
      if (auto fit = fitted(member, key->shape, at, default_of(*key))) {
        made[std::string(key->name)] = std::move(*fit);
      }
    }
    for (const ProtocolKey& key : table.keys) {
      const std::string name(key.name);
      if (key.is_required && !made.contains(name)) {
        auto value = replaced(key.shape, pointer_to(pointer, name), default_of(key));
        if (!value) return {};
        made[name] = std::move(*value);
      }
      const bool applies = std::ranges::all_of(
          key.conditions, [&made](const KeyCondition& each) { return holds_in(each, made); });
      if (!applies && made.erase(name) > 0) places_.insert(pointer_to(pointer, name));
    }
    if (!table.may_be_empty && made.empty()) return {};
    return decide(made, table, pointer) ? std::optional(std::move(made)) : std::nullopt;
  }

  /// Leaves one of the keys of which an object has exactly one, such as the kinds of a step of the flow.
  bool decide(json& object, const KeyTable& table, const std::string& pointer) {
    if (table.deciding.empty()) return true;
    std::vector<std::string> there{};
    for (const std::string_view key : table.deciding) {
      if (object.contains(key)) there.emplace_back(key);
    }
    if (there.size() != 1) places_.insert(pointer);
    for (std::size_t i = 1; i < there.size(); ++i) object.erase(there[i]);
    return !there.empty();
  }

  // A neutral value of a shape.

  std::optional<json> any(const ValueShape& shape, const json& standard = {}) {
    return std::visit(
        [&](const auto& one) {
          if constexpr (std::is_same_v<std::decay_t<decltype(one)>, NumberShape>) {
            return any_number(one, standard);
          } else {
            return any_of(one);
          }
        },
        shape);
  }

  std::optional<json> any_of(const TruthShape&) { return variant_ % 2 == 1; }
  std::optional<json> any_of(const WordShape& shape) { return chosen(shape.words).name; }
  std::optional<json> any_of(const TextShape& shape) {
    for (const char* text : {"x", "1.0.0"}) {
      if (valid_part(text, shape, "", "").problems.empty()) return text;
    }
    return {};
  }
  /// A new name, or that of anything that the document declares.
  std::optional<json> any_of(const NameShape&) {
    choices_ = std::max(choices_, 1 + names_.size());
    return variant_ == 0 || names_.empty() ? "x" : names_[(variant_ - 1) % names_.size()];
  }
  std::optional<json> any_of(const ListShape& shape) {
    json made = json::array();
    for (std::size_t i = 0; i < shape.shortest; ++i) {
      const auto entry = any(*shape.entry);
      if (!entry) return {};
      made.push_back(*entry);
    }
    return made;
  }
  std::optional<json> any_of(const MapShape& shape) {
    return shape.shortest > 0 ? std::nullopt : std::optional(json::object());
  }
  std::optional<json> any_of(const ObjectShape& shape) {
    const KeyTable& table = *shape.table;
    if (!table.may_be_empty || !table.deciding.empty()) return {};
    json made = json::object();
    for (const ProtocolKey& key : table.keys) {
      if (!key.is_required) continue;
      const auto value = any(key.shape, default_of(key));
      if (!value) return {};
      made[std::string(key.name)] = *value;
    }
    return made;
  }
  std::optional<json> any_of(const BoundShape& shape) { return any(*shape.value); }
  std::optional<json> any_of(const FormsShape& shape) { return any(shape.forms.front()); }

  /// The default, a small and a large number.
  std::optional<json> any_number(const NumberShape& shape, const json& standard) {
    std::vector<double> numbers{};
    for (const double number :
         {standard.is_number() ? standard.get<double>() : 1.0, shape.minimum.value_or(0.0),
          shape.maximum.value_or(1e3), shape.below.value_or(1.0) * 0.5}) {
      if (lies_within(shape, number)) numbers.push_back(number);
    }
    if (numbers.empty()) return {};
    const double number = chosen(std::span<const double>(numbers));
    if (shape.is_whole) return static_cast<std::int64_t>(number);
    return number;
  }

  template <class Value>
  const Value& chosen(std::span<const Value> values) {
    choices_ = std::max(choices_, values.size());
    return values[variant_ % values.size()];
  }

  const json& document_;
  std::vector<std::string> names_{};
  std::size_t variant_;
  std::size_t choices_ = 1;  ///< the greatest number of alternatives for one value
  std::set<std::string> places_{};
};

}  // namespace

Repair repaired(const JsonDocument& document) {
  constexpr std::size_t kMostVariants = 24;
  if (!document.root().is_object()) return {};
  Repair repair{};
  std::size_t variants = 1;
  for (std::size_t variant = 0; variant < std::min(variants, kMostVariants); ++variant) {
    Repairer repairer(document.root(), variant);
    auto root = repairer.whole();
    if (!root || !has_form_of_protocol(*root)) return {};
    variants = std::max(variants, repairer.choices());
    repair.roots.push_back(std::move(*root));
    repair.places.assign(repairer.places().begin(), repairer.places().end());
  }
  return repair;
}

bool may_follow_from(const Repair& repair, const std::string& pointer, const Phrase& message) {
  const std::string sentence = message.english();
  const std::string without_keys =
      message.translated([](const char* context, const char* words) -> std::string {
        return context != nullptr && context == std::string_view(kNamesOfKeys) ? "" : words;
      });
  const auto names = [](const std::string& text, const std::string& name) {
    return text.find(in_quotes(name)) != std::string::npos;
  };
  const auto lies_in = [](const std::string& inner, const std::string& outer) {
    return inner == outer || inner.starts_with(outer + '/');
  };
  // A level with an unknown name is invalid regardless of the factor's other levels.
  const bool is_unknown_level =
      lies_in(pointer, "/factors") && sentence.starts_with("there is no ");
  return std::any_of(repair.places.begin(), repair.places.end(), [&](const std::string& place) {
    if (place.empty()) return true;
    const std::string object = place.substr(0, place.rfind('/'));
    const std::string name = place.substr(object.size() + 1);
    const bool is_of_same_object = !is_unknown_level && !object.empty() && lies_in(pointer, object);
    const bool is_made_of_levels = lies_in(place, "/factors") && lies_in(pointer, "/blocks");
    return is_of_same_object || is_made_of_levels || lies_in(place, pointer) ||
           lies_in(pointer, place) || names(without_keys, name) ||
           // A key has the same name in other objects.
           (names(sentence, name) &&
            (object.empty() || names(without_keys, object.substr(object.rfind('/') + 1))));
  });
}

}  // namespace asperity

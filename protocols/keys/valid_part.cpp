// Implements the check of the form of values as one walk over a value and its shape.

#include "protocols/keys/valid_part.h"

#include <algorithm>
#include <regex>
#include <utility>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/keys/form_sentences.h"

namespace asperity {

namespace {

using nlohmann::json;

std::size_t characters_in(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // all bytes of UTF-8 but the first
  }));
}

std::vector<std::string> names_of(std::span<const KeyWord> words) {
  std::vector<std::string> names{};
  for (const KeyWord& word : words) names.emplace_back(word.name);
  return names;
}

/// The keys that the table declares, in the order of the alphabet.
std::vector<std::string> names_of(const KeyTable& table) {
  std::vector<std::string> names{};
  for (const ProtocolKey& key : table.keys) names.emplace_back(key.name);
  std::sort(names.begin(), names.end());
  return names;
}

class Walk final {
 public:
  explicit Walk(std::vector<FormProblem>& problems) : problems_(problems) {}

  std::optional<json> part(const json& value, const ValueShape& shape, std::string_view meaning,
                           const std::string& pointer) {
    meaning = meaning_of(shape, meaning);
    const Place place{value, meaning, pointer};
    // A word is named with all others, so that the sentence about its type would be a second one.
    const bool is_word = std::holds_alternative<WordShape>(shape);
    if (!is_word && shape_of(shape, value) == nullptr) {
      return refused(place, wrong_type(value, shape, meaning));
    }
    return std::visit([&](const auto& one) { return part_of(one, place); }, shape);
  }

 private:
  struct Place {
    const json& value;
    std::string_view meaning{};
    const std::string& pointer;
  };

  void report(const std::string& pointer, Phrase message, bool is_at_key = false) {
    problems_.push_back({pointer, std::move(message), is_at_key});
  }
  std::optional<json> refused(const Place& place, Phrase message) {
    report(place.pointer, std::move(message));
    return {};
  }

  std::optional<json> part_of(const NumberShape& shape, const Place& place) {
    if (lies_within(shape, place.value.get<double>())) return place.value;
    return refused(place, wrong_number(place.value, shape, place.meaning));
  }

  std::optional<json> part_of(const TruthShape&, const Place& place) { return place.value; }

  std::optional<json> part_of(const WordShape& shape, const Place& place) {
    const bool is_one =
        std::any_of(shape.words.begin(), shape.words.end(),
                    [&place](const KeyWord& word) { return place.value == word.name; });
    if (!is_one) return refused(place, wrong_word(place.value, names_of(shape.words)));
    return place.value;
  }

  std::optional<json> part_of(const TextShape& shape, const Place& place) {
    const auto& text = place.value.get_ref<const std::string&>();
    if (text.empty() && !shape.may_be_empty) return refused(place, empty_text(place.meaning));
    if (characters_in(text) > shape.longest) return refused(place, long_text(shape.longest));
    if (!shape.pattern.empty() &&
        !std::regex_search(text, std::regex(shape.pattern.begin(), shape.pattern.end()))) {
      return refused(place, wrong_pattern(place.value, place.meaning));
    }
    return place.value;
  }

  std::optional<json> part_of(const NameShape&, const Place& place) {
    const auto& text = place.value.get_ref<const std::string&>();
    if (text.size() > kMaximumNameLength) return refused(place, long_text(kMaximumNameLength));
    if (!is_name(text)) return refused(place, wrong_pattern(place.value, place.meaning));
    return place.value;
  }

  std::optional<json> part_of(const ListShape& shape, const Place& place) {
    json made = json::array();
    for (std::size_t i = 0; i < place.value.size(); ++i) {
      auto entry = part(place.value[i], *shape.entry, shape.meaning, pointer_to(place.pointer, i));
      if (entry) made.push_back(std::move(*entry));
    }
    if (!has_permitted_size(shape.shortest, shape.longest, place)) return {};
    if (shape.is_distinct) {
      for (std::size_t i = 1; i < place.value.size(); ++i) {
        const auto end = place.value.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::find(place.value.begin(), end, place.value[i]) == end) continue;
        report(pointer_to(place.pointer, i), repeated_entry(place.value[i]));
        return {};
      }
    }
    return made.size() < shape.shortest ? std::nullopt : std::optional(std::move(made));
  }

  std::optional<json> part_of(const MapShape& shape, const Place& place) {
    json made = json::object();
    std::size_t size = 0;
    for (const auto& [name, member] : place.value.items()) {
      if (is_comment(name)) continue;
      ++size;
      const std::string at = pointer_to(place.pointer, name);
      if (shape.has_names && !is_name(name)) {
        report(at, not_a_name(name), true);
      } else if (characters_in(name) > shape.longest_name) {
        report(at, long_text(shape.longest_name), true);
      } else if (auto entry = part(member, *shape.entry, shape.meaning, at)) {
        made[name] = std::move(*entry);
      }
    }
    if (size < shape.shortest) return refused(place, empty_object(place.meaning));
    if (shape.longest && size > *shape.longest) {
      return refused(place, too_many_entries(size, *shape.longest, place.meaning));
    }
    return made.size() < shape.shortest ? std::nullopt : std::optional(std::move(made));
  }

  std::optional<json> part_of(const ObjectShape& shape, const Place& place) {
    const KeyTable& table = *shape.table;
    json made = table.is_open ? place.value : json::object();
    bool has_other_mistake = false;  // which explains the lack of a deciding key
    for (const auto& [name, member] : place.value.items()) {
      if (is_comment(name)) continue;
      const std::string at = pointer_to(place.pointer, name);
      const ProtocolKey* const key = table.find(name);
      if (key == nullptr) {
        if (table.is_open) continue;
        const auto removed = std::ranges::find(table.removed, name, &RemovedKey::name);
        report(at,
               removed == table.removed.end() ? unknown_key(name, names_of(table))
                                              : phrase_of_key(removed->problem),
               true);
        has_other_mistake = true;
      } else if (auto valid = part(member, key->shape, key->meaning, at)) {
        made[name] = std::move(*valid);
      } else {
        made.erase(name);
      }
    }
    for (const ProtocolKey& key : table.keys) {
      const bool is_there = place.value.contains(key.name);
      if (key.is_required && !is_there) {
        report(pointer_to(place.pointer, key.name), missing_key(key.name, meaning_of(key)));
      }
      if (!is_there) continue;
      for (const KeyCondition& condition : key.conditions) {
        // A value without the form of its key is a problem of that key.
        const bool is_known = !place.value.contains(condition.key) || made.contains(condition.key);
        if (!is_known || holds_in(condition, place.value)) continue;
        report(pointer_to(place.pointer, key.name), inapplicable_key(condition), true);
        has_other_mistake = true;
        made.erase(std::string(key.name));
        break;
      }
    }
    const bool is_empty = std::all_of(place.value.items().begin(), place.value.items().end(),
                                      [](const auto& member) { return is_comment(member.key()); });
    if (is_empty && !table.may_be_empty) return refused(place, empty_object(place.meaning));
    if (is_decided(table, place)) return made;
    if (!has_other_mistake) {
      report(place.pointer, undecided_object({table.deciding.begin(), table.deciding.end()}));
    }
    return {};
  }

  std::optional<json> part_of(const BoundShape& shape, const Place& place) {
    auto bound = part(place.value, *shape_of(shape, place.value), place.meaning, place.pointer);
    const bool is_binding = place.value.is_object();
    return is_binding && bound && !bound->contains("factor") ? std::nullopt : std::move(bound);
  }

  std::optional<json> part_of(const FormsShape& shape, const Place& place) {
    // One form has the type: see `part`.
    return part(place.value, *shape_of(shape, place.value), place.meaning, place.pointer);
  }

  bool has_permitted_size(std::size_t shortest, const std::optional<std::size_t>& longest,
                          const Place& place) {
    const std::size_t size = place.value.size();
    if (size < shortest) {
      report(place.pointer, too_few_entries(size, shortest, place.meaning));
    } else if (longest && size > *longest) {
      report(place.pointer, too_many_entries(size, *longest, place.meaning));
    } else {
      return true;
    }
    return false;
  }

  static bool is_decided(const KeyTable& table, const Place& place) {
    if (table.deciding.empty()) return true;
    const auto count =
        std::count_if(table.deciding.begin(), table.deciding.end(),
                      [&place](std::string_view key) { return place.value.contains(key); });
    return count == 1;
  }

  std::vector<FormProblem>& problems_;
};

}  // namespace

bool has_form(const std::vector<FormProblem>& problems, std::string_view pointer) {
  return std::none_of(problems.begin(), problems.end(), [pointer](const FormProblem& problem) {
    return pointer == problem.pointer || pointer.starts_with(problem.pointer + '/') ||
           problem.pointer.starts_with(std::string(pointer) + '/');
  });
}

ValidPart valid_part(const json& value, const KeyTable& table, const std::string& pointer) {
  return valid_part(value, ObjectShape{&table}, "", pointer);
}

ValidPart valid_part(const json& value, const ValueShape& shape, std::string_view meaning,
                     const std::string& pointer) {
  ValidPart result{};
  result.value = Walk(result.problems).part(value, shape, meaning, pointer);
  return result;
}

}  // namespace asperity

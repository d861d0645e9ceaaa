// Chooses the value of a new entry of a list so that no entry occurs twice.

#include "protocols/form/new_entries.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/editing/text_entries.h"
#include "protocols/form/new_values.h"
#include "protocols/form/offered_names.h"
#include "protocols/keys/names_in.h"

namespace asperity {

namespace {

using nlohmann::json;

bool has_entry(const json& list, const json& entry) {
  return std::find(list.begin(), list.end(), entry) != list.end();
}

const NameShape* name_of(const ValueShape& shape) {
  const auto* const text = std::get_if<TextShape>(&shape);
  return text != nullptr ? &text->name : std::get_if<NameShape>(&shape);
}

/// What an entry is one of: the words, or the names that the protocol declares. Empty: it is chosen in another way.
std::vector<std::string> choices_of(const ValueShape& entry, const ProtocolNames& names) {
  if (const auto* const words = std::get_if<WordShape>(&entry)) {
    std::vector<std::string> choices{};
    for (const KeyWord& word : words->words) choices.emplace_back(word.name);
    return choices;
  }
  const NameShape* const name = name_of(entry);
  if (name == nullptr || name->is_declared) return {};
  return offered_names(names, *name);
}

/// As a user types it: without the digits that a sum of two decimals has too many.
json rounded(double number) {
  constexpr int kDigits = 12;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number,
                                 std::chars_format::general, kDigits);
  return json::parse(text.data(), end.ptr);
}

json next_number(const NumberShape& shape, const json& list, std::size_t last) {
  const auto number = list[last].get<double>();
  const bool has_step = last > 0 && list[last - 1].is_number();
  const double step = has_step ? number - list[last - 1].get<double>() : 1.0;
  for (const double by : {step, 1.0, -1.0}) {
    json next = list[last];
    // After as many steps as there are entries, a number is none of them.
    for (std::size_t i = 0; i < list.size() && has_entry(list, next); ++i) {
      const double sum = next.get<double>() + by;
      if (!std::isfinite(sum)) break;
      next = rounded(sum);
    }
    if (!has_entry(list, next) && lies_within(shape, next.get<double>())) return next;
  }
  return list[last];
}

/// "group_3" behind "group_2" of a series; otherwise the name with a number.
std::string next_name(const json& list, const std::string& last) {
  const auto is_taken = [&list](const std::string& name) { return has_entry(list, name); };
  const std::size_t stem = std::min(last.rfind('_'), last.size());
  const std::string base = last.substr(0, stem);
  int number = 0;
  const char* const end = last.data() + last.size();
  const auto read = std::from_chars(std::min(last.data() + stem + 1, end), end, number);
  const bool is_number = read.ec == std::errc() && read.ptr == end;
  if (is_number && (is_taken(base) || is_taken(base + "_" + std::to_string(number - 1)))) {
    while (is_taken(base + "_" + std::to_string(number))) ++number;
    return base + "_" + std::to_string(number);
  }
  return free_name(last, is_taken);
}

/// Of a factor whose levels are names elsewhere, the first of these that is not a level; empty: there is none.
std::string unused_level(const ProtocolNames& names, const std::string& factor,
                         const json& levels) {
  for (const auto& [linked, registry] : names.links) {
    if (linked != levels_of(factor)) continue;
    for (const std::string& name : declared_names(names, registry)) {
      if (!has_entry(levels, name)) return name;
    }
  }
  return {};
}

}  // namespace

std::optional<nlohmann::ordered_json> new_entry(const JsonDocument& protocol,
                                                const ProtocolNames& names, const std::string& list,
                                                const ListShape& shape, std::size_t index) {
  const json& present = value_at(protocol, list);
  const std::vector<std::string> choices = choices_of(*shape.entry, names);
  for (const std::string& choice : choices) {
    if (!has_entry(present, choice)) return choice;
  }
  if (!choices.empty() && shape.is_distinct) {
    refuse(protocol, list, "every possible entry is in this list already");
  }
  const auto* const forms = std::get_if<FormsShape>(shape.entry);
  for (const ValueShape& form : forms == nullptr ? std::span<const ValueShape>{} : forms->forms) {
    const NameShape* const name = name_of(form);
    if (name == nullptr || !name->is_declared) continue;
    const std::string factor = json::json_pointer(list).parent_pointer().back();
    std::string unused = unused_level(names, factor, present);
    if (!unused.empty()) return unused;
    if (index == 0) return {};
    const json& last = present[index - 1];
    if (last.is_string()) return next_name(present, last.get<std::string>());
    if (last.is_number())
      return next_number(std::get<NumberShape>(forms->forms.front()), present, index - 1);
  }
  return {};
}

}  // namespace asperity

// Implements renaming by the names that the tables of a protocol find.

#include "protocols/editing/renaming.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "protocols/editing/edits.h"
#include "protocols/editing/text_entries.h"
#include "protocols/keys/names_in.h"
#include "protocols/shapes/shape.h"

namespace asperity {

namespace {

bool is_of_levels(const std::string& registry) { return registry.starts_with(levels_of("")); }

bool is_part_of_name(char c) { return is_name(std::string{'a', c}); }

/// A formula with `after` in place of the name.
std::string renamed_formula(std::string_view formula, std::string_view name,
                            std::string_view after) {
  std::string made{};
  std::size_t copied = 0;
  for (std::size_t at = 0; (at = formula.find(name, at)) != std::string_view::npos;) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_part_of_name(formula[at - 1]);
    const bool ends = end == formula.size() || !is_part_of_name(formula[end]);
    if (begins && ends) {
      made.append(formula.substr(copied, at - copied)).append(after);
      copied = end;
    }
    at = end;
  }
  return made.append(formula.substr(copied));
}

TextChange renamed_use(const JsonDocument& protocol, const NameUse& use, std::string_view after) {
  const JsonPlace place = protocol.place_of(use.pointer).value();
  if (use.is_key) {
    const auto [container, index] = entry_at(protocol, use.pointer);
    const std::string_view key = container.text_before_value(index);
    return {place.key, key.find_last_of('"') + 1, json_string(after)};
  }
  const auto text = value_at(protocol, use.pointer).get<std::string>();
  return {
      place.value, place.end - place.value,
      json_string(use.is_in_formula ? renamed_formula(text, use.name, after) : std::string(after))};
}

/// The changes of the name in these registries.
TextChanges renamed_in(const JsonDocument& protocol, ProtocolNames names,
                       const std::set<std::string>& registries, std::string_view name,
                       std::string_view after) {
  // An error is reported at a declaration if there is one.
  std::stable_partition(names.uses.begin(), names.uses.end(),
                        [](const NameUse& use) { return use.is_declared; });
  std::set<std::string> undeclared = registries;
  std::optional<std::string> declaration{};  // the place of the first one
  std::optional<std::string> taken{};        // the first place with the new name
  TextChanges changes{};
  for (const NameUse& use : names.uses) {
    if (!registries.contains(use.registry)) continue;
    // A reference to what does not exist was meant as this one; as a key it would be there twice.
    const bool is_meant = !use.is_declared && !use.is_key;
    if (use.name == after && !is_meant && !taken) taken = use.pointer;
    if (use.name != name) continue;
    if (use.is_declared) undeclared.erase(use.registry);
    if (use.is_declared && !declaration) declaration = use.pointer;
    changes.push_back(renamed_use(protocol, use, after));
  }
  const std::string place = declaration.value_or("");
  if (!undeclared.empty()) {
    refuse(
        protocol, place,
        phrase("Protocols", "the protocol does not declare %1 in %2, so that it cannot be renamed")
            .with(json_string(name), *undeclared.begin()));
  }
  if (taken) {
    refuse(protocol, *taken,
           phrase("Protocols", "the name %1 is used here; choose another name")
               .with(json_string(after)));
  }
  if (!is_name(after) && !std::all_of(registries.begin(), registries.end(), is_of_levels)) {
    refuse(protocol, place,
           phrase("Protocols",
                  "%1 is not a name: use lower-case letters, digits and underscores, starting with "
                  "a letter")
               .with(json_string(after)));
  }
  std::sort(changes.begin(), changes.end(), [](const TextChange& one, const TextChange& other) {
    return one.offset < other.offset;
  });
  return changes;
}

}  // namespace

TextChanges rename(const JsonDocument& protocol, const std::string& registry, std::string_view name,
                   std::string_view after) {
  if (name == after) return {};
  const ProtocolNames names = names_in(protocol.root());
  return renamed_in(protocol, names, registries_of(names, registry, name), name, after);
}

TextChanges rename_or_replace(const JsonDocument& protocol, const std::string& registry,
                              std::string_view name, std::string_view after) {
  if (name == after) return {};
  const ProtocolNames names = names_in(protocol.root());
  const bool refers = std::ranges::any_of(
      names.links, [&registry](const auto& link) { return link.first == registry; });
  return renamed_in(protocol, names,
                    refers ? std::set{registry} : registries_of(names, registry, name), name,
                    after);
}

}  // namespace asperity

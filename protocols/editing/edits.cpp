// Implements the edits of a protocol's text.

#include "protocols/editing/edits.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "protocols/design/json_pointer.h"
#include "protocols/editing/text_entries.h"
#include "protocols/editing/text_layout.h"
#include "protocols/keys/tables.h"

namespace asperity {

namespace {

constexpr const char* kNewValue = "the new value";

/// The key in quotation marks. Errors: ProtocolError for one that a reader refuses.
std::string quoted_key(std::string_view key) {
  std::string text = json_string(key);
  const JsonDocument check_of_limits("{" + text + ":0}", "the new key");
  return text;
}

void require_free(const JsonDocument& document, const TextContainer& container,
                  std::string_view key) {
  if (!container.has(key)) return;
  throw ProtocolError({document.at_key(
      pointer_to(container.pointer(), key),
      phrase("Protocols", "the key %1 occurs already in this object; choose another name")
          .with(json_string(key)))});
}

/// The container at the pointer, which must be of this type.
TextContainer container_at(const JsonDocument& document, const std::string& pointer,
                           bool is_object) {
  TextContainer container(document, pointer);
  if (container.is_object() != is_object) {
    refuse(document, pointer,
           is_object ? phrase("Protocols", "this is a list; name an object {…}")
                     : phrase("Protocols", "this is an object; name a list […]"));
  }
  return container;
}

void require_index(const JsonDocument& document, const TextContainer& container, std::size_t index,
                   std::size_t greatest) {
  if (index <= greatest) return;
  refuse(document, container.pointer(),
         phrase("Protocols", "there is no position %1 here; choose one from 0 to %2")
             .with(std::to_string(index), std::to_string(greatest)));
}

TextChanges filled(const EntryGap& gap, const std::string& entry) {
  return {{gap.offset, 0, gap.before + entry + gap.after}};
}

std::size_t index_in_order(const TextContainer& object, std::string_view key,
                           std::span<const std::string_view> order) {
  const auto own = std::find(order.begin(), order.end(), key);
  for (auto before = own; before != order.begin() && own != order.end();) {
    if (object.has(*--before)) return object.index_of(*before) + 1;
  }
  for (auto after = own; after != order.end(); ++after) {
    if (object.has(*after)) return object.index_of(*after);
  }
  return object.entries().size();
}

}  // namespace

std::string json_string(std::string_view text) {
  try {
    return nlohmann::json(std::string(text)).dump();
  } catch (const nlohmann::json::type_error&) {
    throw std::invalid_argument("a new text is not UTF-8; enter it again");
  }
}

TextChanges set_value(const JsonDocument& document, const std::string& pointer,
                      std::string_view value) {
  const JsonDocument given(value, kNewValue);
  if (value_at(document, pointer) == given.root()) return {};
  const JsonPlace place = document.place_of(pointer).value();
  const JsonPlace characters = given.place_of("").value();
  return {{place.value, place.end - place.value,
           std::string(value.substr(characters.value, characters.end - characters.value))}};
}

TextChanges insert_member(const JsonDocument& document, const std::string& object,
                          std::string_view key, std::string_view value,
                          std::span<const std::string_view> order) {
  const TextContainer container = container_at(document, object, true);
  require_free(document, container, key);
  const JsonDocument given(value, kNewValue);
  const EntryGap gap = gap_at(document, container, index_in_order(container, key, order));
  const std::string name = quoted_key(key);
  return filled(gap, name + gap.colon + laid_out(given, gap, name));
}

TextChanges insert_member(const JsonDocument& protocol, const std::string& object,
                          std::string_view key, std::string_view value) {
  const nlohmann::json& value_of_object = value_at(protocol, object);
  const std::optional<ValueShape> shape = shape_at(kProtocolTable, protocol.root(), object);
  const ValueShape* const found = shape ? shape_of(*shape, value_of_object) : nullptr;
  std::vector<std::string_view> order{};
  if (const auto* const declared = std::get_if<ObjectShape>(found)) {
    for (const ProtocolKey& each : declared->table->keys) order.push_back(each.name);
  }
  return insert_member(protocol, object, key, value, order);
}

TextChanges insert_entry(const JsonDocument& document, const std::string& array, std::size_t index,
                         std::string_view value) {
  const TextContainer container = container_at(document, array, false);
  require_index(document, container, index, container.entries().size());
  const JsonDocument given(value, kNewValue);
  const EntryGap gap = gap_at(document, container, index);
  return filled(gap, laid_out(given, gap, ""));
}

TextChanges remove_entry(const JsonDocument& document, const std::string& pointer) {
  return remove_entries(document, {&pointer, 1});
}

TextChanges remove_entries(const JsonDocument& document, std::span<const std::string> pointers) {
  std::map<std::string, std::set<std::size_t>> removed{};  // positions by container
  for (const std::string& pointer : pointers) {
    const bool is_inside = std::any_of(
        pointers.begin(), pointers.end(),
        [&pointer](const std::string& other) { return pointer.starts_with(other + "/"); });
    if (is_inside) continue;
    const auto [container, index] = entry_at(document, pointer);
    removed[container.pointer()].insert(index);
  }
  TextChanges changes{};
  for (const auto& [pointer, positions] : removed) {
    const TextContainer container(document, pointer);
    const std::vector<TextEntry>& entries = container.entries();
    for (auto first = positions.begin(); first != positions.end();) {
      std::size_t last = *first;  // of a run of entries
      auto next = std::next(first);
      while (next != positions.end() && *next == last + 1) last = *next++;
      std::size_t from = container.begin();
      std::size_t to = entries[last].place.end;
      if (*first > 0) {
        from = entries[*first - 1].place.end;
      } else if (last + 1 < entries.size()) {
        from = entries[0].place.key;
        to = entries[last + 1].place.key;
      }
      changes.push_back({from, to - from, {}});
      first = next;
    }
  }
  std::sort(changes.begin(), changes.end(), [](const TextChange& one, const TextChange& other) {
    return one.offset < other.offset;
  });
  return changes;
}

TextChanges move_entry(const JsonDocument& document, const std::string& pointer,
                       std::size_t index) {
  const auto [container, from] = entry_at(document, pointer);
  const std::vector<TextEntry>& entries = container.entries();
  require_index(document, container, index, entries.size() - 1);
  if (index == from) return {};
  const std::size_t first = std::min(from, index);
  const std::size_t last = std::max(from, index);
  std::string text{};
  for (std::size_t i = first; i <= last; ++i) {
    if (i > first) {
      const std::size_t end = entries[i - 1].place.end;
      text += document.text().substr(end, entries[i].place.key - end);
    }
    const std::size_t before = i == index ? from : (from < index ? i + 1 : i - 1);
    text += container.text_of(before);
  }
  const std::size_t offset = entries[first].place.key;
  return {{offset, entries[last].place.end - offset, std::move(text)}};
}

TextChanges duplicate_entry(const JsonDocument& document, const std::string& pointer,
                            std::string_view key) {
  const auto [container, index] = entry_at(document, pointer);
  const EntryGap gap = gap_at(document, container, index + 1);
  std::string entry(container.text_of(index));
  if (container.is_object()) {
    require_free(document, container, key);
    const std::string_view before = container.text_before_value(index);
    entry.replace(0, before.find_last_of('"') + 1, quoted_key(key));
  }
  return filled(gap, entry);
}

}  // namespace asperity

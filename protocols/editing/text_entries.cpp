// Implements the search for the entries of a container, and for the characters between them.

#include "protocols/editing/text_entries.h"

#include <algorithm>
#include <utility>

#include "protocols/design/json_pointer.h"

namespace asperity {

TextContainer::TextContainer(const JsonDocument& document, std::string pointer)
    : text_(document.text()), pointer_(std::move(pointer)) {
  const nlohmann::json& value = value_at(document, pointer_);
  if (!value.is_structured()) {
    refuse(document, pointer_,
           phrase("Protocols", "this value has no entries; name an object {…} or a list […]"));
  }
  is_object_ = value.is_object();
  const JsonPlace place = document.place_of(pointer_).value();
  begin_ = place.value + 1;
  end_ = place.end - 1;
  if (is_object_) {
    for (const auto& [key, member] : value.items()) {
      entries_.push_back({key, document.place_of(pointer_to(pointer_, key)).value()});
    }
  } else {
    for (std::size_t i = 0; i < value.size(); ++i) {
      entries_.push_back({{}, document.place_of(pointer_to(pointer_, i)).value()});
    }
  }
  std::sort(entries_.begin(), entries_.end(), [](const TextEntry& one, const TextEntry& other) {
    return one.place.key < other.place.key;
  });
}

std::size_t TextContainer::index_of(std::string_view key) const noexcept {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [key](const TextEntry& entry) { return entry.key == key; });
  return static_cast<std::size_t>(found - entries_.begin());
}

bool TextContainer::has(std::string_view key) const noexcept {
  return is_object_ && index_of(key) < entries_.size();
}

std::string_view TextContainer::text_before_value(std::size_t index) const {
  const JsonPlace& place = entries_.at(index).place;
  return text_.substr(place.key, place.value - place.key);
}

std::string_view TextContainer::text_of(std::size_t index) const {
  const JsonPlace& place = entries_.at(index).place;
  return text_.substr(place.key, place.end - place.key);
}

std::string_view TextContainer::space_before(std::size_t index) const {
  const std::size_t from = index == 0 ? begin_ : entries_.at(index - 1).place.end;
  const std::size_t to = index == entries_.size() ? end_ : entries_.at(index).place.key;
  const std::string_view between = text_.substr(from, to - from);
  return between.substr(between.find(',') + 1);  // all of it where there is no comma
}

void refuse(const JsonDocument& document, const std::string& pointer, Phrase message) {
  throw ProtocolError({document.at(pointer, std::move(message))});
}

const nlohmann::json& value_at(const JsonDocument& document, const std::string& pointer) {
  const nlohmann::json::json_pointer path(pointer);
  if (!document.place_of(pointer) || !document.root().contains(path)) {
    refuse(document, pointer,
           phrase("Protocols", "there is no value here; name one that the text contains"));
  }
  return document.root().at(path);
}

EntryOfContainer entry_at(const JsonDocument& document, const std::string& pointer) {
  value_at(document, pointer);
  if (pointer.empty()) {
    refuse(document, pointer,
           phrase("Protocols",
                  "the complete document is not an entry; name a member or an entry of a list"));
  }
  TextContainer container(document, pointer.substr(0, pointer.rfind('/')));
  const std::size_t begin = document.place_of(pointer)->key;
  const auto found =
      std::find_if(container.entries().begin(), container.entries().end(),
                   [begin](const TextEntry& entry) { return entry.place.key == begin; });
  const auto index = static_cast<std::size_t>(found - container.entries().begin());
  return {std::move(container), index};
}

}  // namespace asperity

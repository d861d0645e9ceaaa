// Implements the search for the texts of a protocol that a translation replaces.

#include "protocols/texts/translatable_texts.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/keys/names_in.h"
#include "protocols/keys/tables.h"
#include "protocols/shapes/key.h"

namespace asperity {

namespace {

using nlohmann::json;

class Walk {
 public:
  explicit Walk(std::vector<TranslatableText>& found) : found_(found) {}

  struct Place {
    const json& value;
    std::string pointer{};
    std::string address{};
  };

  void visit(const ValueShape& shape, const Place& place) {
    std::visit([&](const auto& one) { texts_of(one, place); }, shape);
  }

 private:
  void texts_of(const TextShape& shape, const Place& place) {
    if (shape.translated == Translated::never || !place.value.is_string()) return;
    const auto& text = place.value.get_ref<const std::string&>();
    const std::string address =
        shape.is_value ? pointer_to(place.address, text) + "/text" : place.address;
    found_.push_back({place.pointer, address, text, shape});
  }

  void texts_of(const ListShape& shape, const Place& place) {
    if (!place.value.is_array()) return;
    for (std::size_t i = 0; i < place.value.size(); ++i) {
      const json& entry = place.value[i];
      const std::string_view name = name_of_entry(entry);
      visit(*shape.entry, {entry, pointer_to(place.pointer, i),
                           name.empty() ? place.address : pointer_to(place.address, name)});
    }
  }

  void texts_of(const MapShape& shape, const Place& place) {
    if (!place.value.is_object()) return;
    for (const auto& [name, entry] : place.value.items()) {
      if (!is_comment(name)) visit(*shape.entry, member(place, name, entry));
    }
  }

  void texts_of(const ObjectShape& shape, const Place& place) {
    if (!place.value.is_object()) return;
    for (const ProtocolKey& key : shape.table->keys) {
      const auto found = place.value.find(key.name);
      if (found != place.value.end()) visit(key.shape, member(place, key.name, *found));
    }
  }

  void texts_of(const FormsShape& shape, const Place& place) {
    if (const ValueShape* const form = shape_of(shape, place.value)) visit(*form, place);
  }

  // These have no texts for people.
  void texts_of(const NumberShape&, const Place&) {}
  void texts_of(const TruthShape&, const Place&) {}
  void texts_of(const WordShape&, const Place&) {}
  void texts_of(const NameShape&, const Place&) {}
  void texts_of(const BoundShape&, const Place&) {}

  static Place member(const Place& of, std::string_view key, const json& value) {
    return {value, pointer_to(of.pointer, key), pointer_to(of.address, key)};
  }

  std::vector<TranslatableText>& found_;
};

}  // namespace

std::vector<TranslatableText> translatable_texts(const json& protocol) {
  std::vector<TranslatableText> found{};
  Walk(found).visit(ObjectShape{&kProtocolTable}, {protocol});
  return found;
}

}  // namespace asperity

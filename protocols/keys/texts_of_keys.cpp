// Implements the collection of the texts of keys.

#include "protocols/keys/texts_of_keys.h"

#include <variant>

#include "protocols/keys/tables.h"

namespace asperity {

namespace {

class TextsOfShapes {
 public:
  void add(const ValueShape& shape) { std::visit(*this, shape); }

  void operator()(const NumberShape&) {}
  void operator()(const TruthShape&) {}
  void operator()(const WordShape& shape) {
    for (const KeyWord& word : shape.words) add_text(word.meaning);
  }
  void operator()(const TextShape&) {}
  void operator()(const NameShape&) {}
  void operator()(const ListShape& shape) {
    add_text(shape.meaning);
    add(*shape.entry);
  }
  void operator()(const MapShape& shape) {
    add_text(shape.meaning);
    add(*shape.entry);
  }
  void operator()(const ObjectShape& shape) {
    if (!tables_.insert(shape.table).second) return;
    add_text(shape.table->meaning);
    for (const ProtocolKey& key : shape.table->keys) {
      add_text(key.label);
      add_text(key.meaning);
      add_text(key.computed_default);
      add(key.shape);
    }
  }
  void operator()(const BoundShape& shape) {
    add_text(kNameMeaning);  // of the factor
    add(*shape.value);
  }
  void operator()(const FormsShape& shape) {
    for (const ValueShape& form : shape.forms) add(form);
  }

  const std::set<std::string_view>& texts() const { return texts_; }

 private:
  void add_text(std::string_view text) {
    if (!text.empty()) texts_.insert(text);
  }

  std::set<const KeyTable*> tables_{};  ///< those that are done
  std::set<std::string_view> texts_{};
};

}  // namespace

std::set<std::string_view> texts_of_keys() {
  TextsOfShapes texts{};
  texts.add(ObjectShape{&kProtocolTable});
  return texts.texts();
}

}  // namespace asperity

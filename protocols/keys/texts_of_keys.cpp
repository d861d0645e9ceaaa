// Implements the collections of the labels and other texts of keys.

#include "protocols/keys/texts_of_keys.h"

#include <variant>

#include "protocols/keys/tables.h"

namespace asperity {

namespace {

class TextsOfShapes {
 public:
  static TextsOfShapes of_protocol() {
    TextsOfShapes texts{};
    texts.add(ObjectShape{&kProtocolTable});
    return texts;
  }
  void add(const ValueShape& shape) { std::visit(*this, shape); }

  void operator()(const NumberShape&) {}
  void operator()(const TruthShape&) {}
  void operator()(const WordShape& shape) {
    for (const KeyWord& word : shape.words) {
      add_text(word.meaning);
      words_.insert(word.name);
    }
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
    for (const RemovedKey& removed : shape.table->removed) problems_.insert(removed.problem);
    for (const ProtocolKey& key : shape.table->keys) {
      add_text(key.label);
      labels_[key.name].insert(key.label);
      for (const KeyCondition& condition : key.conditions) {
        if (!condition.problem.empty()) problems_.insert(condition.problem);
      }
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
  const std::set<std::string_view>& words() const { return words_; }
  const std::set<std::string_view>& problems() const { return problems_; }
  const std::map<std::string_view, std::set<std::string_view>>& labels() const { return labels_; }

 private:
  void add_text(std::string_view text) {
    if (!text.empty()) texts_.insert(text);
  }

  std::set<const KeyTable*> tables_{};  ///< those that are done
  std::set<std::string_view> texts_{};
  std::set<std::string_view> words_{};
  std::set<std::string_view> problems_{};
  std::map<std::string_view, std::set<std::string_view>> labels_{};  ///< by the name of the key
};

}  // namespace

std::set<std::string_view> texts_of_keys() { return TextsOfShapes::of_protocol().texts(); }

std::set<std::string_view> words_of_keys() { return TextsOfShapes::of_protocol().words(); }

std::set<std::string_view> problems_of_keys() { return TextsOfShapes::of_protocol().problems(); }

std::map<std::string_view, std::string_view> labels_of_keys() {
  std::map<std::string_view, std::string_view> labels{};
  const TextsOfShapes texts = TextsOfShapes::of_protocol();
  for (const auto& [name, of_name] : texts.labels()) {
    if (of_name.size() == 1) labels.emplace(name, *of_name.begin());
  }
  return labels;
}

}  // namespace asperity

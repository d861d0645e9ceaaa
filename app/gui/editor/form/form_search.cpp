// Searches the entries of a form, whether or not their fields have been made.

#include "app/gui/editor/form/form_search.h"

#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "app/gui/base/typed_number.h"
#include "app/gui/editor/form/form_fields.h"
#include "app/gui/editor/form/row_table.h"
#include "app/gui/look/words.h"
#include "protocols/design/json_pointer.h"
#include "protocols/editing/text_entries.h"
#include "protocols/form/form_entries.h"
#include "protocols/form/form_pages.h"
#include "protocols/keys/tables.h"

namespace asperity {

namespace {

using nlohmann::json;

QString shown_number(const NumberShape& shape, const json& value) {
  const std::string_view unit = shape.display.unit.empty() ? shape.unit : shape.display.unit;
  return shown_in_unit(shape, value.dump()) + " " + text(std::string(unit));
}

class Search final {
 public:
  Search(const FormSource& source, const QString& words) : source_(source), words_(words) {}

  std::vector<std::string> places() && {
    const json& protocol = source_.document().root();
    const std::vector<FormEntry> entries = entries_of(kProtocolTable, protocol, {}, protocol);
    for (const FormPage& page : form_pages()) {
      page_ = &page;
      for (const PagePart& part : page.parts) {
        for (const FormEntry& entry : entries) {
          if (entry.key->name == part.key) search_key(entry);
        }
      }
    }
    return std::move(places_);
  }

 private:
  void search_key(const FormEntry& entry) {
    const json* const value = source_.find(entry.pointer);
    const QString shown =
        value != nullptr ? shown_value(entry.key->shape, *value, entry.pointer)
                         : shown_value(entry.key->shape, default_of(*entry.key), entry.pointer);
    add_if_found(entry.pointer,
                 text_of_keys(entry.key->label) + "\n" + meaning_of_key(*entry.key) + "\n" + shown);
    if (value != nullptr) search_within(entry.key->shape, *value, entry.pointer);
  }

  /// What has no field of its own contains others.
  void search_within(const ValueShape& shape, const json& value, const std::string& pointer) {
    const ValueShape* const found = shape_of(shape, value);
    if (found == nullptr || has_field(shape, &value)) return;
    if (const auto* const object = std::get_if<ObjectShape>(found)) {
      search_object(*object->table, value, pointer);
      return;
    }
    const auto* const list = std::get_if<ListShape>(found);
    const ValueShape& entry = list != nullptr ? *list->entry : *std::get<MapShape>(*found).entry;
    const TextContainer container(source_.document(), pointer);
    for (std::size_t i = 0; i < container.entries().size(); ++i) {
      const std::string& key = container.entries()[i].key;
      if (is_comment(key)) continue;
      const std::string place = list != nullptr ? pointer_to(pointer, i) : pointer_to(pointer, key);
      const json& present = *source_.find(place);
      if (is_table(*found)) {
        search_row(present, place);
        continue;
      }
      add_if_found(place, text(key) + "\n" + shown_value(entry, present, place));
      search_within(entry, present, place);
    }
  }

  void search_object(const KeyTable& table, const json& object, const std::string& pointer) {
    if (table.is_open) return;
    for (const FormEntry& entry : entries_of(table, object, pointer, source_.document().root())) {
      search_key(entry);
    }
    for (const std::string& key : unknown_keys(table, object)) {
      add_if_found(pointer_to(pointer, key), text(key));
    }
  }

  void search_row(const json& row, const std::string& pointer) {
    for (const auto& [key, level] : row.items()) {
      if (!is_comment(key)) add_if_found(pointer_to(pointer, key), shown_level(level));
    }
  }

  /// Empty for what has no field; an object in a field names a factor.
  QString shown_value(const ValueShape& shape, const json& value,
                      const std::string& pointer) const {
    const ValueShape* const found = shape_of(shape, value);
    if (found == nullptr || !has_field(shape, &value)) return {};
    if (const auto* const words = std::get_if<WordShape>(found)) {
      for (const KeyWord& word : words->words) {
        if (value == word.name) return shown_word(word);
      }
    }
    if (const auto* const list = std::get_if<ListShape>(found)) {
      QString numbers{};
      for (const json& number : value) numbers += shown_value(*list->entry, number, pointer) + "; ";
      return numbers;
    }
    if (!value.is_number()) return text(summary_of(shape, value, pointer));
    if (const Parameter* const parameter = source_.parameter_at(pointer)) {
      return shown_number(number_shape(*parameter), value);
    }
    const auto* const bound = std::get_if<BoundShape>(&shape);
    const auto* const number = std::get_if<NumberShape>(bound == nullptr ? &shape : bound->value);
    return number == nullptr ? shown_level(value)
                             : shown_number(displayed_shape(*number, pointer), value);
  }

  static QString shown_level(const json& level) {
    return level.is_string() ? text(level.get<std::string>()) : shown_decimal(level.dump());
  }

  /// An entry of a block is on one page only.
  void add_if_found(const std::string& pointer, const QString& shown) {
    if (&form_page_of(pointer) == page_ && shown.contains(words_, Qt::CaseInsensitive)) {
      places_.push_back(pointer);
    }
  }

  const FormSource& source_;
  const QString& words_;
  const FormPage* page_ = nullptr;
  std::vector<std::string> places_{};
};

}  // namespace

std::vector<std::string> places_with(const FormSource& source, const QString& words) {
  return words.isEmpty() ? std::vector<std::string>{} : Search(source, words).places();
}

}  // namespace asperity

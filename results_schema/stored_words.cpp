// How words of a study are put together without being read.

#include "results_schema/stored_words.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace asperity {

namespace {

using Item = nlohmann::ordered_json;

/// The parts of a list, or the one thing that it is.
Item parts_of(const StoredWords& words) {
  Item item = words.item();
  if (is_stored_list(item)) return item.at(kArgumentsKey);
  return Item::array({std::move(item)});
}

/// Bytes that are not UTF-8 are replaced: a reason has to be stored whatever was typed.
std::string text_of_item(const Item& item) {
  return item.dump(-1, ' ', false, Item::error_handler_t::replace);
}

}  // namespace

bool is_stored_list(const nlohmann::ordered_json& item) {
  const auto code = item.find(kCodeKey);
  const auto arguments = item.find(kArgumentsKey);
  return item.is_object() && code != item.end() && arguments != item.end() && *code == kListCode &&
         arguments->is_array();
}

StoredWords::StoredWords(std::string typed)
    : text(std::move(typed)), json(text_of_item(Item(text))) {}

nlohmann::ordered_json StoredWords::item() const {
  Item item = Item::parse(json, nullptr, false);
  return item.is_discarded() ? Item(text) : item;
}

StoredWords joined(const std::optional<StoredWords>& first, const StoredWords& second) {
  if (!first) return second;
  Item parts = parts_of(*first);
  for (Item& part : parts_of(second)) parts.push_back(std::move(part));
  return {first->text + "; " + second.text,
          text_of_item({{kCodeKey, kListCode}, {kArgumentsKey, std::move(parts)}})};
}

StoredWords set_aside_because(const StoredWords& reason) {
  return {"repeated by the experimenter: " + reason.text,
          text_of_item(
              {{kCodeKey, kTrialRepeatedCode}, {kArgumentsKey, Item::array({reason.item()})}})};
}

}  // namespace asperity

// Stores phrases by a code with arguments, and reads them again.

#include "app/words/coded_phrases.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/words/event_kinds.h"
#include "app/words/offered_reasons.h"

namespace asperity {

namespace {

using Item = nlohmann::ordered_json;

void add_parts(const Phrase& phrase, std::string_view list, Item& parts) {
  if (phrase.code() == nullptr || phrase.code() != list) {
    parts.push_back(json_of(phrase));
    return;
  }
  for (const Phrase& part : phrase.arguments()) add_parts(part, list, parts);
}

Phrase unknown_code(const std::string& code, const std::vector<Phrase>& arguments) {
  Phrase told{};
  for (const Phrase& argument : arguments) told = with_comma(told, argument);
  return told.empty() ? Phrase(code) : Phrase("%1 (%2)").with(code, told);
}

/// The member of an object, where it is a string.
std::string string_member(const Item& item, std::string_view key) {
  const auto found = item.find(key);
  return found != item.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

constexpr const char* kTyped = "typed";

void add_codes(const Item& item, std::vector<std::string>& codes) {
  if (is_stored_list(item)) {
    for (const Item& part : item.at(kArgumentsKey)) add_codes(part, codes);
    return;
  }
  std::string code = string_member(item, kCodeKey);
  if (code.empty()) code = item.contains(kEnglishKey) ? kEnglishKey : kTyped;
  codes.push_back(std::move(code));
}

std::string in_one_cell(const std::vector<std::string>& codes) {
  std::string all{};
  for (const std::string& code : codes) all += (all.empty() ? "" : "; ") + code;
  return all;
}

}  // namespace

nlohmann::ordered_json json_of(const Phrase& phrase) {
  if (phrase.is_verbatim()) return phrase.english();
  if (phrase.code() == nullptr) return {{kEnglishKey, phrase.english()}};
  Item arguments = Item::array();
  if (is_phrase_list(phrase)) {
    add_parts(phrase, phrase.code(), arguments);
  } else {
    for (const Phrase& argument : phrase.arguments()) arguments.push_back(json_of(argument));
  }
  Item item{{kCodeKey, phrase.code()}};
  if (!arguments.empty()) item[kArgumentsKey] = std::move(arguments);
  return item;
}

Phrase phrase_from(const Item& item) {
  if (item.is_string()) return item.get<std::string>();
  if (!item.is_object()) return item.dump();
  if (item.contains(kEnglishKey)) return string_member(item, kEnglishKey);
  std::vector<Phrase> arguments{};
  const auto stored_arguments = item.find(kArgumentsKey);
  if (stored_arguments != item.end()) {
    for (const Item& argument : *stored_arguments) {
      arguments.push_back(phrase_from(argument));
    }
  }
  const std::string code = string_member(item, kCodeKey);
  const auto known = coded_phrases().find(code);
  if (known == coded_phrases().end()) return unknown_code(code, arguments);
  if (!is_phrase_list(known->second)) return known->second.filled(std::move(arguments));
  Phrase all{};
  for (const Phrase& part : arguments) all = with_next(known->second, all, part);
  return all;
}

StoredWords stored(const Phrase& phrase) {
  return {phrase.english(), json_of(phrase).dump(-1, ' ', false, Item::error_handler_t::replace)};
}

Phrase phrase_of(const StoredWords& words) {
  const Item item = words.item();
  const bool is_readable =
      item.is_string() || !string_member(item, kCodeKey).empty() || item.contains(kEnglishKey);
  return is_readable ? phrase_from(item) : Phrase(words.text);
}

Phrase phrase_of(const std::optional<StoredWords>& words) {
  return words ? phrase_of(*words) : Phrase{};
}

Phrase phrase_of(const EventRow& event) {
  return event.text_json.empty() ? Phrase(event.text) : phrase_of(event.words());
}

EventRow event_row(std::int64_t time_ns, const std::string& kind, const Phrase& text,
                   const std::string& data_json) {
  const EventKind* const known = event_kind(kind);
  EventRow row{.time_ns = time_ns, .kind = kind, .text = text.english(), .data_json = data_json};
  if (known != nullptr && known->text_is_words) row.text_json = stored(text).json;
  return row;
}

std::string codes_of(const StoredWords& words) {
  std::vector<std::string> codes{};
  add_codes(words.item(), codes);
  return in_one_cell(codes);
}

std::string published_codes_of(const StoredWords& words) {
  static const std::vector<Phrase> kOffers = coded_offers();
  std::vector<std::string> codes{};
  add_codes(words.item(), codes);
  for (std::string& code : codes) {
    const bool is_offered =
        std::any_of(kOffers.begin(), kOffers.end(),
                    [&code](const Phrase& offer) { return offer.code() == code; });
    if (is_offered) code = kTyped;
  }
  return in_one_cell(codes);
}

}  // namespace asperity

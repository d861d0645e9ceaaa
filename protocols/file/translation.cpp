// Implements the translation of a protocol's texts by a second file.

#include "protocols/file/translation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/form_check.h"
#include "protocols/file/json_document.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/keys/valid_part.h"
#include "protocols/shapes/key.h"
#include "protocols/texts/translatable_texts.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr std::string_view kMore = "…";

constexpr std::array<KeyWord, 1> kFormats{{{"asperity.translation/1", 0, "this format"}}};
constexpr std::size_t kLongestAddress = 256;
constexpr ValueShape kText = TextShape{.longest = 20'000, .is_long = true};
constexpr ValueShape kTextsOfAddress = MapShape{.entry = &kText,
                                                .meaning = "The translation of a text.",
                                                .has_names = false,
                                                .longest_name = kLongestAddress,
                                                .shortest = 1};
constexpr std::array kKeys{
    ProtocolKey{.name = "format",
                .meaning = "The version of this format.",
                .shape = WordShape{kFormats},
                .is_required = true},
    ProtocolKey{.name = "texts",
                .meaning = "Translations, by the address of the text in the protocol.",
                .shape = MapShape{.entry = &kTextsOfAddress,
                                  .meaning = "Texts of one address with their translations.",
                                  .has_names = false,
                                  .longest_name = kLongestAddress},
                .is_required = true}};
constexpr KeyTable kTranslationTable{.meaning = "A translation of a protocol.", .keys = kKeys};

/// Whether an entry with these words translates the text.
bool translates(std::string_view words, std::string_view text) {
  if (!words.ends_with(kMore)) return words == text;
  return text.starts_with(words.substr(0, words.size() - kMore.size()));
}

/// The words with which an entry can state a text, and no other one of its address.
std::string first_words(const TranslatableText& meant, const std::vector<TranslatableText>& texts) {
  constexpr std::size_t kShort = 60;
  const std::string& text = meant.text;
  if (text.size() <= kShort) return text;
  const std::size_t limit = std::min(text.size(), kLongestAddress - kMore.size());
  for (const bool at_blank : {true, false}) {
    for (std::size_t end = kShort - 20; end < limit; ++end) {
      const auto next = static_cast<unsigned char>(text[end]);
      const bool is_in_character = (next & 0xC0U) == 0x80U;  // of UTF-8
      if (at_blank ? next != ' ' : is_in_character) continue;
      std::string words = text.substr(0, end) + std::string(kMore);
      if (std::none_of(texts.begin(), texts.end(), [&](const TranslatableText& other) {
            return other.address == meant.address && other.text != text &&
                   translates(words, other.text);
          })) {
        return words;
      }
    }
    if (text.size() <= kLongestAddress) break;
  }
  return text;
}

/// The places of texts that are replaced, and their characters.
struct Replacement {
  JsonPlace place{};
  std::string text{};
};

class Translator final {
 public:
  Translator(const JsonDocument& protocol, const JsonDocument& translation)
      : protocol_(protocol),
        translation_(translation),
        texts_(translatable_texts(protocol.root())) {}

  void translate_all() {
    for (const auto& [address, entries] : translation_.root().at("texts").items()) {
      if (is_comment(address)) continue;
      for (const auto& [words, text] : entries.items()) {
        if (!is_comment(words)) translate(address, words, text.get<std::string>());
      }
    }
    report_missing();
    sort_by_line(result.problems);
    sort_by_line(result.warnings);
  }

  void state_language(const std::string& language) {
    const std::string value = json(language).dump();
    if (const auto stated = protocol_.place_of("/language")) {
      replacements_.push_back({*stated, value});
    } else if (const auto name = protocol_.place_of("/name")) {
      replacements_.push_back({{name->end, name->end, name->end}, ", \"language\": " + value});
    }
  }

  /// The protocol with all replacements.
  std::string text() {
    std::sort(replacements_.begin(), replacements_.end(), [](const auto& one, const auto& other) {
      return one.place.value < other.place.value;
    });
    std::string made{};
    std::size_t copied = 0;
    for (const Replacement& each : replacements_) {
      made += protocol_.text().substr(copied, each.place.value - copied);
      made += each.text;
      copied = each.place.end;
    }
    made += protocol_.text().substr(copied);
    return made;
  }

  TranslatedProtocol result{};

 private:
  void problem_at_key(const std::string& pointer, Phrase message) {
    result.problems.push_back(translation_.at_key(pointer, std::move(message)));
  }

  void translate(const std::string& address, const std::string& words, const std::string& text) {
    const std::string place = pointer_to("/texts", address);
    const std::string entry = pointer_to(place, words);
    std::set<std::string> here{};
    std::set<std::string> meant{};
    for (const TranslatableText& each : texts_) {
      if (each.address != address) continue;
      here.insert(each.text);
      if (translates(words, each.text)) meant.insert(each.text);
    }
    if (here.contains(words)) meant = {words};  // the beginning of others, too
    if (here.empty()) {
      if (unknown_.insert(address).second) {
        const Phrase problem =
            phrase("Protocols",
                   "the protocol has no text for participants or readers at the address %1")
                .with(in_quotes(address));
        problem_at_key(place, with_guess(problem, address, addresses()));
      }
    } else if (meant.empty()) {
      problem_at_key(entry,
                     phrase("Protocols",
                            "the protocol has no text at this address that begins with these "
                            "words; it has %1: check the translation, and correct the words")
                         .with(joined_by_or(quoted({here.begin(), here.end()}))));
    } else if (meant.size() > 1 && !meant.contains(words)) {
      problem_at_key(entry,
                     phrase("Protocols",
                            "these words are the beginning of several texts at this address; "
                            "repeat more of the text"));
    } else {
      replace(address, meant.contains(words) ? words : *meant.begin(), text, entry);
    }
  }

  void replace(const std::string& address, const std::string& source, const std::string& text,
               const std::string& entry) {
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      const TranslatableText& each = texts_[i];
      if (each.address != address || each.text != source) continue;
      if (!done_.insert(i).second) {
        return problem_at_key(
            entry, phrase("Protocols", "another entry translates this text; remove one of them"));
      }
      if (text.find_first_not_of(" \n\t") == std::string::npos || text == kMore) {
        return result.problems.push_back(translation_.at(
            entry, phrase("Protocols", "this text has no translation yet; write it in place of %1")
                       .with(in_quotes(text))));
      }
      const std::vector<FormProblem> problems = valid_part(text, each.shape, "", entry).problems;
      if (!problems.empty()) {
        result.problems.push_back(translation_.at(entry, problems.front().message));
        continue;
      }
      const JsonPlace place = *protocol_.place_of(each.pointer);
      const std::string written = json(text).dump();
      const std::string before(protocol_.text().substr(place.value, place.end - place.value));
      replacements_.push_back(
          {place, each.shape.is_value ? R"({"value": )" + before + R"(, "text": )" + written + "}"
                                      : written});
    }
  }

  void report_missing() {
    std::set<std::pair<std::string, std::string>> reported{};
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      const TranslatableText& each = texts_[i];
      if (done_.contains(i) || !reported.emplace(each.address, each.text).second) continue;
      const json entry{{each.address, json{{first_words(each, texts_), "…"}}}};
      Diagnostic missing = translation_.at(
          "/texts",
          phrase("Protocols", "the text %1 has no translation; add %2")
              .with(in_quotes(each.text), entry.dump().substr(1, entry.dump().size() - 2)));
      const bool is_read = each.shape.translated == Translated::always;
      (is_read ? result.problems : result.warnings).push_back(std::move(missing));
    }
  }

  std::vector<std::string> addresses() const {
    std::set<std::string> all{};
    for (const TranslatableText& each : texts_) all.insert(each.address);
    return {all.begin(), all.end()};
  }

  const JsonDocument& protocol_;
  const JsonDocument& translation_;
  std::vector<TranslatableText> texts_{};
  std::set<std::size_t> done_{};     ///< texts with a translation, by their index
  std::set<std::string> unknown_{};  ///< addresses that were reported
  std::vector<Replacement> replacements_{};
};

bool has_format(std::string_view text, std::string_view format) {
  const json root = json::parse(text, nullptr, false);
  if (!root.is_object()) return false;
  const auto stated = root.find("format");
  return stated != root.end() && stated->is_string() &&
         stated->get_ref<const std::string&>().starts_with(format);
}

}  // namespace

bool is_translation(std::string_view text) { return has_format(text, "asperity.translation/"); }

bool is_protocol(std::string_view text) { return has_format(text, "asperity.protocol/"); }

TranslatedProtocol translated(std::string_view protocol, const std::string& file,
                              const TranslationFile& translation) {
  const JsonDocument source(protocol, file);
  try {
    const JsonDocument overlay(translation.text, translation.name);
    std::vector<Diagnostic> problems = check_form(overlay, kTranslationTable);
    if (!problems.empty()) return {.text = std::string(protocol), .problems = std::move(problems)};
    Translator translator(source, overlay);
    translator.translate_all();
    translator.state_language(translation.language);
    translator.result.text = translator.text();
    return std::move(translator.result);
  } catch (const ProtocolError& error) {  // the translation is not JSON
    return {.text = std::string(protocol), .problems = error.diagnostics()};
  }
}

}  // namespace asperity

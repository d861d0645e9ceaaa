// Implements the wording of diagnostics.

#include "protocols/design/wording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>

namespace asperity {

namespace {

/// The number of letters to insert, delete, replace or swap with a neighbour.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        rows[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = rows[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      rows[i][j] = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
      }
    }
  }
  return rows[a.size()][b.size()];
}

Phrase guessed(const Phrase& problem, const std::string& name) {
  return phrase("Protocols", "%1; did you mean %2?").with(problem, in_quotes(name));
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 60;
  if (text.size() <= kShown) return "\"" + std::string(text) + "\"";
  std::size_t end = kShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return "\"" + std::string(text.substr(0, end)) + "…\"";
}

std::string one_of(const std::vector<std::string>& names) {
  return joined_by_or(quoted(names)).english();
}

std::optional<std::string> nearest_name(std::string_view written,
                                        const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 64;
  if (written.size() > kLongest) return {};
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(written.size() / 3, 1) + 1;
  for (const std::string& name : names) {
    if (name.size() > kLongest) continue;
    const std::size_t found = distance(written, name);
    if (found < best_distance) {
      best_distance = found;
      best = &name;
    }
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

std::string did_you_mean(std::string_view written, const std::vector<std::string>& names) {
  const auto nearest = nearest_name(written, names);
  return nearest ? "; did you mean " + in_quotes(*nearest) + "?" : std::string{};
}

std::string digits(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

Phrase key_name(std::string_view key) { return {kNamesOfKeys, in_quotes(key).c_str()}; }

Phrase word_name(std::string_view word) { return {kWordsOfKeys, in_quotes(word).c_str()}; }

Phrase place_name(std::string_view pointer) {
  return {kPlacesOfKeys, std::string(pointer).c_str()};
}

Phrase phrase_of_key(std::string_view text) { return {kTextsOfKeys, std::string(text).c_str()}; }

Phrase with_json(const std::string& json) { return phrase("JsonOfFile", ", with %1").with(json); }

Phrase such_as_json(const std::string& json) {
  return phrase("JsonOfFile", ", such as %1").with(json);
}

std::vector<Phrase> quoted(const std::vector<std::string>& names) {
  std::vector<Phrase> all{};
  for (const std::string& name : names) all.emplace_back(in_quotes(name));
  return all;
}

std::vector<Phrase> key_names(const std::vector<std::string>& keys) {
  std::vector<Phrase> all{};
  for (const std::string& key : keys) all.push_back(key_name(key));
  return all;
}

Phrase with_guess(const Phrase& problem, std::string_view written,
                  const std::vector<std::string>& names) {
  const auto nearest = nearest_name(written, names);
  return nearest ? guessed(problem, *nearest) : problem;
}

Phrase with_declared_names(const Phrase& problem, const std::string& name,
                           const std::vector<std::string>& declared) {
  if (const auto nearest = nearest_name(name, declared)) return guessed(problem, *nearest);
  if (declared.empty()) {
    return phrase("Protocols", "%1; declare it, or remove the name").with(problem);
  }
  return phrase("Protocols", "%1; use %2").with(problem, joined_by_or(quoted(declared)));
}

Phrase unknown_name(std::string_view what, const std::string& name,
                    const std::vector<std::string>& declared) {
  // Whole sentences, since other languages have articles of different gender.
  static const std::map<std::string_view, Phrase> kSentences{
      {"block", phrase("Protocols", "there is no block %1")},
      {"body", phrase("Protocols", "there is no body %1")},
      {"exploration", phrase("Protocols", "there is no exploration %1")},
      {"factor", phrase("Protocols", "there is no factor %1")},
      {"force model", phrase("Protocols", "there is no force model %1")},
      {"group", phrase("Protocols", "there is no group %1")},
      {"numeric parameter", phrase("Protocols", "there is no numeric parameter %1")},
      {"parameter", phrase("Protocols", "there is no parameter %1")},
      {"question", phrase("Protocols", "there is no question %1")},
      {"role of an asset", phrase("Protocols", "there is no role of an asset %1")},
      {"stimulus", phrase("Protocols", "there is no stimulus %1")},
      {"texture", phrase("Protocols", "there is no texture %1")}};
  return with_declared_names(kSentences.at(what).with(in_quotes(name)), name, declared);
}

std::string listed_words(const std::vector<std::string>& words, std::string_view joint) {
  std::string text{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? joint : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace asperity

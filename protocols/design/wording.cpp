// Implements the wording of diagnostics.

#include "protocols/design/wording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

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

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 60;
  if (text.size() <= kShown) return "\"" + std::string(text) + "\"";
  std::size_t end = kShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return "\"" + std::string(text.substr(0, end)) + "…\"";
}

std::string one_of(const std::vector<std::string>& names) {
  std::string text{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += in_quotes(names[i]);
  }
  return names.empty() ? "nothing" : text;
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

std::string unknown_name(std::string_view what, const std::string& name,
                         const std::vector<std::string>& declared) {
  const std::string guess = did_you_mean(name, declared);
  return "there is no " + std::string(what) + " " + in_quotes(name) +
         (!guess.empty()     ? guess
          : declared.empty() ? "; none is declared: declare it, or remove the name"
                             : "; use " + one_of(declared));
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

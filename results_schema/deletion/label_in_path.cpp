// Whether the path of an output names a participant.

#include "results_schema/deletion/label_in_path.h"

#include <algorithm>
#include <cstddef>

namespace asperity {
namespace {

char small(char character) noexcept {
  return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a')
                                              : character;
}

bool is_same(char one, char other) noexcept { return small(one) == small(other); }

bool belongs_to_word(char character) noexcept {
  constexpr unsigned char kFirstBeyondAscii = 0x80;
  const char letter = small(character);
  return (letter >= 'a' && letter <= 'z') || (character >= '0' && character <= '9') ||
         static_cast<unsigned char>(character) >= kFirstBeyondAscii;
}

bool has_as_word(std::string_view name, std::string_view label) noexcept {
  auto from = name.begin();
  for (;;) {
    const auto at = std::search(from, name.end(), label.begin(), label.end(), &is_same);
    if (at == name.end()) return false;
    const auto end = at + static_cast<std::ptrdiff_t>(label.size());
    const bool begins = at == name.begin() || !belongs_to_word(*(at - 1));
    const bool ends = end == name.end() || !belongs_to_word(*end);
    if (begins && ends) return true;
    from = at + 1;
  }
}

}  // namespace

bool names_label(std::string_view path, std::string_view label) noexcept {
  if (label.empty()) return false;
  while (path.ends_with('/')) path.remove_suffix(1);
  for (;;) {
    const std::size_t slash = path.find('/');
    const std::string_view name = path.substr(0, slash);
    if (slash == std::string_view::npos) return has_as_word(name, label);
    if (std::equal(name.begin(), name.end(), label.begin(), label.end(), &is_same)) return true;
    path.remove_prefix(slash + 1);
  }
}

}  // namespace asperity

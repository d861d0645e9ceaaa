// Formats an argument of a command that is shown to the user.

#pragma once

#include <algorithm>
#include <string>

namespace asperity {

/// In shell syntax: with quotation marks where they are required ("falcon:usb 1-2", a folder with
/// blanks).
inline std::string shell_word(const std::string& word) {
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           std::string("/._-:+,=@%").find(c) != std::string::npos ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\' || c == '$' || c == '`') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace asperity

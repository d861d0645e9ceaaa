// An option that takes words of the user's own.

#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace asperity {

/// Refuses a text of blanks alone, naming what was to be entered; takes blanks at the ends away.
inline CLI::Validator not_blank(const std::string& what) {
  const auto read = [what](std::string& text) -> std::string {
    text = CLI::detail::trim_copy(text);
    return text.empty() ? "the text is blank: enter " + what + ", or leave the option out" : "";
  };
  return {read, ""};
}

/// The same where an empty text takes away what there is.
inline CLI::Validator empty_or_not_blank(const std::string& what) {
  const auto read = [refused = not_blank(what)](std::string& text) -> std::string {
    return text.empty() ? "" : refused(text);
  };
  return {read, ""};
}

}  // namespace asperity

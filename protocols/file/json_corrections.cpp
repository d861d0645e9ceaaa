// States what is wrong in a text that is no JSON, from what the parser expects and the characters around.

#include "protocols/file/json_corrections.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace asperity {

Phrase problem_of_text(std::string_view reason) {
  const auto has = [reason](std::string_view what) {
    return reason.find(what) != std::string_view::npos;
  };
  if (has("missing closing quote")) {
    return phrase("Protocols", "this text does not end; add the closing quotation mark");
  }
  if (has("U+000A") || has("U+000D")) {
    return phrase("Protocols",
                  "this text contains a line break; add the closing quotation mark on this line, "
                  "or write \\n for a line break");
  }
  constexpr std::string_view kControl = "control character ";
  if (const std::size_t at = reason.find(kControl); at != std::string_view::npos) {
    const std::string code(reason.substr(at + kControl.size() + 2, 4));  // of "U+0009 (HT)"
    return phrase("Protocols", "this text contains the control character %1; write %2 for it")
        .with("U+" + code, code == "0009" ? "\\t" : "\\u" + code);
  }
  if (has("backslash")) {
    return phrase("Protocols",
                  "there is no such character with a backslash; write \\\\ for a backslash");
  }
  if (has("hex digits")) {
    return phrase("Protocols",
                  "\\u must be followed by four hexadecimal digits; add them, or write \\\\ for a "
                  "backslash");
  }
  if (has("surrogate")) {
    return phrase("Protocols",
                  "this is half of a pair of \\u characters; write both, or the character itself");
  }
  return phrase("Protocols", "this text is invalid; correct it");
}

bool is_of_word(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '.' ||
         letter == '+' || letter == '-';
}

std::string_view token_at(std::string_view text, std::size_t from) {
  std::size_t end = from;
  while (end < text.size() && is_of_word(text[end])) ++end;
  return text.substr(from, std::max<std::size_t>(end - from, 1));
}

Phrase correction_at(std::string_view text, std::size_t from, std::string_view expected) {
  const std::size_t last =
      from == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", from - 1);
  const char before = last == std::string_view::npos ? '\0' : text[last];
  const char token = text[from];
  const auto expects = [expected](std::string_view what) {
    return expected.find(what) != std::string_view::npos;
  };
  if (token == '\'') {
    return phrase("Protocols", "write double quotation marks (\") instead of single ones");
  }
  if (token == '/' || token == '#') {
    return phrase("Protocols",
                  "JSON has no comments: delete it, or write it as the text of a key \"$comment\"");
  }
  if (expects("end of input")) {
    return phrase("Protocols",
                  "delete what follows the end of the protocol, or a closing bracket too many "
                  "before it");
  }
  const bool is_digit = std::isdigit(static_cast<unsigned char>(token)) != 0;
  if (is_digit && from > 1 && text[from - 1] == ',' &&
      std::isdigit(static_cast<unsigned char>(text[from - 2])) != 0) {
    return phrase("Protocols", "write a decimal point in place of the comma before it");
  }
  if (token == ',') {
    return before == ':' ? phrase("Protocols", "write a value after the colon")
                         : phrase("Protocols", "delete this comma");
  }
  if (token == '}' || token == ']') {
    if (before == ',') {
      return phrase("Protocols", "delete the comma before it: the last entry has none");
    }
    if (before == ':') return phrase("Protocols", "write a value after the colon");
    if (expects("']'")) return phrase("Protocols", "close the list with ']' before it");
    if (expects("'}'")) return phrase("Protocols", "close the object with '}' before it");
    return {};
  }
  if (token == ':') {
    return before == ':' ? phrase("Protocols", "delete this colon")
                         : phrase("Protocols",
                                  "a colon is permitted only between a key and its value: add a "
                                  "comma or a quotation mark before it");
  }
  if (expects("':'")) {
    return phrase("Protocols",
                  "write a colon between a key and its value, and close every quotation mark");
  }
  if (expects("quotation marks") && is_of_word(token)) {
    return phrase("Protocols", "write the key in \"quotation marks\"");
  }
  // "3x" is one word that is no number.
  const bool is_separate = !is_of_word(token) || last + 1 < from;
  const bool follows_a_value =
      is_separate && (before == '"' || before == '}' || before == ']' || is_of_word(before));
  if (follows_a_value && (expects("'}'") || expects("']'"))) {
    return phrase("Protocols", "add a comma after the entry before it, or close a quotation mark");
  }
  return {};
}

Phrase unexpected(std::string_view expected) {
  const auto expects = [expected](std::string_view what) {
    return expected.find(what) != std::string_view::npos;
  };
  if (expects("quotation marks")) {
    return phrase("Protocols", "unexpected %1; expected a key in \"quotation marks\"");
  }
  if (expects("literal")) return phrase("Protocols", "unexpected %1; expected a value");
  if (expects("'}'")) return phrase("Protocols", "unexpected %1; expected '}'");
  if (expects("']'")) return phrase("Protocols", "unexpected %1; expected ']'");
  return phrase("Protocols", "unexpected %1");
}

}  // namespace asperity

// Compares UTF-8 bytes with a table of characters, each with its name and its remedy.

#include "analysis/numbers/look_alikes.h"

#include <charconv>
#include <cstddef>
#include <system_error>

namespace asperity {
namespace {

constexpr std::string_view kSpace = "write a space instead";
constexpr std::string_view kNothing = "delete it";
constexpr std::string_view kQuotes = "write straight quotation marks (\") instead";
constexpr std::string_view kMinus = "write a hyphen (-) instead";
constexpr std::string_view kPoint = "write a decimal point instead";
constexpr std::string_view kComma = "write a comma (,) instead";

constexpr LookAlike kLookAlikes[] = {
    {"\xC2\xA0", "a no-break space (U+00A0)", kSpace},
    {"\xC2\xAD", "a soft hyphen (U+00AD)", kNothing},
    {"\xC2\xAB", "a typographic quotation mark (U+00AB)", kQuotes},
    {"\xC2\xBB", "a typographic quotation mark (U+00BB)", kQuotes},
    {"\xD8\x8C", "an Arabic comma (U+060C)", kComma},
    {"\xD9\xAB", "an Arabic decimal separator (U+066B)", kPoint},
    {"\xE2\x80\x87", "a figure space (U+2007)", kSpace},
    {"\xE2\x80\x89", "a thin space (U+2009)", kSpace},
    {"\xE2\x80\x8B", "a zero-width space (U+200B)", kNothing},
    {"\xE2\x80\x8C", "a zero-width non-joiner (U+200C)", kNothing},
    {"\xE2\x80\x8D", "a zero-width joiner (U+200D)", kNothing},
    {"\xE2\x80\x8E", "a left-to-right mark (U+200E)", kNothing},
    {"\xE2\x80\x8F", "a right-to-left mark (U+200F)", kNothing},
    {"\xE2\x80\x93", "an en dash (U+2013)", kMinus},
    {"\xE2\x80\x94", "an em dash (U+2014)", kMinus},
    {"\xE2\x80\x98", "a typographic quotation mark (U+2018)", kQuotes},
    {"\xE2\x80\x99", "a typographic quotation mark (U+2019)", kQuotes},
    {"\xE2\x80\x9A", "a typographic quotation mark (U+201A)", kQuotes},
    {"\xE2\x80\x9C", "a typographic quotation mark (U+201C)", kQuotes},
    {"\xE2\x80\x9D", "a typographic quotation mark (U+201D)", kQuotes},
    {"\xE2\x80\x9E", "a typographic quotation mark (U+201E)", kQuotes},
    {"\xE2\x80\xA8", "a line separator (U+2028)", kSpace},
    {"\xE2\x80\xAF", "a narrow no-break space (U+202F)", kSpace},
    {"\xE2\x81\xA0", "a word joiner (U+2060)", kNothing},
    {"\xE2\x88\x92", "a minus sign (U+2212)", kMinus},
    {"\xE3\x80\x80", "an ideographic space (U+3000)", kSpace},
    {kByteOrderMark, "a byte order mark (U+FEFF)", kNothing},
    {"\xEF\xBC\x8C", "a full-width comma (U+FF0C)", kComma},
    {"\xEF\xBC\x8E", "a full-width full stop (U+FF0E)", kPoint},
    {"\xEF\xBC\x9A", "a full-width colon (U+FF1A)", "write a colon (:) instead"},
};

}  // namespace

std::optional<LookAlike> look_alike_at(std::string_view text) {
  for (const LookAlike& each : kLookAlikes) {
    if (text.starts_with(each.bytes)) return each;
  }
  return std::nullopt;
}

std::optional<LookAlike> first_look_alike(std::string_view text) {
  for (; !text.empty(); text.remove_prefix(1)) {
    if (static_cast<unsigned char>(text.front()) < 0x80) continue;
    if (const auto found = look_alike_at(text)) return found;
  }
  return std::nullopt;
}

std::string number_correction(std::string_view cell) {
  if (const auto found = first_look_alike(cell)) {
    const std::string_view remedy = found->remedy == kSpace ? kNothing : found->remedy;
    return "with " + std::string(found->name) + "; " + std::string(remedy);
  }
  if (const std::size_t comma = cell.find(','); comma != std::string_view::npos) {
    std::string pointed(cell);
    pointed[comma] = '.';
    double number = 0.0;
    const char* const end = pointed.data() + pointed.size();
    const auto read = std::from_chars(pointed.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end) {
      return "with a decimal comma; write a decimal point";
    }
  }
  return "which is not a finite number; correct it";
}

}  // namespace asperity

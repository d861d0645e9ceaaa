// Compares UTF-8 bytes with a table of characters, each with its name and its remedy.

#include "analysis/numbers/look_alikes.h"

#include <charconv>
#include <cstddef>
#include <system_error>
#include <vector>

namespace asperity {
namespace {

Phrase space_instead() { return phrase("Characters", "write a space instead"); }
Phrase nothing_instead() { return phrase("Characters", "delete it"); }

LookAlike row(std::string_view bytes, const char* code_point, const Phrase& name,
              const Phrase& correction) {
  return {bytes, Phrase("%1 (U+%2)").with(name, code_point), correction};
}

std::vector<LookAlike> look_alikes() {
  const Phrase space = space_instead();
  const Phrase nothing = nothing_instead();
  const Phrase quotation_mark = phrase("Characters", "a typographic quotation mark");
  const Phrase quotes = phrase("Characters", "write straight quotation marks (\") instead");
  const Phrase hyphen = phrase("Characters", "write a hyphen (-) instead");
  const Phrase point = phrase("Characters", "write a decimal point instead");
  const Phrase comma = phrase("Characters", "write a comma (,) instead");
  return {
      row("\xC2\xA0", "00A0", phrase("Characters", "a no-break space"), space),
      row("\xC2\xAD", "00AD", phrase("Characters", "a soft hyphen"), nothing),
      row("\xC2\xAB", "00AB", quotation_mark, quotes),
      row("\xC2\xBB", "00BB", quotation_mark, quotes),
      row("\xD8\x8C", "060C", phrase("Characters", "an Arabic comma"), comma),
      row("\xD9\xAB", "066B", phrase("Characters", "an Arabic decimal separator"), point),
      row("\xE2\x80\x87", "2007", phrase("Characters", "a figure space"), space),
      row("\xE2\x80\x89", "2009", phrase("Characters", "a thin space"), space),
      row("\xE2\x80\x8B", "200B", phrase("Characters", "a zero-width space"), nothing),
      row("\xE2\x80\x8C", "200C", phrase("Characters", "a zero-width non-joiner"), nothing),
      row("\xE2\x80\x8D", "200D", phrase("Characters", "a zero-width joiner"), nothing),
      row("\xE2\x80\x8E", "200E", phrase("Characters", "a left-to-right mark"), nothing),
      row("\xE2\x80\x8F", "200F", phrase("Characters", "a right-to-left mark"), nothing),
      row("\xE2\x80\x93", "2013", phrase("Characters", "an en dash"), hyphen),
      row("\xE2\x80\x94", "2014", phrase("Characters", "an em dash"), hyphen),
      row("\xE2\x80\x98", "2018", quotation_mark, quotes),
      row("\xE2\x80\x99", "2019", quotation_mark, quotes),
      row("\xE2\x80\x9A", "201A", quotation_mark, quotes),
      row("\xE2\x80\x9C", "201C", quotation_mark, quotes),
      row("\xE2\x80\x9D", "201D", quotation_mark, quotes),
      row("\xE2\x80\x9E", "201E", quotation_mark, quotes),
      row("\xE2\x80\xA8", "2028", phrase("Characters", "a line separator"), space),
      row("\xE2\x80\xAF", "202F", phrase("Characters", "a narrow no-break space"), space),
      row("\xE2\x81\xA0", "2060", phrase("Characters", "a word joiner"), nothing),
      row("\xE2\x88\x92", "2212", phrase("Characters", "a minus sign"), hyphen),
      row("\xE3\x80\x80", "3000", phrase("Characters", "an ideographic space"), space),
      row(kByteOrderMark, "FEFF", phrase("Characters", "a byte order mark"), nothing),
      row("\xEF\xBC\x8C", "FF0C", phrase("Characters", "a full-width comma"), comma),
      row("\xEF\xBC\x8E", "FF0E", phrase("Characters", "a full-width full stop"), point),
      row("\xEF\xBC\x9A", "FF1A", phrase("Characters", "a full-width colon"),
          phrase("Characters", "write a colon (:) instead")),
  };
}

}  // namespace

std::optional<LookAlike> look_alike_at(std::string_view text) {
  static const std::vector<LookAlike> kLookAlikes = look_alikes();
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
    const bool is_space = found->correction == space_instead();
    return "with " + found->character.english() + "; " +
           (is_space ? nothing_instead() : found->correction).english();
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

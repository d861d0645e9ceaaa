// JSON while it is being written: tokens, places and brackets of a text that may be broken.

#pragma once

#include <optional>
#include <vector>

#include <QtCore/QString>
#include <QtCore/QStringList>

namespace asperity {

// All positions are in UTF-16 units, as Qt's texts count. Nothing here judges: what is right is
// said by `read_protocol`.

struct JsonToken {
  enum class Kind {
    key,     ///< a string that a colon follows on its line
    string,  ///< another one; without its second quotation mark it reaches to the line's end
    number,
    word,  ///< true, false, null, and what is none of these
    mark,  ///< one of { } [ ] : ,
  };
  Kind kind = Kind::mark;
  qsizetype start = 0;
  qsizetype length = 0;

  qsizetype end() const noexcept { return start + length; }
};

/// No token reaches over the end of a line, so that lines can be taken one by one.
std::vector<JsonToken> json_tokens(QStringView text);

/// The keys and indices that lead to what stands at `position`, outermost first. On a key or its
/// value, the last one is that key.
QStringList json_place(QStringView text, qsizetype position);

/// Where a range of the text is.
struct TextRange {
  qsizetype start = 0;
  qsizetype length = 0;
};

/// The string that is the value of a key of the outermost object, with its quotation marks.
std::optional<TextRange> string_of_key(QStringView text, QStringView key);

/// A bracket at `position`, and the one that belongs to it.
struct BracketPair {
  qsizetype at = 0;
  std::optional<qsizetype> other{};  ///< nothing: it has none
};
/// Of the bracket before or else after the cursor; nothing when there is none.
std::optional<BracketPair> bracket_pair(QStringView text, qsizetype cursor);

/// Where a diagnostic's line and column are: both from 1, columns in characters (code points), as
/// protocols/ counts. Beyond the end: the end.
qsizetype position_of(QStringView text, int line, int column);

/// What to underline for a problem at `position`: the token there, or the nearest one before it.
/// Empty only in an empty text.
TextRange range_to_underline(QStringView text, qsizetype position);

}  // namespace asperity

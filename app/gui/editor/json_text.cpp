// Scans the text for tokens without a parser, so that incomplete JSON has places and brackets too.

#include "app/gui/editor/json_text.h"

#include <algorithm>

namespace asperity {

namespace {

bool is_space(QChar c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_mark(QChar c) { return QStringView(u"{}[]:,").contains(c); }

bool is_opening(QChar c) { return c == '{' || c == '['; }

bool is_closing(QChar c) { return c == '}' || c == ']'; }

/// Behind the second quotation mark, or the end of the line where there is none.
qsizetype end_of_string(QStringView text, qsizetype start) {
  for (qsizetype at = start + 1; at < text.size(); ++at) {
    if (text[at] == '\n') return at;
    if (text[at] == '"') return at + 1;
    if (text[at] == '\\' && at + 1 < text.size() && text[at + 1] != '\n') ++at;
  }
  return text.size();
}

bool colon_follows(QStringView text, qsizetype at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
  return at < text.size() && text[at] == ':';
}

JsonToken token_at(QStringView text, qsizetype start) {
  const QChar first = text[start];
  if (first == '"') {
    const qsizetype end = end_of_string(text, start);
    return {colon_follows(text, end) ? JsonToken::Kind::key : JsonToken::Kind::string, start,
            end - start};
  }
  if (is_mark(first)) return {JsonToken::Kind::mark, start, 1};
  qsizetype end = start + 1;
  while (end < text.size() && !is_space(text[end]) && !is_mark(text[end]) && text[end] != '"') {
    ++end;
  }
  const bool number = first == '-' || (first >= '0' && first <= '9');
  return {number ? JsonToken::Kind::number : JsonToken::Kind::word, start, end - start};
}

/// The text of a key, without its quotation marks. Names of the format have no escapes.
QString key_text(QStringView text, const JsonToken& token) {
  return text.mid(token.start + 1, std::max<qsizetype>(token.length - 2, 0)).toString();
}

/// What is open around a position.
struct OpenValue {
  bool is_object = true;
  QString key{};        ///< the last one in an object
  qsizetype index = 0;  ///< in an array
};

}  // namespace

std::vector<JsonToken> json_tokens(QStringView text) {
  std::vector<JsonToken> tokens{};
  for (qsizetype at = 0; at < text.size();) {
    if (is_space(text[at])) {
      ++at;
      continue;
    }
    tokens.push_back(token_at(text, at));
    at = tokens.back().end();
  }
  return tokens;
}

QStringList json_place(QStringView text, qsizetype position) {
  std::vector<OpenValue> levels{};
  for (const JsonToken& token : json_tokens(text)) {
    if (token.start > position) break;
    const QChar first = text[token.start];
    if (token.kind == JsonToken::Kind::key && !levels.empty()) {
      levels.back().key = key_text(text, token);
    } else if (token.kind == JsonToken::Kind::mark && token.end() <= position) {
      if (is_opening(first)) {
        levels.push_back({first == '{', {}, 0});
      } else if (is_closing(first)) {
        if (!levels.empty()) levels.pop_back();
      } else if (first == ',' && !levels.empty()) {
        levels.back().key.clear();
        ++levels.back().index;
      }
    }
  }
  QStringList place{};
  for (const OpenValue& level : levels) {
    if (!level.is_object) {
      place.append(QString::number(level.index));
    } else if (!level.key.isEmpty()) {
      place.append(level.key);
    }
  }
  return place;
}

std::optional<TextRange> string_of_key(QStringView text, QStringView key) {
  int depth = 0;
  bool is_next = false;
  for (const JsonToken& token : json_tokens(text)) {
    const QChar first = text[token.start];
    if (token.kind == JsonToken::Kind::key) {
      is_next = depth == 1 && key_text(text, token) == key;
    } else if (token.kind == JsonToken::Kind::string && is_next) {
      return TextRange{token.start, token.length};
    } else if (is_opening(first)) {
      ++depth;
    } else if (is_closing(first)) {
      --depth;
    }
  }
  return {};
}

std::optional<BracketPair> bracket_pair(QStringView text, qsizetype cursor) {
  const std::vector<JsonToken> tokens = json_tokens(text);
  const auto bracket_at = [&](qsizetype position) {
    return std::find_if(tokens.begin(), tokens.end(), [&](const JsonToken& token) {
      return token.kind == JsonToken::Kind::mark && token.start == position &&
             (is_opening(text[position]) || is_closing(text[position]));
    });
  };
  auto found = bracket_at(cursor - 1);
  if (found == tokens.end()) found = bracket_at(cursor);
  if (found == tokens.end()) return {};
  BracketPair pair{found->start, {}};
  const bool forwards = is_opening(text[found->start]);
  std::vector<QChar> open{};
  const auto end = forwards ? tokens.end() - found : found - tokens.begin() + 1;
  for (std::ptrdiff_t i = 0; i < end; ++i) {
    const JsonToken& token = *(forwards ? found + i : found - i);
    const QChar c = text[token.start];
    if (token.kind != JsonToken::Kind::mark || (!is_opening(c) && !is_closing(c))) continue;
    if (is_opening(c) == forwards) {
      open.push_back(c);
      continue;
    }
    const QChar opened = open.back();
    open.pop_back();
    if (!open.empty()) continue;
    const bool curly = opened == '{' || opened == '}';
    if (curly == (c == '{' || c == '}')) pair.other = token.start;
    break;
  }
  return pair;
}

qsizetype position_of(QStringView text, int line, int column) {
  qsizetype at = 0;
  for (int passed = 1; passed < line; ++passed) {
    const qsizetype end = text.indexOf('\n', at);
    if (end < 0) return text.size();
    at = end + 1;
  }
  for (int passed = 1; passed < column && at < text.size() && text[at] != '\n'; ++passed) {
    const bool pair = text[at].isHighSurrogate() && at + 1 < text.size();
    at += pair ? 2 : 1;
  }
  return at;
}

TextRange range_to_underline(QStringView text, qsizetype position) {
  const JsonToken* before = nullptr;
  const std::vector<JsonToken> tokens = json_tokens(text);
  for (const JsonToken& token : tokens) {
    if (token.start > position) break;
    before = &token;
  }
  if (before == nullptr) return {0, std::min<qsizetype>(text.size(), 1)};
  // Of an object or a list its key is seen, and its first bracket hardly.
  const bool begins = before->start == position && (text[position] == '{' || text[position] == '[');
  const auto index = before - tokens.data();
  if (begins && index >= 2 && text[before[-1].start] == ':' &&
      before[-2].kind == JsonToken::Kind::key) {
    before -= 2;
  }
  return {before->start, before->length};
}

}  // namespace asperity

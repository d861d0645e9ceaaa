// Highlights each line by its JSON tokens, in the colours of the theme.

#include "app/gui/editor/json_colors.h"

namespace asperity {

QColor json_color(JsonToken::Kind kind, const Theme& theme) {
  switch (kind) {
    case JsonToken::Kind::key:
      return theme.text;
    case JsonToken::Kind::string:
      return QColor(theme.dark ? "#6FD3C7" : "#0B6158");  // teal
    case JsonToken::Kind::number:
      return QColor(theme.dark ? "#D2A8FF" : "#7A3E9D");  // violet
    case JsonToken::Kind::word:
      return QColor(theme.dark ? "#FF9BCB" : "#A0285E");  // raspberry
    case JsonToken::Kind::mark:
      break;
  }
  return theme.muted;
}

void JsonColors::highlightBlock(const QString& line) {
  for (const JsonToken& token : json_tokens(line)) {
    QTextCharFormat format{};
    format.setForeground(json_color(token.kind, theme()));
    if (token.kind == JsonToken::Kind::key) format.setFontWeight(QFont::Bold);
    setFormat(static_cast<int>(token.start), static_cast<int>(token.length), format);
  }
}

}  // namespace asperity

#include "moc_json_colors.cpp"

// Colours of JSON.

#pragma once

#include <QtGui/QColor>
#include <QtGui/QSyntaxHighlighter>

#include "app/gui/editor/json_text.h"
#include "app/gui/look/theme.h"

namespace asperity {

/// On `panel` and `ground` of the theme with a contrast of 4.5 : 1 or more. None is the blue,
/// green, amber or red that mean something elsewhere.
QColor json_color(JsonToken::Kind kind, const Theme& theme);

/// In the theme of when it was made.
class JsonColors final : public QSyntaxHighlighter {
  Q_OBJECT
 public:
  explicit JsonColors(QTextDocument* document) : QSyntaxHighlighter(document) {}

 protected:
  void highlightBlock(const QString& line) override;
};

}  // namespace asperity

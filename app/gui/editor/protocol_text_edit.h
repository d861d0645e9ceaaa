// The text of a protocol: line numbers, marked problems, matched brackets.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtGui/QTextDocument>
#include <QtWidgets/QPlainTextEdit>

#include "app/gui/editor/json_text.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Tab indents by two spaces, Shift+Tab takes them back; Ctrl+Tab leaves the field. Long lines are
/// wrapped; a line keeps its number.
class ProtocolTextEdit final : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit ProtocolTextEdit(QWidget* parent = nullptr);

  /// Every character as it stands there, lines ended by '\n'. (`toPlainText` makes plain spaces of
  /// no-break spaces.)
  QString text() const;
  /// In place of everything, as one step that can be undone.
  void replace_text(const QString& text);
  /// Whether undo takes a change back by itself, or together with the one before it.
  enum class Step { another, same };
  void replace(TextRange range, const QString& text, Step step = Step::another);

  /// The text with its undo and whether it is modified, for another field. This one is empty then.
  std::unique_ptr<QTextDocument> take_document();
  void set_document(std::unique_ptr<QTextDocument> document);

  /// Underlines every problem and every warning and marks its line. The marks move with the text.
  void show_problems(const std::vector<Diagnostic>& problems,
                     const std::vector<Diagnostic>& warnings);
  /// What is underlined, in the order of the problems and then of the warnings.
  const QList<QTextEdit::ExtraSelection>& underlined() const noexcept { return underlines_; }
  /// What is said of the problems at a position, a line each; empty where there is none.
  QString problems_at(int position) const;
  /// The cursor goes there, in sight, with the focus.
  void go_to(int position);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Numbers;

  void add_underlines(const std::vector<Diagnostic>& places, const QColor& color);
  int width_of_numbers() const;
  void paint_numbers(QWidget& numbers);
  void make_room_for_numbers();
  void show_marks();
  void indent_lines(int steps);
  void begin_line();

  Numbers* numbers_ = nullptr;
  QList<QTextEdit::ExtraSelection> underlines_{};
  std::vector<QString> sentences_{};  ///< of the underlines
};

}  // namespace asperity

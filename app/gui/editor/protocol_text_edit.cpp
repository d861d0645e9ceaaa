// Paints line numbers and problems in a margin, underlines problems, and indents JSON while it is typed.

#include "app/gui/editor/protocol_text_edit.h"

#include <algorithm>
#include <map>

#include <QtGui/QHelpEvent>
#include <QtGui/QPainter>
#include <QtGui/QTextBlock>
#include <QtWidgets/QToolTip>

#include "app/gui/editor/json_colors.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr int kIndent = 2;

QString spaces(qsizetype count) { return QString(count, ' '); }

qsizetype indent_of(const QString& line) {
  const auto first =
      std::find_if(line.begin(), line.end(), [](QChar c) { return c != ' ' && c != '\t'; });
  return first - line.begin();
}

}  // namespace

/// Beside the text: the number of every line, and the shape of a problem where one is.
class ProtocolTextEdit::Numbers final : public QWidget {
 public:
  explicit Numbers(ProtocolTextEdit& edit) : QWidget(&edit), edit_(edit) {}
  QSize sizeHint() const override { return {edit_.width_of_numbers(), 0}; }

 protected:
  void paintEvent(QPaintEvent*) override { edit_.paint_numbers(*this); }

 private:
  ProtocolTextEdit& edit_;
};

ProtocolTextEdit::ProtocolTextEdit(QWidget* parent)
    : QPlainTextEdit(parent), numbers_(new Numbers(*this)) {
  setFont(number_font(TextSize::small));
  // The application's style sheet would set another.
  setStyleSheet(QString("QPlainTextEdit { padding: 0px; font-family: \"%1\"; font-size: %2pt; }")
                    .arg(font().family())
                    .arg(static_cast<int>(TextSize::small)));
  setLineWrapMode(QPlainTextEdit::WidgetWidth);
  setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  new JsonColors(document());
  connect(this, &QPlainTextEdit::blockCountChanged, this, &ProtocolTextEdit::make_room_for_numbers);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& area, int dy) {
    if (dy != 0) {
      numbers_->scroll(0, dy);
    } else {
      numbers_->update(0, area.y(), numbers_->width(), area.height());
    }
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &ProtocolTextEdit::show_marks);
  make_room_for_numbers();
  show_marks();
}

QString ProtocolTextEdit::text() const { return text_of(*document()); }

void ProtocolTextEdit::replace_text(const QString& text) {
  replace({0, document()->characterCount() - 1}, text);
}

void ProtocolTextEdit::replace(TextRange range, const QString& text, Step step) {
  QTextCursor cursor(document());
  if (step == Step::same) {
    cursor.joinPreviousEditBlock();
  } else {
    cursor.beginEditBlock();
  }
  cursor.setPosition(static_cast<int>(range.start));
  cursor.setPosition(static_cast<int>(range.start + range.length), QTextCursor::KeepAnchor);
  cursor.insertText(text);
  cursor.endEditBlock();
}

std::unique_ptr<QTextDocument> ProtocolTextEdit::take_document() {
  show_problems({}, {});  // their places are in it
  std::unique_ptr<QTextDocument> taken(document());
  taken->setParent(nullptr);
  setDocument(nullptr);
  return taken;
}

void ProtocolTextEdit::set_document(std::unique_ptr<QTextDocument> document) {
  QTextDocument* given = document.release();
  given->setParent(this);
  given->setDocumentLayout(new QPlainTextDocumentLayout(given));  // the old one knows its field
  setDocument(given);
  delete given->findChild<JsonColors*>();  // of the theme before
  new JsonColors(given);
  make_room_for_numbers();
}

void ProtocolTextEdit::show_problems(const std::vector<Diagnostic>& problems,
                                     const std::vector<Diagnostic>& warnings) {
  underlines_.clear();
  sentences_.clear();
  add_underlines(problems, theme().stop);
  add_underlines(warnings, theme().look);
  show_marks();
  numbers_->update();
}

void ProtocolTextEdit::add_underlines(const std::vector<Diagnostic>& places, const QColor& color) {
  const QString whole = text();
  for (const Diagnostic& problem : places) {
    const TextRange range =
        range_to_underline(whole, position_of(whole, problem.line, problem.column));
    QTextEdit::ExtraSelection underline{};
    underline.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    underline.format.setUnderlineColor(color);
    underline.cursor = QTextCursor(document());
    underline.cursor.setPosition(static_cast<int>(range.start));
    underline.cursor.setPosition(static_cast<int>(range.start + range.length),
                                 QTextCursor::KeepAnchor);
    underlines_.append(underline);
    sentences_.push_back(QString::fromStdString(problem.message.translated(language_of_windows())));
  }
}

QString ProtocolTextEdit::problems_at(int position) const {
  QStringList said{};
  for (qsizetype i = 0; i < underlines_.size(); ++i) {
    const QTextCursor& place = underlines_[i].cursor;
    if (place.selectionStart() <= position && position < place.selectionEnd()) {
      said.append(sentences_[static_cast<std::size_t>(i)]);
    }
  }
  return said.join('\n');
}

void ProtocolTextEdit::go_to(int position) {
  QTextCursor cursor = textCursor();
  cursor.setPosition(std::clamp(position, 0, document()->characterCount() - 1));
  setTextCursor(cursor);
  centerCursor();
  setFocus();
}

void ProtocolTextEdit::show_marks() {
  QList<QTextEdit::ExtraSelection> marks{};
  QTextEdit::ExtraSelection line{};
  line.format.setBackground(theme().ground);
  line.format.setProperty(QTextFormat::FullWidthSelection, true);
  line.cursor = textCursor();
  line.cursor.clearSelection();
  marks.append(line);
  const QString whole = text();
  if (const auto pair = bracket_pair(whole, textCursor().position())) {
    const auto mark = [&](qsizetype at) {
      QTextEdit::ExtraSelection bracket{};
      bracket.format.setBackground(theme().raised);
      bracket.format.setForeground(pair->other ? theme().text : theme().stop);
      bracket.format.setFontWeight(QFont::Bold);
      bracket.cursor = QTextCursor(document());
      bracket.cursor.setPosition(static_cast<int>(at));
      bracket.cursor.setPosition(static_cast<int>(at) + 1, QTextCursor::KeepAnchor);
      marks.append(bracket);
    };
    mark(pair->at);
    if (pair->other) mark(*pair->other);
  }
  setExtraSelections(marks + underlines_);
}

bool ProtocolTextEdit::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QPoint point = viewport()->mapFrom(this, help->pos());
    // As rich text it is wrapped.
    const QString said = problems_at(cursorForPosition(point).position());
    if (said.isEmpty()) {
      QToolTip::hideText();
    } else {
      QToolTip::showText(help->globalPos(),
                         "<p>" + said.toHtmlEscaped().replace('\n', "</p><p>") + "</p>", this);
    }
    return true;
  }
  return QPlainTextEdit::event(event);
}

void ProtocolTextEdit::keyPressEvent(QKeyEvent* event) {
  const bool control = event->modifiers().testFlag(Qt::ControlModifier);
  const bool is_tab = event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab;
  if (is_tab && control) {
    focusNextPrevChild(event->key() == Qt::Key_Tab);
  } else if (isReadOnly()) {
    QPlainTextEdit::keyPressEvent(event);
  } else if (event->key() == Qt::Key_Backtab) {
    indent_lines(-1);
  } else if (event->key() == Qt::Key_Tab) {
    if (textCursor().hasSelection()) {
      indent_lines(1);
    } else {
      textCursor().insertText(spaces(kIndent));
    }
  } else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && !control) {
    begin_line();
  } else {
    QPlainTextEdit::keyPressEvent(event);
  }
}

void ProtocolTextEdit::indent_lines(int steps) {
  QTextCursor cursor = textCursor();
  const QTextBlock last = document()->findBlock(cursor.selectionEnd());
  cursor.beginEditBlock();
  for (QTextBlock line = document()->findBlock(cursor.selectionStart()); line.isValid();
       line = line.next()) {
    QTextCursor start(line);
    if (steps > 0) {
      start.insertText(spaces(kIndent));
    } else {
      const auto taken = std::min<qsizetype>(indent_of(line.text()), kIndent);
      start.movePosition(QTextCursor::Right, QTextCursor::KeepAnchor, static_cast<int>(taken));
      start.removeSelectedText();
    }
    if (line == last) break;
  }
  cursor.endEditBlock();
}

void ProtocolTextEdit::begin_line() {
  QTextCursor cursor = textCursor();
  const QString before = cursor.block().text().left(cursor.positionInBlock());
  QString indent = before.left(indent_of(before));
  const QString trimmed = before.trimmed();
  if (trimmed.endsWith('{') || trimmed.endsWith('[')) indent += spaces(kIndent);
  cursor.insertText('\n' + indent);
  setTextCursor(cursor);
  ensureCursorVisible();
}

void ProtocolTextEdit::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  const QRect area = contentsRect();
  numbers_->setGeometry(area.left(), area.top(), width_of_numbers(), area.height());
}

int ProtocolTextEdit::width_of_numbers() const {
  const auto digits = std::max<qsizetype>(3, QString::number(blockCount()).size());
  return fontMetrics().horizontalAdvance('9') * static_cast<int>(digits + 2) + 2 * kGrid;
}

void ProtocolTextEdit::make_room_for_numbers() {
  setViewportMargins(width_of_numbers() + kGrid / 2, 0, 0, 0);
  const QRect area = contentsRect();
  numbers_->setGeometry(area.left(), area.top(), width_of_numbers(), area.height());
}

void ProtocolTextEdit::paint_numbers(QWidget& numbers) {
  std::map<int, QColor> with_problem{};  // problems come before warnings
  for (const QTextEdit::ExtraSelection& underline : underlines_) {
    with_problem.emplace(document()->findBlock(underline.cursor.selectionStart()).blockNumber(),
                         underline.format.underlineColor());
  }
  QPainter painter(&numbers);
  painter.fillRect(numbers.rect(), theme().raised);
  const int right = numbers.width() - kGrid;
  QTextBlock line = firstVisibleBlock();
  for (; line.isValid(); line = line.next()) {
    const QRectF area = blockBoundingGeometry(line).translated(contentOffset());
    if (area.top() > numbers.height()) break;
    if (!line.isVisible()) continue;
    const int number = line.blockNumber();
    const bool problem = with_problem.contains(number);
    const bool current = number == textCursor().blockNumber();
    QFont letters = font();
    letters.setBold(problem || current);
    painter.setFont(letters);
    const QRectF row(0.0, area.top(), right, fontMetrics().lineSpacing());
    if (problem) {
      const QColor color = with_problem.at(number);
      painter.setPen(color);
      painter.drawText(row.adjusted(kGrid / 2, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                       shape_of(color == theme().stop ? State::stop : State::look));
    } else {
      painter.setPen(current ? theme().text : theme().muted);
    }
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, QString::number(number + 1));
  }
}

}  // namespace asperity

#include "moc_protocol_text_edit.cpp"

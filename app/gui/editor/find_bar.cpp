// Searches forwards and backwards from the cursor, and states the number of matches.

#include "app/gui/editor/find_bar.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPlainTextEdit>

#include "app/gui/look/controls.h"

namespace asperity {

FindBar::FindBar(QPlainTextEdit& text, QWidget* parent) : QWidget(parent), text_(text) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  words_ = new QLineEdit(this);
  words_->setObjectName("find_words");
  words_->setPlaceholderText(tr("Find in the text"));
  words_->setClearButtonEnabled(true);
  count_ = make_text({}, this, true);
  count_->setObjectName("find_count");
  count_->setWordWrap(false);
  count_->setMinimumWidth(96);
  QPushButton* previous = make_button(tr("Previous"), ButtonRole::plain, this);
  previous->setObjectName("find_previous");
  QPushButton* next = make_button(tr("Next"), ButtonRole::plain, this);
  next->setObjectName("find_next");
  QPushButton* close = make_button(tr("Close"), ButtonRole::link, this);
  layout->addWidget(words_, 1);
  layout->addWidget(count_);
  layout->addWidget(previous);
  layout->addWidget(next);
  layout->addWidget(close);
  // What is typed is found from where the last hit began, so that it grows in place.
  connect(words_, &QLineEdit::textChanged, this,
          [this] { find_from(text_.textCursor().selectionStart(), Direction::forwards); });
  connect(previous, &QPushButton::clicked, this, [this] { find(Direction::backwards); });
  connect(next, &QPushButton::clicked, this, [this] { find(Direction::forwards); });
  connect(close, &QPushButton::clicked, this, [this] {
    hide();
    text_.setFocus();
  });
  connect(&text_, &QPlainTextEdit::textChanged, this, [this] {
    if (isVisible()) say_how_many();
  });
  hide();
}

void FindBar::begin() {
  const QString selected = text_.textCursor().selectedText();
  show();
  if (!selected.isEmpty() && !selected.contains(QChar::ParagraphSeparator)) {
    words_->setText(selected);
  }
  words_->selectAll();
  words_->setFocus();
  say_how_many();
}

void FindBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    hide();
    text_.setFocus();
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    find(event->modifiers().testFlag(Qt::ShiftModifier) ? Direction::backwards
                                                        : Direction::forwards);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void FindBar::find(Direction direction) {
  const QTextCursor cursor = text_.textCursor();
  find_from(direction == Direction::forwards ? cursor.selectionEnd() : cursor.selectionStart(),
            direction);
}

void FindBar::find_from(int position, Direction direction) {
  say_how_many();
  if (words_->text().isEmpty()) return;
  const QTextDocument& document = *text_.document();
  const bool back = direction == Direction::backwards;
  const QTextDocument::FindFlags flags =
      back ? QTextDocument::FindBackward : QTextDocument::FindFlags{};
  QTextCursor hit = document.find(words_->text(), position, flags);
  if (hit.isNull()) {  // once around
    hit = document.find(words_->text(), back ? document.characterCount() - 1 : 0, flags);
  }
  if (hit.isNull()) return;
  text_.setTextCursor(hit);
  text_.ensureCursorVisible();
}

void FindBar::say_how_many() {
  const QString words = words_->text();
  if (words.isEmpty()) {
    count_->clear();
    return;
  }
  const auto hits = text_.document()->toRawText().count(words, Qt::CaseInsensitive);
  count_->setText(hits == 0   ? tr("not found")
                  : hits == 1 ? tr("1 match")
                              : tr("%1 matches").arg(hits));
}

}  // namespace asperity

#include "moc_find_bar.cpp"

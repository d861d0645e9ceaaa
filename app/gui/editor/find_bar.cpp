// Searches forwards and backwards, in the text from the cursor and in the form from the last match, and states the number of
// matches.

#include "app/gui/editor/find_bar.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPlainTextEdit>

#include "app/gui/editor/form/protocol_form.h"
#include "app/gui/look/controls.h"

namespace asperity {

namespace {

QString count_of(qsizetype matches) {
  return matches == 0   ? FindBar::tr("no match")
         : matches == 1 ? FindBar::tr("1 match")
                        : FindBar::tr("%1 matches").arg(matches);
}

}  // namespace

FindBar::FindBar(QPlainTextEdit& text, ProtocolForm& form, QWidget* parent)
    : QWidget(parent), text_(text), form_(form) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  words_ = new QLineEdit(this);
  words_->setObjectName("find_words");
  words_->setClearButtonEnabled(true);
  count_ = make_text({}, this, true);
  count_->setObjectName("find_count");
  count_->setWordWrap(false);
  count_->setMinimumWidth(96);
  layout->addWidget(words_, 1);
  layout->addWidget(count_);
  const auto add = [&](const QString& verb, const char* name, int key, Direction direction) {
    QPushButton* button = make_button(verb, ButtonRole::plain, this);
    button->setObjectName(name);
    button->setToolTip(QKeySequence(key).toString(QKeySequence::NativeText));
    layout->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, direction] { find(direction); });
  };
  add(tr("Previous"), "find_previous", int(Qt::SHIFT) | Qt::Key_F3, Direction::backwards);
  add(tr("Next"), "find_next", Qt::Key_F3, Direction::forwards);
  QPushButton* close = make_button(tr("Close"), ButtonRole::link, this);
  layout->addWidget(close);
  // What is typed is found from where the last hit began, so that it grows in place. In the form only its matches are counted:
  // what was unfolded for a part of a word would stay unfolded.
  connect(words_, &QLineEdit::textChanged, this, [this] {
    if (!is_in_form()) find_from(text_.textCursor().selectionStart(), Direction::forwards);
    refresh();
  });
  connect(close, &QPushButton::clicked, this, &FindBar::leave);
  hide();
}

bool FindBar::is_in_form() const { return !form_.isHidden(); }

void FindBar::begin() {
  const QString selected = is_in_form() ? QString() : text_.textCursor().selectedText();
  if (QWidget* const focus = QApplication::focusWidget();
      focus != nullptr && !isAncestorOf(focus)) {
    was_focus_ = focus;
  }
  show();
  if (!selected.isEmpty() && !selected.contains(QChar::ParagraphSeparator)) {
    words_->setText(selected);
  }
  words_->selectAll();
  words_->setFocus();
  refresh();
}

/// Not to a button that began the search.
void FindBar::leave() {
  QWidget* const view = is_in_form() ? static_cast<QWidget*>(&form_) : &text_;
  const bool was_in_view =
      was_focus_ != nullptr && was_focus_->isVisible() && view->isAncestorOf(was_focus_);
  if (!is_in_form() || !form_.enter_marked()) {
    (was_in_view ? was_focus_.data() : view)->setFocus();
  }
  hide();
}

void FindBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    leave();
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    find(event->modifiers().testFlag(Qt::ShiftModifier) ? Direction::backwards
                                                        : Direction::forwards);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void FindBar::find(Direction direction) {
  if (words_->text().isEmpty()) {
    begin();
  } else if (is_in_form()) {
    find_in_form(direction);
  } else {
    const QTextCursor cursor = text_.textCursor();
    find_from(direction == Direction::forwards ? cursor.selectionEnd() : cursor.selectionStart(),
              direction);
  }
  refresh();
}

/// From the last match, if its page is shown, otherwise from the page.
void FindBar::find_in_form(Direction direction) {
  const std::vector<std::string> places = form_.places_with(words_->text());
  if (places.empty()) return;
  const bool is_forwards = direction == Direction::forwards;
  const auto last = std::find(places.begin(), places.end(), found_);
  const bool is_last_shown = last != places.end() && &form_page_of(found_) == &form_.page();
  const auto from = is_last_shown
                        ? last + (is_forwards ? 1 : 0)
                        : std::find_if(places.begin(), places.end(), [this](const auto& place) {
                            return &form_page_of(place) >= &form_.page();
                          });
  const auto index = static_cast<std::size_t>(from - places.begin());
  found_ = places[(is_forwards ? index : index + places.size() - 1) % places.size()];
  // A key that is pressed in the bar must not reach a field.
  const bool is_focus_here = isAncestorOf(QApplication::focusWidget());
  form_.go_to(found_, is_focus_here ? ProtocolForm::Lead::mark : ProtocolForm::Lead::focus,
              words_->text());
}

void FindBar::find_from(int position, Direction direction) {
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

void FindBar::refresh() {
  const QString where = is_in_form() ? tr("Find in the form") : tr("Find in the text");
  words_->setPlaceholderText(where);
  words_->setAccessibleName(where);
  const QString words = words_->text();
  QString count{};
  if (isHidden() || words.isEmpty()) {
    // nothing to count
  } else if (!is_in_form()) {
    count = count_of(text_.document()->toRawText().count(words, Qt::CaseInsensitive));
  } else {
    const std::vector<std::string> places = form_.places_with(words);
    const auto last = std::find(places.begin(), places.end(), found_);
    count = last == places.end() ? count_of(static_cast<qsizetype>(places.size()))
                                 : tr("%1 of %2").arg(last - places.begin() + 1).arg(places.size());
  }
  count_->setText(count);
  words_->setAccessibleDescription(count);
}

}  // namespace asperity

#include "moc_find_bar.cpp"

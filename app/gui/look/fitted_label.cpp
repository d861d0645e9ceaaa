// Uses the smaller font, then elision, where a text is too wide; the tool tip has the whole text.

#include "app/gui/look/fitted_label.h"

#include <algorithm>

#include <QtGui/QFontMetrics>
#include <QtGui/QPainter>

namespace asperity {

FittedLabel::FittedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void FittedLabel::show_text(const QString& text) {
  if (text == this->text() && !state_) return;
  state_.reset();
  setText(text);
  write_tool_tip();
}

void FittedLabel::show_state(State state, const QString& text) {
  if (text == this->text() && state_ == state) return;
  state_ = state;
  setText(text);
  write_tool_tip();
  update();
}

void FittedLabel::set_smaller_font(const QFont& font) {
  smaller_ = font;
  write_tool_tip();
}

namespace {

int width_of_shape(const QFont& font, const std::optional<State>& state) {
  return state ? QFontMetrics(font).horizontalAdvance(shape_of(*state)) + kGrid : 0;
}

}  // namespace

int FittedLabel::needed(const QFont& font) const {
  if (text().isEmpty()) return 0;
  return QFontMetrics(font).horizontalAdvance(text()) + width_of_shape(font, state_);
}

QFont FittedLabel::shown_font() const {
  return smaller_ && needed(font()) > contentsRect().width() ? *smaller_ : font();
}

bool FittedLabel::is_cut() const { return needed(shown_font()) > contentsRect().width(); }

void FittedLabel::write_tool_tip() { setToolTip(is_cut() ? text() : QString()); }

QSize FittedLabel::sizeHint() const {
  // A pixel more: widths of letters are rounded.
  return {needed(font()) + 1, fontMetrics().height()};
}

QSize FittedLabel::minimumSizeHint() const {
  return {std::min(needed(smaller_.value_or(font())) + 1, kept_), fontMetrics().height()};
}

void FittedLabel::paintEvent(QPaintEvent*) {
  if (text().isEmpty()) return;
  QPainter painter(this);
  const QFont letters = shown_font();
  painter.setFont(letters);
  const int shape = width_of_shape(letters, state_);
  QRect place = contentsRect();
  const QFontMetrics metrics(letters);
  const QString shown = metrics.elidedText(text(), elide_, place.width() - shape);
  if (alignment() & Qt::AlignRight) {
    place.setLeft(place.right() + 1 - shape - metrics.horizontalAdvance(shown));
  }
  if (state_) {
    painter.setPen(color_of(*state_));
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, shape_of(*state_));
    place.setLeft(place.left() + shape);
  }
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, shown);
}

void FittedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  write_tool_tip();
}

}  // namespace asperity

#include "moc_fitted_label.cpp"

// Draws boxes, badges, texts, pictures, options and controls in the participant's colours.

#include "app/gui/participant/pages/participant_brush.h"

#include <algorithm>

#include <QtGui/QFontMetricsF>
#include <QtGui/QPainter>

#include "app/gui/participant/pages/participant_font.h"

namespace asperity {

namespace {

using Item = ParticipantItem;

}  // namespace

ParticipantBrush::ParticipantBrush(QPainter& painter, const ParticipantColors& colors,
                                   const PictureOf& picture_of)
    : painter_(painter), colors_(colors), picture_of_(picture_of) {
  painter_.setRenderHint(QPainter::Antialiasing);
  painter_.setRenderHint(QPainter::SmoothPixmapTransform);
}

void ParticipantBrush::write(const QRectF& rect, const QString& text, int size_px, bool bold,
                             const QColor& color, int alignment) {
  if (text.isEmpty()) return;
  painter_.setPen(color);
  painter_.setFont(participant_font(size_px, bold));
  painter_.drawText(rect, alignment, text);
  drawn_.append(text);
}

void ParticipantBrush::box(const QRectF& rect, double radius, const QColor& fill,
                           const QColor& edge, double width) {
  painter_.setPen(QPen(edge, width));
  painter_.setBrush(fill);
  const double inset = width / 2.0;
  painter_.drawRoundedRect(rect.adjusted(inset, inset, -inset, -inset), radius, radius);
}

void ParticipantBrush::badge(QPointF center, const QString& key, int size_px, bool filled) {
  const double unit = size_px / 32.0;
  const double height = 48.0 * unit;
  const double width = key.size() > 1 ? 64.0 * unit : height;
  const QRectF round(center.x() - width / 2.0, center.y() - height / 2.0, width, height);
  painter_.setPen(QPen(filled ? colors_.press : colors_.muted, height / 20.0));
  painter_.setBrush(filled ? colors_.press : colors_.panel);
  painter_.drawRoundedRect(round.adjusted(1.5, 1.5, -1.5, -1.5), height / 2.0, height / 2.0);
  write(round, key, size_px, true, filled ? colors_.on_press : colors_.text, Qt::AlignCenter);
}
void ParticipantBrush::picture(const Item& item, const QRectF& square) {
  const QPixmap pixmap = picture_of_(item.picture, square.width());
  if (pixmap.isNull()) {
    box(square, 4.0, colors_.ground.darker(106), colors_.line, 1.0);
    return;
  }
  painter_.drawPixmap(square, pixmap, QRectF(pixmap.rect()));
}

void ParticipantBrush::draw_picture(const Item& item) {
  // Its key stands below it or on its left.
  const QRectF square(item.rect.right() - item.side, item.rect.top(), item.side, item.side);
  const bool beside = item.rect.width() > item.side;
  picture(item, square);
  const double unit = item.size_px / 32.0;
  if (item.chosen) {
    const double ring = 8.0 * unit;
    painter_.setPen(QPen(colors_.press, ring, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(square.adjusted(ring / 2.0, ring / 2.0, -ring / 2.0, -ring / 2.0));
    // A light line inside keeps the ring apart from a dark picture.
    painter_.setPen(QPen(colors_.panel, 2.0 * unit));
    painter_.drawRect(square.adjusted(ring, ring, -ring, -ring));
  }
  if (!item.given_to.isEmpty()) {
    const double side = std::clamp(0.45 * square.width(), 48.0 * unit, 72.0 * unit);
    const double inset = std::min(8.0 * unit, (square.width() - side) / 2.0);
    const QRectF letter(square.left() + inset, square.top() + inset, side, side);
    box(letter, 8.0 * unit, colors_.press, colors_.panel, 3.0 * unit);
    write(letter, item.given_to, std::max(item.size_px, static_cast<int>(0.6 * side)), true,
          colors_.on_press, Qt::AlignCenter);
  }
  const double half = 24.0 * unit;
  const QPointF key = beside
                          ? QPointF((item.rect.left() + square.left()) / 2.0, square.center().y())
                          : QPointF(square.center().x(), item.rect.bottom() - half);
  badge(key, item.key, item.size_px, item.chosen);
}

void ParticipantBrush::draw_option(const Item& item) {
  const double unit = item.size_px / 32.0;
  if (item.key.isEmpty()) {  // a letter that is its own key
    box(item.rect, 12.0, item.chosen ? colors_.press : colors_.panel,
        item.chosen ? colors_.press : colors_.muted, item.chosen ? 8.0 : 2.0);
    write(item.rect, item.text, item.size_px, true, item.chosen ? colors_.on_press : colors_.text);
    return;
  }
  box(item.rect, 10.0 * unit, colors_.panel,
      item.chosen || item.current ? colors_.press : colors_.line,
      (item.chosen ? 6.0 : (item.current ? 4.0 : 2.0)) * unit);
  badge({item.rect.left() + 36.0 * unit, item.rect.center().y()}, item.key, item.size_px,
        item.chosen);
  write(item.rect.adjusted(72.0 * unit, 0.0, -12.0 * unit, 0.0), item.text, item.size_px, false,
        colors_.text, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap);
}

void ParticipantBrush::draw_control(const Item& item) {
  const double unit = item.size_px / 32.0;
  box(item.rect, 10.0 * unit, item.ready ? colors_.press : colors_.ground,
      item.ready ? colors_.press : colors_.muted, 2.0 * unit);
  const QColor ink = item.ready ? colors_.on_press : colors_.text;
  const QRectF inner = item.rect.adjusted(16.0 * unit, 0.0, -16.0 * unit, 0.0);
  const double key =
      QFontMetricsF(participant_font(item.size_px, false)).horizontalAdvance(item.key);
  write(inner.adjusted(0.0, 0.0, -key, 0.0), item.text, item.size_px, true, ink,
        Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap);
  write(inner, item.key, item.size_px, false, item.ready ? colors_.on_press : colors_.muted,
        Qt::AlignRight | Qt::AlignVCenter);
}

/// What stands in the field where text is typed. Of a long one the end is seen, as in the field.
void ParticipantBrush::draw_written(const Item& item) {
  const QRectF inner = item.rect.adjusted(20.0, 16.0, -20.0, -16.0);
  const double height =
      QFontMetricsF(participant_font(item.size_px, false))
          .boundingRect(QRectF(0.0, 0.0, inner.width(), 1e6), Qt::TextWordWrap, item.text)
          .height();
  write(inner, item.text, item.size_px, false, colors_.text,
        Qt::AlignLeft | Qt::TextWordWrap |
            (height > inner.height() ? Qt::AlignBottom : Qt::AlignTop));
}

void ParticipantBrush::draw(const Item& item) {
  const double unit = item.size_px / 32.0;
  switch (item.kind) {
    case Item::Kind::words:
      write(item.rect, item.text, item.size_px, item.bold,
            item.muted ? colors_.muted : colors_.text,
            (item.left_aligned ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter) |
                Qt::TextWordWrap);
      break;
    case Item::Kind::picture:
      draw_picture(item);
      break;
    case Item::Kind::standard:
      picture(item, item.rect);
      break;
    case Item::Kind::option:
      draw_option(item);
      break;
    case Item::Kind::control:
      draw_control(item);
      break;
    case Item::Kind::pad:
      box(item.rect, 8.0, colors_.panel, colors_.muted, 2.0);
      write(item.rect, item.text, item.size_px, true, colors_.text, Qt::AlignCenter);
      break;
    case Item::Kind::number:
      box(item.rect, 8.0, colors_.panel, colors_.press, 3.0);
      write(item.rect, item.text, item.size_px, true, colors_.text, Qt::AlignCenter);
      break;
    case Item::Kind::field:
      box(item.rect, 8.0, colors_.panel, colors_.press, 3.0);
      draw_written(item);
      break;
    case Item::Kind::workspace:
      box(item.rect, 4.0, colors_.ground.darker(104), colors_.line, 1.0);
      break;
    case Item::Kind::surface:
      box(item.rect, 0.0, colors_.panel, colors_.press, 3.0);
      break;
    case Item::Kind::guide:  // a widget
    case Item::Kind::chip:   // drawn by the pages that have them
    case Item::Kind::scale:
    case Item::Kind::line:
      break;
    case Item::Kind::cue:
      box(item.rect, 8.0 * unit, colors_.cue_ground, colors_.cue_line, 2.0 * unit);
      write(item.rect, item.text, item.size_px, false, colors_.text);
      break;
  }
}

}  // namespace asperity

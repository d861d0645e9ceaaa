#include "app/gui/participant/participant_painter.h"

#include <algorithm>

#include <QtGui/QFontMetricsF>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

namespace asperity {

namespace {

using Item = ParticipantItem;

class Brush final {
 public:
  Brush(QPainter& painter, const ParticipantColors& colors, const PictureOf& picture_of)
      : painter_(painter), colors_(colors), picture_of_(picture_of) {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setRenderHint(QPainter::SmoothPixmapTransform);
  }

  void draw(const Item& item);
  QStringList take_drawn() { return std::move(drawn_); }

 private:
  void words(const QRectF& rect, const QString& text, int size_px, bool bold, const QColor& color,
             int alignment = Qt::AlignCenter | Qt::TextWordWrap) {
    if (text.isEmpty()) return;
    painter_.setPen(color);
    painter_.setFont(participant_font(size_px, bold));
    painter_.drawText(rect, alignment, text);
    drawn_.append(text);
  }
  void box(const QRectF& rect, double radius, const QColor& fill, const QColor& edge,
           double width) {
    painter_.setPen(QPen(edge, width));
    painter_.setBrush(fill);
    const double inset = width / 2.0;
    painter_.drawRoundedRect(rect.adjusted(inset, inset, -inset, -inset), radius, radius);
  }
  /// A key to be pressed: a circle around one sign, a longer one around two; filled once it is chosen.
  void badge(QPointF center, const QString& key, int size_px, bool filled) {
    const double unit = size_px / 32.0;
    const double height = 48.0 * unit;
    const double width = key.size() > 1 ? 64.0 * unit : height;
    const QRectF round(center.x() - width / 2.0, center.y() - height / 2.0, width, height);
    painter_.setPen(QPen(filled ? colors_.press : colors_.muted, height / 20.0));
    painter_.setBrush(filled ? colors_.press : colors_.panel);
    painter_.drawRoundedRect(round.adjusted(1.5, 1.5, -1.5, -1.5), height / 2.0, height / 2.0);
    words(round, key, size_px, true, filled ? colors_.on_press : colors_.text, Qt::AlignCenter);
  }
  void picture(const Item& item, const QRectF& square);
  void draw_picture(const Item& item);
  void draw_option(const Item& item);
  void draw_chip(const Item& item);
  void draw_control(const Item& item);
  void draw_written(const Item& item);
  void draw_scale(const Item& item);

  QPainter& painter_;
  const ParticipantColors& colors_;
  const PictureOf& picture_of_;
  QStringList drawn_{};
};

void Brush::picture(const Item& item, const QRectF& square) {
  const QPixmap pixmap = picture_of_(item.picture, square.width());
  if (pixmap.isNull()) {
    box(square, 4.0, colors_.ground.darker(106), colors_.line, 1.0);
    return;
  }
  painter_.drawPixmap(square, pixmap, QRectF(pixmap.rect()));
}

void Brush::draw_picture(const Item& item) {
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
    words(letter, item.given_to, std::max(item.size_px, static_cast<int>(0.6 * side)), true,
          colors_.on_press, Qt::AlignCenter);
  }
  const double half = 24.0 * unit;
  const QPointF key = beside
                          ? QPointF((item.rect.left() + square.left()) / 2.0, square.center().y())
                          : QPointF(square.center().x(), item.rect.bottom() - half);
  badge(key, item.key, item.size_px, item.chosen);
}

void Brush::draw_option(const Item& item) {
  const double unit = item.size_px / 32.0;
  if (item.key.isEmpty()) {  // a letter that is its own key
    box(item.rect, 12.0, item.chosen ? colors_.press : colors_.panel,
        item.chosen ? colors_.press : colors_.muted, item.chosen ? 8.0 : 2.0);
    words(item.rect, item.text, item.size_px, true, item.chosen ? colors_.on_press : colors_.text);
    return;
  }
  box(item.rect, 10.0 * unit, colors_.panel, item.chosen ? colors_.press : colors_.line,
      (item.chosen ? 6.0 : 2.0) * unit);
  badge({item.rect.left() + 36.0 * unit, item.rect.center().y()}, item.key, item.size_px,
        item.chosen);
  words(item.rect.adjusted(72.0 * unit, 0.0, -12.0 * unit, 0.0), item.text, item.size_px, false,
        colors_.text, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap);
}

void Brush::draw_chip(const Item& item) {
  const double unit = item.size_px / 38.0;
  const bool pairs = !item.key.isEmpty();  // it stands beside pictures that it is given to
  const bool filled = pairs ? !item.given.isEmpty() : item.current;
  const QColor ink = filled ? colors_.on_press : colors_.text;
  box(item.rect, 10.0 * unit, filled ? colors_.press : colors_.panel,
      item.current ? colors_.text : colors_.muted, (item.current ? 5.0 : 2.0) * unit);
  if (!pairs) {
    const bool marked = item.felt && !item.current;
    words(item.rect, marked ? item.text + QStringLiteral(" ✓") : item.text, item.size_px, true,
          ink);
    return;
  }
  // The half that is nearer to the pictures says which one it has.
  QRectF near = item.rect;
  QRectF far = item.rect;
  // A letter needs less room than a key of two digits.
  near.setWidth((item.points_down ? 0.6 : 0.5) * item.rect.width());
  far.setWidth(item.rect.width() - near.width());
  (item.points_left ? far : near).moveRight(item.rect.right());
  words(far, item.text, item.size_px, true, ink, Qt::AlignCenter);
  if (!item.given.isEmpty()) {
    words(near, item.given, item.size_px, false, ink, Qt::AlignCenter);
    painter_.setPen(QPen(ink, 3.0 * unit));
    const QPointF middle(item.points_left ? near.right() : near.left(), item.rect.center().y());
    const double half = (item.points_down ? 6.0 : 9.0) * unit;
    painter_.drawLine(middle - QPointF(half, 0.0), middle + QPointF(half, 0.0));
  } else if (item.current) {
    // Points to the pictures: the next one is for this surface.
    const double ahead = (item.points_left ? -1.0 : 1.0) * 9.0 * unit;
    const QPointF middle = near.center();
    const auto corner = [&](double along, double across) {
      return middle + (item.points_down ? QPointF(across, std::abs(ahead) / ahead * along)
                                        : QPointF(along, across));
    };
    QPainterPath arrow(corner(ahead, 0.0));
    arrow.lineTo(corner(-0.6 * ahead, -9.0 * unit));
    arrow.lineTo(corner(-0.6 * ahead, 9.0 * unit));
    arrow.closeSubpath();
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(ink);
    painter_.drawPath(arrow);
  }
}

void Brush::draw_control(const Item& item) {
  const double unit = item.size_px / 32.0;
  box(item.rect, 10.0 * unit, item.ready ? colors_.press : colors_.ground,
      item.ready ? colors_.press : colors_.muted, 2.0 * unit);
  const QColor ink = item.ready ? colors_.on_press : colors_.text;
  const QRectF inner = item.rect.adjusted(16.0 * unit, 0.0, -16.0 * unit, 0.0);
  const double key =
      QFontMetricsF(participant_font(item.size_px, false)).horizontalAdvance(item.key);
  words(inner.adjusted(0.0, 0.0, -key, 0.0), item.text, item.size_px, true, ink,
        Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap);
  words(inner, item.key, item.size_px, false, item.ready ? colors_.on_press : colors_.muted,
        Qt::AlignRight | Qt::AlignVCenter);
}

/// What stands in the field where text is typed. Of a long one the end is seen, as in the field.
void Brush::draw_written(const Item& item) {
  const QRectF inner = item.rect.adjusted(20.0, 16.0, -20.0, -16.0);
  const double height =
      QFontMetricsF(participant_font(item.size_px, false))
          .boundingRect(QRectF(0.0, 0.0, inner.width(), 1e6), Qt::TextWordWrap, item.text)
          .height();
  words(inner, item.text, item.size_px, false, colors_.text,
        Qt::AlignLeft | Qt::TextWordWrap |
            (height > inner.height() ? Qt::AlignBottom : Qt::AlignTop));
}

/// A mark that is no answer yet is hollow. The current scale has a heavier line and a frame.
void Brush::draw_scale(const Item& item) {
  const ParticipantScene::Scale& scale = *item.scale;
  const double unit = item.size_px / 32.0;
  const double left = item.rect.left() + item.side;
  const double length = item.rect.width() - 2.0 * item.side;
  const double y = item.rect.center().y();
  if (scale.current) box(item.rect, 8.0 * unit, colors_.panel, colors_.press, 2.0 * unit);
  painter_.setPen(QPen(colors_.text, (scale.current ? 4.0 : 3.0) * unit));
  painter_.drawLine(QPointF(left, y), QPointF(left + length, y));
  const int steps = scale.form.steps();
  const auto x_of = [&](int step) { return left + length * step / steps; };
  const double half = 16.0 * unit;
  if (scale.form.points == 0) {
    for (const double x : {left, left + length}) {
      painter_.drawLine(QPointF(x, y - half), QPointF(x, y + half));
    }
  } else {
    painter_.setBrush(colors_.panel);
    for (int step = 0; step <= steps; ++step) {
      painter_.drawEllipse(QPointF(x_of(step), y), 0.75 * half, 0.75 * half);
    }
  }
  if (!scale.step) return;
  painter_.setPen(QPen(colors_.press, 4.0 * unit));
  painter_.setBrush(scale.counts ? colors_.press : colors_.panel);
  const QPointF at(x_of(*scale.step), y);
  if (scale.form.points == 0) {
    painter_.drawRoundedRect(QRectF(at.x() - 5.0 * unit, y - 1.25 * half, 10.0 * unit, 2.5 * half),
                             4.0 * unit, 4.0 * unit);
  } else {
    painter_.drawEllipse(at, half, half);
  }
}

void Brush::draw(const Item& item) {
  const double unit = item.size_px / 32.0;
  switch (item.kind) {
    case Item::Kind::words:
      words(item.rect, item.text, item.size_px, item.bold,
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
    case Item::Kind::chip:
      draw_chip(item);
      break;
    case Item::Kind::control:
      draw_control(item);
      break;
    case Item::Kind::scale:
      draw_scale(item);
      break;
    case Item::Kind::pad:
      box(item.rect, 8.0, colors_.panel, colors_.muted, 2.0);
      words(item.rect, item.text, item.size_px, true, colors_.text, Qt::AlignCenter);
      break;
    case Item::Kind::number:
      box(item.rect, 8.0, colors_.panel, colors_.press, 3.0);
      words(item.rect, item.text, item.size_px, true, colors_.text, Qt::AlignCenter);
      break;
    case Item::Kind::field:
      box(item.rect, 8.0, colors_.panel, colors_.press, 3.0);
      draw_written(item);
      break;
    case Item::Kind::workspace:
      box(item.rect, 4.0, colors_.ground.darker(104), colors_.line, 1.0);
      break;
    case Item::Kind::guide:
      break;
    case Item::Kind::cue:
      box(item.rect, 8.0 * unit, colors_.cue_ground, colors_.cue_line, 2.0 * unit);
      words(item.rect, item.text, item.size_px, false, colors_.text);
      break;
  }
}

}  // namespace

QStringList paint(QPainter& painter, const std::vector<ParticipantItem>& items,
                  const ParticipantColors& colors, const PictureOf& picture_of) {
  Brush brush(painter, colors, picture_of);
  for (const ParticipantItem& item : items) brush.draw(item);
  return brush.take_drawn();
}

void paint_dragged(QPainter& painter, const QString& letter, QPointF at, double scale,
                   const ParticipantColors& colors) {
  const double side = 72.0 * scale;
  const QRectF rect(at.x() - side / 2.0, at.y() - side / 2.0, side, side);
  painter.setPen(QPen(colors.panel, 3.0 * scale));
  painter.setBrush(colors.press);
  painter.drawRoundedRect(rect, 8.0 * scale, 8.0 * scale);
  painter.setPen(colors.on_press);
  painter.setFont(participant_font(static_cast<int>(0.6 * side), true));
  painter.drawText(rect, Qt::AlignCenter, letter);
}

}  // namespace asperity

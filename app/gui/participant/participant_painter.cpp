// Draws the items of a layout in their order, and the letter of an option that is being dragged.

#include "app/gui/participant/participant_painter.h"

#include <QtGui/QPainter>

#include "app/gui/participant/pages/participant_font.h"

namespace asperity {

QStringList paint(QPainter& painter, const ParticipantPage& page,
                  const std::vector<ParticipantItem>& items, const ParticipantColors& colors,
                  const PictureOf& picture_of) {
  ParticipantBrush brush(painter, colors, picture_of);
  for (const ParticipantItem& item : items) page.draw(brush, item);
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

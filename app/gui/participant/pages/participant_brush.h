// Draws the things that all pages of the participant's window have.

#pragma once

#include <functional>

#include <QtCore/QPointF>
#include <QtCore/QRectF>
#include <QtCore/QStringList>
#include <QtGui/QColor>
#include <QtGui/QPixmap>

#include "app/gui/participant/pages/participant_item.h"

class QPainter;

namespace asperity {

/// The same in the light and the dark theme: what a participant sees is part of the experiment, not
/// of the experimenter's taste. Text on either ground has a contrast of 7 : 1 or more.
struct ParticipantColors {
  QColor ground{"#E6E8EB"};
  QColor panel{"#FFFFFF"};
  QColor line{"#A7AEB7"};
  QColor text{"#14181D"};
  QColor muted{"#414A54"};
  QColor press{"#0A4FB3"};
  QColor on_press{"#FFFFFF"};
  QColor cue_ground{"#FFF1C9"};
  QColor cue_line{"#8A5300"};
};

/// The scaled picture of a study-relative path, null while it is not there yet.
using PictureOf = std::function<QPixmap(const QString& picture, double side)>;

class ParticipantBrush final {
 public:
  /// All outlive the brush.
  ParticipantBrush(QPainter& painter, const ParticipantColors& colors, const PictureOf& picture_of);

  QPainter& painter() noexcept { return painter_; }
  const ParticipantColors& colors() const noexcept { return colors_; }

  /// Nothing for a chip and a scale, which the pages that have them draw.
  void draw(const ParticipantItem& item);
  void write(const QRectF& rect, const QString& text, int size_px, bool bold, const QColor& color,
             int alignment = Qt::AlignCenter | Qt::TextWordWrap);
  void box(const QRectF& rect, double radius, const QColor& fill, const QColor& edge, double width);
  /// Every piece of text that was drawn, in order.
  QStringList take_drawn() { return std::move(drawn_); }

 private:
  /// A key to be pressed: a circle around one sign, a longer one around two; filled once it is chosen.
  void badge(QPointF center, const QString& key, int size_px, bool filled);
  void picture(const ParticipantItem& item, const QRectF& square);
  void draw_picture(const ParticipantItem& item);
  void draw_option(const ParticipantItem& item);
  void draw_control(const ParticipantItem& item);
  void draw_written(const ParticipantItem& item);

  QPainter& painter_;
  const ParticipantColors& colors_;
  const PictureOf& picture_of_;
  QStringList drawn_{};
};

}  // namespace asperity

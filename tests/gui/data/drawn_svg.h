// What stands in an SVG of a figure, read back for tests.

#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QList>
#include <QtCore/QPointF>
#include <QtCore/QRectF>
#include <QtCore/QString>
#include <QtCore/QStringList>

namespace asperity {

struct DrawnText {
  QString words{};
  QPointF at{};  ///< the left end of its base line, before it is turned
  double letters = 0.0;
  bool is_turned = false;
};

struct DrawnSvg {
  QString width{};  ///< "85mm"
  QRectF view{};
  QString title{};
  QList<QPointF> circles{};
  bool has_ground = false;  ///< a rectangle as wide as the picture, which is not among the others
  QList<QRectF> rectangles{};
  QList<QList<QPointF>> polylines{};
  QList<DrawnText> texts{};
  int pictures = 0;

  QStringList words() const;
};

/// Only what the figures draw: groups may be turned or moved, nothing else.
DrawnSvg read_svg(const QByteArray& svg);

}  // namespace asperity

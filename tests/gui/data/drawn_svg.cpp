// Reads texts and points from the elements of an SVG.

#include "tests/gui/data/drawn_svg.h"

#include <QtCore/QXmlStreamReader>

namespace asperity {

namespace {

QList<QPointF> points_in(const QString& text) {
  QList<QPointF> points{};
  for (const QString& pair : text.split(' ', Qt::SkipEmptyParts)) {
    points << QPointF(pair.section(',', 0, 0).toDouble(), pair.section(',', 1, 1).toDouble());
  }
  return points;
}

}  // namespace

QStringList DrawnSvg::words() const {
  QStringList all{};
  for (const DrawnText& text : texts) all << QString(text.words).replace(QChar::Nbsp, ' ');
  return all;
}

DrawnSvg read_svg(const QByteArray& svg) {
  DrawnSvg drawn{};
  bool turned = false;
  QXmlStreamReader reader(svg);
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = reader.name();
    const QXmlStreamAttributes attributes = reader.attributes();
    const auto number = [&attributes](const char* key) {
      return attributes.value(QLatin1String(key)).toDouble();
    };
    if (name == u"svg") {
      drawn.width = attributes.value("width").toString();
      const QStringList box = attributes.value("viewBox").toString().split(' ');
      drawn.view =
          QRectF(box[0].toDouble(), box[1].toDouble(), box[2].toDouble(), box[3].toDouble());
    } else if (name == u"title") {
      drawn.title = reader.readElementText();
    } else if (name == u"g" && attributes.hasAttribute("transform")) {
      turned = !attributes.value("transform").startsWith(u"matrix(1,0,0,1,");
    } else if (name == u"circle") {
      drawn.circles << QPointF(number("cx"), number("cy"));
    } else if (name == u"rect") {
      const QRectF rectangle(number("x"), number("y"), number("width"), number("height"));
      if (rectangle.width() > 0.999 * drawn.view.width()) {
        drawn.has_ground = true;
      } else {
        drawn.rectangles << rectangle;
      }
    } else if (name == u"polyline") {
      drawn.polylines << points_in(attributes.value("points").toString());
    } else if (name == u"image") {
      ++drawn.pictures;
    } else if (name == u"text") {
      const QPointF at(number("x"), number("y"));
      const double letters = number("font-size");
      drawn.texts << DrawnText{reader.readElementText(), at, letters, turned};
    }
  }
  return drawn;
}

}  // namespace asperity

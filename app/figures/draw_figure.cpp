// Draws axes, marks, intervals, curves and legends of a layout, in its colours.

#include "app/figures/draw_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <QtCore/QLineF>
#include <QtGui/QFontMetricsF>
#include <QtGui/QPainter>
#include <QtGui/QPolygonF>

#include "app/figures/figure_layout.h"
#include "app/figures/label_places.h"

namespace asperity {

namespace {

enum class MarkShape { disc, square, triangle, diamond, lower_triangle, cross };

/// A colour of Okabe and Ito, a shape and a line style; each of the three is sufficient to
/// distinguish series.
struct Style {
  const char* color = "";
  MarkShape shape = MarkShape::disc;
  std::array<double, 4> dashes{};  ///< in pen widths; zeros: a solid line
};

constexpr std::array kStyles{Style{"#0072B2", MarkShape::disc, {}},
                             Style{"#E69F00", MarkShape::square, {5, 2, 5, 2}},
                             Style{"#009E73", MarkShape::triangle, {5, 2, 1, 2}},
                             Style{"#CC79A7", MarkShape::diamond, {2, 2, 2, 2}},
                             Style{"#56B4E9", MarkShape::lower_triangle, {8, 2, 8, 2}},
                             Style{"#D55E00", MarkShape::cross, {1, 2, 1, 2}}};

const Style& style_of(const FigureSeries& series) {
  return kStyles[static_cast<std::size_t>(series.style) % kStyles.size()];
}

/// Mixes two colours: 0 gives the first, 1 the second.
QColor mixed(const QColor& from, const QColor& to, double share) {
  const auto between = [share](float a, float b) {
    return a + static_cast<float>(share) * (b - a);
  };
  return QColor::fromRgbF(between(from.redF(), to.redF()), between(from.greenF(), to.greenF()),
                          between(from.blueF(), to.blueF()));
}

/// On a dark background the dark colours are lightened. Single participants are pale, without
/// transparency, which some programs cannot display.
QColor color_of(const FigureSeries& series, const FigureLook& look) {
  constexpr int kHalf = 128;
  constexpr int kLighter = 130;  // percent
  constexpr double kPale = 0.45;
  QColor color(style_of(series).color);
  if (look.colors.ground.lightness() < kHalf) color = color.lighter(kLighter);
  return series.single ? mixed(color, look.colors.ground, kPale) : color;
}

enum class Across { left, centre, right };
enum class Along { top, middle, bottom };

class FigureDrawing final {
 public:
  FigureDrawing(const Figure& figure, const FigureLayout& layout, QPainter& painter,
                const FigureLook& look)
      : figure_(figure), layout_(layout), painter_(painter), look_(look) {}

  void draw() {
    painter_.setFont(layout_.font());
    if (!figure_.is_drawn()) {
      text(layout_.sentence(), {0.5 * letters(), 0.5 * letters()}, Across::left, Along::top,
           look_.colors.text);
      return;
    }
    cells();
    axes();
    names();
    references();
    for (const bool single : {true, false}) {
      std::vector<const FigureSeries*> layer{};
      for (const FigureSeries& series : figure_.series) {
        if (series.single == single) layer.push_back(&series);
      }
      for (const FigureSeries* series : layer) arrows(*series);
      for (const FigureSeries* series : layer) lines(*series);
      for (const FigureSeries* series : layer) intervals(*series);
      for (const FigureSeries* series : layer) points(*series);
    }
    labels();
    key();
  }

 private:
  double letters() const { return layout_.letters(); }
  double thin() const { return letters() * 0.07; }
  QPointF at(double x, double y) const { return {layout_.x_of(x), layout_.y_of(y)}; }

  /// Draws lines of text with `anchor` at the given edge of the block.
  void text(const TextLines& block, const QPointF& anchor, Across across, Along along,
            const QColor& color) {
    const QFontMetricsF metrics(layout_.font());
    painter_.setPen(color);
    double top = anchor.y();
    if (along == Along::middle) top -= block.height / 2.0;
    if (along == Along::bottom) top -= block.height;
    for (const QString& line : block.lines) {
      const double width = metrics.horizontalAdvance(line);
      double left = anchor.x();
      if (across == Across::centre) left -= width / 2.0;
      if (across == Across::right) left -= width;
      painter_.drawText(QPointF(left, top + metrics.ascent()), line);
      top += metrics.height();
    }
  }
  void text(const QString& words, const QPointF& anchor, Across across, Along along,
            const QColor& color) {
    text({.lines = {words}, .height = QFontMetricsF(layout_.font()).height()}, anchor, across,
         along, color);
  }
  /// The same, rotated to be read from below.
  void upright_text(const TextLines& block, const QPointF& anchor, Across across, Along along,
                    const QColor& color) {
    painter_.save();
    painter_.translate(anchor);
    painter_.rotate(-90.0);
    text(block, {0.0, 0.0}, across, along, color);
    painter_.restore();
  }

  void line(const QPointF& from, const QPointF& to, const QColor& color, double width) {
    painter_.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap));
    painter_.drawLine(from, to);
  }

  void axes() {
    const QRectF& plot = layout_.plot();
    const bool cells = !figure_.cells.empty();
    const bool rows = !figure_.y.places.empty();
    const double tick = 0.35 * letters();
    const double gap = tick + 0.25 * letters();
    const auto has_arrows = [](const FigureSeries& series) { return !series.arrows.empty(); };
    if (std::any_of(figure_.series.begin(), figure_.series.end(), has_arrows)) {
      line({plot.left(), layout_.y_of(0.0)}, {plot.right(), layout_.y_of(0.0)}, look_.colors.line,
           thin());
      line({layout_.x_of(0.0), plot.top()}, {layout_.x_of(0.0), plot.bottom()}, look_.colors.line,
           thin());
    }
    if (figure_.marks_per_row > 1) {
      for (std::size_t row = 1; row < figure_.y.places.size(); ++row) {
        const double border = layout_.bottom_of_row(row - 1);
        line({plot.left(), border}, {plot.right(), border}, look_.colors.line, thin());
      }
    }
    for (const LaidTick& one : layout_.x_ticks()) {
      const bool labelled = !one.label.lines.isEmpty();
      if (!cells) {
        if (rows && labelled) {
          line({one.at, plot.top()}, {one.at, plot.bottom()}, look_.colors.line, thin());
        }
        line({one.at, plot.bottom()}, {one.at, plot.bottom() + (labelled ? tick : tick / 2.0)},
             look_.colors.muted, thin());
      }
      if (layout_.has_upright_x_labels()) {
        upright_text(one.label, {one.at, plot.bottom() + gap}, Across::right, Along::middle,
                     look_.colors.text);
      } else {
        text(one.label, {one.at, plot.bottom() + gap}, Across::centre, Along::top,
             look_.colors.text);
      }
    }
    for (const LaidTick& one : layout_.y_ticks()) {
      const bool labelled = !one.label.lines.isEmpty();
      if (!cells && !rows) {
        if (figure_.shape == FigureShape::wide && labelled) {
          line({plot.left(), one.at}, {plot.right(), one.at}, look_.colors.line, thin());
        }
        line({plot.left() - (labelled ? tick : tick / 2.0), one.at}, {plot.left(), one.at},
             look_.colors.muted, thin());
      }
      text(one.label, {plot.left() - gap - 0.1 * letters(), one.at}, Across::right, Along::middle,
           look_.colors.text);
    }
    for (const LaidTick& one : layout_.far_ticks()) {
      text(one.label, {plot.right() + gap + 0.1 * letters(), one.at}, Across::left, Along::middle,
           look_.colors.text);
    }
    if (cells) return;
    line(plot.bottomLeft(), plot.bottomRight(), look_.colors.muted, thin());
    if (!rows) line(plot.topLeft(), plot.bottomLeft(), look_.colors.muted, thin());
  }

  void names() {
    const QRectF& plot = layout_.plot();
    const double bottom = layout_.shades().isNull() ? layout_.height() - 0.5 * letters()
                                                    : layout_.shades().top() - letters() -
                                                          QFontMetricsF(layout_.font()).height();
    text(layout_.x_name(), {plot.center().x(), bottom}, Across::centre, Along::bottom,
         look_.colors.text);
    upright_text(layout_.y_name(), {0.5 * letters(), plot.center().y()}, Across::centre, Along::top,
                 look_.colors.text);
    if (!layout_.shades().isNull()) shades();
  }

  QColor shade(double share) const {
    return mixed(look_.colors.ground, look_.colors.strong, share);
  }

  /// The one of the two text colours with more contrast on a shade [WCAG 2.1].
  QColor text_on(const QColor& shade) const {
    const auto linear = [](double value) {
      return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    const double luminance = 0.2126 * linear(shade.redF()) + 0.7152 * linear(shade.greenF()) +
                             0.0722 * linear(shade.blueF());
    constexpr double kEqual = 0.179;  // black and white have the same contrast
    return luminance > kEqual ? QColor("#000000") : QColor("#FFFFFF");
  }

  void cells() {
    if (figure_.cells.empty()) return;
    const QRectF& plot = layout_.plot();
    const double width = plot.width() / static_cast<double>(figure_.x.places.size());
    const double height = plot.height() / static_cast<double>(figure_.y.places.size());
    const QFontMetricsF metrics(layout_.font());
    const auto place = [&](const FigureCell& cell) {
      return QRectF(plot.left() + static_cast<double>(cell.column) * width,
                    plot.top() + static_cast<double>(cell.row) * height, width, height);
    };
    for (const FigureCell& cell : figure_.cells) {
      const QColor color = cell.shade ? shade(*cell.shade) : look_.colors.ground;
      painter_.setPen(QPen(look_.colors.line, thin()));
      painter_.setBrush(color);
      painter_.drawRect(place(cell));
      const QString words = QString::fromStdString(cell.text);
      if (metrics.horizontalAdvance(words) > width || metrics.height() > 1.3 * height) continue;
      text(words, place(cell).center(), Across::centre, Along::middle,
           cell.shade ? text_on(color) : look_.colors.muted);
    }
    painter_.setBrush(Qt::NoBrush);
    for (const FigureCell& cell : figure_.cells) {
      if (!cell.framed) continue;
      const double inside = 1.2 * thin();
      painter_.setPen(
          QPen(look_.colors.text, 2.0 * thin(), Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
      painter_.drawRect(place(cell).adjusted(inside, inside, -inside, -inside));
    }
  }

  void shades() {
    const QRectF& bar = layout_.shades();
    constexpr int kSteps = 20;  // some programs would convert a gradient to a picture
    painter_.setPen(Qt::NoPen);
    for (int i = 0; i < kSteps; ++i) {
      painter_.setBrush(shade((i + 0.5) / kSteps));
      painter_.drawRect(QRectF(bar.left() + bar.width() * i / kSteps, bar.top(),
                               bar.width() / kSteps, bar.height()));
    }
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(look_.colors.line, thin()));
    painter_.drawRect(bar);
    text(layout_.words(figure_.shade_name), bar.topLeft() - QPointF(0.0, 0.2 * letters()),
         Across::left, Along::bottom, look_.colors.text);
    const double below = bar.bottom() + 0.2 * letters();
    text("0 %", {bar.left(), below}, Across::left, Along::top, look_.colors.text);
    text("100 %", {bar.right(), below}, Across::right, Along::top, look_.colors.text);
  }

  void references() {
    const QRectF& plot = layout_.plot();
    for (const FigureReference& one : figure_.references) {
      const bool across = one.at == FigureReference::At::y;
      QPen pen(look_.colors.muted, 1.4 * thin(), Qt::CustomDashLine, Qt::FlatCap);
      pen.setDashPattern({4.0, 3.0});
      painter_.setPen(pen);
      const QString words = layout_.words(one.label);
      if (across) {
        const double y = layout_.y_of(one.value);
        painter_.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        text(words, {plot.right(), y - 0.1 * letters()}, Across::right, Along::bottom,
             look_.colors.muted);
        continue;
      }
      if (one.at == FigureReference::At::equal) {
        diagonal(words);
        continue;
      }
      const double x = layout_.x_of(one.value);
      painter_.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
      text(words, {x, plot.top()}, Across::centre, Along::bottom, look_.colors.muted);
    }
  }

  /// The line on which both axes have the same number, with the words below its middle.
  void diagonal(const QString& words) {
    const double low = std::max(figure_.x.low, figure_.y.low);
    const double high = std::min(figure_.x.high, figure_.y.high);
    painter_.drawLine(at(low, low), at(high, high));
    const double middle = std::midpoint(low, high);
    text(words, at(middle, middle) + QPointF(0.8 * letters(), 0.0), Across::left, Along::top,
         look_.colors.muted);
  }

  QPen pen_of(const FigureSeries& series, double width) const {
    const Style& style = style_of(series);
    QPen pen(color_of(series, look_), width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (style.dashes[0] > 0.0) {
      pen.setDashPattern({style.dashes[0], style.dashes[1], style.dashes[2], style.dashes[3]});
    }
    return pen;
  }

  /// Lines between outlined points are guides to the eye; those of single participants are many.
  void lines(const FigureSeries& series) {
    painter_.setPen(pen_of(series, (series.hollow || series.single ? 1.0 : 1.8) * thin()));
    painter_.setBrush(Qt::NoBrush);
    for (const std::vector<FigurePlace>& one : series.lines) {
      QPolygonF polyline{};
      for (const FigurePlace& place : one) polyline << at(place.x, place.y);
      painter_.drawPolyline(polyline);
    }
  }

  /// A line with a filled head, which ends at `to`.
  void arrow(const QPointF& from, const QPointF& to, const QColor& color) {
    const QLineF whole(from, to);
    const double length = whole.length();
    if (!(length > 0.0)) return;
    const QPointF along = (to - from) / length;
    const double head = std::min(0.8 * letters(), length);
    const QPointF neck = to - head * along;
    const QPointF aside = 0.35 * head * QPointF(-along.y(), along.x());
    line(from, neck, color, 1.8 * thin());
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(color);
    painter_.drawPolygon(QPolygonF({to, neck + aside, neck - aside}));
    painter_.setBrush(Qt::NoBrush);
  }

  void arrows(const FigureSeries& series) {
    for (const FigureArrow& one : series.arrows) {
      arrow(at(0.0, 0.0), at(one.to.x, one.to.y), color_of(series, look_));
    }
  }

  /// One end of an interval: a cap, or an arrow where it extends beyond the axis. `out`: the unit
  /// vector away from the point.
  void end_of_interval(const QPointF& end, const QPointF& out, bool goes_on) {
    const double size = 0.25 * letters();
    const QPointF aside(-out.y() * size, out.x() * size);
    const QPointF back = goes_on ? 1.5 * size * out : QPointF();
    painter_.drawLine(end - back + aside, goes_on ? end : end - aside);
    if (goes_on) painter_.drawLine(end - back - aside, end);
  }

  void intervals(const FigureSeries& series) {
    painter_.setPen(QPen(color_of(series, look_), 1.8 * thin(), Qt::SolidLine, Qt::FlatCap));
    const auto held = [](const FigureAxis& axis, double value) {
      return axis.places.empty() ? std::clamp(value, axis.low, axis.high) : value;
    };
    for (const FigurePoint& point : series.points) {
      for (const bool across : {true, false}) {
        const std::optional<FigureSpan>& span = across ? point.x_interval : point.y_interval;
        if (!span) continue;
        const FigureAxis& axis = across ? figure_.x : figure_.y;
        const double low = held(axis, span->low);
        const double high = held(axis, span->high);
        const QPointF from = across ? at(low, point.y) : at(point.x, low);
        const QPointF to = across ? at(high, point.y) : at(point.x, high);
        const QPointF out = across ? QPointF(1.0, 0.0) : QPointF(0.0, -1.0);
        painter_.drawLine(from, to);
        end_of_interval(from, -out, low > span->low);
        end_of_interval(to, out, high < span->high);
      }
    }
  }

  double half_width(const FigurePoint& point) const { return 0.34 * letters() * point.size; }

  void mark(const FigureSeries& series, const QPointF& middle, double half) {
    const QColor color = color_of(series, look_);
    painter_.setPen(QPen(color, 1.8 * thin(), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter_.setBrush(series.hollow ? look_.colors.ground : color);
    const auto corner = [&](double x, double y) {
      return QPointF(middle.x() + x * half, middle.y() + y * half);
    };
    switch (style_of(series).shape) {
      case MarkShape::disc:
        painter_.drawEllipse(middle, half, half);
        break;
      case MarkShape::square:
        painter_.drawRect(QRectF(corner(-0.9, -0.9), corner(0.9, 0.9)));
        break;
      case MarkShape::triangle:
        painter_.drawPolygon(
            QPolygonF({corner(0.0, -1.15), corner(1.1, 0.85), corner(-1.1, 0.85)}));
        break;
      case MarkShape::diamond:
        painter_.drawPolygon(QPolygonF(
            {corner(0.0, -1.25), corner(1.25, 0.0), corner(0.0, 1.25), corner(-1.25, 0.0)}));
        break;
      case MarkShape::lower_triangle:
        painter_.drawPolygon(
            QPolygonF({corner(0.0, 1.15), corner(1.1, -0.85), corner(-1.1, -0.85)}));
        break;
      case MarkShape::cross:
        painter_.drawLine(corner(-0.9, -0.9), corner(0.9, 0.9));
        painter_.drawLine(corner(-0.9, 0.9), corner(0.9, -0.9));
        break;
    }
    painter_.setBrush(Qt::NoBrush);
  }

  void points(const FigureSeries& series) {
    constexpr double kSingle = 0.5;  // relative to other marks
    for (const FigurePoint& point : series.points) {
      mark(series, at(point.x, point.y), (series.single ? kSingle : 1.0) * half_width(point));
    }
  }

  /// Draws labels next to their points and beyond the heads of arrows, where they cover no other
  /// mark and no label, if there is such a place.
  void labels() {
    LabelPlaces places(layout_.plot());
    for (const FigureSeries& series : figure_.series) {
      if (series.single) continue;
      for (const FigurePoint& point : series.points) {
        const double half = 1.3 * half_width(point);
        places.keep_free(
            QRectF(at(point.x, point.y) - QPointF(half, half), QSizeF(2 * half, 2 * half)));
      }
      for (const FigureArrow& arrow : series.arrows) {
        places.keep_free(QLineF(at(0.0, 0.0), at(arrow.to.x, arrow.to.y)), 0.5 * letters());
      }
    }
    const QFontMetricsF metrics(layout_.font());
    const auto draw = [&](const QStringList& lines, const QPointF& named, const QColor& color,
                          const auto& candidates_for) {
      TextLines words{.lines = lines,
                      .height = static_cast<double>(lines.size()) * metrics.height()};
      for (const QString& line : lines) {
        words.width = std::max(words.width, metrics.horizontalAdvance(line));
      }
      if (words.width == 0.0) return;
      const QRectF place = places.take(named, candidates_for(QSizeF(words.width, words.height)));
      text(words, place.topLeft(), Across::left, Along::top, color);
    };
    // Arrows first: their labels can only be in one direction. They have a dark colour of the arrow.
    constexpr double kDark = 0.35;
    for (const FigureSeries& series : figure_.series) {
      const QColor color = mixed(color_of(series, look_), look_.colors.text, kDark);
      for (const FigureArrow& arrow : series.arrows) {
        const QLineF line(at(0.0, 0.0), at(arrow.to.x, arrow.to.y));
        draw({layout_.words(arrow.label)}, line.p2(), color,
             [&](const QSizeF& size) { return beyond_arrow(line, size, 0.3 * letters()); });
      }
    }
    for (const FigureSeries& series : figure_.series) {
      QStringList names{};
      std::vector<QPointF> middles{};
      double widest_mark = 0.0;
      for (const FigurePoint& point : series.points) {
        if (point.label.empty()) continue;
        names.push_back(layout_.words(point.label));
        middles.push_back(at(point.x, point.y));
        widest_mark = std::max(widest_mark, half_width(point));
      }
      constexpr double kWidestJoined = 0.4;  // of the plot
      for (const std::vector<std::size_t>& group : near_points(middles, metrics.height())) {
        QStringList own{};
        QRectF marks(middles[group.front()], QSizeF(0.0, 0.0));
        for (const std::size_t i : group) {
          own.push_back(names[static_cast<qsizetype>(i)]);
          marks.setLeft(std::min(marks.left(), middles[i].x()));
          marks.setRight(std::max(marks.right(), middles[i].x()));
          marks.setTop(std::min(marks.top(), middles[i].y()));
          marks.setBottom(std::max(marks.bottom(), middles[i].y()));
        }
        const double gap =
            std::max(marks.width(), marks.height()) / 2.0 + widest_mark + 0.3 * letters();
        draw(joined_names(own, metrics, kWidestJoined * layout_.plot().width()), marks.center(),
             look_.colors.text,
             [&](const QSizeF& size) { return around_point(marks.center(), size, gap); });
      }
    }
  }

  void key() {
    for (const KeyItem& item : layout_.key()) {
      const FigureSeries& series = figure_.series[item.series];
      const double length = 2.6 * letters();
      if (!series.lines.empty()) {
        painter_.setPen(pen_of(series, 1.8 * thin()));
        painter_.drawLine(item.at, item.at + QPointF(length, 0.0));
      }
      if (!series.arrows.empty()) {
        arrow(item.at, item.at + QPointF(length, 0.0), color_of(series, look_));
      }
      if (!series.points.empty()) {
        // Outlined marks differ from others of their style in size, too.
        mark(series, item.at + QPointF(length / 2.0, 0.0),
             series.hollow ? half_width(series.points.front()) : 0.34 * letters());
      }
      text(item.name, item.at + QPointF(length + 0.5 * letters(), 0.0), Across::left, Along::middle,
           look_.colors.text);
    }
  }

  const Figure& figure_;
  const FigureLayout& layout_;
  QPainter& painter_;
  const FigureLook& look_;
};

}  // namespace

double figure_height(const Figure& figure, double width, const FigureLook& look) {
  return FigureLayout(figure, width, look).height();
}

void draw_figure(const Figure& figure, QPainter& painter, const QRectF& into,
                 const FigureLook& look) {
  const FigureLayout layout(figure, into.width(), look);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(into.topLeft());
  FigureDrawing(figure, layout, painter, look).draw();
  painter.restore();
}

}  // namespace asperity

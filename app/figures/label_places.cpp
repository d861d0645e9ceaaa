// Takes the candidate that covers the least of lines, arrow heads and other labels.

#include "app/figures/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <QtGui/QFontMetricsF>

namespace asperity {

namespace {

double area_of(const QRectF& rectangle) { return rectangle.width() * rectangle.height(); }

/// The length of the part of a line that is in a rectangle (Liang and Barsky).
double length_inside(const QLineF& line, const QRectF& place) {
  double from = 0.0;
  double to = 1.0;
  const std::array borders{std::pair{-line.dx(), line.x1() - place.left()},
                           std::pair{line.dx(), place.right() - line.x1()},
                           std::pair{-line.dy(), line.y1() - place.top()},
                           std::pair{line.dy(), place.bottom() - line.y1()}};
  for (const auto& [towards, room] : borders) {
    if (towards == 0.0) {
      if (room < 0.0) return 0.0;
    } else if (towards < 0.0) {
      from = std::max(from, room / towards);
    } else {
      to = std::min(to, room / towards);
    }
  }
  return from < to ? (to - from) * line.length() : 0.0;
}

}  // namespace

void LabelPlaces::keep_free(const QLineF& arrow, double head) {
  lines_.push_back(arrow);
  const QPointF half(head / 2.0, head / 2.0);
  heads_.emplace_back(arrow.p2() - half, arrow.p2() + half);
}

QRectF LabelPlaces::take(const QPointF& named, std::span<const QRectF> candidates) {
  QRectF best = candidates.front();
  constexpr double kRounding = 1e-9;
  double least = disturbance(named, best);
  for (const QRectF& candidate : candidates.subspan(1)) {
    const double covered = disturbance(named, candidate);
    if (covered < least - kRounding) {
      least = covered;
      best = candidate;
    }
  }
  marks_.push_back(best);
  return best;
}

double LabelPlaces::disturbance(const QPointF& named, const QRectF& place) const {
  constexpr double kOutside = 100.0;
  constexpr double kMarkOfPoint = 10.0;
  double covered =
      within_.contains(place) ? 0.0 : kOutside * (1.0 - area_of(place & within_) / area_of(place));
  for (const QRectF& mark : marks_) {
    // However small the common part is, it is worse than a line.
    if (mark.intersects(place))
      covered += kMarkOfPoint * (1.0 + area_of(mark & place) / area_of(mark));
  }
  for (const QRectF& head : heads_) {
    if (head.intersects(place)) covered += 1.0 + area_of(head & place) / area_of(head);
  }
  // Arrows that end at the same place as that of the label do not separate it from its head.
  constexpr double kFromNamed = 0.2;
  const QLineF all(named, place.center());
  const QLineF between(all.pointAt(kFromNamed), all.p2());
  for (const QLineF& line : lines_) {
    covered += length_inside(line, place) / place.width();
    if (line.intersects(between, nullptr) == QLineF::BoundedIntersection) covered += 1.0;
  }
  return covered;
}

std::vector<QRectF> around_point(const QPointF& point, const QSizeF& label, double gap) {
  const double width = label.width();
  const double height = label.height();
  std::vector<QRectF> candidates{};
  for (const double distance : {gap, 2.0 * gap}) {
    const double right = point.x() + distance;
    const double left = point.x() - distance - width;
    const double above = point.y() - distance - height;
    const double below = point.y() + distance;
    const QPointF centred(point.x() - width / 2.0, point.y() - height / 2.0);
    candidates.emplace_back(QPointF(right, centred.y()), label);
    candidates.emplace_back(QPointF(left, centred.y()), label);
    candidates.emplace_back(QPointF(centred.x(), above), label);
    candidates.emplace_back(QPointF(centred.x(), below), label);
    const double inwards = distance * (1.0 - 1.0 / std::numbers::sqrt2);  // at the same distance
    for (const double x : {right - inwards, left + inwards}) {
      for (const double y : {above + inwards, below - inwards}) {
        candidates.emplace_back(QPointF(x, y), label);
      }
    }
  }
  return candidates;
}

std::vector<std::vector<std::size_t>> near_points(std::span<const QPointF> points, double reach) {
  std::vector<std::vector<std::size_t>> groups{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto near = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return QLineF(points[group.front()], points[i]).length() < reach;
    });
    if (near == groups.end()) {
      groups.push_back({i});
    } else {
      near->push_back(i);
    }
  }
  return groups;
}

QStringList joined_names(const QStringList& names, const QFontMetricsF& metrics, double widest) {
  constexpr qsizetype kMostLines = 2;
  const auto broken = [&](QStringList entries) {
    QStringList lines{};
    for (qsizetype i = 0; i < entries.size(); ++i) {
      const QString entry = entries[i] + (i + 1 < entries.size() ? "," : "");
      const QString longer = lines.isEmpty() ? QString() : lines.back() + ' ' + entry;
      if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= widest) {
        lines.back() = longer;
      } else {
        lines.push_back(entry);
      }
    }
    return lines;
  };
  QStringList lines = broken(names);
  for (qsizetype shown = names.size() - 1; shown > 0 && lines.size() > kMostLines; --shown) {
    lines = broken(names.first(shown) << '+' + QString::number(names.size() - shown));
  }
  return lines;
}

std::vector<QRectF> beyond_arrow(const QLineF& arrow, const QSizeF& label, double gap) {
  const double length = arrow.length();
  const QPointF along = length > 0.0 ? QPointF(arrow.dx(), arrow.dy()) / length : QPointF(1.0, 0.0);
  constexpr double kTurn = std::numbers::pi / 12.0;
  constexpr int kFarthestTurn = 6;  // at right angles
  std::vector<QRectF> candidates{};
  for (const double distance : {gap, 3.0 * gap, 6.0 * gap}) {
    for (int turn = 0; turn <= kFarthestTurn; ++turn) {
      for (const double side : {1.0, -1.0}) {
        if (turn == 0 && side < 0.0) continue;
        const double cosine = std::cos(side * turn * kTurn);
        const double sine = std::sin(side * turn * kTurn);
        const QPointF out(along.x() * cosine - along.y() * sine,
                          along.x() * sine + along.y() * cosine);
        // As far as the label has to move in this direction to leave the head.
        const double across = (label.width() / 2.0 + distance) / std::abs(out.x());
        const double upwards = (label.height() / 2.0 + distance) / std::abs(out.y());
        const QPointF middle = arrow.p2() + std::min(across, upwards) * out;
        candidates.emplace_back(
            QPointF(middle.x() - label.width() / 2.0, middle.y() - label.height() / 2.0), label);
      }
    }
  }
  return candidates;
}

}  // namespace asperity

// Finds places for labels next to the marks that they name.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <QtCore/QLineF>
#include <QtCore/QRectF>
#include <QtCore/QStringList>

class QFontMetricsF;

namespace asperity {

/// Chooses a place for one label after the other, in the order of `take`; places that are taken stay.
/// Lengths are in units of the painter.
class LabelPlaces final {
 public:
  /// Labels are inside `within` where this is possible.
  explicit LabelPlaces(const QRectF& within) : within_(within) {}

  /// Marks, which labels do not cover where this is possible.
  void keep_free(const QRectF& mark) { marks_.push_back(mark); }
  /// The head of an arrow, at the end of the line, is as wide as `head`.
  void keep_free(const QLineF& arrow, double head);

  /// Takes the first of `candidates` (at least one) for the label of `named` that covers nothing, or
  /// else the one that covers least: an arrow rather than a label or a mark, and these rather than
  /// what is outside. Places that an arrow separates from `named` are avoided like those on an arrow.
  QRectF take(const QPointF& named, std::span<const QRectF> candidates);

 private:
  double disturbance(const QPointF& named, const QRectF& place) const;

  QRectF within_{};
  std::vector<QRectF> marks_{};  ///< and labels
  std::vector<QRectF> heads_{};
  std::vector<QLineF> lines_{};
};

/// Next to a point, from the best place to the worst: right, left, above, below, in the corners; then
/// the same at twice the distance.
std::vector<QRectF> around_point(const QPointF& point, const QSizeF& label, double gap);

/// Groups of points that have a common label, by their indices in the given order: each point is closer than `reach` to the first
/// point of its group.
std::vector<std::vector<std::size_t>> near_points(std::span<const QPointF> points, double reach);

/// The common label of several points: "cork, felt, wool". Broken into at most two lines, which are not wider than `widest` unless one
/// name is; if they cannot hold all names, the last entry is the number of the others: "cork, felt, +3". A single name is unchanged.
QStringList joined_names(const QStringList& names, const QFontMetricsF& metrics, double widest);

/// Beyond the head of an arrow, first in its direction, then moved sideways.
std::vector<QRectF> beyond_arrow(const QLineF& arrow, const QSizeF& label, double gap);

}  // namespace asperity

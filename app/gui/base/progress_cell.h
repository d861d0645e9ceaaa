// How many of how many, in words and as a bar.

#pragma once

#include <QtWidgets/QStyledItemDelegate>

class QStandardItem;

namespace asperity {

/// "12 of 20" at the left and the bar at the right; sorts by the fraction.
QStandardItem* progress_cell(int done, int planned);

/// Draws the cells of a column that `progress_cell` made.
class ProgressDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
};

}  // namespace asperity

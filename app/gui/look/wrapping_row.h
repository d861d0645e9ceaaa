// Declares a row of widgets that becomes several rows where it is too narrow.

#pragma once

#include <vector>

#include <QtWidgets/QLayout>

#include "app/gui/look/theme.h"

namespace asperity {

/// Items next to each other; those whose minimum widths have no room are in further rows. Within a row all items get the width
/// that they need; what remains is shared by those that expand. An item with Qt::AlignRight is at the right edge.
class WrappingRow final : public QLayout {
 public:
  explicit WrappingRow(QWidget* parent = nullptr, int gap = kGrid / 2);
  ~WrappingRow() override;
  /// As a part of the row, which stays together.
  void add_layout(QLayout* layout, Qt::Alignment alignment = {});

  void addItem(QLayoutItem* item) override;
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override {
    return lay_out(QRect(0, 0, width, 0), Effect::none);
  }
  QSize sizeHint() const override;
  QSize minimumSize() const override;
  void setGeometry(const QRect& place) override;

 private:
  using Line = std::vector<QLayoutItem*>;
  std::vector<Line> lines(int width) const;
  std::vector<int> widths(const Line& line, int width) const;
  enum class Effect { none, placed };
  /// The height that the items need.
  int lay_out(const QRect& place, Effect effect) const;

  std::vector<QLayoutItem*> items_{};
};

}  // namespace asperity

// Divides the items into rows by their minimum widths, then each row by what its items need.

#include "app/gui/look/wrapping_row.h"

#include <algorithm>

#include <QtWidgets/QWidget>

namespace asperity {

namespace {

int height_of(const QLayoutItem& item, int width) {
  return item.hasHeightForWidth() ? item.heightForWidth(width) : item.sizeHint().height();
}

}  // namespace

WrappingRow::WrappingRow(QWidget* parent, int gap) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
  setSpacing(gap);
}

WrappingRow::~WrappingRow() {
  while (QLayoutItem* const item = takeAt(0)) delete item;
}

void WrappingRow::add_layout(QLayout* layout, Qt::Alignment alignment) {
  layout->setAlignment(alignment);
  addChildLayout(layout);
  addItem(layout);
}

void WrappingRow::addItem(QLayoutItem* item) {
  items_.push_back(item);
  invalidate();
}

QLayoutItem* WrappingRow::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* WrappingRow::takeAt(int index) {
  QLayoutItem* const item = itemAt(index);
  if (item != nullptr) items_.erase(items_.begin() + index);
  return item;
}

std::vector<WrappingRow::Line> WrappingRow::lines(int width) const {
  std::vector<Line> lines{};
  int room = 0;
  for (QLayoutItem* const item : items_) {
    if (item->isEmpty()) continue;
    const int needed = item->minimumSize().width();
    if (lines.empty() || needed + spacing() > room) {
      lines.emplace_back();
      room = width + spacing();
    }
    lines.back().push_back(item);
    room -= needed + spacing();
  }
  return lines;
}

std::vector<int> WrappingRow::widths(const Line& line, int width) const {
  std::vector<int> widths{};
  int rest = width - spacing() * (static_cast<int>(line.size()) - 1);
  for (const QLayoutItem* const item : line) {
    widths.push_back(std::min(item->minimumSize().width(), width));
    rest -= widths.back();
  }
  const auto grow = [&](std::size_t i, int most) {
    const int more = std::clamp(most - widths[i], 0, std::max(rest, 0));
    widths[i] += more;
    rest -= more;
  };
  for (std::size_t i = 0; i < line.size(); ++i) grow(i, line[i]->sizeHint().width());
  std::vector<std::size_t> expanding{};
  for (std::size_t i = 0; i < line.size(); ++i) {
    if ((line[i]->expandingDirections() & Qt::Horizontal) != 0) expanding.push_back(i);
  }
  for (std::size_t i = 0; i < expanding.size(); ++i) {
    const int share = rest / static_cast<int>(expanding.size() - i);
    const QLayoutItem& item = *line[expanding[i]];
    grow(expanding[i], std::min(widths[expanding[i]] + share, item.maximumSize().width()));
  }
  return widths;
}

int WrappingRow::lay_out(const QRect& place, Effect effect) const {
  const QRect room = place.marginsRemoved(contentsMargins());
  int end = room.y();
  for (const Line& line : lines(room.width())) {
    const std::vector<int> wide = widths(line, room.width());
    const int y = end + (end > room.y() ? spacing() : 0);
    int height = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      height = std::max(height, height_of(*line[i], wide[i]));
    }
    end = y + height;
    if (effect == Effect::none) continue;
    int x = room.x();
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool is_last = i + 1 == line.size();
      const bool is_right = is_last && (line[i]->alignment() & Qt::AlignRight) != 0;
      const int begin = is_right ? room.x() + room.width() - wide[i] : x;
      line[i]->setGeometry(QRect(begin, y, wide[i], height));
      x += wide[i] + spacing();
    }
  }
  return end - room.y() + place.height() - room.height();
}

QSize WrappingRow::sizeHint() const {
  QSize all{0, 0};
  for (const QLayoutItem* const item : items_) {
    if (item->isEmpty()) continue;
    const QSize wanted = item->sizeHint();
    all = {all.width() + (all.width() > 0 ? spacing() : 0) + wanted.width(),
           std::max(all.height(), wanted.height())};
  }
  return all.grownBy(contentsMargins());
}

QSize WrappingRow::minimumSize() const {
  QSize least{0, 0};
  for (const QLayoutItem* const item : items_) {
    if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
  }
  return least.grownBy(contentsMargins());
}

void WrappingRow::setGeometry(const QRect& place) {
  QLayout::setGeometry(place);
  lay_out(place, Effect::placed);
}

}  // namespace asperity

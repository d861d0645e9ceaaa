// Paints name, count and bar by a delegate, and widens the list to its longest name.

#include "app/gui/window/navigation_list.h"

#include <algorithm>

#include <QtGui/QFontMetrics>
#include <QtGui/QPainter>
#include <QtWidgets/QStyledItemDelegate>

#include "app/gui/look/theme.h"

namespace asperity {

namespace {

constexpr int kPageKey = Qt::UserRole;
constexpr int kCount = Qt::UserRole + 1;
constexpr int kItemHeight = 40;
constexpr int kNavigationWidth = 208;  // at least: words may be longer in other languages

/// The name at the left, the count at the right, a bar before the page that is shown.
class PageItem final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
    return {kNavigationWidth, kItemHeight};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const Theme& look = theme();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    if (selected || option.state.testFlag(QStyle::State_MouseOver)) {
      painter->fillRect(option.rect, look.raised);
    }
    if (selected) {
      painter->fillRect(QRect(option.rect.topLeft(), QSize(4, option.rect.height())), look.press);
    }
    if (selected && option.state.testFlag(QStyle::State_HasFocus)) {
      painter->setPen(look.press);
      painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
    }
    const QRect inside = option.rect.adjusted(kMargin, 0, -kMargin, 0);
    painter->setFont(text_font(TextSize::body, selected));
    painter->setPen(look.text);
    painter->drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, index.data().toString());
    painter->setFont(text_font(TextSize::small));
    painter->setPen(look.muted);
    painter->drawText(inside, Qt::AlignRight | Qt::AlignVCenter, index.data(kCount).toString());
    painter->restore();
  }
};

}  // namespace

NavigationList::NavigationList(QWidget* parent) : QListWidget(parent) {
  setObjectName("navigation");
  setAccessibleName(tr("Pages of the study"));
  setFixedWidth(kNavigationWidth);
  setFrameShape(QFrame::NoFrame);
  setViewportMargins(0, kGrid, 0, 0);
  setStyleSheet("QListWidget { border: none; background: transparent; }");
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMouseTracking(true);
  setItemDelegate(new PageItem(this));
  connect(this, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr) emit page_selected(item->data(kPageKey).toString());
  });
  // Chosen once more: back from a page that is not in the list (a session's trials, its start).
  for (const auto chosen : {&QListWidget::itemClicked, &QListWidget::itemActivated}) {
    connect(this, chosen, this,
            [this](QListWidgetItem* item) { emit page_selected(item->data(kPageKey).toString()); });
  }
}

void NavigationList::add_page(const QString& key, const QString& name) {
  auto* item = new QListWidgetItem(name, this);
  item->setData(kPageKey, key);
  make_room();
}

void NavigationList::set_count(const QString& key, const QString& count) {
  QListWidgetItem* item = item_of(key);
  if (item == nullptr) return;
  item->setData(kCount, count);
  item->setData(Qt::AccessibleTextRole, QString(item->text() + ' ' + count).trimmed());
  make_room();
}

void NavigationList::make_room() {
  const QFontMetrics name(text_font(TextSize::body, true));
  const QFontMetrics number(text_font(TextSize::small));
  int width = kNavigationWidth;
  for (int row = 0; row < count(); ++row) {
    const int words = name.horizontalAdvance(item(row)->text()) +
                      number.horizontalAdvance(item(row)->data(kCount).toString());
    width = std::max(width, words + 2 * kMargin + kGrid);
  }
  setFixedWidth(width);
}

void NavigationList::select(const QString& key) {
  if (QListWidgetItem* item = item_of(key)) setCurrentItem(item);
}

QString NavigationList::selected() const {
  return currentItem() == nullptr ? QString{} : currentItem()->data(kPageKey).toString();
}

QListWidgetItem* NavigationList::item_of(const QString& key) const {
  for (int row = 0; row < count(); ++row) {
    if (item(row)->data(kPageKey).toString() == key) return item(row);
  }
  return nullptr;
}

}  // namespace asperity

#include "moc_navigation_list.cpp"

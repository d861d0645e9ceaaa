// Stores the fraction in an item role, from which a delegate paints the bar next to the words.

#include "app/gui/base/progress_cell.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtGui/QPainter>

#include "app/gui/base/study_table.h"
#include "app/gui/look/theme.h"

namespace asperity {

namespace {

constexpr int kFraction = Qt::UserRole + 2;
constexpr int kWordsWidth = 112;
constexpr int kBarHeight = 8;

}  // namespace

QStandardItem* progress_cell(int done, int planned) {
  const double fraction = planned > 0 ? std::min(1.0, static_cast<double>(done) / planned) : 0.0;
  const QString text =
      planned > 0
          ? QCoreApplication::translate("asperity::ProgressCell", "%1 of %2").arg(done).arg(planned)
          : QString::number(done);
  QStandardItem* cell = text_cell(text, fraction);
  cell->setData(fraction, kFraction);
  return cell;
}

void ProgressDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const double fraction = index.data(kFraction).toDouble();
  QRect bar = option.rect.adjusted(kWordsWidth, 0, -kMargin, 0);
  bar.setTop(option.rect.center().y() - kBarHeight / 2);
  bar.setHeight(kBarHeight);
  const bool selected = option.state.testFlag(QStyle::State_Selected);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  painter->setBrush(selected ? theme().on_press : theme().raised);
  painter->setOpacity(selected ? 0.4 : 1.0);
  painter->drawRoundedRect(bar, kBarHeight / 2, kBarHeight / 2);
  painter->setOpacity(1.0);
  painter->setBrush(selected ? theme().on_press : theme().press);
  bar.setWidth(static_cast<int>(fraction * bar.width()));
  if (bar.width() > 0) painter->drawRoundedRect(bar, kBarHeight / 2, kBarHeight / 2);
  painter->restore();
}

}  // namespace asperity

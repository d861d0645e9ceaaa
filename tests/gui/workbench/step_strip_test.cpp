// The strip of the steps from photograph to relief: its names are shown in full.

#include "app/gui/workbench/step_strip.h"

#include <QtGui/QFontMetrics>
#include <QtWidgets/QToolButton>
#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(StepStrip, ShowsEveryNameInFullAlsoOfTheChosenStep) {
  StepStrip strip;
  strip.resize(strip.width(), 600);
  strip.show();
  const QList<QToolButton*> buttons = strip.findChildren<QToolButton*>();
  ASSERT_EQ(buttons.size(), kSteps);
  for (const QToolButton* button : buttons) {
    QFont bold = button->font();
    bold.setBold(true);
    EXPECT_LE(QFontMetrics(bold).horizontalAdvance(button->text()), button->width() - 8)
        << button->text().toStdString();
  }
}

}  // namespace
}  // namespace asperity

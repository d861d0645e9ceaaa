// The pieces of every page under a change of theme, and what is told by their look.

#include "app/gui/look/controls.h"

#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QTableWidget>
#include <gtest/gtest.h>

#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

class Controls : public testing::Test {
 protected:
  ~Controls() override { apply_theme(*qApp, ThemeChoice::light); }
};

/// In the middle of the left half, beside the words.
QColor ground_of(QWidget& widget) {
  widget.ensurePolished();
  const QImage picture = widget.grab().toImage();
  return picture.pixelColor(10, picture.height() / 2);
}

TEST_F(Controls, FollowTheThemeWhileTheyAreShown) {
  apply_theme(*qApp, ThemeChoice::light);
  QWidget page{};
  auto* banner = new Banner(&page);
  banner->resize(400, 64);
  auto* label = new StateLabel(&page);
  page.show();
  banner->show_news(State::stop, "The device is gone.");
  label->set_state(State::look, "Two problems");
  ASSERT_TRUE(label->text().contains(color_of(State::look).name()));
  apply_theme(*qApp, ThemeChoice::dark);
  EXPECT_TRUE(label->text().contains(color_of(State::look).name())) << label->text().toStdString();
  EXPECT_TRUE(label->text().contains("Two problems"));
  EXPECT_EQ(ground_of(*banner).name(), theme().panel.name());
  EXPECT_TRUE(banner->styleSheet().contains(color_of(State::stop).name()));
}

TEST_F(Controls, ShowThatADangerousButtonCannotBePressed) {
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, choice);
    QPushButton& button = *make_button("Emergency stop", ButtonRole::danger, nullptr);
    button.resize(200, 48);
    EXPECT_EQ(ground_of(button).name(), theme().stop.name());
    button.setEnabled(false);
    EXPECT_EQ(ground_of(button).name(), theme().raised.name());
    delete &button;
  }
}

TEST_F(Controls, ArePressedByReturnAndEnterWhileTheyHaveTheFocus) {
  QWidget page{};
  QPushButton& button = *make_button("Start", ButtonRole::plain, &page);
  int pressed = 0;
  QObject::connect(&button, &QPushButton::clicked, [&pressed] { ++pressed; });
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space}) {
    QTest::keyClick(&button, key);
  }
  EXPECT_EQ(pressed, 3);
  button.setEnabled(false);
  QTest::keyClick(&button, Qt::Key_Return);
  EXPECT_EQ(pressed, 3);
}

TEST_F(Controls, ShowWhichOneHasTheFocus) {
  QWidget page{};
  page.resize(600, 200);
  auto* other = new QLineEdit(&page);
  const auto picture = [](QWidget& widget) { return widget.grab().toImage(); };
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, choice);
    for (const ButtonRole role : {ButtonRole::plain, ButtonRole::primary, ButtonRole::danger,
                                  ButtonRole::link, ButtonRole::selector}) {
      for (const bool checked : {false, true}) {
        if (checked && role != ButtonRole::selector) continue;
        QPushButton& button = *make_button("Start", role, &page);
        button.resize(200, 40);
        button.setChecked(checked);
        page.show();
        page.activateWindow();
        button.show();
        other->setFocus();
        ASSERT_TRUE(eventually([&] { return other->hasFocus(); }));
        const QImage without = picture(button);
        button.setFocus();
        EXPECT_NE(picture(button), without)
            << static_cast<int>(role) << (checked ? " checked" : "");
        delete &button;
      }
    }
  }
}

TEST_F(Controls, LetTheFocusGoOnFromATable) {
  QWidget page{};
  QTableWidget table(2, 2, &page);
  style_table(table);
  QPushButton* after = make_button("Go on", ButtonRole::plain, &page);
  page.show();
  page.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page, kPatience_ms));
  table.setFocus();
  table.setCurrentCell(0, 0);
  QTest::keyClick(&table, Qt::Key_Tab);
  EXPECT_TRUE(after->hasFocus());
}

}  // namespace
}  // namespace asperity

// The pieces of every page under a change of theme, and what is told by their look.

#include "app/gui/look/controls.h"

#include <initializer_list>
#include <string>

#include <QtCore/QLocale>
#include <QtGui/QImage>
#include <QtGui/QTextLayout>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QStyleOption>
#include <QtWidgets/QTableWidget>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/background_task.h"
#include "app/gui/look/decimal_field.h"
#include "app/gui/look/task_line.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
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

TEST_F(Controls, HaveTheHeightOfTheirLinesAndMarginsInARowThatWraps) {
  QWidget page{};
  auto* row = new WrappingRow(&page, kGrid);
  row->setContentsMargins(1, 2, 3, 4);
  for (int i = 0; i < 3; ++i) row->addWidget(make_button("Ready", ButtonRole::plain, &page));
  const QWidget& first = *row->itemAt(0)->widget();
  const QSize one = first.sizeHint();
  EXPECT_EQ(row->minimumSize(), one + QSize(4, 6));
  EXPECT_EQ(row->sizeHint(), QSize(3 * one.width() + 2 * kGrid + 4, one.height() + 6));
  EXPECT_EQ(row->heightForWidth(row->sizeHint().width()), row->sizeHint().height());
  EXPECT_EQ(row->heightForWidth(row->minimumSize().width()), 3 * one.height() + 2 * kGrid + 6);
  row->setGeometry(QRect(10, 20, row->minimumSize().width(), 200));
  EXPECT_EQ(first.geometry(), QRect(QPoint(11, 22), one));
}

// Of a banner of 600 pixels the button “Dismiss” leaves the text enough; of 392, the width of a panel, it does not.
TEST_F(Controls, PutTheButtonsOfABannerBelowATextThatTheyWouldLeaveTooNarrow) {
  QWidget page{};
  auto* banner = new Banner(&page);
  page.show();
  banner->show_news(State::look, "The device is gone.");
  const auto& dismiss = *banner->findChild<QPushButton*>("banner_dismiss");
  const int one_row = banner->heightForWidth(600);
  EXPECT_EQ(one_row, banner->heightForWidth(1200));
  EXPECT_GE(banner->heightForWidth(392), one_row + dismiss.sizeHint().height() / 2);
  EXPECT_LE(banner->minimumSizeHint().width(), 360) << "the room of a panel beside its scroll bar";
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

/// What the style draws.
class ComboBoxOption final : public QComboBox {
 public:
  static QString text_of(const QComboBox& box) {
    QStyleOptionComboBox option{};
    (box.*&ComboBoxOption::initStyleOption)(&option);
    return option.currentText;
  }
};

TEST_F(Controls, ShowBothEndsOfAChoiceThatIsTooLong) {
  ChoiceBox box{};
  const auto shown = [&box] { return ComboBoxOption::text_of(box); };
  box.addItem("Which of six pictures shows the felt texture? (chapter_recognition)");
  box.resize(400, 32);
  EXPECT_TRUE(shown().startsWith("Which of six")) << shown().toStdString();
  EXPECT_TRUE(shown().endsWith("recognition)")) << shown().toStdString();
  EXPECT_TRUE(shown().contains(QChar(0x2026))) << shown().toStdString();
  EXPECT_LT(box.fontMetrics().horizontalAdvance(shown()), 400);
  box.resize(2000, 32);
  EXPECT_EQ(shown(), box.currentText());
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

TEST_F(Controls, ShowNumbersInTheLocaleAndTakePointAndComma) {
  struct Restored {
    ~Restored() { QLocale::setDefault(QLocale::c()); }
  } restored{};
  for (const char* const language : {"en", "de"}) {
    apply_language(language);
    const bool german = std::string(language) == "de";
    EXPECT_EQ(shown_number(1234.5, 'f', 1), german ? "1234,5" : "1234.5");
    const Phrase force = phrase("ControlsTest", "%1 N by %2").with("10.0", "falcon.1");
    EXPECT_EQ(words_of(force), german ? "10,0 N by falcon.1" : "10.0 N by falcon.1");
    EXPECT_EQ(words_as_published(force), "10.0 N by falcon.1");
    for (const char* const typed : {"65.5", "65,5"}) {
      DecimalField field;
      field.setRange(0.0, 2000.0);
      field.setDecimals(1);
      field.setSuffix(" dB(A)");
      field.selectAll();
      QTest::keyClicks(&field, typed);
      field.interpretText();
      EXPECT_EQ(field.value(), 65.5) << language << ' ' << typed;
      EXPECT_EQ(field.text(), german ? "65,5 dB(A)" : "65.5 dB(A)");
    }
  }
  apply_language("en");
}

/// The lines of a text that is laid out as in a label of this width.
QStringList lines_of(const QString& text, int width) {
  QTextLayout layout(text, text_font(TextSize::body));
  QStringList lines{};
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    lines << text.mid(line.textStart(), line.textLength()).simplified().remove(QChar(0x2060));
  }
  layout.endLayout();
  return lines;
}

TEST_F(Controls, KeepNumbersTogetherWhereLinesBreak) {
  const QString text =
      "Permutation test: p < .001, on average r = −.08 (95 % CI [−.08, .44]), and 3.2 ± 0.4 mm.";
  const QString unbroken = with_unbroken_numbers(text);
  for (int width = 130; width < 900; width += 3) {
    const QStringList lines = lines_of(unbroken, width);
    EXPECT_EQ(lines.join(' '), text) << "nothing else changes";
    for (const char* const number :
         {"p < .001", "r = −.08", "95 % CI", "[−.08, .44]", "3.2 ± 0.4"}) {
      EXPECT_EQ(lines.filter(number).size(), 1)
          << number << " at " << width << ": " << lines.join(" / ").toStdString();
    }
  }
  EXPECT_EQ(with_unbroken_numbers("falcon.1 in 12 trials."), "falcon.1 in 12 trials.");
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

/// Texts of the visible buttons, in the order of focus.
QStringList visited(const QWidget& page) {
  QStringList texts{};
  for (const QWidget* at = page.nextInFocusChain(); at != &page; at = at->nextInFocusChain()) {
    const auto* button = qobject_cast<const QPushButton*>(at);
    if (button != nullptr && button->isVisible()) texts << button->text();
  }
  return texts;
}

TEST_F(Controls, AreVisitedBeforeBannersAndLinesBelowThemWhicheverWasMadeFirst) {
  QWidget page{};
  auto* layout = new QVBoxLayout(&page);
  auto* head = new QHBoxLayout();
  layout->addLayout(head);
  BackgroundTask task{};
  auto* upper = new Banner(&page);
  auto* lower = new Banner(&page);
  auto* line = new TaskLine(task, &page);
  for (QWidget* const strip : std::initializer_list<QWidget*>{upper, lower, line}) {
    layout->addWidget(strip);
  }
  // Only now, as pages fill their heads: a part with a button of its own, and buttons.
  auto* part = new QWidget(&page);
  auto* inside = new QHBoxLayout(part);
  inside->addWidget(make_button("Save", ButtonRole::plain, part));
  head->addWidget(part);
  head->addWidget(make_button("Export", ButtonRole::plain, &page));
  QPushButton* stop = make_button("Stop", ButtonRole::danger, &page);
  head->addWidget(stop);
  stop->hide();
  layout->addWidget(make_button("Below", ButtonRole::plain, &page));
  page.show();
  EXPECT_EQ(visited(page), (QStringList{"Save", "Export", "Below"}));
  lower->show_news(State::look, "The second", "Help");
  EXPECT_EQ(visited(page), (QStringList{"Save", "Export", "Help", "Dismiss", "Below"}));
  line->show();
  EXPECT_EQ(visited(page), (QStringList{"Save", "Export", "Help", "Dismiss", "Cancel", "Below"}));
  upper->show_news(State::look, "The first");
  EXPECT_EQ(visited(page),
            (QStringList{"Save", "Export", "Dismiss", "Help", "Dismiss", "Cancel", "Below"}));
  stop->show();
  EXPECT_EQ(visited(page), (QStringList{"Save", "Export", "Stop", "Dismiss", "Help", "Dismiss",
                                        "Cancel", "Below"}));
  upper->hide();
  lower->hide();
  line->hide();
  EXPECT_EQ(visited(page), (QStringList{"Save", "Export", "Stop", "Below"}));
}

TEST_F(Controls, KeepTheirOrderBelowABannerThatIsTheFirst) {
  QWidget page{};
  auto* layout = new QVBoxLayout(&page);
  auto* banner = new Banner(&page);
  layout->addWidget(banner);
  layout->addWidget(make_button("Below", ButtonRole::plain, &page));
  banner->show_news(State::look, "Before the page is shown", "Help");
  page.show();
  EXPECT_EQ(visited(page), (QStringList{"Help", "Dismiss", "Below"}));
}

}  // namespace
}  // namespace asperity

// The layout of the form of a protocol: what has room in small windows, and what stays in its place.

#include <algorithm>
#include <set>
#include <string>

#include <QtWidgets/QApplication>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QTableWidget>

#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "protocols/file/library_protocols.h"
#include "protocols/form/form_pages.h"
#include "tests/gui/editor/form_of_protocol.h"
#include "tests/gui/editor/library_text.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

// Of the form next to the plan: in windows of 1366 and 1280 points; in one of 910 points it is alone and not narrower.
constexpr int kWidth1366 = 650;
constexpr int kWidth1280 = 590;

/// The controls and labels that are too wide for this, without those that are small and at the right edge, for messages.
std::string parts_wider_than(int width, const QWidget& content) {
  std::string wide{};
  for (const QWidget* const part : content.findChildren<QWidget*>()) {
    const int begin = part->mapTo(&content, QPoint(0, 0)).x();
    const int needed = std::max(part->minimumSizeHint().width(), part->minimumWidth());
    const bool is_inner = part->layout() != nullptr || !part->isVisible();
    if (is_inner || needed < width / 2 || begin + needed <= width) continue;
    wide += " " + part->property("text").toString().toStdString() + " (" +
            part->metaObject()->className() + ", " + std::to_string(begin) + " + " +
            std::to_string(needed) + ")";
  }
  return wide;
}

/// The choices whose box shows neither the whole text nor the value without its explanation, for messages.
std::string cut_choices(const QWidget& content) {
  std::string cut{};
  for (const ChoiceBox* const box : content.findChildren<ChoiceBox*>()) {
    const QString shown = box->shown_text();
    const bool is_whole =
        shown == box->currentText() || shown == box->currentData(ChoiceBox::kValueRole).toString();
    if (!box->isVisible() || is_whole) continue;
    cut += " " + box->accessibleName().toStdString() + ": " + shown.toStdString() + " (" +
           std::to_string(box->width()) + ")";
  }
  return cut;
}

/// The cards in a value, and in German, which has the longer words, also their settings without a value.
void add_all(std::set<std::string>& opened, const nlohmann::json& value, const std::string& pointer,
             bool with_settings) {
  if (!value.is_structured()) return;
  opened.insert(pointer);
  if (with_settings) opened.insert(pointer + "/");
  for (const auto& [key, member] : value.items()) {
    add_all(opened, member, pointer + "/" + key, with_settings);
  }
}

TEST_F(FormOfProtocol, HasRoomForFieldsAndChoices) {
  int boxes = 0;
  std::set<std::string> seen{};
  for (const char* const language : {"de", "en"}) {
    apply_language(language);
    ProtocolViews views(declarations_of(built_in_models()));
    views.show();
    auto& form = child<ProtocolForm>(views, "editor_form");
    const auto& area = child<QScrollArea>(form, "form_area");
    for (const LibraryProtocol& library : library_protocols()) {
      views.text().setPlainText(QString::fromStdString(std::string(library.text)));
      views.show_form_if_possible();
      QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of what was made again
      std::set<std::string> opened{};
      const auto file = nlohmann::json::parse(library.text);
      add_all(opened, file, "", language == std::string_view("de"));
      for (const FormPage& page : form_pages()) {
        std::string content = language + std::string(page.id);
        for (const PagePart& part : page.parts) {
          content += file.value(part.key, nlohmann::json()).dump();
        }
        if (!seen.insert(content).second) continue;  // as in another protocol
        form.resume({page.id, opened, {}});
        for (const int width : {kWidth1280, kWidth1366}) {
          views.resize(width, 700);
          QApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // without drawing it
          const std::string place = std::string(library.name) + " " + std::string(page.id) + " " +
                                    language + " " + std::to_string(width) + ":";
          EXPECT_LE(area.widget()->width(), area.viewport()->width())
              << place << parts_wider_than(area.viewport()->width(), *area.widget());
          EXPECT_EQ(cut_choices(*area.widget()), "") << place;
        }
        boxes += static_cast<int>(area.widget()->findChildren<ChoiceBox*>().size());
      }
    }
  }
  EXPECT_GT(boxes, 1000);
}

TEST_F(FormOfProtocol, ShowsTheValueOfAChoiceWhereItsExplanationHasNoRoom) {
  open(library_text("amplitude_jnd"));
  auto& box = static_cast<ChoiceBox&>(control<QComboBox>("/blocks/comparisons/feedback"));
  EXPECT_EQ(box.currentText(), "none: no feedback");
  const QString value = box.currentData(ChoiceBox::kValueRole).toString();
  EXPECT_EQ(value, "none");
  box.setFixedWidth(box.width_for(box.currentText()));
  EXPECT_EQ(box.shown_text(), "none: no feedback");
  box.setFixedWidth(box.width() - 1);
  EXPECT_EQ(box.shown_text(), "none");
  EXPECT_EQ(box.toolTip(), "none: no feedback");
}

TEST_F(FormOfProtocol, OffersGermanWordsInGermanWindowsAndWritesThoseOfTheFile) {
  apply_language("de");
  open(library_text("amplitude_jnd"));
  auto& box = static_cast<ChoiceBox&>(control<QComboBox>("/blocks/comparisons/feedback"));
  EXPECT_EQ(box.currentText(), "ohne: keine Rückmeldung");
  EXPECT_EQ(box.toolTip(), "ohne: keine Rückmeldung\nIn der Datei: none");
  take_screenshot(views_, "german-words-of-choices", {1366, 768});
  const int correctness = box.findText("Richtigkeit: ob die Antwort richtig ist");
  ASSERT_GE(correctness, 0);
  box.setCurrentIndex(correctness);
  emit box.activated(correctness);
  EXPECT_EQ(tree()["blocks"]["comparisons"]["feedback"], "correctness");
  apply_language("en");
}

TEST_F(FormOfProtocol, SummarizesStepsWithTheNamesOfWords) {
  apply_language("de");
  open(library_text("amplitude_jnd"));
  ASSERT_NE(part("/flow"), nullptr);
  QStringList summaries{};
  for (const QLabel* const summary : form().findChildren<QLabel*>("summary")) {
    summaries.append(summary->text());
  }
  EXPECT_TRUE(summaries.contains("Gerät")) << summaries.join(" | ").toStdString();
  EXPECT_TRUE(summaries.contains("Kraft null"));
  EXPECT_TRUE(summaries.join('|').contains("Übung · amplitude_m · Vergleich · Standard"));
  take_screenshot(views_, "german-steps-of-flow", {1366, 768});
  apply_language("en");
}

TEST_F(FormOfProtocol, KeepsTheScrollPositionOfEachPage) {
  open(library_text("semantic_differential"));
  const QScrollBar& bar = *child<QScrollArea>(form(), "form_area").verticalScrollBar();
  const auto show = [this](std::string_view page) {
    form().show_page(page);
    QApplication::processEvents();
  };
  ASSERT_NE(part("/blocks/ratings/questions/2/scale/labels"), nullptr);
  const int position = bar.value();
  ASSERT_GT(position, 0);
  show("question");
  EXPECT_EQ(bar.value(), 0);
  show("task");
  EXPECT_EQ(bar.value(), position);
}

TEST_F(FormOfProtocol, ShowsNoHelpOfAFieldOfAnotherPage) {
  open(library_text("amplitude_jnd"));
  const auto& help = child<QLabel>(form(), "form_help");
  control<QLineEdit>("/material/friction").setFocus();
  EXPECT_FALSE(help.text().isEmpty());
  form().show_page("device");
  EXPECT_TRUE(help.text().isEmpty()) << help.text().toStdString();
}

TEST_F(FormOfProtocol, ShowsNoHelpOfAFieldThatIsGone) {
  open(library_text("semantic_differential"));
  const auto& help = child<QLabel>(form(), "form_help");
  form().go_to("/analysis/constructs/coarseness");
  QApplication::processEvents();
  const QString before = help.text();
  EXPECT_FALSE(before.isEmpty());
  child<QPushButton>(views_, "editor_to_form").setFocus();
  EXPECT_EQ(help.text(), before);
  nlohmann::json protocol = tree();
  protocol["analysis"].erase("constructs");
  views_.text().setPlainText(QString::fromStdString(protocol.dump(2)));
  QApplication::processEvents();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_TRUE(help.text().isEmpty()) << help.text().toStdString();
}

TEST_F(FormOfProtocol, ShowsTheWholeHelpInTheRoomOfAFewLines) {
  open(library_text("amplitude_jnd"));
  const auto& help = child<QLabel>(form(), "form_help");
  control<QComboBox>("/kind").setFocus();
  QApplication::processEvents();
  const auto& area = *qobject_cast<QScrollArea*>(help.parentWidget()->parentWidget());
  EXPECT_GE(help.height(), help.heightForWidth(help.width())) << "no line is cut off";
  EXPECT_GT(area.verticalScrollBar()->maximum(), 0);
  area.verticalScrollBar()->setValue(area.verticalScrollBar()->maximum());
  control<QComboBox>("/design").setFocus();
  EXPECT_EQ(area.verticalScrollBar()->value(), 0) << "another help begins at its beginning";
}

TEST_F(FormOfProtocol, GoesByTabFromThePagesToTheFirstField) {
  open(library_text("amplitude_jnd"));
  auto& pages = child<QListWidget>(form(), "form_pages");
  pages.setFocus();
  QTest::keyClick(&pages, Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), &control<QLineEdit>("/title"));
}

TEST_F(FormOfProtocol, ShowsTheLevelsOfListedTrialsInFull) {
  open(library_text("map_of_renderings"));
  const auto& table = control<QTableWidget>("/blocks/familiarisation/listed");
  for (int column = 0; column < table.columnCount(); ++column) {
    const int needed = table.horizontalHeader()->sectionSizeHint(column);
    EXPECT_GE(table.columnWidth(column), needed) << column;
    const QFontMetrics letters(table.font());
    EXPECT_GE(table.columnWidth(column), letters.horizontalAdvance(table.item(0, column)->text()));
  }
}

// A problem of a field above it appears or is solved while something is typed.
TEST_F(FormOfProtocol, KeepsTheFieldInUseInItsPlaceWhenProblemsAppear) {
  open(library_text("semantic_differential"));
  auto& field = control<QLineEdit>("/blocks/ratings/questions/2/name");
  field.setFocus();
  QApplication::processEvents();
  const QPoint before = field.mapTo(&views_, QPoint());
  Diagnostic problem{};
  problem.pointer = "/blocks/ratings/questions/0";
  problem.message = "a problem";
  views_.show_problems({problem}, {});
  QApplication::processEvents();
  EXPECT_EQ(field.mapTo(&views_, QPoint()), before);
  views_.show_problems({}, {});
  QApplication::processEvents();
  EXPECT_EQ(field.mapTo(&views_, QPoint()), before);
}

// A click that is aimed at a control does not hit its neighbour.
TEST_F(FormOfProtocol, KeepsWhatIsPointedAtInItsPlaceWhenProblemsAppear) {
  open(library_text("semantic_differential"));
  views_.setGeometry(0, 0, 760, 700);  // on the screen
  type_into("/blocks/ratings/questions/0/name", "rougher");
  control<QLineEdit>("/blocks/ratings/questions/1/name").setFocus();
  QApplication::processEvents();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of what was made again
  auto& aimed_at = child<QToolButton>(form(), "remove:/blocks/ratings/questions/3");
  child<QScrollArea>(form(), "form_area").ensureWidgetVisible(&aimed_at);
  QApplication::processEvents();
  const QPoint before = aimed_at.mapToGlobal(aimed_at.rect().center());
  QCursor::setPos(before);
  ASSERT_EQ(QApplication::widgetAt(before), &aimed_at);
  Diagnostic problem{};
  problem.pointer = "/blocks/ratings/questions/1/name";
  problem.message = "a problem";
  views_.show_problems({problem}, {});
  QApplication::processEvents();
  EXPECT_EQ(aimed_at.mapToGlobal(aimed_at.rect().center()), before);
}

// It is where the last click was, which may have opened the editor.
TEST_F(FormOfProtocol, KeepsTheFieldInUseWhereThePointerRests) {
  open(library_text("semantic_differential"));
  views_.setGeometry(0, 0, 760, 700);
  auto& field = control<QLineEdit>("/blocks/ratings/questions/1/name");
  field.setFocus();
  QApplication::processEvents();
  const auto& above = child<QToolButton>(form(), "open:/blocks/ratings/questions/0");
  QCursor::setPos(above.mapToGlobal(above.rect().center()));
  ASSERT_EQ(QApplication::widgetAt(QCursor::pos()), &above);
  form().show_text(text());
  ASSERT_TRUE(field.hasFocus());
  const QPoint before = field.mapTo(&views_, QPoint());
  Diagnostic problem{};
  problem.pointer = "/blocks/ratings/questions/0";
  problem.message = "a problem";
  views_.show_problems({problem}, {});
  QApplication::processEvents();
  EXPECT_EQ(field.mapTo(&views_, QPoint()), before);
}

TEST_F(FormOfProtocol, KeepsThePagesInTheirPlacesWhenProblemsAppear) {
  for (const char* language : {"de", "en"}) {
    apply_language(language);
    ProtocolViews views(declarations_of(built_in_models()));
    views.show();
    views.text().setPlainText(QString::fromStdString(library_text("amplitude_jnd")));
    views.show_form_if_possible();
    const auto& pages = child<QListWidget>(views, "form_pages");
    const auto places = [&] {
      QApplication::processEvents();
      std::vector<int> tops{};
      for (int row = 0; row < pages.count(); ++row) {
        tops.push_back(pages.visualItemRect(pages.item(row)).bottom());
      }
      return tops;
    };
    for (const int width : {900, 650, 590}) {
      views.resize(width, 700);
      views.show_problems({}, {});
      const std::vector<int> before = places();
      std::vector<Diagnostic> problems{};
      for (const FormPage& page : form_pages()) {
        Diagnostic problem{};
        problem.pointer = "/" + std::string(page.parts.empty() ? "title" : page.parts.front().key);
        problem.message = "a problem";
        problems.push_back(problem);
      }
      views.show_problems({}, problems);
      EXPECT_EQ(places(), before) << language << " " << width;
    }
    take_screenshot(views, language == std::string("de") ? "german-pages" : "pages", {650, 700});
  }
}

TEST_F(FormOfProtocol, ShowsTheNamesOfItsPagesInFull) {
  Diagnostic problem{};
  problem.pointer = "/flow/0";
  for (const char* language : {"de", "en"}) {
    apply_language(language);
    ProtocolViews views(declarations_of(built_in_models()));
    views.show();
    views.text().setPlainText(QString::fromStdString(library_text("amplitude_jnd")));
    views.show_form_if_possible();
    views.show_problems({problem}, {});
    const auto& pages = child<QListWidget>(views, "form_pages");
    for (const int width : {900, 590}) {
      views.resize(width, 700);
      QApplication::processEvents();
      for (int row = 0; row < pages.count(); ++row) {
        const QRect place = pages.visualItemRect(pages.item(row));
        constexpr int kPadding = 24;
        const QRect room(0, 0, place.width() - kPadding, 1000);
        const QRect needed =
            pages.fontMetrics().boundingRect(room, Qt::TextWordWrap, pages.item(row)->text());
        EXPECT_LE(needed.height(), place.height()) << pages.item(row)->text().toStdString();
        EXPECT_LE(needed.width(), room.width()) << pages.item(row)->text().toStdString();
      }
    }
  }
}

}  // namespace
}  // namespace asperity

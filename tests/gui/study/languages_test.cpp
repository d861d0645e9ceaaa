// The windows in another language: chosen in the menu, shown on the pages, with its own plurals.

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtCore/QPointer>
#include <QtCore/QRegularExpression>
#include <QtGui/QTextBlock>
#include <QtGui/QTextLayout>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QStackedWidget>

#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/editor/form/protocol_form.h"
#include "app/gui/editor/json_colors.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/editor/question_bar.h"
#include "app/gui/look/controls.h"
#include "app/gui/session/session_dialogs.h"
#include "app/gui/start/start_page.h"
#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/editor/library_text.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/screenshot.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

QString count_of(int people) {
  return QCoreApplication::translate("asperity::AnalysisPage", "%n participants", nullptr, people);
}

class Languages : public QuietHome {
 protected:
  ~Languages() override { apply_language("en"); }

  /// As a person does, in the menu.
  static void choose(StudyWindow& window, const QString& name) {
    for (QAction* action : window.findChildren<QAction*>()) {
      if (action->text() == name) return action->trigger();
    }
    ADD_FAILURE() << "no menu offers " << name.toStdString();
  }
  static QString navigation_of(StudyWindow& window) {
    QStringList names{};
    auto* list = window.findChild<QListWidget*>();
    for (int row = 0; list != nullptr && row < list->count(); ++row) {
      names.append(list->item(row)->text());
    }
    return names.join('|');
  }
};

/// On the smallest screen, 1280 × 720 without a frame: whatever page is shown, the window is as large
/// as it was, and the page has the room that it asks for.
void expect_every_page_to_fit(StudyWindow& window) {
  constexpr QSize kSmall{1264, 672};
  window.resize(kSmall);
  auto& pages = child<QStackedWidget>(window, "study_pages");
  for (int i = 0; i < pages.count(); ++i) {
    const QString key = pages.widget(i)->property("page").toString();
    if (key.isEmpty()) continue;
    window.show_page(key);
    QCoreApplication::processEvents();
    EXPECT_EQ(window.size(), kSmall) << key.toStdString();
    take_screenshot(window, QString("small-%1-%2").arg(language_choice(), key), kSmall);
    const QSize wanted = pages.widget(i)->minimumSizeHint();
    EXPECT_LE(wanted.width(), pages.width()) << key.toStdString();
    EXPECT_LE(wanted.height(), pages.height()) << key.toStdString();
    for (const auto* area : pages.widget(i)->findChildren<QScrollArea*>()) {
      if (!area->isVisible() || area->widget() == nullptr) continue;
      EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width())
          << key.toStdString();
    }
  }
}

TEST_F(Languages, AreEnglishAndGerman) {
  EXPECT_EQ(available_languages(), (QStringList{"en", "de"}));
}

TEST_F(Languages, HavePluralsOfTheirOwn) {
  apply_language("en");
  EXPECT_EQ(count_of(1), "1 participant");
  EXPECT_EQ(count_of(2), "2 participants");
  apply_language("de");
  EXPECT_EQ(count_of(1), "1 Versuchsperson");
  EXPECT_EQ(count_of(2), "2 Versuchspersonen");
}

TEST_F(Languages, ThatHaveNoTextsAreEnglish) {
  apply_language("de");
  apply_language("fr");
  EXPECT_EQ(count_of(1), "1 participant");
  apply_language("C");
  EXPECT_EQ(count_of(1), "1 participant");
}

TEST_F(Languages, OfARegionAreThatLanguage) {
  apply_language("de_AT");
  EXPECT_EQ(count_of(1), "1 Versuchsperson");
  apply_language("en_GB");
  EXPECT_EQ(count_of(1), "1 participant");
}

TEST_F(Languages, DistinguishAbortingASessionFromGoingBack) {
  apply_language("de");
  AbortDialog dialog(nullptr, [](const Phrase&) {});
  dialog.show();
  take_screenshot(dialog, "german-abort", QSize(900, 300));
  EXPECT_EQ(child<QPushButton>(dialog, "reason_given").text(), "Sitzung abbrechen");
  EXPECT_EQ(child<QPushButton>(dialog, "reason_cancel").text(), "Zurück");
  dialog.setAttribute(Qt::WA_DeleteOnClose, false);
}

TEST_F(Languages, KeepWhatIsShownOfAProtocol) {
  const std::filesystem::path folder = small_demo_study();
  const std::filesystem::path file = folder / "protocols" / "improved_recognition.json";
  write_file(file,
             replaced(library_text("improved_recognition"), "\"factors\": {",
                      "\"groups\": {\"factor\": \"ground\"}, "
                      "\"factors\": {\"ground\": {\"levels\": [\"dawn\", \"dusk\"]}, "),
             Overwrite::refuse);
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(folder));
  const auto editor = [&]() -> ProtocolEditorPage& {
    return *static_cast<ProtocolEditorPage*>(window.page("editor"));
  };
  window.show_page("editor");
  editor().open(file);
  const auto steps = [&]() -> StudyTable& { return child<StudyTable>(editor(), "plan_table"); };
  ASSERT_TRUE(eventually([&] { return steps().shown_rows() > 20; }));
  child<QComboBox>(editor(), "plan_group").setCurrentIndex(1);
  child<QSpinBox>(editor(), "plan_seed").setValue(5);
  QTest::qWait(100);
  steps().select("20");
  child<QPushButton>(editor(), "editor_show_screen").click();
  const auto form = [&]() -> ProtocolForm& { return child<ProtocolForm>(editor(), "editor_form"); };
  form().go_to("/flow/10/break_every_trials");
  QCoreApplication::processEvents();
  choose(window, QLocale("de").nativeLanguageName());
  ASSERT_TRUE(eventually([&] { return window.menuBar()->actions()[1]->text() == "&Ansicht"; }));
  ASSERT_TRUE(eventually([&] { return steps().selected_key() == "20"; }));
  EXPECT_EQ(window.shown_page(), "editor");
  EXPECT_EQ(child<QComboBox>(editor(), "plan_group").currentText(), "dusk");
  EXPECT_EQ(child<QSpinBox>(editor(), "plan_seed").value(), 5);
  EXPECT_EQ(child<QStackedWidget>(editor(), "editor_plan_side").currentIndex(), 1);
  EXPECT_EQ(form().page().id, "order");
  const auto* focused = qobject_cast<QLineEdit*>(form().focusWidget());
  ASSERT_NE(focused, nullptr) << "the field of the unfolded step";
  EXPECT_EQ(focused->parentWidget()->objectName(), "/flow/10/break_every_trials");

  child<QPushButton>(editor(), "editor_to_text").click();
  choose(window, "English");
  ASSERT_TRUE(eventually([&] { return window.menuBar()->actions()[1]->text() == "&View"; }));
  EXPECT_TRUE(eventually([&] { return child<QWidget>(editor(), "editor_text").isVisible(); }));
  child<QPushButton>(editor(), "editor_back").click();
  ASSERT_TRUE(eventually([&] { return window.shown_page() == "protocols"; }));
  const auto& protocols = child<StudyTable>(window, "protocols_table");
  EXPECT_TRUE(eventually([&] {
    return protocols.selected_key().endsWith("improved_recognition.json");
  })) << protocols.selected_key().toStdString();
}

TEST_F(Languages, KeepUnsavedChangesOfAProtocolAndTheirUndo) {
  const std::filesystem::path folder = small_demo_study();
  const std::filesystem::path file = folder / "protocols" / "improved_recognition.json";
  std::string content = library_text("improved_recognition");
  for (std::size_t at = 0; (at = content.find('\n', at)) != std::string::npos; at += 2) {
    content.replace(at, 1, "\r\n");
  }
  write_file(file, content, Overwrite::refuse);
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(folder));
  const auto editor = [&]() -> ProtocolEditorPage& {
    return *static_cast<ProtocolEditorPage*>(window.page("editor"));
  };
  const auto form = [&]() -> ProtocolForm& { return child<ProtocolForm>(editor(), "editor_form"); };
  const auto edit = [&]() -> ProtocolTextEdit& {
    return child<ProtocolTextEdit>(editor(), "editor_text");
  };
  const auto choose_and_wait = [&](const QString& name) {
    const QPointer<ProtocolEditorPage> before(&editor());
    choose(window, name);
    ASSERT_TRUE(eventually([&] { return before.isNull(); }));
    EXPECT_EQ(window.shown_page(), "editor");
    EXPECT_FALSE(child<QuestionBar>(editor(), "editor_question").isVisible());
    EXPECT_TRUE(editor().has_unsaved_changes());
    ASSERT_TRUE(eventually([&] { return editor().is_checked(); }));
  };
  window.show_page("editor");
  editor().open(file);
  form().go_to("/title");
  QCoreApplication::processEvents();
  auto* title = qobject_cast<QLineEdit*>(form().focusWidget());
  ASSERT_NE(title, nullptr);
  const QString former = title->text();
  title->setText("Typed");
  QTest::keyClicks(title, "!");  // not in the text while the field has the focus
  choose_and_wait(QLocale("de").nativeLanguageName());
  EXPECT_EQ(window.menuBar()->actions()[1]->text(), "&Ansicht");
  EXPECT_NE(editor().content().find("\"title\": \"Typed!\""), std::string::npos);
  title = qobject_cast<QLineEdit*>(form().focusWidget());
  ASSERT_NE(title, nullptr);
  EXPECT_EQ(title->text(), "Typed!");
  EXPECT_TRUE(child<QPushButton>(editor(), "editor_save").isEnabled());

  child<QPushButton>(editor(), "editor_to_text").click();
  QTest::keyClicks(&edit(), " ");
  choose_and_wait("&Dunkel");
  ASSERT_TRUE(eventually([&] {
    const auto formats = edit().document()->firstBlock().next().layout()->formats();
    return !formats.isEmpty() &&
           formats.first().format.foreground().color() == json_color(JsonToken::Kind::key, theme());
  }));
  take_screenshot(window, "editor-handed-over", QSize(1366, 900));
  choose_and_wait("&Hell");
  choose_and_wait("English");

  edit().undo();
  edit().undo();
  EXPECT_EQ(editor().content(), content);
  EXPECT_FALSE(editor().has_unsaved_changes());
  EXPECT_EQ(read_file(file), content);
  edit().redo();
  edit().redo();
  child<QPushButton>(editor(), "editor_save").click();
  choose(window, QLocale("de").nativeLanguageName());
  EXPECT_EQ(window.banner().text(), "The protocol is being saved.");
  ASSERT_TRUE(eventually([&] { return !editor().has_unsaved_changes(); }));
  EXPECT_EQ(read_file(file), editor().content());
  EXPECT_NE(read_file(file).find("Typed!"), std::string::npos);
  apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::light);
}

/// What the banner of a page states; empty without one.
QString news_of(const QWidget& page) {
  for (const Banner* const each : page.findChildren<Banner*>()) {
    if (each->isVisible()) return each->text();
  }
  return {};
}

/// A protocol in the text view of an editor that is made anew for another theme.
class HandedOver : public Languages {
 protected:
  ~HandedOver() override { apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::light); }

  void open(const std::string& content) {
    const std::filesystem::path folder = small_demo_study();
    file_ = folder / "protocols" / "improved_recognition.json";
    write_file(file_, content, Overwrite::refuse);
    window_.show();
    ASSERT_TRUE(window_.open_study(folder));
    window_.show_page("editor");
    editor().open(file_);
    child<QPushButton>(editor(), "editor_to_text").click();
    ASSERT_TRUE(eventually([&] { return editor().is_checked(); }));
  }
  /// `meanwhile` is done before the new page is there.
  void hand_over(
      const QString& theme, const std::function<void()>& meanwhile = [] {}) {
    const QPointer<ProtocolEditorPage> before(&editor());
    choose(window_, theme);
    meanwhile();
    ASSERT_TRUE(eventually([&] { return before.isNull(); }));
    EXPECT_EQ(window_.shown_page(), "editor");
    ASSERT_TRUE(eventually([&] { return editor().is_checked(); }));
  }
  ProtocolEditorPage& editor() { return *static_cast<ProtocolEditorPage*>(window_.page("editor")); }
  ProtocolTextEdit& edit() { return child<ProtocolTextEdit>(editor(), "editor_text"); }

  std::filesystem::path file_{};
  StudyWindow window_{};
};

TEST_F(HandedOver, IsUnderlinedAtTheSamePlaces) {
  open(replaced(library_text("improved_recognition"), R"("friction": 0.2)", R"("friction": "x")"));
  const auto underlined = [this] {
    QStringList words{};
    for (const QTextEdit::ExtraSelection& mark : edit().underlined()) {
      EXPECT_EQ(mark.cursor.document(), edit().document());
      words.append(mark.cursor.selectedText());
    }
    return words;
  };
  const QStringList before = underlined();
  ASSERT_FALSE(before.isEmpty());
  hand_over("&Dark");
  EXPECT_EQ(underlined(), before);
  QTest::keyClicks(&edit(), " ");
  EXPECT_TRUE(editor().has_unsaved_changes());
}

TEST_F(HandedOver, StaysReadOnlyWhereItCannotBeGivenBack) {
  std::string content = library_text("improved_recognition");
  content.replace(content.find('\n'), 1, "\r\n");  // only the first one
  open(content);
  ASSERT_TRUE(edit().isReadOnly());
  const QString why = news_of(editor());
  EXPECT_FALSE(why.isEmpty());
  hand_over("&Dark");
  EXPECT_TRUE(edit().isReadOnly());
  EXPECT_EQ(news_of(editor()), why);
  EXPECT_FALSE(editor().has_unsaved_changes());
  EXPECT_FALSE(child<QPushButton>(editor(), "editor_save").isEnabled());
  EXPECT_EQ(read_file(file_), content);
}

TEST_F(HandedOver, IsComparedWithAFileThatWasChangedMeanwhile) {
  const std::string content = library_text("improved_recognition");
  open(content);
  hand_over("&Dark", [&] { write_file(file_, content + " ", Overwrite::allow); });
  EXPECT_EQ(editor().content(), content + " ");
  EXPECT_TRUE(news_of(editor()).contains("changed outside the editor"));
  EXPECT_FALSE(editor().has_unsaved_changes());
  QTest::keyClicks(&edit(), " ");
  const std::string mine = editor().content();
  hand_over("&Light", [&] { write_file(file_, content + "\n", Overwrite::allow); });
  EXPECT_TRUE(child<QuestionBar>(editor(), "editor_question").isVisible());
  EXPECT_EQ(editor().content(), mine);
  EXPECT_TRUE(editor().has_unsaved_changes());
  child<QPushButton>(editor(), "editor_take_theirs").click();
  EXPECT_EQ(editor().content(), content + "\n");
  EXPECT_EQ(read_file(file_), content + "\n");
}

TEST_F(Languages, StayAsTheyAreWhereANameThatWasTypedIsRefused) {
  const std::filesystem::path folder = small_demo_study();
  const std::filesystem::path file = folder / "protocols" / "improved_recognition.json";
  write_file(file, library_text("improved_recognition"), Overwrite::refuse);
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(folder));
  window.show_page("editor");
  const QPointer<ProtocolEditorPage> editor(
      static_cast<ProtocolEditorPage*>(window.page("editor")));
  editor->open(file);
  auto& form = child<ProtocolForm>(*editor, "editor_form");
  form.go_to("/textures/metal");
  QCoreApplication::processEvents();
  auto* name = qobject_cast<QLineEdit*>(child<QWidget>(form, "name:/textures/metal").focusProxy());
  ASSERT_NE(name, nullptr);
  for (const QString& choice : {QLocale("de").nativeLanguageName(), QString("&Dark")}) {
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, "stone");
    choose(window, choice);
    QTest::qWait(50);  // in which the window would be filled anew
    ASSERT_FALSE(editor.isNull());
    EXPECT_EQ(window.shown_page(), "editor");
    EXPECT_TRUE(news_of(*editor).contains("stone")) << news_of(*editor).toStdString();
    EXPECT_EQ(window.menuBar()->actions()[1]->text(), "&View");
  }
  EXPECT_NE(language_choice(), "de");
  EXPECT_NE(theme_choice(), ThemeChoice::dark);
  QTest::keyClicks(name, "_2");  // the name as it was, with these letters
  choose(window, QLocale("de").nativeLanguageName());
  EXPECT_TRUE(eventually([&] { return editor.isNull(); }));
}

TEST_F(Languages, ReachThePagesOfTheOpenStudyFromTheMenu) {
  const std::filesystem::path folder = lively_study();
  StudyWindow window{};
  const SessionDesk desk(window, nullptr);
  window.show();
  ASSERT_TRUE(window.open_study(folder));
  choose(window, QLocale("de").nativeLanguageName());
  ASSERT_TRUE(eventually([&] { return window.menuBar()->actions()[1]->text() == "&Ansicht"; }));
  EXPECT_EQ(language_choice(), "de");
  const QString pages = navigation_of(window);
  for (const char* name : {"Protokolle", "Versuchspersonen", "Sitzungen", "Reize", "Werkstatt"}) {
    EXPECT_TRUE(pages.contains(name)) << pages.toStdString();
  }
  const auto picture_of = [&window](const char* page, const char* table, int rows) {
    window.show_page(page);
    EXPECT_TRUE(eventually([&] { return child<StudyTable>(window, table).shown_rows() == rows; }));
    child<StudyTable>(window, table).selectRow(0);
    take_screenshot(window, QString("german-study-") + page);
  };
  picture_of("participants", "participants_table", 12);
  // Dates are read whole in a small window, next to names of columns that are longer in German.
  window.resize(1264, 672);
  const QAbstractItemView& people = child<StudyTable>(window, "participants_table");
  EXPECT_TRUE(eventually([&] {
    return child<StudyTable>(window, "participants_table").columnWidth(6) >=
           people.sizeHintForColumn(6);
  }));
  picture_of("stimuli", "stimuli_table", 16);
  picture_of("sessions", "sessions_table", 15);
  EXPECT_EQ(
      child<StudyTable>(window, "sessions_table").model()->headerData(0, Qt::Horizontal).toString(),
      "Vp");

  picture_of("protocols", "protocols_table", 4);
  child<QPushButton>(window, "protocol_start").click();
  const auto* start = window.findChild<StartPage*>();
  ASSERT_NE(start, nullptr);
  EXPECT_TRUE(eventually([&] {
    const std::vector<QString> reasons = start->reasons();
    return start->is_read() &&
           std::none_of(reasons.begin(), reasons.end(),
                        [](const QString& reason) { return reason.contains("Checkliste wird"); });
  }));
  EXPECT_EQ(child<QPushButton>(window, "start").text(), "Sitzung starten");
  for (const auto* label : start->findChildren<QLabel*>(QRegularExpression("^check_(?!summary)"))) {
    EXPECT_FALSE(label->text().contains(QRegularExpression("\\b(the|not|is|of)\\b")))
        << label->text().toStdString();
  }
  take_screenshot(window, "german-study-start");
  for (const char* page : {"workbench", "analysis", "devices"}) {
    window.show_page(page);
    take_screenshot(window, QString("german-study-") + page);
  }
  expect_every_page_to_fit(window);

  window.show_page("sessions");  // what is filled in for a session is not thrown away
  choose(window, "English");
  ASSERT_TRUE(eventually([&] { return window.menuBar()->actions()[1]->text() == "&View"; }));
  EXPECT_TRUE(navigation_of(window).contains("Sessions"));
  expect_every_page_to_fit(window);
}

}  // namespace
}  // namespace asperity

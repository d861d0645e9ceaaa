// The study window as a person meets it: from the welcome page to a study and back.

#include "app/gui/window/study_window.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <unistd.h>

#include <QtCore/QFile>
#include <QtCore/QPointer>
#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QTableWidget>

#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/study/share_study_dialog.h"
#include "app/gui/window/navigation_list.h"
#include "app/gui/workbench/parameter_form.h"
#include "app/gui/workbench/workbench_page.h"
#include "app/tasks/new_study.h"
#include "results_schema/sqlite.h"
#include "results_schema/study_sharing.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

class StudyWindowTest : public QuietHome {
 protected:
  void click(StudyWindow& window, const char* button) {
    QTest::mouseClick(&child<QPushButton>(window, button), Qt::LeftButton);
  }
  void choose_to_open(StudyWindow& window, const std::filesystem::path& folder) {
    click(window, "welcome_open");
    auto* chooser = window.findChild<QFileDialog*>();
    ASSERT_NE(chooser, nullptr);
    emit chooser->fileSelected(QString::fromStdString(folder.string()));
    chooser->close();
  }
};

TEST_F(StudyWindowTest, MakesTheDemoStudyByOneClickNextToOtherFoldersAndThenOpensIt) {
  const QString place = child<QLabel>(StudyWindow(), "welcome_demo_place").text();
  EXPECT_TRUE(place.contains("created in ~/Asperity/demo (about")) << place.toStdString();
  std::filesystem::create_directories(home() / "Asperity" / "demo" / "of something else");
  {
    StudyWindow window{};
    window.show();
    click(window, "welcome_demo");
    ASSERT_TRUE(eventually([&] { return window.study() != nullptr; }));
    EXPECT_EQ(window.study()->folder(), home() / "Asperity" / "demo-2");
    EXPECT_EQ(window.windowTitle(), "demo-2 – Asperity");
    EXPECT_TRUE(holds_demo_study(window.study()->folder()));
  }
  StudyWindow window{};
  click(window, "welcome_demo");
  ASSERT_NE(window.study(), nullptr);  // without making anything
  EXPECT_EQ(window.study()->folder(), home() / "Asperity" / "demo-2");
}

TEST_F(StudyWindowTest, PassesOverADemoStudyOfAnotherSchema) {
  const std::filesystem::path older = home() / "Asperity" / "demo";
  std::filesystem::create_directories(older.parent_path());
  std::filesystem::copy(small_demo_study(), older, std::filesystem::copy_options::recursive);
  EXPECT_TRUE(holds_demo_study(older));
  Database(older, older / "study.sqlite", Database::Mode::read_write)
      .execute("PRAGMA user_version = 1");
  EXPECT_FALSE(holds_demo_study(older));
  const QString place = child<QLabel>(StudyWindow(), "welcome_demo_place").text();
  EXPECT_TRUE(place.contains("created in ~/Asperity/demo-2 (about")) << place.toStdString();
}

TEST_F(StudyWindowTest, OpensWhereAndAsLargeAsItWasLeftHoweverOften) {
  QRect was{};
  for (int time = 0; time < 3; ++time) {
    StudyWindow window{};
    if (time == 0) {
      window.resize(777, 700);
      window.move(16, 24);
    }
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience_ms));
    if (time == 0) was = window.geometry();
    EXPECT_EQ(window.geometry(), was) << "opened " << time << " times before";
    if (time == 2) window.showMaximized();
    EXPECT_TRUE(window.close());
  }
  EXPECT_EQ(was.size(), QSize(777, 700));
  StudyWindow window{};
  window.show();
  EXPECT_TRUE(window.isMaximized());
}

TEST_F(StudyWindowTest, LeavesNothingOfACancelledDemoStudy) {
  StudyWindow window{};
  window.show();
  click(window, "welcome_demo");
  click(window, "welcome_demo_cancel");
  auto& demo = child<QPushButton>(window, "welcome_demo");
  ASSERT_TRUE(eventually([&] { return demo.isEnabled(); }));
  EXPECT_EQ(window.study(), nullptr);
  EXPECT_FALSE(std::filesystem::exists(home() / "Asperity" / "demo"));
}

TEST_F(StudyWindowTest, MakesAStudyOfTheNameThatIsTyped) {
  StudyWindow window{};
  window.show();
  click(window, "welcome_new");
  auto& dialog = child<QDialog>(window, "new_study_dialog");
  auto& create = child<QPushButton>(dialog, "new_study_create");
  EXPECT_FALSE(create.isEnabled());
  child<QLineEdit>(dialog, "new_study_place")
      .setText(QString::fromStdString((home() / "studies").string()));
  child<QLineEdit>(dialog, "metadata_authors").setText("Doe, Jane");
  QTest::keyClicks(&child<QLineEdit>(dialog, "new_study_name"), "Rough surfaces");
  ASSERT_TRUE(create.isEnabled());
  take_screenshot(dialog, "new-study", dialog.size());
  QTest::keyClick(&child<QLineEdit>(dialog, "new_study_name"), Qt::Key_Return);
  ASSERT_TRUE(eventually([&] { return window.study() != nullptr; }));
  EXPECT_EQ(window.study()->folder(), home() / "studies" / "Rough surfaces");
  EXPECT_EQ(window.study()->study().name(), "Rough surfaces");
}

TEST_F(StudyWindowTest, MakesAStudyOfAnEmptyFolder) {
  const std::filesystem::path folder = home() / "empty";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / ".DS_Store") << "of a desktop";
  {
    StudyWindow window{};
    window.show();
    click(window, "welcome_new");
    auto& dialog = child<QDialog>(window, "new_study_dialog");
    child<QLineEdit>(dialog, "new_study_place").setText("~");
    child<QLineEdit>(dialog, "new_study_name").setText("empty");
    EXPECT_EQ(child<QLabel>(dialog, "new_study_what_follows").text(),
              "~/empty is an empty folder. It will become the study.");
    EXPECT_EQ(child<QPushButton>(dialog, "new_study_create").text(), "Create here");
    take_screenshot(dialog, "new-study-in-empty-folder", dialog.size());
  }
  StudyWindow window{};
  window.resize(1366, 900);
  window.show();
  choose_to_open(window, folder);
  EXPECT_EQ(window.study(), nullptr);
  EXPECT_EQ(window.banner().text(),
            "~/empty is an empty folder and not yet a study. It can become one.");
  take_screenshot(window, "empty-folder-opened");
  child<QPushButton>(window.banner(), "banner_action").click();
  ASSERT_TRUE(eventually([&] { return window.study() != nullptr; }));
  EXPECT_EQ(window.study()->folder(), folder);
  EXPECT_EQ(window.study()->study().name(), "empty");
}

// As the mount point of a disk that is not connected.
TEST_F(StudyWindowTest, OffersNoSecondStudyInTheEmptyFolderOfAKnownOne) {
  const std::filesystem::path folder = home() / "mounted";
  std::filesystem::create_directories(folder);
  StudyWindow window{};
  window.show();
  const auto expect_no_offer = [&] {
    EXPECT_TRUE(window.banner().text().startsWith("The study could not be opened"))
        << window.banner().text().toStdString();
    EXPECT_FALSE(child<QPushButton>(window.banner(), "banner_action").isVisible());
  };
  EXPECT_FALSE(window.open_study(folder));  // as the command line and the list of recent studies do
  expect_no_offer();
  remember_study(folder, "mounted");
  choose_to_open(window, folder);
  expect_no_offer();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(StudyWindowTest, OpensARelativeFolder) {
  const std::filesystem::path place = std::filesystem::canonical(home());
  new_study(place / "study");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(place);
  StudyWindow window{};
  EXPECT_TRUE(window.open_study("./study"));
  std::filesystem::current_path(before);
  ASSERT_NE(window.study(), nullptr);
  EXPECT_EQ(window.study()->folder(), place / "study");
  EXPECT_EQ(recent_studies().at(0).folder, place / "study");
}

TEST_F(StudyWindowTest, RefusesANameThatIsTaken) {
  std::filesystem::create_directories(home() / "taken" / "letters");
  new_study(home() / "study");
  StudyWindow window{};
  window.show();
  click(window, "welcome_new");
  auto& dialog = child<QDialog>(window, "new_study_dialog");
  child<QLineEdit>(dialog, "new_study_place").setText("~");
  child<QLineEdit>(dialog, "new_study_name").setText("taken");
  EXPECT_FALSE(child<QPushButton>(dialog, "new_study_create").isEnabled());
  EXPECT_EQ(child<QLabel>(dialog, "new_study_what_follows").text(),
            "~/taken already exists and is not an empty folder. Choose another name or another "
            "parent folder, or move the other files out of that folder.");
  child<QLineEdit>(dialog, "new_study_name").setText("study");
  EXPECT_FALSE(child<QPushButton>(dialog, "new_study_create").isEnabled());
  EXPECT_EQ(child<QLabel>(dialog, "new_study_what_follows").text(),
            "~/study is already a study. Open it, or choose another name.");
}

TEST_F(StudyWindowTest, SaysOnTheBannerWhatCannotBeOpened) {
  StudyWindow window{};
  window.show();
  EXPECT_FALSE(window.open_study(home() / "nothing"));
  EXPECT_EQ(window.study(), nullptr);
  EXPECT_TRUE(window.banner().isVisible());
  EXPECT_TRUE(window.banner().text().contains("nothing"));
}

/// Runs as somebody who may not write here; the superuser may write everywhere.
class AsSomebodyElse {
 public:
  AsSomebodyElse() : was_(::geteuid()) {
    if (was_ == 0 && ::seteuid(65534) != 0) throw std::runtime_error("no other user");
  }
  ~AsSomebodyElse() {
    if (was_ == 0 && ::seteuid(0) != 0) std::abort();
  }
  AsSomebodyElse(const AsSomebodyElse&) = delete;
  AsSomebodyElse& operator=(const AsSomebodyElse&) = delete;

 private:
  uid_t was_;
};

TEST_F(StudyWindowTest, SaysThatAFolderForANewStudyCannotBeRead) {
  using std::filesystem::perms;
  std::filesystem::create_directories(home() / "closed");
  std::filesystem::permissions(home(), perms::all);  // the way there
  std::filesystem::permissions(home() / "closed", perms::none);
  {
    const AsSomebodyElse somebody_else;
    StudyWindow window{};
    window.show();
    click(window, "welcome_new");
    auto& dialog = child<QDialog>(window, "new_study_dialog");
    child<QLineEdit>(dialog, "new_study_place").setText("~");
    child<QLineEdit>(dialog, "new_study_name").setText("closed");
    EXPECT_EQ(child<QLabel>(dialog, "new_study_what_follows").text(),
              "~/closed already exists and cannot be read, so that it is unknown whether it is "
              "empty. Choose another name or another parent folder.");
    EXPECT_FALSE(child<QPushButton>(dialog, "new_study_create").isEnabled());
  }
  std::filesystem::permissions(home() / "closed", perms::all);
}

TEST_F(StudyWindowTest, ShowsAStudyThatCanOnlyBeReadAndOffersNothingThatWrites) {
  using std::filesystem::perms;
  const std::filesystem::path folder = lively_study();
  const perms reading = perms::owner_read | perms::group_read | perms::others_read |
                        perms::owner_exec | perms::group_exec | perms::others_exec;
  for (const auto& part : {home(), folder.parent_path()}) {
    std::filesystem::permissions(part, perms::all);  // the way there
  }
  const std::vector<std::filesystem::path> read_only = {folder, folder / "study.sqlite",
                                                        folder / "recordings", folder / "locks"};
  for (const auto& part : read_only) std::filesystem::permissions(part, reading);
  {
    const AsSomebodyElse somebody_else;
    StudyWindow window{};
    window.resize(1366, 768);
    window.show();
    ASSERT_TRUE(window.open_study(folder));
    EXPECT_TRUE(window.banner().text().startsWith("This study is read-only"))
        << window.banner().text().toStdString();
    auto& table = child<StudyTable>(window, "protocols_table");
    ASSERT_TRUE(eventually([&] { return table.shown_rows() == 4; }));
    table.select(
        QString::fromStdString((folder / "protocols" / "chapter_recognition.json").string()));
    for (const char* button : {"protocols_new", "protocol_start", "protocol_simulate"}) {
      EXPECT_FALSE(child<QPushButton>(window, button).isEnabled()) << button;
    }
    EXPECT_TRUE(child<QPushButton>(window, "protocol_preview").isEnabled());
    EXPECT_EQ(child<QLabel>(window, "protocol_reason").text(),
              "This study is read-only: no session can be stored. Copy it to a folder that you may "
              "write to.");
    take_screenshot(window, "study-read-only");
    window.show_page("sessions");
    auto& sessions = child<StudyTable>(window, "sessions_table");
    ASSERT_TRUE(eventually([&] { return sessions.shown_rows() == 15; }));
    child<QLineEdit>(window, "sessions_filter").setText("P012");
    ASSERT_TRUE(eventually([&] { return sessions.shown_rows() == 1; }));
    sessions.selectRow(0);
    EXPECT_FALSE(child<QPushButton>(window, "sessions_resume").isEnabled());
    EXPECT_EQ(child<QLabel>(window, "sessions_reason").text(),
              "This study is read-only: no session can be stored. Copy it to a folder that you may "
              "write to.");
    click(window, "sessions_open");
    EXPECT_FALSE(child<QPushButton>(window, "trials_exclude").isEnabled());
  }
  for (const auto& part : read_only) std::filesystem::permissions(part, perms::all);
}

TEST_F(StudyWindowTest, ListsRecentStudiesLatestFirstAndGreysThoseThatAreGone) {
  new_study(home() / "first");
  new_study(home() / "second");
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(home() / "first"));
  ASSERT_TRUE(window.open_study(home() / "second"));
  window.close_study();
  std::filesystem::remove_all(home() / "first");
  child<QTableWidget>(window, "welcome_recent");
  StudyWindow another{};
  another.show();
  auto& recent = child<QTableWidget>(another, "welcome_recent");
  ASSERT_TRUE(eventually([&] { return recent.rowCount() == 2; }));
  EXPECT_EQ(recent.item(0, 0)->text(), "second");
  EXPECT_EQ(recent.item(0, 1)->text(), "~/second");
  EXPECT_EQ(recent.item(1, 2)->text(), "study not found");
  EXPECT_EQ(recent.item(1, 0)->foreground().color(), theme().muted);

  recent.selectRow(1);
  EXPECT_FALSE(child<QPushButton>(another, "welcome_recent_open").isEnabled());
  click(another, "welcome_recent_forget");
  ASSERT_TRUE(eventually([&] { return recent.rowCount() == 1; }));
  recent.selectRow(0);
  click(another, "welcome_recent_open");
  ASSERT_NE(another.study(), nullptr);
  EXPECT_EQ(another.windowTitle(), "second – Asperity");
}

TEST_F(StudyWindowTest, SharesTheStudyWithAGroup) {
  const std::filesystem::path folder = home() / "mine";
  new_study(folder);
  StudyWindow window{};
  auto& share = child<QAction>(window, "menu_share_study");
  EXPECT_FALSE(share.isEnabled());
  window.show();
  ASSERT_TRUE(window.open_study(folder));
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(folder).permissions(), perms::owner_all);
  share.trigger();
  auto& dialog = child<QDialog>(window, "share_study_dialog");
  EXPECT_EQ(child<QComboBox>(dialog, "share_study_group").currentText().toStdString(),
            group_of(folder));
  EXPECT_EQ(child<QLabel>(dialog, "share_study_now").text(), "At present the study is not shared.");
  take_screenshot(dialog, "share-study", dialog.size());
  click(window, "share_study_share");
  EXPECT_EQ(
      child<QLabel>(ShareStudyDialog(folder, nullptr), "share_study_now").text().toStdString(),
      "At present the study is shared with the group “" + group_of(folder) + "”.");
  EXPECT_EQ(std::filesystem::status(folder).permissions(),
            perms::owner_all | perms::group_all | perms::set_gid);
  EXPECT_EQ(std::filesystem::status(folder / "study.sqlite").permissions(),
            perms::owner_read | perms::owner_write | perms::group_read | perms::group_write);
}

TEST_F(StudyWindowTest, StoresTheMetadataOfTheStudy) {
  new_study(home() / "study");
  StudyWindow window{};
  auto& metadata = child<QAction>(window, "menu_metadata");
  EXPECT_FALSE(metadata.isEnabled());
  window.show();
  ASSERT_TRUE(window.open_study(home() / "study"));
  metadata.trigger();
  child<QLineEdit>(window, "metadata_authors").setText("Doe, Jane; Roe, Richard ;");
  child<QComboBox>(window, "metadata_license").setCurrentText("CC-BY-4.0");
  auto& dialog = child<QDialog>(window, "metadata_dialog");
  take_screenshot(dialog, "study-metadata", dialog.size());
  click(window, "metadata_save");
  const StudyMetadata expected{.authors = {"Doe, Jane", "Roe, Richard"}, .license = "CC-BY-4.0"};
  EXPECT_EQ(window.study()->study().metadata(), expected);
  ASSERT_TRUE(eventually([&] { return window.findChild<QDialog*>("metadata_dialog") == nullptr; }));
  metadata.trigger();
  EXPECT_EQ(child<QLineEdit>(window, "metadata_authors").text(), "Doe, Jane; Roe, Richard");
  child<QComboBox>(window, "metadata_license").setCurrentText("");
  child<QLineEdit>(window, "metadata_ethics").setText("Board, 12/2026");
  click(window, "metadata_save");
  EXPECT_EQ(window.study()->study().metadata().license, std::nullopt);
  EXPECT_EQ(window.study()->study().metadata().ethics_approval, "Board, 12/2026");
}

TEST_F(StudyWindowTest, SaysWhenTheStudyDisappears) {
  new_study(home() / "study");
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(home() / "study"));
  std::filesystem::rename(home() / "study", home() / "elsewhere");
  ASSERT_TRUE(eventually([&] { return window.banner().isVisible(); }));
  EXPECT_TRUE(window.banner().text().startsWith("The study is no longer at ~/study"));
}

TEST_F(StudyWindowTest, DoesNotCloseWhileBusyAndSaysWhy) {
  StudyWindow window{};
  window.show();
  window.set_busy("A session is running.");
  window.close();
  EXPECT_TRUE(window.isVisible());
  EXPECT_EQ(window.banner().text(), "A session is running.");
  window.set_busy({});
  window.close();
  EXPECT_FALSE(window.isVisible());
}

// To make them takes longer than everything else of opening a study.
TEST_F(StudyWindowTest, MakesALargePageWhenItIsFirstWanted) {
  const std::filesystem::path folder = small_demo_study();
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(folder));
  EXPECT_EQ(window.findChild<WorkbenchPage*>(), nullptr);
  EXPECT_EQ(window.shown_page(), "protocols");
  const auto& list = child<NavigationList>(window, "navigation");
  EXPECT_EQ(list.count(), 7) << "and is in the navigation all the same";
  window.show_page("workbench");
  const QPointer<WorkbenchPage> made = window.findChild<WorkbenchPage*>();
  ASSERT_FALSE(made.isNull());
  EXPECT_EQ(window.shown_page(), "workbench");
  window.show_page("protocols");
  EXPECT_EQ(window.page("workbench"), made) << "once";
  EXPECT_EQ(window.page("no such page"), nullptr);
  ASSERT_TRUE(window.open_study(folder));
  EXPECT_TRUE(made.isNull());
  EXPECT_EQ(window.findChild<WorkbenchPage*>(), nullptr);
}

/// Counts how often it came into sight and went out of it.
class CountingPage final : public QWidget {
 public:
  struct Counts {
    int shown = 0;
    int hidden = 0;
  };
  explicit CountingPage(Counts& counts) : counts_(counts) {}

 protected:
  void showEvent(QShowEvent*) override { ++counts_.shown; }
  void hideEvent(QHideEvent*) override { ++counts_.hidden; }

 private:
  Counts& counts_;
};

// A page that is shown begins to work: to read the study, to look for devices.
TEST_F(StudyWindowTest, ShowsNoPageOnTheWayWhenItIsClosed) {
  const std::filesystem::path folder = home() / "study";
  new_study(folder);
  CountingPage::Counts other{};
  CountingPage::Counts last{};
  StudyWindow window{};
  ASSERT_TRUE(window.open_study(folder));
  window.add_page("other", {}, new CountingPage(other));
  window.add_page("last", {}, new CountingPage(last));
  window.show_page("last");
  window.show();
  ASSERT_EQ(last.shown, 1);
  window.close_study();
  EXPECT_GE(last.hidden, 1) << "it heard of its end";
  EXPECT_EQ(other.shown, 0);
}

TEST_F(StudyWindowTest, KeepsTheWorkbenchThroughAChangeOfTheme) {
  const std::filesystem::path folder = small_demo_study();
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(folder));
  window.show_page("workbench");
  const auto bench = [&window] { return qobject_cast<WorkbenchPage*>(window.page("workbench")); };
  bench()->open_file(folder / "stimuli" / "brick.png");
  ASSERT_TRUE(eventually([&] { return bench()->field() != nullptr && bench()->is_settled(); }));
  const std::shared_ptr<const HeightField> field = bench()->field();
  const auto chosen = [&bench](const char* model) { return bench()->findChild<QCheckBox*>(model); };
  const bool had_height_map = chosen("model_height_map")->isChecked();
  chosen("model_height_map")->setChecked(!had_height_map);
  chosen("model_stochastic")->setChecked(true);
  const ParameterValues softer{{"stiffness_N_per_m", 400.0}};
  bench()->findChild<ParameterForm*>("surface")->set_values(softer);
  bench()->findChild<QComboBox*>("force_component")->setCurrentIndex(1);
  const QPointer<WorkbenchPage> before = bench();
  const auto actions = window.findChildren<QAction*>();
  const auto dark = std::find_if(actions.begin(), actions.end(),
                                 [](const QAction* action) { return action->text() == "&Dark"; });
  ASSERT_NE(dark, actions.end());
  (*dark)->trigger();
  ASSERT_TRUE(eventually([&] { return before.isNull() && bench() != nullptr; }));
  EXPECT_EQ(bench()->field(), field);
  EXPECT_EQ(chosen("model_height_map")->isChecked(), !had_height_map);
  EXPECT_TRUE(chosen("model_stochastic")->isChecked());
  EXPECT_EQ(bench()->findChild<ParameterForm*>("surface")->given(), softer);
  EXPECT_EQ(bench()->findChild<QComboBox*>("force_component")->currentIndex(), 1);
  EXPECT_TRUE(bench()->property("keep").toString().isEmpty()) << "it was saved, and still is";
  EXPECT_EQ(window.shown_page(), "workbench");
  apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::light);
}

TEST_F(StudyWindowTest, RemembersTheThemeUntilTheNextStart) {
  EXPECT_EQ(theme_choice(), ThemeChoice::system) << "until one is chosen";
  for (const auto choice : {ThemeChoice::dark, ThemeChoice::light, ThemeChoice::system}) {
    remember_theme(choice);
    EXPECT_EQ(theme_choice(), choice);
  }
}

TEST_F(StudyWindowTest, OffersThePlaceOfTheLastStudyForTheNext) {
  new_study(home() / "studies" / "first");
  StudyWindow window{};
  window.show();
  click(window, "welcome_new");
  EXPECT_EQ(child<QLineEdit>(window, "new_study_place").text(), "~/Asperity");
  child<QDialog>(window, "new_study_dialog").close();
  ASSERT_TRUE(window.open_study(home() / "studies" / "first"));
  window.close_study();
  const QPointer<QDialog> before = window.findChild<QDialog*>("new_study_dialog");
  ASSERT_TRUE(eventually([&] { return before.isNull(); }));
  click(window, "welcome_new");
  EXPECT_EQ(child<QLineEdit>(window, "new_study_place").text(), "~/studies");
}

// The room of a laptop with 1366 x 768 pixels at 150 %: what does not fit is further down, and whole.
TEST_F(StudyWindowTest, ScrollsTheWelcomePageOnASmallScreen) {
  new_study(home() / "Rough surfaces 2026");
  remember_study(home() / "Rough surfaces 2026", "Rough surfaces 2026");
  StudyWindow window{};
  const auto& recent = child<QTableWidget>(window, "welcome_recent");
  ASSERT_TRUE(eventually([&] { return recent.rowCount() == 1; }));
  window.resize(895, 464);
  window.show();
  const auto& area = child<QScrollArea>(window, "welcome_area");
  ASSERT_TRUE(
      eventually([&] { return area.widget()->height() > area.viewport()->height() + 100; }));
  for (const char* const name : {"welcome_demo", "welcome_new", "welcome_recent_open"}) {
    const auto& button = child<QPushButton>(window, name);
    EXPECT_GE(button.height(), button.sizeHint().height()) << name;
    const auto place = [&] {
      return QRect(button.mapTo(area.widget(), QPoint(0, 0)), button.size());
    };
    ASSERT_TRUE(eventually([&] { return area.widget()->rect().contains(place()); }))
        << name << " reaches " << place().bottom() << " of " << area.widget()->height();
  }
  for (const QLabel* label : area.findChildren<QLabel*>()) {
    if (!label->isVisibleTo(&area) || label->text().isEmpty()) continue;
    EXPECT_GE(label->height(), label->heightForWidth(label->width()))
        << label->text().toStdString();
  }
  take_screenshot(window, "study-welcome_895x464", {895, 464});
}

TEST_F(StudyWindowTest, WelcomePictures) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) GTEST_SKIP() << "no folder for pictures";
  new_study(home() / "Rough surfaces 2026");
  remember_study(home() / "Lost on a stick", "Lost on a stick");
  remember_study(home() / "Rough surfaces 2026", "Rough surfaces 2026");
  StudyWindow window{};
  auto& recent = child<QTableWidget>(window, "welcome_recent");
  ASSERT_TRUE(eventually([&] { return recent.rowCount() == 2; }));
  take_screenshot(window, "study-welcome");
}

}  // namespace
}  // namespace asperity

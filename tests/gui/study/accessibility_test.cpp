// Every page and dialog, as somebody meets them who has a keyboard and a screen reader.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QTableWidget>

#include "app/gui/base/documents.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/data/attempt_page.h"
#include "app/gui/devices/driver_setup.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/session/session_dialogs.h"
#include "app/gui/session/session_window.h"
#include "app/gui/start/start_page.h"
#include "app/gui/study/about_dialog.h"
#include "app/gui/study/metadata_dialog.h"
#include "app/gui/study/new_study_dialog.h"
#include "app/gui/study/plugin_loading.h"
#include "app/gui/study/plugins_dialog.h"
#include "app/gui/study/share_study_dialog.h"
#include "app/gui/study/trials_page.h"
#include "app/gui/study/withdraw_dialog.h"
#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/accessible.h"

namespace asperity {
namespace {

class Accessibility : public QuietHome, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override { apply_language(GetParam()); }
  ~Accessibility() override { apply_language("en"); }

  static void expect_accessible(const QWidget& window, const QString& what) {
    // What appears when work in the background ends is laid out by later events.
    const auto complaints = [&window] {
      return (nameless_controls(window) + steps_against_reading(window) +
              told_by_color_alone(window))
          .join('\n')
          .toStdString();
    };
    EXPECT_TRUE(eventually([&complaints] { return complaints().empty(); }))
        << what.toStdString() << '\n'
        << complaints();
  }

  /// The page that is shown, as it is, and with each of its banners.
  static void expect_accessible_page(const StudyWindow& window, const QString& what) {
    expect_accessible(window, what);
    const QWidget& page = *child<QStackedWidget>(window, "study_pages").currentWidget();
    QList<Banner*> banners = page.findChildren<Banner*>();
    EXPECT_FALSE(banners.empty()) << what.toStdString();
    banners << &child<Banner>(window, "study_banner");
    for (Banner* banner : banners) banner->show_news(State::look, "A message", "Try again");
    expect_accessible(window, what + " with banners");
    for (Banner* banner : banners) banner->hide();
  }

  /// Deletes the dialog.
  static void expect_accessible_dialog(QDialog* dialog) {
    const std::unique_ptr<QDialog> shown(dialog);
    shown->setAttribute(Qt::WA_DeleteOnClose, false);  // it may close when its work ends
    shown->show();
    expect_accessible(*shown, shown->metaObject()->className());
    // Nothing is found in a hidden window.
    EXPECT_TRUE(shown->isVisible()) << shown->metaObject()->className();
  }
};

/// Fills pages that need a selection.
void fill_page(StudyWindow& window, const std::string& key) {
  QWidget* page = window.page(QString::fromStdString(key));
  const std::filesystem::path& folder = window.study()->folder();
  const Study study = Study::open(folder, Access::read_only);
  const std::int64_t session = study.sessions().front().id;
  if (auto* editor = qobject_cast<ProtocolEditorPage*>(page)) {
    editor->open(folder / "protocols" / "chapter_recognition.json");
  }
  if (auto* trials = qobject_cast<TrialsPage*>(page)) trials->show_session(session);
  if (auto* attempt = qobject_cast<AttemptPage*>(page)) {
    attempt->show_attempt(study.attempts(session).front().id);
  }
}

TEST_P(Accessibility, EveryPageHasNamesAndTheOrderOfReading) {
  const std::filesystem::path folder = lively_study();
  StudyWindow window{};
  const SessionDesk desk(window, nullptr);
  window.resize(1280, 720);
  window.show();
  expect_accessible_page(window, "welcome");
  ASSERT_TRUE(window.open_study(folder));
  const auto& pages = child<QStackedWidget>(window, "study_pages");
  for (const char* const key :
       {"protocols", "participants", "sessions", "stimuli", "workbench", "analysis", "devices",
        "device_test", "editor", "trials", "attempt"}) {
    fill_page(window, key);
    window.show_page(key);
    ASSERT_EQ(window.shown_page(), key);
    (void)eventually([&window] {
      const auto* table = window.findChild<QWidget*>("study_pages")->findChild<StudyTable*>();
      return table == nullptr || !table->isVisible() || table->shown_rows() > 0;
    });
    expect_accessible_page(window, key);
  }
  EXPECT_GE(pages.count(), 11);

  window.show_page("protocols");
  auto& protocols = child<StudyTable>(window, "protocols_table");
  ASSERT_TRUE(eventually([&] { return protocols.shown_rows() > 0; }));
  protocols.selectRow(0);
  child<QPushButton>(window, "protocol_start").click();
  const auto* start = window.findChild<StartPage*>();
  ASSERT_NE(start, nullptr);
  EXPECT_TRUE(eventually([&] { return start->is_read(); }));
  expect_accessible_page(window, "start");

  expect_accessible_dialog(new WithdrawDialog(*window.study(), "P001"));
}

TEST_P(Accessibility, EveryEmptyPageHasNamesAndTheOrderOfReading) {
  Study::create(home() / "empty", "empty");
  StudyWindow window{};
  const SessionDesk desk(window, nullptr);
  window.resize(1280, 720);
  window.show();
  ASSERT_TRUE(window.open_study(home() / "empty"));
  for (const char* const key : {"protocols", "participants", "sessions", "stimuli", "analysis"}) {
    window.show_page(key);
    EXPECT_TRUE(eventually([&window] {
      const auto empty = window.findChildren<EmptyState*>();
      return std::any_of(empty.begin(), empty.end(),
                         [](const EmptyState* state) { return state->isVisible(); });
    })) << key;
    expect_accessible_page(window, QString("empty %1").arg(key));
  }
}

TEST_P(Accessibility, EveryDialogHasNamesAndTheOrderOfReading) {
  expect_accessible_dialog(new AboutDialog());
  expect_accessible_dialog(new DocumentDialog("methods.md"));
  expect_accessible_dialog(new MetadataDialog(StudyMetadata{}));
  expect_accessible_dialog(new NewStudyDialog(home()));
  expect_accessible_dialog(new ShareStudyDialog(home()));
  expect_accessible_dialog(new DriverSetup(
      std::vector<std::string>{"falcon", "force_dimension", "forcefeedback_joystick"}));
  const std::filesystem::path plugins = ASPERITY_TEST_PLUGINS;
  expect_accessible_dialog(
      new PluginsDialog({plugins / "faulty_none.so", plugins / "faulty_slow.so"}));
  expect_accessible_dialog(new PluginLoading(std::vector(3, plugins / "faulty_slow.so")));
  expect_accessible_dialog(new AbortDialog(nullptr, [](const Phrase&) {}));
  expect_accessible_dialog(new CloseDialog(nullptr, [](Leaving) {}));
}

TEST_P(Accessibility, TheSessionWindowHasNamesAndTheOrderOfReading) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  for (const QSize size : {QSize(1920, 1016), QSize(1270, 688), QSize(683, 700)}) {
    window->resize(size);
    window->show();
    window->refresh();
    expect_accessible(*window, QString("session at %1").arg(size.width()));
    for (const char* const name : {"trouble", "device_trouble", "news"}) {
      auto& banner = child<Banner>(*window, name);
      banner.show_news(State::look, "A message", "Try again");
      const auto steps = [&window] { return steps_against_reading(*window).filter("banner_"); };
      EXPECT_TRUE(eventually([&steps] { return steps().empty(); }))
          << name << " at " << size.width() << '\n'
          << steps().join('\n').toStdString();
      banner.hide();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, Accessibility, testing::Values("en", "de"),
                         [](const auto& given) { return std::string(given.param); });

TEST(AccessibleNames, AreMissedOfAButtonWithoutOne) {
  QWidget window{};
  auto* lower = new QPushButton("Lower", &window);
  lower->setGeometry(0, 60, 80, 24);
  auto* nameless = new QPushButton("…", &window);
  nameless->setObjectName("planted");
  nameless->setGeometry(0, 10, 80, 24);
  window.show();
  EXPECT_EQ(nameless_controls(window), QStringList{"QPushButton \"planted\" (…)"});
  EXPECT_EQ(steps_against_reading(window).size(), 1) << "from the lower to the upper one";
  nameless->setAccessibleName("More");
  nameless->move(0, 110);
  EXPECT_EQ(nameless_controls(window), QStringList{});
  EXPECT_EQ(steps_against_reading(window), QStringList{});
}

TEST(ColorAlone, IsFoundInALabelAndInACell) {
  QWidget window{};
  auto* number =
      new QLabel(QString("<span style='color:%1'>4.2 mm</span>").arg(theme().stop.name()), &window);
  auto* table = new QTableWidget(1, 2, &window);
  table->setItem(0, 0, new QTableWidgetItem("4.2"));
  table->setItem(0, 1, new QTableWidgetItem("12 ms"));
  table->item(0, 1)->setForeground(theme().look);
  table->move(0, 40);
  window.show();
  EXPECT_EQ(told_by_color_alone(window).size(), 2);
  number->setText(QString("<span style='color:%1'>✕</span> 4.2").arg(theme().stop.name()));
  table->item(0, 1)->setText("▲ 4.2");
  EXPECT_EQ(told_by_color_alone(window), QStringList{});
}

}  // namespace
}  // namespace asperity

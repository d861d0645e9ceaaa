// Plug-ins of the windows: their dialog, the models that they add, the sentence about one that was not loaded, and the progress of
// their checks.

#include "app/gui/study/plugins_dialog.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QtTest/QTest>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>

#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "app/gui/window/study_window.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

std::filesystem::path test_plugin(const char* name) {
  return std::filesystem::path(ASPERITY_TEST_PLUGINS) / name;
}

class PluginsDialogTest : public QuietHome {
 protected:
  /// Opens the dialog by its entry of the menu.
  static QDialog& opened_dialog(StudyWindow& window) {
    child<QAction>(window, "menu_plugins").trigger();
    return child<QDialog>(window, "plugins_dialog");
  }
  static void load(QDialog& dialog) {
    QTest::mouseClick(&child<QPushButton>(dialog, "plugins_load"), Qt::LeftButton);
  }
  static void add_to_list(QDialog& dialog, const char* plugin) {
    child<QListWidget>(dialog, "plugins_list")
        .addItem(QString::fromStdString(test_plugin(plugin).string()));
  }
  static bool is_loading(const StudyWindow& window) {
    return window.findChild<QDialog*>("plugin_loading") != nullptr;
  }
  /// Their checks take seconds.
  static std::vector<std::filesystem::path> slow_plugins() {
    return std::vector(3, test_plugin("faulty_slow.so"));
  }
  /// The dialog of slow plug-ins, after one of the checks has ended.
  static QDialog& loading_dialog(const StudyWindow& window) {
    const auto& bar = child<QProgressBar>(window, "loading_progress");
    require([&] { return !is_loading(window) || bar.value() > 0; }, "progress");
    return child<QDialog>(window, "plugin_loading");
  }
};

TEST_F(PluginsDialogTest, LoadsTheListedPlugins) {
  StudyWindow window{};
  window.show();
  window.open_study(small_demo_study());
  ASSERT_NE(window.study(), nullptr);
  EXPECT_EQ(window.study()->models().find("faulty"), nullptr);
  QDialog& dialog = opened_dialog(window);
  add_to_list(dialog, "faulty_none.so");
  take_screenshot(dialog, "plugins", dialog.size());
  load(dialog);
  require([&] { return !is_loading(window); }, "end of the loading");
  EXPECT_EQ(plugin_files(), std::vector{test_plugin("faulty_none.so")});
  ASSERT_NE(window.study(), nullptr);
  const ForceModel* const model = window.study()->models().find("faulty");
  ASSERT_NE(model, nullptr);
  EXPECT_TRUE(model->plugin);
  EXPECT_TRUE(window.banner().isHidden());
}

TEST_F(PluginsDialogTest, StatesWhyAPluginWasNotLoadedAndOpensTheStudy) {
  remember_plugin_files({test_plugin("faulty_nan.so"), test_plugin("faulty_none.so")});
  StudyWindow window{};
  window.show();
  window.open_study(small_demo_study());
  require([&] { return window.study() != nullptr; }, "study");
  EXPECT_TRUE(window.banner().isVisible());
  EXPECT_TRUE(window.banner().text().contains("faulty_nan.so"))
      << window.banner().text().toStdString();
  EXPECT_NE(window.study()->models().find("faulty"), nullptr) << "the other one";
  QDialog& dialog = opened_dialog(window);
  auto& list = child<QListWidget>(dialog, "plugins_list");
  list.setCurrentRow(0);
  QTest::mouseClick(&child<QPushButton>(dialog, "plugins_remove"), Qt::LeftButton);
  load(dialog);
  require([&] { return !is_loading(window); }, "end of the loading");
  EXPECT_EQ(plugin_files(), std::vector{test_plugin("faulty_none.so")});
  EXPECT_TRUE(window.banner().isHidden());
}

TEST_F(PluginsDialogTest, ShowsTheProgressOfTheChecksBeforeAStudyIsOpened) {
  remember_plugin_files({test_plugin("faulty_none.so")});
  StudyWindow window{};
  window.show();
  bool was_called = false;
  EXPECT_FALSE(window.open_study(small_demo_study(), [&] { was_called = true; }));
  EXPECT_TRUE(child<QDialog>(window, "plugin_loading").isVisible());
  EXPECT_FALSE(window.open_study(home() / "studies" / "demo")) << "a second time";
  EXPECT_EQ(window.findChildren<QDialog*>("plugin_loading").size(), 1);
  EXPECT_EQ(window.study(), nullptr);
  EXPECT_FALSE(was_called);
  require([&] { return !is_loading(window); }, "end of the loading");
  ASSERT_NE(window.study(), nullptr);
  EXPECT_NE(window.study()->models().find("faulty"), nullptr);
  EXPECT_TRUE(was_called);
}

TEST_F(PluginsDialogTest, DoesNotOpenAStudyIfTheChecksAreCancelled) {
  remember_plugin_files(slow_plugins());
  StudyWindow window{};
  window.show();
  EXPECT_FALSE(window.open_study(small_demo_study()));
  QDialog& dialog = loading_dialog(window);
  take_screenshot(dialog, "plugin_loading", dialog.size());
  auto& cancel = child<QPushButton>(dialog, "loading_cancel");
  const auto& bar = child<QProgressBar>(dialog, "loading_progress");
  const int most = bar.value() + bar.maximum() / 3;  // one of the three plug-ins
  int reached = 0;
  QObject::connect(&bar, &QProgressBar::valueChanged, [&reached](int value) { reached = value; });
  QTest::mouseClick(&cancel, Qt::LeftButton);
  EXPECT_FALSE(cancel.isEnabled());
  require([&] { return !is_loading(window); }, "end of the loading");
  EXPECT_LT(reached, most) << "the checks went on";
  EXPECT_EQ(window.study(), nullptr);
  EXPECT_TRUE(window.banner().text().contains("loading the plug-ins was cancelled"))
      << window.banner().text().toStdString();
  EXPECT_EQ(plugin_files(), slow_plugins());
}

TEST_F(PluginsDialogTest, KeepsTheStudyAndItsPluginsIfTheChecksAreCancelled) {
  StudyWindow window{};
  window.show();
  ASSERT_TRUE(window.open_study(small_demo_study()));
  const OpenStudy* const study = window.study();
  QDialog& dialog = opened_dialog(window);
  for (int i = 0; i < 3; ++i) add_to_list(dialog, "faulty_slow.so");
  load(dialog);
  QTest::keyClick(&loading_dialog(window), Qt::Key_Escape);
  require([&] { return !is_loading(window); }, "end of the loading");
  EXPECT_EQ(window.study(), study);
  EXPECT_TRUE(plugin_files().empty());
  EXPECT_TRUE(window.banner().text().contains("The plug-ins are unchanged"))
      << window.banner().text().toStdString();
}

TEST_F(PluginsDialogTest, CanBeClosedWithItsWindowWhilePluginsAreChecked) {
  remember_plugin_files(slow_plugins());
  for (const bool closed_first : {true, false}) {
    auto window = std::make_unique<StudyWindow>();
    window->show();
    window->open_study(home() / "none");
    loading_dialog(*window);
    if (closed_first) {
      EXPECT_TRUE(window->close());
    }
    window.reset();
  }
}

TEST_F(PluginsDialogTest, RemovesTheSelectedPlugin) {
  remember_plugin_files({test_plugin("faulty_nan.so"), test_plugin("faulty_none.so")});
  StudyWindow window{};
  window.show();
  QDialog& dialog = opened_dialog(window);
  auto& list = child<QListWidget>(dialog, "plugins_list");
  auto& remove = child<QPushButton>(dialog, "plugins_remove");
  EXPECT_FALSE(remove.isEnabled()) << "no plug-in is selected";
  list.setCurrentRow(0);
  ASSERT_TRUE(remove.isEnabled());
  QTest::mouseClick(&remove, Qt::LeftButton);
  ASSERT_EQ(list.count(), 1);
  EXPECT_TRUE(list.item(0)->text().endsWith("faulty_none.so"));
}

TEST_F(PluginsDialogTest, ShortensALongPath) {
  const std::filesystem::path file =
      std::filesystem::path("/") / std::string(200, 'a') / "ridges.so";
  PluginsDialog dialog({file});
  dialog.show();
  const auto& list = child<QListWidget>(dialog, "plugins_list");
  EXPECT_EQ(list.horizontalScrollBar()->maximum(), 0);
  EXPECT_EQ(list.item(0)->toolTip().toStdString(), file.string());
}

TEST_F(PluginsDialogTest, ChangesNothingIfItIsCancelled) {
  remember_plugin_files({test_plugin("faulty_none.so")});
  StudyWindow window{};
  window.show();
  QDialog& dialog = opened_dialog(window);
  delete child<QListWidget>(dialog, "plugins_list").item(0);
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_EQ(plugin_files(), std::vector{test_plugin("faulty_none.so")});
}

}  // namespace
}  // namespace asperity

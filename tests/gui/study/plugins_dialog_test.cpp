// Plug-ins of the windows: their dialog, the models that they add, and the sentence about one that was not loaded.

#include "app/gui/study/plugins_dialog.h"

#include <filesystem>
#include <vector>

#include <QtTest/QTest>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QPushButton>

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
};

TEST_F(PluginsDialogTest, LoadsTheListedPlugins) {
  StudyWindow window{};
  window.show();
  window.open_study(small_demo_study());
  ASSERT_NE(window.study(), nullptr);
  EXPECT_EQ(window.study()->models().find("faulty"), nullptr);
  QDialog& dialog = opened_dialog(window);
  child<QListWidget>(dialog, "plugins_list")
      .addItem(QString::fromStdString(test_plugin("faulty_none.so").string()));
  take_screenshot(dialog, "plugins", dialog.size());
  load(dialog);
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
  ASSERT_NE(window.study(), nullptr);
  EXPECT_TRUE(window.banner().isVisible());
  EXPECT_TRUE(window.banner().text().contains("faulty_nan.so"))
      << window.banner().text().toStdString();
  EXPECT_NE(window.study()->models().find("faulty"), nullptr) << "the other one";
  QDialog& dialog = opened_dialog(window);
  auto& list = child<QListWidget>(dialog, "plugins_list");
  list.setCurrentRow(0);
  QTest::mouseClick(&child<QPushButton>(dialog, "plugins_remove"), Qt::LeftButton);
  load(dialog);
  EXPECT_EQ(plugin_files(), std::vector{test_plugin("faulty_none.so")});
  EXPECT_TRUE(window.banner().isHidden());
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

// The page of the workbench in a study of its own, with a photograph dropped onto it.

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <QtCore/QMimeData>
#include <QtGui/QDragEnterEvent>
#include <QtGui/QDropEvent>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <gtest/gtest.h>

#include "app/gui/base/open_study.h"
#include "app/gui/workbench/workbench_page.h"
#include "app/tasks/new_study.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/synthetic_photograph.h"
#include "tests/gui/sound/fake_card.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

class PageOfTheWorkbench : public testing::Test {
 protected:
  static void open() {
    folder_ = std::make_unique<TemporaryFolder>();
    new_study(study_folder());
    study_ = std::make_unique<OpenStudy>(study_folder());
    page_ = std::make_unique<WorkbenchPage>(*study_);
    page_->resize(1366, 768);
    page_->show();
  }
  static void close() {
    page_.reset();
    study_.reset();
    folder_.reset();
  }

  static std::filesystem::path folder() { return folder_->path(); }
  static std::filesystem::path study_folder() { return folder() / "study"; }

  static std::filesystem::path photograph(
      const std::string& kind, std::size_t pixels,
      PhotographCase photograph_case = PhotographCase::bright_height) {
    static std::map<std::tuple<std::string, std::size_t, PhotographCase>, GreyImage> made{};
    GreyImage& picture = made[{kind, pixels, photograph_case}];
    if (picture.values.empty()) {
      PhotographSettings settings{};
      settings.photograph_case = photograph_case;
      picture = synthetic_photograph(
          make_surface(kind, {}, {.width_m = 0.10, .pixels = pixels, .seed = 2}), settings);
    }
    const std::filesystem::path file = folder() / (kind + ".png");
    save_picture(file, picture, Overwrite::allow);
    return file;
  }

  /// Chooses also that bright parts are high.
  void drop(const std::filesystem::path& file) {
    drop_all({file});
    auto& kind = find<QComboBox>("kind");
    if (kind.currentIndex() < 0) kind.setCurrentIndex(0);
    settle();
  }

  void drop_all(const std::vector<std::filesystem::path>& files) {
    QMimeData data{};
    QList<QUrl> urls{};
    for (const std::filesystem::path& file : files) {
      urls << QUrl::fromLocalFile(QString::fromStdString(file.string()));
    }
    data.setUrls(urls);
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(page_.get(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent dropped({100.0, 100.0}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(page_.get(), &dropped);
    settle();
  }

  void settle() {
    ASSERT_TRUE(eventually([this] { return page_->is_settled(); }));
  }

  template <class Widget>
  Widget& find(const char* name) {
    return child<Widget>(*page_, name);
  }

  void type(const char* field_name, const char* text) {
    auto& field = find<QDoubleSpinBox>(field_name);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
  }

  void click(const char* name) { QTest::mouseClick(&find<QAbstractButton>(name), Qt::LeftButton); }

  static inline std::unique_ptr<TemporaryFolder> folder_{};
  static inline std::unique_ptr<OpenStudy> study_{};
  static inline std::unique_ptr<WorkbenchPage> page_{};
};

class Workbench : public PageOfTheWorkbench {
 protected:
  void SetUp() override { open(); }
  void TearDown() override { close(); }

  FakeCard card_{};  // outlives the page, whose sound thread takes from it
};

/// Tests that save nothing and hear nothing have one page. Each begins with a brick of 256 pixels under the default recipe.
class BrickOnTheWorkbench : public PageOfTheWorkbench {
 protected:
  void SetUp() override {
    if (page_) {
      page_->resume(brick_);
      click("mode_making");
      settle();
    } else {
      open();
      drop(photograph("brick", 256));
      brick_ = page_->work();
    }
  }
  static void TearDownTestSuite() {
    brick_ = {};
    close();
  }

 private:
  static inline WorkbenchPage::Work brick_{};
};

}  // namespace asperity

// The study window around tests of its pages: one for each test, or one for tests that change nothing.

#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/base/open_study.h"
#include "app/gui/base/study_table.h"
#include "app/gui/window/study_window.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

class PagesOfAWindow : public QuietHome {
 protected:
  PagesOfAWindow() {
    window_.resize(1366, 768);
    window_.show();
  }
  static void close_window() { made_.reset(); }

  /// The page is shown and its table filled.
  StudyTable& table_of(const char* page, const char* name, int rows) {
    window_.show_page(page);
    auto& table = child<StudyTable>(window_, name);
    if (!eventually([&] { return table.shown_rows() == rows; })) {
      throw std::runtime_error(std::string(name) + " has " + std::to_string(table.shown_rows()) +
                               " rows");
    }
    return table;
  }
  void click(const char* button) {
    QTest::mouseClick(&child<QPushButton>(window_, button), Qt::LeftButton);
  }
  void choose_theme(const QString& name) {
    for (QAction* action : window_.findChildren<QAction*>()) {
      if (action->text() == name) action->trigger();
    }
  }
  static void press(QWidget& in, const QString& text) {
    for (auto* button : in.findChildren<QPushButton*>()) {
      if (button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
    }
    ADD_FAILURE() << "no button " << text.toStdString();
  }
  /// Every text of the column has the room that it needs.
  static void expect_whole(const StudyTable& table, int column) {
    constexpr int kPadding = 16;
    for (int row = 0; row < table.shown_rows(); ++row) {
      const QRect cell = table.visualRect(table.model()->index(row, column));
      const QRect room(0, 0, cell.width() - kPadding, 10'000);
      const QRect needed =
          QFontMetrics(table.font())
              .boundingRect(room, Qt::TextWordWrap | Qt::AlignLeft, table.text_at(row, column));
      EXPECT_LE(needed.height(), cell.height())
          << table.text_at(row, column).toStdString() << " in " << cell.width();
    }
  }
  QString texts_on(const char* page) const {
    QStringList texts{};
    for (const auto* label : child<QWidget>(window_, page).findChildren<QLabel*>()) {
      if (label->isVisible()) texts.append(label->text());
    }
    return texts.join(" | ");
  }
  static QStringList column(const StudyTable& table, int column) {
    QStringList texts{};
    for (int row = 0; row < table.shown_rows(); ++row) texts.append(table.text_at(row, column));
    return texts;
  }

  void select_protocol(const char* name) {
    table_of("protocols", "protocols_table", 4)
        .select(QString::fromStdString((window_.study()->folder() / "protocols" / name).string()));
  }

  StudyWindow& window_ = made_ ? *made_ : *(made_ = std::make_unique<StudyWindow>());

 private:
  static inline std::unique_ptr<StudyWindow> made_{};
};

/// Each test has its own window and study.
class StudyPages : public PagesOfAWindow {
 protected:
  ~StudyPages() override { close_window(); }

  void open_demo() { ASSERT_TRUE(window_.open_study(small_demo_study())); }
  void open_lively() { ASSERT_TRUE(window_.open_study(lively_study())); }
};

/// Tests that change nothing of the study, and of the window only what the constructor restores, have one of both.
class PagesToRead : public PagesOfAWindow {
 protected:
  PagesToRead() {
    if (!study_) {
      study_ = std::make_unique<TemporaryFolder>();
      copy(lively_study(), study_->path(), std::filesystem::copy_options::recursive);
      EXPECT_TRUE(window_.open_study(study_->path()));
    }
    window_.show_page("protocols");
    child<QPushButton>(window_, "participants_people").click();
    child<QLineEdit>(window_, "sessions_filter").clear();
    child<StudyTable>(window_, "sessions_table").sortByColumn(5, Qt::DescendingOrder);
  }
  static void TearDownTestSuite() {
    close_window();
    study_.reset();
  }

 private:
  static inline std::unique_ptr<TemporaryFolder> study_{};
};

}  // namespace asperity

// A study window with three reliefs and a protocol that rates them.

#pragma once

#include <filesystem>
#include <string>

#include <QtGui/QTextDocumentFragment>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gui/base/open_study.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/window/study_window.h"
#include "app/study_files/height_field_files.h"
#include "app/tasks/new_study.h"
#include "app/tasks/protocol_templates.h"
#include "app/tasks/template_overviews.h"
#include "results_schema/files/atomic_file.h"
#include "stimuli/heights/synthetic_surface.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/accessible.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {

class WindowWithReliefs : public QuietHome {
 protected:
  WindowWithReliefs() {
    new_study(folder());
    for (const char* const kind : {"brick", "noise", "wood"}) {
      save_height_field(stimulus(std::string(kind) + ".png"),
                        make_surface(kind, {}, {.width_m = 0.02, .pixels = 128, .seed = 3}),
                        {.kind = kind}, Overwrite::refuse);
    }
    protocol_ = protocol_from_template(
        folder(),
        {.name = "semantic_differential",
         .textures = {.from = TemplateTextures::From::study, .own = reliefs_of_study(folder())}});
    window_.resize(1280, 720);
    window_.show();
    EXPECT_TRUE(window_.open_study(folder()));
  }

  std::filesystem::path folder() const { return home() / "study"; }
  std::filesystem::path stimulus(const std::string& name) const {
    return folder() / "stimuli" / name;
  }

  /// The stimuli page with so many rows.
  StudyTable& stimuli(int rows) {
    window_.show_page("stimuli");
    auto& table = child<StudyTable>(window_, "stimuli_table");
    require([&] { return table.shown_rows() == rows; }, "list of stimuli");
    return table;
  }
  void click(const char* button) { click(button, window_); }
  static void click(const char* button, const QWidget& in) {
    auto& found = child<QPushButton>(in, button);
    EXPECT_TRUE(found.isEnabled()) << button;
    QTest::mouseClick(&found, Qt::LeftButton);
  }
  QString words(const char* label) const { return child<QLabel>(window_, label).text(); }
  /// "✓ The text of the label."
  static QString state_in(const QWidget& in, const char* label) {
    const QString html = child<StateLabel>(in, label).text();
    return QTextDocumentFragment::fromHtml(html).toPlainText().simplified();
  }
  /// The command that this part of the window shows.
  static QString command_of(const QWidget& part) {
    click("show_commands", part);
    auto& popup = child<QWidget>(part, "commands");
    const QString line = child<QLineEdit>(popup, "command_1").text();
    popup.close();
    return line;
  }
  /// The banners that are shown.
  QString news() const {
    QString all{};
    for (const Banner* banner : window_.findChildren<Banner*>()) {
      if (banner->isVisible()) all += banner->text() + '\n';
    }
    return all;
  }
  /// In both themes, at two sizes of the window or of a dialog in it.
  static void take_screenshots(QWidget& widget, const QString& name) {
    for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
      apply_theme(*qApp, choice);
      const QString end = choice == ThemeChoice::light ? "" : "-dark";
      take_screenshot(widget, name + end, {1280, 720});
      take_screenshot(widget, name + "-small" + end, {910, 512});
    }
    apply_theme(*qApp, ThemeChoice::light);
  }

  std::filesystem::path protocol_{};
  StudyWindow window_{};
};

}  // namespace asperity

// A trial with the mouse from the Protocols page, of which nothing remains.

#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableView>

#include "app/gui/look/controls.h"
#include "results_schema/hashes/sha256.h"
#include "tests/gui/sessions/session_room.h"

namespace asperity {

class MouseTrialRoom : public SessionRoom {
 protected:
  MouseTrialRoom() : former_(qgetenv("TMPDIR")) {
    std::filesystem::create_directories(temporary());
    qputenv("TMPDIR", temporary().c_str());
  }
  ~MouseTrialRoom() override {
    close_windows();
    former_.isEmpty() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", former_);
  }

  std::filesystem::path temporary() const { return home() / "temporary"; }
  std::map<std::string, std::string> hashes() const {
    std::map<std::string, std::string> hashes{};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder())) {
      if (entry.is_regular_file()) hashes[entry.path().string()] = sha256_of_file(entry.path());
    }
    return hashes;
  }

  /// Of the table in the session window.
  int rows_of_plan() {
    experimenter().refresh();
    return child<QTableView>(experimenter(), "plan").model()->rowCount();
  }
  /// On a label of the session window.
  bool is_shown(const QString& words) {
    const auto labels = experimenter().findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* each) { return each->text() == words; });
  }

  /// Until the first text is shown.
  void begin_by_mouse(const QString& protocol) {
    open();
    window->show_page("protocols");
    click_row(*window, "protocols_table", protocol);
    click(*window, "protocol_by_mouse");
    wait_for("the session",
             [&] { return desk->runner() != nullptr && monitor().facts() != nullptr; });
    wait_for("the first text", [&] { return view().scene().kind == Scene::Kind::text; });
  }

  /// Tries the protocol with this name; each surface is felt for `contact_s`.
  void try_by_mouse(const QString& protocol, double contact_s,
                    const std::function<void(const Scene&)>& answer) {
    const auto before = hashes();
    begin_by_mouse(protocol);
    EXPECT_NE(view().scene().text.find("The mouse exerts no force"), std::string::npos)
        << view().scene().text;
    EXPECT_FALSE(std::filesystem::is_empty(temporary()));
    int questions = 0;
    take_part(
        [&](const Scene& scene) {
          ++questions;
          EXPECT_EQ(monitor().snapshot().trials, 2);
          EXPECT_FALSE(monitor().snapshot().trials_are_estimated);
          EXPECT_EQ(monitor().snapshot().blocks, 1);
          EXPECT_LE(rows_of_plan(), 3) << "a heading and two trials";
          EXPECT_TRUE(is_shown("Block 1 of 1"));
          EXPECT_TRUE(is_shown(QString("trial %1 of 2").arg(questions)));
          answer(scene);
        },
        [&] {
          if (desk->runner() == nullptr || !desk->is_running()) return desk->runner() == nullptr;
          // A text may have several pages.
          const bool is_text = view().scene().kind == Scene::Kind::text;
          if (is_text && view().waits() && can_be_perceived()) key(Qt::Key_Return);
          if (desk->runner() != nullptr && desk->is_running()) stroke_by_mouse(contact_s);
          return desk->runner() == nullptr;
        });
    EXPECT_GE(questions, 2);
    EXPECT_EQ(window->shown_page(), "protocols");
    EXPECT_EQ(window->banner().text(),
              "The trial with the mouse has ended. Nothing was stored in the study.");
    wait_for("the removal of the copy", [&] { return std::filesystem::is_empty(temporary()); });
    EXPECT_TRUE(Study::open(folder(), Access::read_only).sessions().empty());
    close_windows();
    EXPECT_EQ(hashes(), before);
  }

 private:
  QByteArray former_{};
};

}  // namespace asperity

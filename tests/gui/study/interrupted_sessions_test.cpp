// Interrupted sessions: where they are reported, and what is offered.

#include <filesystem>
#include <fstream>
#include <string>

#include <QtTest/QSignalSpy>

#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/gui/window/study_window.h"
#include "results_schema/study.h"
#include "tests/gui/study/pages_of_a_window.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

TEST_F(StudyPages, ReportAnInterruptedSessionAndOfferToResumeIt) {
  open_lively();
  auto& banner = child<Banner>(window_, "protocols_interrupted");
  ASSERT_TRUE(eventually([&] { return banner.isVisible(); }));
  EXPECT_EQ(banner.text(),
            "Session 1 of P012 was interrupted; trials completed and stored: 3 of 12.");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  press(banner, "Resume session 1 of P012");
  ASSERT_EQ(wanted.count(), 1);
  const auto wish = wanted[0][0].value<SessionWish>();
  EXPECT_EQ(wish.participant, "P012");
  EXPECT_EQ(wish.protocol.filename(), "chapter_recognition.json");
  EXPECT_EQ(Study::open(window_.study()->folder(), Access::read_only).session(*wish.session).state,
            SessionState::crashed);
  EXPECT_FALSE(banner.isVisible());
  window_.study()->announce_change();
  table_of("sessions", "sessions_table", 15);
  table_of("protocols", "protocols_table", 4);
  EXPECT_FALSE(banner.isVisible()) << "reported once only";
}

TEST_F(StudyPages, ReportAnInterruptedSessionOnTheWelcomePage) {
  open_lively();
  const std::filesystem::path folder = window_.study()->folder();
  window_.close_study();
  auto& banner = child<Banner>(window_, "welcome_interrupted");
  ASSERT_TRUE(eventually([&] { return banner.isVisible(); }));
  EXPECT_TRUE(banner.text().startsWith("Session 1 of P012 in the study “demo” was interrupted;"))
      << banner.text().toStdString();
  EXPECT_TRUE(child<QLabel>(window_, "welcome_versions")
                  .text()
                  .endsWith(". Before 1.0.0, finish a study with the version that began it; the "
                            "package of each version stays available."))
      << child<QLabel>(window_, "welcome_versions").text().toStdString();
  window_.resize(1280, 720);
  const auto cut = [&]() -> std::string {
    for (const auto* label : child<QWidget>(window_, "welcome_page").findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty()) continue;
      if (label->height() < label->heightForWidth(label->width()))
        return label->text().toStdString();
    }
    return {};
  };
  EXPECT_TRUE(eventually([&] { return cut().empty(); })) << cut();
  take_screenshot(window_, "study-welcome-interrupted");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  press(banner, "Resume session 1 of P012");
  ASSERT_NE(window_.study(), nullptr);
  EXPECT_EQ(window_.study()->folder(), folder);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted[0][0].value<SessionWish>().participant, "P012");
}

TEST_F(StudyPages, ShowAnInterruptedSessionThatCannotBeResumed) {
  const std::filesystem::path folder = lively_study();
  std::ofstream(folder / "protocols" / "chapter_recognition.json", std::ios::app) << "\n";
  ASSERT_TRUE(window_.open_study(folder));
  auto& banner = child<Banner>(window_, "protocols_interrupted");
  ASSERT_TRUE(eventually([&] { return banner.isVisible(); }));
  EXPECT_TRUE(banner.text().contains("restore chapter_recognition version 1.1.0 to resume"))
      << banner.text().toStdString();
  press(banner, "Show the sessions");
  EXPECT_EQ(window_.shown_page(), "sessions");
}

}  // namespace
}  // namespace asperity

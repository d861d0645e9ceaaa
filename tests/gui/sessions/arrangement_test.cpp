// Sessions in the windows whose trials present surfaces side by side, and on request.

#include <fstream>

#include <nlohmann/json.hpp>

#include "app/gui/session/session_window.h"
#include "app/session/session_monitor.h"
#include "app/tasks/protocol_files.h"
#include "protocols/file/library_protocols.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

using nlohmann::json;

class ArrangementsInWindows : public SessionRoom {
 protected:
  /// The library's protocol `spacing_jnd` with three trials and short visits, under the name "small".
  void add_spacing_jnd(const json& arrangement = nullptr) {
    add_protocol({.kind = "recognition"});
    const std::filesystem::path file = folder() / "protocols" / "small.json";
    for (const LibraryProtocol& each : library_protocols()) {
      if (each.name != "spacing_jnd") continue;
      json protocol = json::parse(each.text);
      protocol["name"] = "small";
      protocol["blocks"].erase("practice");
      protocol.erase("resume");
      json& block = protocol["blocks"]["comparisons"];
      block["procedure"]["stop"]["trials"] = 3;
      block["pause_before_trial_s"] = 0;
      if (!arrangement.is_null()) block["arrangement"] = arrangement;
      protocol["explorations"]["stroking"]["minimum_contact_s"] = 0.3;
      protocol["participants"]["questions"] = json::array();
      // Real time on a busy machine.
      protocol["device"]["maximum_missed_deadlines"] = 100000;
      protocol["device"]["maximum_gaps_in_contact"] = 100000;
      protocol["device"]["maximum_lost_records"] = 100000;
      protocol["environment"].erase("masking_noise");
      protocol["flow"] = json::parse(R"([{"run": "comparisons"}])");
      write_file(file, protocol.dump(1), Overwrite::allow);
    }
    load_protocol(file, built_in_models(), folder());
  }
};

TEST_F(ArrangementsInWindows, SpacingIsJudgedSideBySide) {
  make_study();
  add_spacing_jnd();
  open();
  start("small");
  int answers = 0;
  std::int64_t asked_ns = 0;
  take_part(
      [&](const Scene& scene) {
        ASSERT_EQ(scene.choices.size(), 2U);
        choose(++answers % 2 == 0 ? Qt::Key_A : Qt::Key_B);
      },
      [&] {
        if (!desk->is_running()) return true;
        if (desk->participant_window() == nullptr) return false;
        const SessionSnapshot now = monitor().snapshot();
        // Asks to finish twice a second, as an impatient participant does: before both were visited twice it is refused.
        if (now.phase == SessionPhase::contact && view().scene().kind == Scene::Kind::feel &&
            now.now_ns - asked_ns > 500'000'000) {
          if (asked_ns == 0) {
            EXPECT_EQ(view().scene().surfaces.size(), 2U);
            EXPECT_TRUE(view().scene().surfaces[0].now && view().scene().surfaces[1].now);
            take_screenshot(*desk->participant_window(), "side-by-side-feel", {1280, 720});
            take_screenshot(experimenter(), "side-by-side-session", {1280, 720});
          }
          asked_ns = now.now_ns;
          key(Qt::Key_Space);
        }
        return false;
      });
  EXPECT_EQ(answers, 3);
  EXPECT_EQ(stored_session().state, SessionState::completed);
  for (const AttemptRow& attempt : stored_attempts()) {
    EXPECT_TRUE(attempt.valid) << attempt.invalid_reason.value_or(StoredWords{}).text;
    ASSERT_EQ(attempt.presentations.size(), 2U);
    for (const PresentationRow& surface : attempt.presentations) {
      EXPECT_GE(surface.visits.size(), 2U);
      EXPECT_GE(surface.contact_s, 0.3);
    }
  }
  EXPECT_FALSE(stored_events("refused").empty()) << "asked too early";
}

TEST_F(ArrangementsInWindows, SurfacesAreFeltInTheOrderThatTheParticipantRequests) {
  make_study();
  add_spacing_jnd({{"surfaces", "on_request"}, {"visits", {{"minimum", 1}, {"maximum", 2}}}});
  open();
  start("small");
  // What the scene states decides, and not how often it was shown.
  bool is_first = true;
  take_part([&](const Scene& scene) {
    if (!scene.surfaces[1].felt) {
      EXPECT_FALSE(scene.surfaces[0].felt) << "B first";
      if (is_first) take_screenshot(*desk->participant_window(), "on-request", {1280, 720});
      is_first = false;
      key(Qt::Key_B);       // chooses B, and
      key(Qt::Key_Return);  // cannot confirm before both were felt
      key(Qt::Key_Space);   // feels B
    } else if (!scene.surfaces[0].felt) {
      key(Qt::Key_A);
      wait_until_feeling_again_counts();
      key(Qt::Key_Space);
    } else {
      choose(Qt::Key_A);
    }
  });
  EXPECT_EQ(stored_session().state, SessionState::completed);
  int answered = 0;
  for (const AttemptRow& attempt : stored_attempts()) {
    if (!attempt.valid) continue;
    ++answered;
    ASSERT_EQ(attempt.presentations.at(0).visits.size(), 1U);
    ASSERT_EQ(attempt.presentations.at(1).visits.size(), 1U);
    EXPECT_LT(attempt.presentations[1].visits[0].offset_ns,
              attempt.presentations[0].visits[0].contact_ns)
        << "B first";
  }
  EXPECT_EQ(answered, 3);
}

}  // namespace
}  // namespace asperity

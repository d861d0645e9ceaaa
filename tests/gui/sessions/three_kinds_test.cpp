// One session in the windows with blocks of three kinds, five scales in a trial and two groups: what was pressed is stored
// under the name of its question.

#include <fstream>

#include <nlohmann/json.hpp>

#include "app/session/respondents/participant_scene.h"
#include "app/tasks/protocol_files.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

using nlohmann::json;

constexpr std::size_t kScales = 5;

class ThreeKinds : public SessionRoom {
 protected:
  /// A recognition of three textures, preceded by ratings of one and followed by a comparison of two.
  void add_three_kinds() {
    add_protocol({.kind = "recognition"});
    const std::filesystem::path file = folder() / "protocols" / "small.json";
    json protocol = json::parse(std::ifstream(file));
    protocol["factors"]["training"] = {{"levels", {"haptic", "visual"}}};
    protocol["groups"] = {{"factor", "training"}, {"assigned", "balanced"}};
    const json presented = {{"stimulus", "rendered"},
                            {"with", {{"texture", "slate"}, {"model", "height_map"}}}};
    json ratings = {{"kind", "rating"},
                    {"presented", {presented}},
                    {"exploration", "short"},
                    {"question_layout", "one_page"},
                    {"questions", json::array()}};
    for (const char* const name : {"rough", "hard", "slippery", "coarse", "pleasant"}) {
      ratings["questions"].push_back({{"name", name},
                                      {"prompt", std::string("How ") + name + "?"},
                                      {"scale", {{"minimum", 1}, {"maximum", 7}, {"points", 7}}}});
    }
    protocol["blocks"]["ratings"] = ratings;
    json second = presented;
    second["with"]["texture"] = "cork";
    protocol["blocks"]["pairs"] = {
        {"kind", "paired_comparison"},
        {"presented", {presented, second}},
        {"crossed", {"go"}},
        {"positions", "balanced"},
        {"exploration", "short"},
        {"question", {{"name", "rougher"}, {"prompt", "Which is rougher?"}}}};
    protocol["flow"] = {{{"run", "ratings"}}, {{"run", "main"}}, {{"run", "pairs"}}};
    write_file(file, protocol.dump(1), Overwrite::allow);
    load_protocol(file, built_in_models(), folder());
  }
};

TEST_F(ThreeKinds, AreAskedOnePageAfterAnotherAndStoredByQuestion) {
  make_study();
  add_three_kinds();
  open();
  start("small");
  std::map<std::string, int> pages{};
  take_part([&](const Scene& scene) {
    if (!scene.scales.empty()) {
      ++pages["scales"];
      ASSERT_EQ(scene.scales.size(), kScales);
      for (const Qt::Key point : {Qt::Key_1, Qt::Key_3, Qt::Key_4, Qt::Key_6, Qt::Key_7})
        key(point);
      take_screenshot(view(), "three-kinds-scales", {1280, 720});
      key(Qt::Key_Return);
    } else if (scene.choices.size() == 3) {
      ++pages["pictures"];
      choose(Qt::Key_2);
    } else {
      ++pages["surfaces"];
      ASSERT_EQ(scene.choices.size(), 2U);
      choose(Qt::Key_B);
    }
  });
  EXPECT_EQ(pages, (std::map<std::string, int>{{"scales", 1}, {"pictures", 3}, {"surfaces", 2}}));
  const SessionRow session = stored_session();
  EXPECT_EQ(session.state, SessionState::completed);
  EXPECT_EQ(session.group_level, "haptic");

  std::map<std::string, std::vector<std::string>> answers{};
  for (const AttemptRow& attempt : stored_attempts()) {
    EXPECT_TRUE(attempt.valid) << attempt.trial;
    for (const ResponseRow& response : attempt.responses) {
      answers[response.question].push_back(response.answer);
    }
  }
  const std::map<std::string, std::string> points{
      {"rough", "1"}, {"hard", "3"}, {"slippery", "4"}, {"coarse", "6"}, {"pleasant", "7"}};
  for (const auto& [question, point] : points) {
    EXPECT_EQ(answers[question], std::vector<std::string>{point}) << question;
  }
  EXPECT_EQ(answers["felt"].size(), 3U);
  EXPECT_EQ(answers["rougher"].size(), 2U);
}

}  // namespace
}  // namespace asperity

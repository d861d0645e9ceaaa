// One session in the windows with the judgements that neither name a texture nor give a number: matching of roughness and the
// comparison after it, rated dissimilarities, same–different and yes/no.

#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <QtWidgets/QApplication>
#include <nlohmann/json.hpp>

#include "app/gui/look/theme.h"
#include "app/gui/session/session_window.h"
#include "app/session/session_monitor.h"
#include "app/tasks/protocol_files.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

using nlohmann::json;

/// Two tracks of two trials match the roughness of one model to that of the other; then the pair in both orders.
constexpr const char* kMatching = R"({
  "kind": "discrimination", "crossed": ["model"], "exclude": [{"model": "sinusoid"}],
  "vary": {"parameter": "relative_amplitude", "of": "comparison", "relative_to": "standard",
           "levels_decibels": {"lowest": -8, "highest": 8, "step": 2}},
  "procedure": {"method": "transformed_up_down", "down": 1, "up": 1, "steps": [4, 2],
                "stop": {"trials": 2}, "tracks": [{"start": 2}, {"start": -2}]},
  "presented": [{"role": "standard", "stimulus": "reference"},
                {"role": "comparison", "stimulus": "rendering"}],
  "positions": "balanced", "exploration": "short",
  "question": {"name": "rougher", "prompt": "Which surface is rougher?", "judgement": "comparison"}})";
constexpr const char* kPairs = R"({
  "kind": "paired_comparison", "all_pairs": {"factor": "model", "in_both_orders": true},
  "presented": [{"stimulus": "rendering"}], "exploration": "short",
  "question": {"name": "closer", "prompt": "Which surface is more realistic?"},
  "equal_roughness": {"matched_in": "matching"}})";
constexpr const char* kSimilarity = R"({
  "kind": "similarity", "all_pairs": {"factor": "model", "with_identical": true},
  "presented": [{"stimulus": "rendering"}], "positions": "shuffle", "exploration": "short",
  "question": {"name": "different", "prompt": "How different did the two surfaces feel?",
               "scale": {"minimum": 1, "maximum": 7, "points": 7,
                         "labels": ["identical", "completely different"]}}})";
constexpr const char* kSameDifferent = R"({
  "kind": "discrimination", "design": "same_different",
  "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
           "levels_percent": [50]},
  "presented": [{"role": "standard", "stimulus": "grating"},
                {"role": "comparison", "stimulus": "grating"}],
  "positions": "balanced", "exploration": "short",
  "question": {"name": "equal", "prompt": "Were the two surfaces the same or different?",
               "judgement": "performance",
               "options": [{"value": "same", "text": "The same"},
                           {"value": "different", "text": "Different"}]}})";
constexpr const char* kYesNo = R"({
  "kind": "discrimination", "design": "yes_no",
  "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
           "levels_percent": [50]},
  "presented": [{"role": "standard", "stimulus": "grating"},
                {"role": "comparison", "stimulus": "grating"}],
  "exploration": "short",
  "question": {"name": "strong", "prompt": "Was it the strong grating?",
               "judgement": "performance",
               "options": [{"value": "yes", "text": "Yes"}, {"value": "no", "text": "No"}]}})";

class JudgementsInWindows : public SessionRoom {
 protected:
  void add_judgements() {
    add_protocol({.kind = "recognition"});
    const std::filesystem::path file = folder() / "protocols" / "small.json";
    json protocol = json::parse(std::ifstream(file));
    protocol["kind"] = "similarity";
    protocol.erase("textures");
    protocol["factors"] = {{"model", {{"levels", {"sinusoid", "stochastic"}}}}};
    protocol["stimuli"] = json::parse(R"({
      "reference": {"model": "sinusoid"}, "rendering": {"model": {"factor": "model"}},
      "grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-05}}})");
    protocol["observer"] = {{"yes_above", 0.1}, {"different_above", 0.3}};
    protocol["blocks"] = {{"matching", json::parse(kMatching)},
                          {"pairs", json::parse(kPairs)},
                          {"similarity", json::parse(kSimilarity)},
                          {"same_different", json::parse(kSameDifferent)},
                          {"yes_no", json::parse(kYesNo)}};
    protocol["flow"] = json::array();
    for (const char* const block :
         {"matching", "pairs", "similarity", "same_different", "yes_no"}) {
      protocol["blocks"][block]["pause_before_trial_s"] = 0;
      if (protocol["blocks"][block].value("design", "") != "yes_no")
        protocol["blocks"][block]["pause_between_surfaces_s"] = 0;
      protocol["flow"].push_back({{"run", block}});
    }
    write_file(file, protocol.dump(1), Overwrite::allow);
    load_protocol(file, built_in_models(), folder());
  }

  /// Both windows, light and dark, at both sizes, once under each name.
  void take_pictures(const std::string& name) {
    if (qEnvironmentVariable("ASPERITY_SCREENSHOTS").isEmpty()) return;
    if (!taken_.insert(name).second) return;
    const QString file = QString::fromStdString("judgements-" + name);
    const auto take = [&](const QString& theme) {
      for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080)}) {
        const QString end = theme + '-' + QString::number(size.width());
        take_screenshot(*desk->participant_window(), file + end, size);
        take_screenshot(experimenter(), file + "-session" + end, size);
      }
    };
    take("");
    apply_theme(*qApp, ThemeChoice::dark);
    take("-dark");
    apply_theme(*qApp, ThemeChoice::light);
  }

 private:
  std::set<std::string> taken_{};
};

TEST_F(JudgementsInWindows, AreAskedAndStoredAsPressed) {
  make_study();
  add_judgements();
  open();
  start("small");
  int asked = 0;
  std::map<std::string, int> trials{};
  take_part([&](const Scene& scene) {
    const std::shared_ptr<const SessionFacts> facts = monitor().facts();
    const std::string block = facts->plan->trials.at(static_cast<std::size_t>(asked++)).block;
    ++trials[block];
    if (!scene.scales.empty()) {
      key(Qt::Key_5);
      take_pictures(block);
      key(Qt::Key_Return);
      return;
    }
    ASSERT_EQ(scene.choices.size(), 2U);
    const bool is_in_words = !scene.choices.back().text.empty();
    take_pictures(block);
    choose(is_in_words ? Qt::Key_2 : Qt::Key_B);
  });
  EXPECT_EQ(
      trials,
      (std::map<std::string, int>{
          {"matching", 4}, {"pairs", 2}, {"similarity", 3}, {"same_different", 4}, {"yes_no", 2}}));
  EXPECT_EQ(stored_session().state, SessionState::completed);
  std::map<std::string, std::vector<std::string>> answers{};
  for (const AttemptRow& attempt : stored_attempts()) {
    EXPECT_TRUE(attempt.valid) << attempt.trial;
    for (const ResponseRow& response : attempt.responses) {
      answers[response.question].push_back(response.answer);
    }
  }
  EXPECT_EQ(answers["different"], std::vector<std::string>(3, "5"));
  EXPECT_EQ(answers["equal"], std::vector<std::string>(4, "different"));
  EXPECT_EQ(answers["strong"], std::vector<std::string>(2, "no"));
  EXPECT_EQ(answers["rougher"].size(), 4U);
  EXPECT_EQ(answers["closer"].size(), 2U);
}

}  // namespace
}  // namespace asperity

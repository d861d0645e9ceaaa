// Builds of a plug-in with one version: the warnings before a session, the remark of the analysis, and the report.

#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "app/report/text/study_report.h"
#include "app/tasks/warnings/plugin_warnings.h"
#include "renderers/built_in_models.h"
#include "tests/app/made_up_study.h"
#include "tests/app/small_study.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const std::string kFormer(64, 'a');
const std::string kLoaded(64, 'b');

/// The built-in models, of which "stochastic" stands for a plug-in.
ModelRegistry models_with_plugin(const std::string& sha256, const std::string& version) {
  ModelRegistry models{};
  const ModelRegistry built_in = built_in_models();
  for (ForceModel model : built_in.models()) {
    if (model.declaration.id == "stochastic") {
      model.plugin = PluginOrigin{.file = "stochastic.so", .sha256 = sha256};
      model.declaration.version = version;
    }
    models.add(std::move(model));
  }
  return models;
}

class PluginBuilds : public testing::Test {
 protected:
  /// A session of the small protocol with one trial for each build.
  std::int64_t add_session(const std::vector<std::string>& builds,
                           SessionMode mode = SessionMode::run,
                           const std::string& version = "1.0.0") {
    const std::string label = "p" + std::to_string(++people_);
    mode == SessionMode::simulate ? made_.add_virtual(label, "F") : made_.add_person(label, "F");
    std::vector<MadeUpTrial> trials{};
    for (const std::string& sha256 : builds) {
      MadeUpTrial trial{};
      trial.block = "main";
      trial.options = {"height_map", "stochastic"};
      for (const std::string& model : trial.options) {
        trial.surfaces.push_back(surface_of(model, model, "grain"));
      }
      trial.surfaces.back().assets = {{std::string(kPluginRole), sha256}};
      trial.answers = {"stochastic"};
      trials.push_back(trial);
    }
    return made_.add_session(label, protocol_of(version), trials, mode);
  }

  std::vector<Diagnostic> warnings(std::optional<SessionMode> mode = {},
                                   const std::string& version_of_plugin = "1") {
    const ModelRegistry models = models_with_plugin(kLoaded, version_of_plugin);
    return warnings_about_plugins({read_small_protocol(models, small_protocol()), "small.json"},
                                  made_.study(), models, mode);
  }

  std::vector<std::string> remarks() {
    std::vector<std::string> texts{};
    for (const AnalysisOutcome& outcome : analyze_study(made_.study())) {
      for (const Phrase& remark : outcome.remarks) texts.push_back(remark.english());
    }
    return texts;
  }

  /// The text of every section and table of the report.
  std::string report() {
    std::string text{};
    for (const ReportChapter& chapter : study_report(made_.study()).chapters) {
      for (const ReportSection& section : chapter.sections) {
        for (const ReportPart& part : section.parts) {
          if (const auto* words = std::get_if<ReportText>(&part)) text += words->text + '\n';
          const auto* const table = std::get_if<ReportTable>(&part);
          if (table == nullptr) continue;
          for (const auto& row : table->rows) {
            for (const std::string& cell : row) text += cell + " | ";
            text += '\n';
          }
        }
      }
    }
    return text;
  }

  MadeUpStudy made_{};

 private:
  std::int64_t protocol_of(const std::string& version) {
    return made_.add_protocol("small", "selection", small_protocol(), version);
  }

  int people_ = 0;
};

TEST_F(PluginBuilds, OfOneVersionAreWarnedOfWithBothDigestsAtTheirStimulus) {
  EXPECT_THAT(warnings(), IsEmpty());
  add_session({kFormer, kFormer});
  add_session({kFormer});
  add_session({kLoaded});
  const std::vector<Diagnostic> found = warnings();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found.front().pointer, "/stimuli/rendered");
  EXPECT_THAT(found.front().message.english(),
              AllOf(HasSubstr("force model stochastic, version 1 (attempts: 3, SHA-256: " +
                              kFormer + "; the loaded plug-in has the SHA-256 " + kLoaded + ")"),
                    HasSubstr("; raise the version of the plug-in if its forces have changed")));
  EXPECT_THAT(warnings({}, "2"), IsEmpty()) << "another version";
}

TEST_F(PluginBuilds, AreWarnedOfOnlyIfTheirAttemptsWouldBeAnalysedTogether) {
  add_session({kFormer}, SessionMode::pilot);
  add_session({kFormer}, SessionMode::run, "0.9.0");
  const std::int64_t excluded = add_session({kFormer});
  made_.study().add_decision(
      excluded, {.verdict = Verdict::exclude, .reason = "former build", .decided_by = "MK"});
  EXPECT_THAT(warnings(SessionMode::run), IsEmpty());
  EXPECT_THAT(warnings(SessionMode::simulate), IsEmpty());
  EXPECT_THAT(warnings(SessionMode::pilot), SizeIs(1));
  EXPECT_THAT(warnings(), SizeIs(1));
}

TEST_F(PluginBuilds, ArePooledWithARemark) {
  const std::int64_t former = add_session({kFormer, kFormer});
  add_session({kLoaded}, SessionMode::pilot);
  EXPECT_THAT(remarks(), Each(Not(HasSubstr("builds")))) << "analysed separately";
  add_session({kLoaded});
  const std::string remark =
      "Different builds of the plug-in of the force model stochastic have the version 1, and the "
      "responses to them are pooled. Their SHA-256: aaaaaaaa… (attempts: 2), bbbbbbbb… (attempts: "
      "1). Raise the version of a plug-in";
  EXPECT_THAT(remarks(), Contains(HasSubstr(remark)));
  EXPECT_THAT(report(), HasSubstr(remark));
  made_.study().add_decision(
      former, {.verdict = Verdict::exclude, .reason = "former build", .decided_by = "MK"});
  EXPECT_THAT(remarks(), Each(Not(HasSubstr("builds"))));
}

TEST_F(PluginBuilds, AreInTheReport) {
  const std::int64_t session = add_session({kFormer});
  made_.study().add_event(session, {.time_ns = 5'000'000'000,
                                    .kind = "plugin",
                                    .text = "stochastic 1",
                                    .data_json = R"({"model": "stochastic", "version": "1",
                                        "sha256": ")" +
                                                 kFormer + R"(", "file": "noise.so"})"});
  const std::string text = report();
  EXPECT_THAT(text, HasSubstr("force model in a plug-in | stochastic 1, file noise.so, SHA-256 " +
                              kFormer + " |"));
  EXPECT_THAT(text, HasSubstr("with their versions: height_map 1 and stochastic 1 (plug-in)"));
  EXPECT_THAT(text, HasSubstr("force models height_map (version 1) and stochastic (version 1, a "
                              "plug-in with the SHA-256 aaaaaaaa…)"));
}

}  // namespace
}  // namespace asperity

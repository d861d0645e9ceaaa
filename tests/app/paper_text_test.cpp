// The paragraphs of a report that a paper prints.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/outcome/level_words.h"
#include "app/findings/outcome/references.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/outcome/test_methods.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/report/text/report_order.h"
#include "app/report/text/report_roughness.h"
#include "app/report/text/study_report.h"
#include "protocols/design/analysis_declaration.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/kinds/experiment_kind.h"
#include "renderers/built_in_models.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

/// The paragraphs under "Methods" or "Results", joined by blanks; empty where there are none.
std::string paragraph(const Report& report, const std::string& heading) {
  std::string paragraphs{};
  for (const ReportSection& section : report.chapters.at(1).sections) {
    if (section.heading != "Text for a paper") continue;
    bool is_below = false;
    for (const ReportPart& part : section.parts) {
      const auto* const text = std::get_if<ReportText>(&part);
      if (text == nullptr) break;
      if (text->tone == ReportText::Tone::lead) {
        is_below = text->text == heading;
      } else if (is_below) {
        paragraphs += (paragraphs.empty() ? "" : " ") + text->text;
      }
    }
  }
  return paragraphs;
}

/// The texts of the section "Results".
std::string results_of(MadeUpStudy& made) {
  const Report report = study_report(made.study());
  std::string text{};
  for (const ReportSection& section : report.chapters.at(1).sections) {
    if (section.heading != "Results") continue;
    for (const ReportPart& part : section.parts) {
      if (const auto* words = std::get_if<ReportText>(&part)) text += words->text + '\n';
      if (const auto* table = std::get_if<ReportTable>(&part)) text += table->note + '\n';
    }
  }
  return text;
}

/// The entries under "References".
std::vector<std::string> reference_list(const Report& report) {
  for (const ReportSection& section : report.chapters.at(1).sections) {
    if (section.heading != "Text for a paper") continue;
    for (const ReportPart& part : section.parts) {
      if (const auto* list = std::get_if<ReportList>(&part)) return list->items;
    }
  }
  return {};
}

MadeUpTrial one_of_two(const std::string& chosen) {
  MadeUpTrial trial{};
  trial.options = {"height_map", "sinusoid"};
  for (const std::string& model : trial.options) {
    trial.surfaces.push_back(surface_of(model, model, "brick"));
  }
  trial.answers = {chosen};
  return trial;
}

/// Two textures with their pictures, or with each other's.
MadeUpTrial matched(bool is_correct) {
  MadeUpTrial trial{};
  trial.options = {"brick", "stone"};
  for (const std::string& texture : trial.options) {
    trial.surfaces.push_back(surface_of(texture, "height_map", texture));
  }
  trial.right = trial.options;
  trial.answers = trial.options;
  if (!is_correct) std::swap(trial.answers.front(), trial.answers.back());
  return trial;
}

/// As many participants as entries, each of whom chose height_map so often in six trials.
Report report_of_choices(const std::vector<int>& height_map,
                         const std::vector<std::string>& family = {}) {
  MadeUpStudy made;
  made.study().set_metadata({.ethics_approval = "committee 12/2026"});
  nlohmann::json source = nlohmann::json::object();
  if (!family.empty()) source["analysis"]["family"] = family;
  const std::int64_t protocol = made.add_protocol("which", "selection", source.dump());
  for (std::size_t i = 0; i < height_map.size(); ++i) {
    const std::string label = "p" + std::to_string(i);
    made.add_person(label, i % 2 == 0 ? "F" : "M");
    std::vector<MadeUpTrial> trials{};
    for (int k = 0; k < 6; ++k) {
      trials.push_back(one_of_two(k < height_map[i] ? "height_map" : "sinusoid"));
    }
    made.add_session(label, protocol, trials);
  }
  return study_report(made.study());
}

/// Of eight participants, made once in this process.
const Report& report_of_eight() {
  static const Report kReport = report_of_choices({6, 5, 6, 5, 4, 6, 5, 6});
  return kReport;
}

TEST(PaperText, StatesADifferenceWithItsTestOnce) {
  const Report& report = report_of_eight();
  // All of 8 participants chose the one more often: p = 2/2⁸. The differences sum to 6+4+6+4+2+6+4+6.
  EXPECT_THAT(
      paragraph(report, "Results"),
      HasSubstr(
          ". In an exploratory test, the item height_map was chosen more often than "
          "sinusoid: sign-flip (randomisation) test, exact, D = 38, N = 8, p = .008, uncorrected; "
          "Cohen’s d of paired differences = "));
}

TEST(PaperText, CallsNoTestConfirmatoryThatTheProtocolDoesNotDeclare) {
  const Report& report = report_of_eight();
  EXPECT_THAT(paragraph(report, "Methods"),
              HasSubstr(" No test was declared in advance: all tests are exploratory. "));
  EXPECT_THAT(paragraph(report, "Results"), Not(HasSubstr("confirmatory")));
  EXPECT_THAT(paragraph(report, "Results"), Not(HasSubstr("The following tests are exploratory.")));
}

// Six models in a fixed order of preference: 15 pairs, more than a reader can take in as sentences.
TEST(PaperText, CountsManyTestsOfOneKind) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("which", "selection", R"({"analysis": {"family": ["pairs"]}})");
  const std::vector<std::string> models{"a", "b", "c", "d", "e", "f"};
  for (int person = 0; person < 12; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    made.add_person(label, "F");
    std::vector<MadeUpTrial> trials{};
    for (std::size_t i = 0; i < models.size(); ++i) {
      for (std::size_t j = i + 1; j < models.size(); ++j) {
        MadeUpTrial trial{};
        trial.options = {models[i], models[j]};
        for (const std::string& model : trial.options) {
          trial.surfaces.push_back(surface_of(model, model, "brick"));
        }
        trial.answers = {i == 4 && person % 2 == 0 ? models[j] : models[i]};
        trials.push_back(trial);
      }
    }
    made.add_session(label, protocol, trials);
  }
  const std::string results = paragraph(study_report(made.study()), "Results");
  EXPECT_THAT(results, HasSubstr("14 of the 15 tests of pairs were significant (largest of "
                                 "these p values, Holm-corrected: .007). The table of tests "
                                 "contains them with their effect sizes."));
  EXPECT_THAT(results, Not(HasSubstr("was chosen significantly more often than")));
}

// Six items on two scales: 15 pairs on each, more than there are sentences for exploratory tests.
TEST(PaperText, CountsAllExploratoryTestsOfOneKind) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("rated", "rating", R"({"kind": "rating",
    "blocks": {"only": {"questions": [
      {"name": "rough", "prompt": "How rough?", "scale": {"minimum": 1, "maximum": 100}},
      {"name": "hard", "prompt": "How hard?", "scale": {"minimum": 1, "maximum": 100}}]}}})");
  for (int person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    made.add_person(label, "F");
    std::vector<MadeUpTrial> trials{};
    for (int item = 0; item < 6; ++item) {
      MadeUpTrial trial{};
      const std::string name(1, static_cast<char>('a' + item));
      trial.surfaces = {surface_of(name, "height_map", name)};
      trial.questions = {"rough", "hard"};
      // Roughness differs little between the items; all participants agree on their hardness.
      trial.answers = {std::to_string(40 + (item * 7 + person * 11) % 13),
                       std::to_string(10 + 10 * item + person)};
      trials.push_back(trial);
    }
    made.add_session(label, protocol, trials);
  }
  const std::string results = paragraph(study_report(made.study()), "Results");
  EXPECT_THAT(results, HasSubstr(" of the 30 exploratory tests of pairs of items were below .05 "));
  EXPECT_THAT(results, Not(HasSubstr("further test")));
  EXPECT_THAT(results, HasSubstr("on the scale “hard”")) << "the tests of other kinds follow";
}

TEST(PaperText, SeparatesExploratoryTestsFromDeclaredOnes) {
  const Report report = report_of_choices({6, 5, 6, 5, 4, 6, 5, 6}, {"pairs", "preference"});
  EXPECT_THAT(
      paragraph(report, "Methods"),
      HasSubstr(" The p values of the 2 confirmatory tests (pairs and choices of the items) were "
                "Holm-corrected (Holm, 1979)."));
  EXPECT_THAT(paragraph(report, "Methods"), Not(HasSubstr("declared in advance")));
  EXPECT_THAT(paragraph(report, "Results"), HasSubstr(" The following tests are exploratory. "));
}

/// The list of references has exactly what the text cites.
TEST(PaperText, CitesEachPublicationBehindItsTest) {
  const Report& report = report_of_eight();
  EXPECT_THAT(
      paragraph(report, "Methods"),
      HasSubstr(" Tests: sign-flip (randomisation) test (Ernst, 2004), effect size Cohen’s d "
                "of paired differences (Cohen, 1988); within-participant permutation test "
                "(Ernst, 2004)"));
  std::string text = paragraph(report, "Methods") + paragraph(report, "Results");
  const std::vector<std::string> listed = reference_list(report);
  for (const Reference& each : references()) {
    const bool is_cited = text.find('(' + std::string(each.cited) + ')') != std::string::npos;
    EXPECT_EQ(std::count(listed.begin(), listed.end(), each.entry), is_cited ? 1 : 0) << each.key;
  }
}

TEST(PaperText, StatesTheMeansInTheSentencesOfConfirmatoryTests) {
  const std::string results =
      paragraph(report_of_choices({6, 5, 6, 5, 4, 6, 5, 6}, {"pairs"}), "Results");
  EXPECT_THAT(results, HasSubstr(". The item height_map was chosen significantly more often than "
                                 "sinusoid: sign-flip (randomisation) test, exact, D = 38, "));
  // 43 of 48 choices.
  EXPECT_THAT(results, HasSubstr("; means: 90 % (95 % CI ["));
  EXPECT_THAT(results, HasSubstr("%]) for height_map and 10 % (95 % CI ["));
}

TEST(PaperText, StatesTheDirectionOfADifference) {
  EXPECT_THAT(paragraph(report_of_choices({0, 1, 0, 1, 2, 0, 1, 0}), "Results"),
              HasSubstr(" the item height_map was chosen less often than sinusoid: "));
}

TEST(PaperText, ClaimsNothingOfADifferenceThatIsNotSignificant) {
  EXPECT_THAT(paragraph(report_of_choices({4, 2, 4, 2, 5, 1, 3, 3}), "Results"),
              HasSubstr(" the numbers of choices of height_map and sinusoid were not significantly "
                        "different: "));
}

TEST(PaperText, StatesWhyAConfirmatoryTestCouldNotBeMade) {
  const std::string results = paragraph(report_of_choices({6}), "Results");
  EXPECT_THAT(results, HasSubstr(". The test of pairs"));
  EXPECT_THAT(results, HasSubstr(" could not be computed: "));
}

TEST(PaperText, StatesWhoTookPartAndWhatWasAnalysed) {
  const std::string methods = paragraph(report_of_choices({6, 5, 6, 5}), "Methods");
  EXPECT_THAT(
      methods,
      StartsWith("Four participants (2 female and 2 male) took part in one session each. "));
  EXPECT_THAT(methods, HasSubstr(" Ethics approval: committee 12/2026."));
  EXPECT_THAT(methods, HasSubstr(" The 24 attempts at trials were analysed, with Asperity "));
  EXPECT_THAT(methods, Not(HasSubstr("Consent")));  // of which nothing is stored
}

// Fifteen pairs of six items, and six participants: 15·2^(1 − 6) = .469, and 15·2^(1 − n) is below it from n = 10 on.
TEST(PaperText, StatesThatNoneOfManyTestsCouldBeSignificant) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("rougher", "paired_comparison",
                        R"({"kind": "paired_comparison", "blocks": {"only": {
          "question": {"name": "rougher", "prompt": "Which is rougher?"}}},
          "analysis": {"family": ["pairs"]}})");
  const std::vector<std::string> items{"a", "b", "c", "d", "e", "f"};
  for (const char* const label : {"p1", "p2", "p3", "p4", "p5", "p6"}) {
    std::vector<MadeUpTrial> trials{};
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        MadeUpTrial& trial = trials.emplace_back();
        trial.surfaces = {surface_of(items[i], "height_map", items[i]),
                          surface_of(items[j], "height_map", items[j])};
        trial.options = {items[i], items[j]};
        trial.answers = {items[i]};
      }
    }
    made.add_person(label, "");
    made.add_session(label, protocol, trials);
  }
  EXPECT_THAT(paragraph(study_report(made.study()), "Results"),
              HasSubstr("; with these participants none of them could be significant: the smallest "
                        "attainable p is .469, and at least 10 participants whose difference is "
                        "not zero are required"));
}

TEST(PaperText, StatesThatNothingWasAnalysed) {
  MadeUpStudy made;
  made.add_person("p1", "F");
  const std::int64_t session = made.add_session("p1", made.add_protocol("which", "selection"),
                                                {one_of_two("sinusoid"), one_of_two("sinusoid")});
  made.study().add_decision(session, {.verdict = Verdict::exclude, .reason = "fire alarm"});
  const std::string methods = paragraph(study_report(made.study()), "Methods");
  EXPECT_THAT(methods, HasSubstr("One session was excluded from the analysis (fire alarm)."));
  EXPECT_THAT(methods, HasSubstr("None of the 2 attempts at trials was included in the analysis."));
}

TEST(PaperText, StatesThatFilesInTwoLanguagesDifferInTextsOnly) {
  MadeUpStudy made;
  int sessions = 0;
  const auto add = [&](const std::string& source) {
    const std::string label = "p" + std::to_string(++sessions);
    made.add_person(label, "F");
    made.add_session(label, made.add_protocol("which", "selection", source),
                     {one_of_two("sinusoid"), one_of_two("height_map")});
  };
  const auto design = [&made] {
    const ReportSection section = study_report(made.study()).chapters.at(1).sections.front();
    return std::get<ReportText>(section.parts.front()).text;
  };
  add(R"({"language": "en", "title": "Which?"})");
  add(R"({"language": "de", "title": "Welche?"})");
  EXPECT_THAT(design(),
              AllOf(StartsWith("Two texts have the name and version of this protocol. They "
                               "differ in language and texts only; "),
                    EndsWith(" Participants by language: 1 (de), 1 (en).")));
  EXPECT_THAT(results_of(made), Not(HasSubstr("different files")));
  add(R"({"language": "de", "title": "Welche?", "sessions": 2})");
  EXPECT_THAT(design(), StartsWith("Three different texts have the name and version"));
  EXPECT_THAT(results_of(made), HasSubstr("2 different files have this protocol name"));
}

TEST(PaperText, StatesThatScalesInTwoLanguagesWereNotCompared) {
  MadeUpStudy made;
  int sessions = 0;
  const auto add = [&](const std::string& language, const std::string& label) {
    const std::string participant = "p" + std::to_string(++sessions);
    const std::string source = R"({"language": ")" + language +
                               R"(", "questions": {"pain": {"prompt": "?", "form": "scale",
                                   "scale": {"labels": [")" +
                               label + R"(", "10"]}}}})";
    made.add_person(participant, "F");
    made.add_session(participant, made.add_protocol("which", "selection", source),
                     {one_of_two("sinusoid"), one_of_two("height_map")});
  };
  const auto design = [&made] {
    const ReportSection section = study_report(made.study()).chapters.at(1).sections.front();
    return std::get<ReportText>(section.parts.front()).text;
  };
  add("en", "none");
  EXPECT_THAT(design(), Not(HasSubstr("by language")));
  add("de", "keine");
  add("de", "keine");
  EXPECT_THAT(design(),
              EndsWith(" Participants by language: 2 (de), 1 (en). The scales have labels "
                       "in words; whether they are equivalent in these languages was not "
                       "tested."));
}

TEST(PaperText, DoesNotCallUndeclaredWhatFilesDeclareDifferently) {
  MadeUpStudy made;
  int sessions = 0;
  for (const char* family : {R"(["pairs"])", R"(["preference"])"}) {
    const std::int64_t id = made.add_protocol(
        "which", "selection", std::string(R"({"analysis": {"family": )") + family + "}}");
    for (int i = 0; i < 2; ++i) {
      const std::string label = "p" + std::to_string(++sessions);
      made.add_person(label, "F");
      made.add_session(label, id, {one_of_two("sinusoid"), one_of_two("height_map")});
    }
  }
  const std::string methods = paragraph(study_report(made.study()), "Methods");
  EXPECT_THAT(methods, HasSubstr("The files of the protocol declare different tests"));
  EXPECT_THAT(methods, Not(HasSubstr("No test was declared")));
}

TEST(ReportOfTests, ExplainsTheSymbolsOfItsTableOnly) {
  MadeUpStudy made;
  const auto add = [&made](const std::string& protocol, const std::string& source) {
    const std::int64_t id = made.add_protocol(protocol, "matching", source);
    for (int i = 0; i < 6; ++i) {
      const std::string label = "p" + std::to_string(i);
      made.add_session(label, id, {matched(i < 4), matched(true)});
    }
  };
  for (int i = 0; i < 6; ++i) made.add_person("p" + std::to_string(i), i % 2 == 0 ? "F" : "M");
  add("match", "{}");
  EXPECT_THAT(results_of(made), HasSubstr("k: number correct"));
  EXPECT_THAT(results_of(made), Not(HasSubstr("ΔM")));
  EXPECT_THAT(results_of(made), Not(HasSubstr("Hedges")));
  add("a_match_of_sexes", R"({"analysis": {"family": ["items", "sexes"]}})");
  EXPECT_THAT(results_of(made),
              HasSubstr("ΔM: difference of the mean numbers of correctly matched items per trial"));
}

TEST(PaperText, StatesMeanProportionsOfChoicesWithTheChanceLevel) {
  const std::string results = paragraph(report_of_choices({6, 5, 6, 5, 4, 6}), "Results");
  EXPECT_THAT(results,
              MatchesRegex("Mean proportions of choices were 89 % \\(95 % CI \\[.*\\]\\) for "
                           "height_map and 11 % \\(95 % CI \\[.*\\]\\) for sinusoid, N = 6; "
                           "the chance level was 50 %\\. .*"));
}

TEST(PaperText, StatesIncompleteSessionsAndWhoseDataWereAnalysed) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("which", "selection");
  const std::vector<MadeUpTrial> trials{one_of_two("sinusoid"), one_of_two("height_map")};
  for (const char* label : {"p1", "p2", "p3"}) made.add_person(label, "F");
  made.add_session("p1", protocol, trials);
  made.set_state(SessionState::stopped);
  made.add_session("p2", protocol, trials);
  const std::int64_t third = made.add_session("p3", protocol, trials);
  made.study().add_decision(third, {.verdict = Verdict::exclude, .reason = "fire alarm"});
  const std::string methods = paragraph(study_report(made.study()), "Methods");
  EXPECT_THAT(methods, HasSubstr(" took part in one session each. Two sessions were not completed "
                                 "(stopped). One session "
                                 "was excluded from the analysis (fire alarm)."));
  EXPECT_THAT(methods,
              HasSubstr("Four of the 6 attempts at trials were analysed (of the others, two "
                        "were excluded), with Asperity "));
  EXPECT_THAT(methods, HasSubstr(" They were made by two of the three participants."));
}

TEST(PaperText, StatesTheChanceLevelOfProportions) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("match", "matching");
  for (int i = 0; i < 6; ++i) {
    const std::string label = "p" + std::to_string(i);
    made.add_person(label, "F");
    made.add_session(label, protocol, {matched(i < 4), matched(true)});
  }
  const std::string results = paragraph(study_report(made.study()), "Results");
  EXPECT_THAT(results, HasSubstr(" the proportion of correctly matched items was"));
  EXPECT_THAT(results, HasSubstr(" above the chance level of 50 %: "));
}

/// Conditions are named by the factors and levels of the stored protocol.
TEST(PaperText, NamesFactorsLevelsAndTheTask) {
  MadeUpStudy made;
  const auto library = library_protocols();
  const auto tools = std::find_if(library.begin(), library.end(),
                                  [](const auto& each) { return each.name == "tools_matching"; });
  ASSERT_NE(tools, library.end());
  MadeUpTrial trial{};
  trial.options = {"fine", "medium", "coarse"};
  for (const std::string& tool : trial.options) {
    trial.surfaces.push_back(surface_of(tool, "pd_gradient", tool));
  }
  trial.right = trial.options;
  trial.answers = trial.options;
  made.add_person("p1", "F");
  made.add_session("p1", made.add_protocol("tools_matching", "matching", std::string(tools->text)),
                   {trial, trial});
  const std::string methods = paragraph(study_report(made.study()), "Methods");
  EXPECT_THAT(
      methods,
      HasSubstr(" The factor was file (fine, medium and coarse). In each trial, three "
                "stimuli were presented, one for each level of file, and each was to "
                "be assigned to one of an equal number of pictures. The question was “Which "
                "picture belongs to which tool?” The surfaces of a trial were presented one after "
                "another. Participants could not return to a surface within a trial. A session was "
                "planned with 2 "
                "experimental trials. Trials were presented in "));
  EXPECT_THAT(methods, HasSubstr(" 12 repetitions"));
  EXPECT_THAT(methods, HasSubstr("; attempts outside these limits were "));
  EXPECT_THAT(methods, HasSubstr(" An attempt at a trial was invalid if more than "));
  EXPECT_THAT(methods, Not(HasSubstr("texture")));
}

std::string library_text(const std::string& name) {
  for (const auto& each : library_protocols()) {
    if (each.name == name) return std::string(each.text);
  }
  return {};
}

/// The methods of a study of one participant with two discriminations of a library protocol, changed by `patch`.
std::string methods_of_discrimination(const std::string& name, const nlohmann::json& patch = {}) {
  auto source = nlohmann::ordered_json::parse(library_text(name));
  if (!patch.is_null()) source.merge_patch(patch);
  MadeUpStudy made;
  made.add_person("p1", "F");
  MadeUpTrial trial{};
  trial.block = "comparisons";
  trial.surfaces = {surface_of("standard", "sinusoid", ""),
                    surface_of("comparison", "sinusoid", "")};
  trial.options = {"standard", "comparison"};
  trial.right = {"comparison"};
  trial.answers = {"comparison"};
  made.add_session("p1", made.add_protocol(name, "discrimination", source.dump()), {trial, trial});
  return paragraph(study_report(made.study()), "Methods");
}

const std::string& methods_of_amplitude_jnd() {
  static const std::string kMethods = methods_of_discrimination("amplitude_jnd");
  return kMethods;
}

// The direction of the force has its default value, and belongs to the table only.
TEST(PaperText, StatesTheParametersOfTheProtocolAndListsAllInATable) {
  const ModelRegistry models = built_in_models();
  MadeUpStudy made;
  made.add_person("p1", "F");
  MadeUpTrial trial{};
  trial.block = "comparisons";
  for (const double amplitude_m : {50e-6, 60e-6}) {
    PresentationRow surface =
        surface_of(trial.surfaces.empty() ? "standard" : "comparison", "sinusoid", "");
    nlohmann::json parameters{};
    for (const auto& [name, value] :
         complete_values(models.find("sinusoid")->declaration,
                         {{"amplitude_m", amplitude_m}, {"wavelength_m", 0.0025}})) {
      std::visit([&, name = name](const auto& each) { parameters[name] = each; }, value);
    }
    surface.parameters_json = parameters.dump();
    trial.surfaces.push_back(surface);
  }
  trial.options = {"standard", "comparison"};
  trial.right = {"comparison"};
  trial.answers = {"comparison"};
  made.add_session(
      "p1", made.add_protocol("amplitude_jnd", "discrimination", library_text("amplitude_jnd")),
      {trial, trial});
  const Report report = study_report(made.study());
  const std::string methods = paragraph(report, "Methods");
  EXPECT_THAT(methods,
              HasSubstr("The parameters of the force model were: amplitude 50 µm and 60 µm, "
                        "wavelength 2.5 mm. All others had their default values; the report "
                        "of the study lists all parameters. The friction law was elastoplastic."));
  EXPECT_THAT(methods, Not(HasSubstr("force direction")));
  std::vector<std::vector<std::string>> rows{};
  for (const ReportSection& section : report.chapters.back().sections) {
    for (const ReportPart& part : section.parts) {
      const auto* const table = std::get_if<ReportTable>(&part);
      if (table != nullptr && table->title.starts_with("Parameters")) rows = table->rows;
    }
  }
  using Row = std::vector<std::string>;
  EXPECT_THAT(rows, testing::Contains(Row{"sinusoid", "wavelength", "2.5 mm"}));
  EXPECT_THAT(rows, testing::Contains(Row{"sinusoid", "force direction", "fixed"}));
  EXPECT_THAT(rows, testing::Contains(Row{"sinusoid", "friction law", "elastoplastic"}));
}

TEST(PaperText, StatesTheConsequenceOfAVibration) {
  const std::string limit =
      "if a surface vibrated above 150 Hz with an RMS force of more than 0.4 times its texture "
      "force, which was counted as at least 20 mN.";
  const auto methods_with = [](const char* consequence) {
    return methods_of_discrimination("amplitude_jnd",
                                     {{"instability", {{"buzz_max", 0.4}, {"on", consequence}}}});
  };
  EXPECT_THAT(
      methods_with("repeat_now"),
      HasSubstr(" lost. An attempt was also invalid, and was repeated at most twice, " + limit));
  EXPECT_THAT(methods_with("flag"), HasSubstr(" lost. An attempt was flagged " + limit));
  EXPECT_THAT(methods_of_amplitude_jnd(), Not(HasSubstr("vibrated")));
}

TEST(PaperText, StatesHowAStaircaseChoseTheLevels) {
  const std::string& methods = methods_of_amplitude_jnd();
  EXPECT_THAT(
      methods,
      HasSubstr("A 3-down/1-up staircase (Levitt, 1971) with a target of 79.4 % correct "
                "responses chose the amplitude of the comparison from the responses, in "
                "two randomly interleaved tracks. The tracks began at 50 % and 34 %, and "
                "levels remained between 2 % and 100 %. Steps were 16 % of the standard up "
                "to the first reversal, 8 % up to the second and 4 % thereafter. Each track "
                "ended after 40 trials. One in every 20 trials, at a random place, was a "
                "catch trial, in which the comparison differed from the standard by 150 %; "
                "no threshold was estimated from catch trials. "));
  EXPECT_THAT(methods, Not(HasSubstr("random order, the positions of the surfaces balanced over "
                                     "the trials, with a break")));
  EXPECT_THAT(methods, HasSubstr(" The slope of the function was limited to 1 to 8. "));
}

TEST(PaperText, StatesLevelsInDecibelsAsDifferences) {
  const Protocol protocol = read_protocol(std::string(library_text("realism_of_models")),
                                          "file.json", declarations_of(built_in_models()));
  const auto varied = std::find_if(protocol.blocks.begin(), protocol.blocks.end(),
                                   [](const auto& named) { return named.second.vary.has_value(); });
  ASSERT_NE(varied, protocol.blocks.end());
  EXPECT_EQ(as_possible(levels_text(varied->second, "it")),
            "could differ from it by −16 dB to 14 dB in 31 levels");
}

TEST(PaperText, StatesAfterWhichTrialsThereAreBreaks) {
  const auto breaks = [](int trials) {
    Protocol::Run run{};
    run.break_every_trials = trials;
    run.pause = Protocol::Break{};
    run.pause->minimum_s = 30.0;
    return order_of_run(Protocol{}, Protocol::Block{}, run, Tense::past);
  };
  EXPECT_THAT(breaks(1), testing::EndsWith(", with a break of at least 30 s after every trial"));
  EXPECT_THAT(breaks(4), testing::EndsWith(", with a break of at least 30 s after every 4 trials"));
}

TEST(PaperText, StatesWhichTrialsAreLeftOutAndRepeatedWithUnits) {
  Protocol protocol{};
  protocol.factors["deep"] = {.name = "deep", .levels = {2e-5, 5e-5}};
  StimulusTemplate stimulus{};
  stimulus.parameters["amplitude_m"].factor = "deep";
  protocol.stimuli["grating"] = stimulus;
  Protocol::Block made{};
  made.order = Protocol::Block::Order::shuffle;
  made.exclude = {{{"deep", 2e-5}, {"side", std::string("left")}}};
  made.repetitions_of = {{.levels = {{"deep", 5e-5}}, .repetitions = 3}};
  made.repetitions = 2;
  EXPECT_EQ(
      order_of_run(protocol, made, {}, Tense::past),
      "in random order (without the combination of deep 20 µm and side left; trials with deep "
      "50 µm presented 3 times), 2 repetitions");
}

TEST(PaperText, StatesThatForcesWereMatchedBeforeTheRoughness) {
  ReportFacts facts{};
  EXPECT_EQ(equal_force_text(facts), "");
  facts.has_equal_force = true;
  EXPECT_THAT(equal_force_text(facts), StartsWith("The force models were matched"));
  facts.roughness_matches[MatchStatus::matched] = 5;
  EXPECT_THAT(equal_force_text(facts),
              StartsWith("Before their roughness was matched, the force models were matched"));
}

TEST(PaperText, StatesTheStepsOfAWeightedStaircase) {
  EXPECT_THAT(methods_of_discrimination("spacing_jnd"),
              HasSubstr("A weighted up-down staircase (Kaernbach, 1991) with a target of 75.0 % "
                        "correct responses chose the wavelength of the comparison from the "
                        "responses. It began at 30 %, and levels remained between 1 % and 60 %. "
                        "Steps downwards were 6 % of the standard up to the first reversal, 4 % up "
                        "to the second and 2 % thereafter, and those upwards were 3 times as "
                        "large. The staircase ended after 60 trials."));
}

TEST(PaperText, StatesThatCatchTrialsPresentedTwoStandards) {
  const nlohmann::json block{
      {"procedure", {{"catch_trials", {{"type", "no_signal"}, {"every", 20}}}}},
      {"question", {{"allow_cannot_tell", true}}}};
  EXPECT_THAT(methods_of_discrimination("spacing_jnd", {{"blocks", {{"comparisons", block}}}}),
              HasSubstr("was a catch trial, in which two standards were presented and “cannot "
                        "tell” was the correct response; no threshold was estimated"));
}

TEST(PaperText, StatesHowPsiChoseTheLevels) {
  const nlohmann::json psi{
      {"method", "psi"},
      {"marginalise", {"slope", "lapse"}},
      {"stop",
       {{"trials", 60},
        {"interval", {{"ratio", 1.5}, {"minimum_trials", 30}, {"minimum_of_each", 5}}}}}};
  nlohmann::json patch{{"blocks", {{"comparisons", {{"procedure", psi}}}}}};
  for (const char* const key : {"target", "steps_down", "start", "tracks", "catch_trials"}) {
    patch["blocks"]["comparisons"]["procedure"][key] = nullptr;
  }
  const std::string methods = methods_of_discrimination("spacing_jnd", patch);
  EXPECT_THAT(
      methods,
      HasSubstr("The psi procedure (Kontsevich & Tyler, 1999), with slope and lapse rate "
                "marginalised (Prins, 2013), chose the wavelength of the comparison from the "
                "responses. Levels remained between 1 % and 60 %. Before the first response, a "
                "Weibull function of the difference from the standard had equally probable values "
                "of its threshold at 75.0 % correct responses (41 values between 1 % and 60 %, in "
                "steps of equal ratio), its slope (8 values between 1 and 8) and its lapse rate (4 "
                "values between 0 % and 6 %). The track ended when the upper end of the 95 % "
                "credible interval of the threshold was at most 1.5 times the lower end, after at "
                "least 30 trials with at least 5 correct and as many incorrect responses, or at "
                "the latest after 60 trials."));
  EXPECT_THAT(methods, HasSubstr("its 95 % credible interval (CrI) has equal tails."));
  EXPECT_THAT(methods, Not(HasSubstr("running the procedure again")));
}

TEST(PaperText, StatesEveryRuleThatEndsATrack) {
  const std::string methods = methods_of_discrimination(
      "spacing_jnd",
      {{"blocks",
        {{"comparisons",
          {{"procedure",
            {{"stop", {{"trials", 60}, {"reversals", 8}, {"clipped_moves", 3}}}}}}}}}});
  EXPECT_THAT(
      methods,
      HasSubstr("The staircase ended after 8 reversals, or when an end of the range of levels had "
                "limited 3 steps in succession, or at the latest after 60 trials."));
}

// Constant stimuli are a procedure of the protocol, but no levels depend on responses.
TEST(PaperText, StatesConstantStimuliWithoutTheIntervalsOfStaircases) {
  const std::string methods = methods_of_discrimination(
      "spacing_jnd", {{"blocks",
                       {{"comparisons",
                         {{"vary", {{"levels_percent", nullptr}, {"levels_ratio", {1.0125, 1.3}}}},
                          {"procedure",
                           {{"method", "constant_stimuli"},
                            {"repetitions", 20},
                            {"target", nullptr},
                            {"steps_down", nullptr},
                            {"start", nullptr},
                            {"stop", nullptr}}}}}}}});
  EXPECT_THAT(methods, HasSubstr("had ratios to it of 1.0125 and 1.3. The choice of the comparison "
                                 "was correct. The levels were presented by the method of constant "
                                 "stimuli, each 20 times."));
  EXPECT_THAT(methods, Not(HasSubstr("simulated observers")));
  EXPECT_THAT(methods, HasSubstr("single participants are by the delta method."));
  EXPECT_THAT(methods, HasSubstr("Trials were presented in random order"));
}

TEST(PaperText, StatesPracticeExposureAndFeedback) {
  const std::string& methods = methods_of_amplitude_jnd();
  EXPECT_THAT(methods, HasSubstr(" was drawn between 0.8 s and 1.2 s. A visit ended after 3 "
                                 "strokes. Participants could not return to a surface within a "
                                 "trial. The place on the texture was drawn for each "
                                 "presentation."));
  EXPECT_THAT(
      methods,
      HasSubstr(" Practice trials were presented in random order within each repetition, the "
                "positions of the surfaces balanced over the trials, until 5 of the last 6 "
                "trials were correct, at most 12 trials, with feedback on whether each "
                "response was correct. In these, the amplitude of the comparison differed "
                "from that of the standard by 45 % and 75 %. No feedback was given in the "
                "experimental trials."));
}

/// The library's protocol has ratings and a recognition, here with a rating of confidence.
TEST(PaperText, StatesThePointsOfScalesAndNamesBlocks) {
  const auto library = library_protocols();
  const auto known = std::find_if(library.begin(), library.end(), [](const auto& each) {
    return each.name == "attributes_of_textures";
  });
  ASSERT_NE(known, library.end());
  auto source = nlohmann::ordered_json::parse(known->text);
  auto& block = source["blocks"]["recognition"];
  const auto asked = block["question"];
  block.erase("question");
  block["questions"] = {
      asked,
      {{"name", "sure"}, {"prompt", "How sure?"}, {"scale", {{"minimum", 0}, {"maximum", 100}}}}};
  MadeUpStudy made;
  MadeUpTrial trial{};
  trial.block = "ratings";
  trial.surfaces = {surface_of("wood", "height_map", "wood")};
  trial.questions = {"rough"};
  trial.answers = {"2"};
  made.add_person("p1", "F");
  made.add_session("p1", made.add_protocol("attributes", "rating", source.dump()), {trial, trial});
  const std::string methods = paragraph(study_report(made.study()), "Methods");
  EXPECT_THAT(methods, HasSubstr("ratings were given on five scales with 7 points from −3 to 3."));
  EXPECT_THAT(methods, HasSubstr("Each response of the absolute identification was accompanied by "
                                 "ratings on one continuous scale from 0 to 100."));
  EXPECT_THAT(methods,
              HasSubstr(" In the block “ratings”, trials were presented in random order "));
  EXPECT_THAT(methods, HasSubstr(" In the block “recognition”, trials were presented in "));
}

/// Every test that a study can report has words, and every work that is cited an entry.
TEST(PaperText, HasWordsForEveryTestAndEntriesForEverySource) {
  for (const ExperimentKind* const kind : experiment_kinds()) {
    for (const KindTest& named : kind->tests) {
      StudyTests::Test test{
          .name = std::string(named.name), .about = {"a", "b"}, .made_by = test_method("p")};
      test.n = 7;
      for (const double p : {0.01, 0.5}) {
        test.p = p;
        EXPECT_THAT(sentence_of_test(test, kind->id).text, Not(StartsWith(":")))
            << kind->id << ' ' << named.name;
      }
    }
  }
  for (const TestMethod& method : test_methods()) {
    for (const std::string_view source : method.sources) {
      if (source.empty()) continue;
      EXPECT_NO_THROW(reference(source)) << source;
    }
  }
}

}  // namespace
}  // namespace asperity

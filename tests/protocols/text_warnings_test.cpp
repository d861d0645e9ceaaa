// Texts that contradict the design of a library protocol are named, and those that state it are not.

#include "protocols/warnings/text_warnings.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/file/translation.h"
#include "protocols/plan/course.h"
#include "renderers/built_in_models.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

std::string library_text(const std::string& name, const std::string& language) {
  const auto all = library_protocols();
  const auto found =
      std::find_if(all.begin(), all.end(), [&name](const auto& each) { return each.name == name; });
  if (language == "en") return std::string(found->text);
  return translated(found->text, name, {found->translations.front().text, "de", language}).text;
}

std::vector<std::string> warnings_of(const std::string& text) {
  static const std::vector<ModelDeclaration> kModels = declarations_of(built_in_models());
  const Protocol protocol = read_protocol(text, "test.json", kModels);
  std::vector<std::string> messages{};
  for (const Diagnostic& each :
       warnings_about_texts(protocol, "test.json", example_plan(protocol, {1, 0}))) {
    messages.push_back(each.pointer + ": " + each.message.english());
    EXPECT_EQ(test::untranslated(each.message), "");
  }
  return messages;
}

/// The protocol with a sentence added to its third screen, which instructs the participant.
std::string with_sentence(const std::string& protocol, const std::string& language,
                          const std::string& sentence) {
  json root = json::parse(library_text(protocol, language));
  int screens = 0;
  for (json& step : root.at("flow")) {
    if (!step.contains("screen") || ++screens < 3) continue;
    step.at("screen") = step.at("screen").get<std::string>() + ' ' + sentence;
    break;
  }
  return root.dump();
}

struct Statement {
  const char* protocol = "";
  const char* language = "en";
  const char* sentence = "";
  const char* words = "";  ///< that the warning quotes; empty: the statement is true
};

class TextStatements : public testing::TestWithParam<Statement> {};

TEST_P(TextStatements, AreComparedWithTheDesign) {
  const Statement& stated = GetParam();
  const std::vector<std::string> found =
      warnings_of(with_sentence(stated.protocol, stated.language, stated.sentence));
  if (stated.words[0] == '\0') {
    EXPECT_THAT(found, IsEmpty()) << stated.sentence;
    return;
  }
  ASSERT_EQ(found.size(), 1U) << stated.sentence << testing::PrintToString(found);
  EXPECT_THAT(found.front(), HasSubstr("\"" + std::string(stated.words) + "\""));
  EXPECT_THAT(found.front(), testing::StartsWith("/flow/"));
}

INSTANTIATE_TEST_SUITE_P(
    Contradictions, TextStatements,
    testing::Values(
        Statement{"semantic_differential", "en", "Mark on each of four scales.", "four scales"},
        Statement{"semantic_differential", "en", "There are 7 labelled scales.",
                  "7 labelled scales"},
        Statement{"semantic_differential", "en", "You will feel two surfaces.", "two surfaces"},
        Statement{"semantic_differential", "en", "Choose one of the three pictures.", "pictures"},
        Statement{"amplitude_jnd", "en", "Mark the answer on the line.", "answer on the line"},
        Statement{"semantic_differential", "en", "If you cannot tell, choose “I cannot tell”.",
                  "I cannot tell"},
        Statement{"semantic_differential", "en", "Answer nine questions.", "nine questions"},
        Statement{"semantic_differential", "en", "The session takes 240 minutes.", "240 minutes"},
        Statement{"attributes_of_textures", "en", "Mark on each of eight scales.", "eight scales"},
        Statement{"attributes_of_textures", "en", "You will see nine pictures.", "nine pictures"},
        Statement{"amplitude_jnd", "en", "You will feel three surfaces.", "three surfaces"},
        Statement{"amplitude_jnd", "en", "You will feel one surface.", "one surface"},
        Statement{"amplitude_jnd", "en", "Mark your answer on the scale.", "on the scale"},
        Statement{"amplitude_jnd", "en", "There are 7 trials.", "7 trials"},
        Statement{"amplitude_jnd", "en", "You will make nineteen practice trials.",
                  "nineteen practice trials"},
        Statement{"amplitude_jnd", "en", "Please keep the blindfold on.", "the blindfold"},
        Statement{"amplitude_jnd", "en", "The session takes about 2 minutes.", "2 minutes"},
        Statement{"chapter_selection", "en", "You will feel two surfaces.", "two surfaces"},
        Statement{"chapter_selection", "en", "First you will practise the task.",
                  "practise the task"},
        Statement{"chapter_selection", "en", "First, become familiar with the task.",
                  "become familiar"},
        Statement{"chapter_matching", "en", "You will see five pictures.", "five pictures"},
        Statement{"chapter_matching", "en", "Each of the 6 surfaces belongs to a picture.",
                  "6 surfaces"},
        Statement{"chapter_recognition", "en", "Choose one of twelve pictures.", "twelve pictures"},
        Statement{"roughness_force", "en", "The main part has five blocks.", "five blocks"},
        Statement{"roughness_force", "en", "Mark it on the scale.", "on the scale"},
        Statement{"roughness_force", "en", "Choose the picture that fits.", "the picture"},
        Statement{"tools_matching", "en", "You will feel four tools.", "four tools"},
        Statement{"semantic_differential", "de", "Markieren Sie auf vier Skalen.", "vier Skalen"},
        Statement{"semantic_differential", "de", "Sie fühlen zwei Oberflächen.",
                  "zwei Oberflächen"},
        Statement{"amplitude_jnd", "de", "Markieren Sie es auf der Linie.", "Sie es auf der Linie"},
        Statement{"semantic_differential", "de", "Die Sitzung dauert 240 Minuten.", "240 Minuten"},
        Statement{"amplitude_jnd", "de", "Sie fühlen drei Oberflächen.", "drei Oberflächen"},
        Statement{"amplitude_jnd", "de", "Markieren Sie es auf der Skala.", "auf der Skala"},
        Statement{"amplitude_jnd", "de", "Es gibt neunzehn Übungsdurchgänge.",
                  "neunzehn Übungsdurchgänge"},
        Statement{"amplitude_jnd", "de", "Es gibt sieben Durchgänge.", "sieben Durchgänge"},
        Statement{"amplitude_jnd", "de", "Bitte setzen Sie die Augenbinde auf.", "Augenbinde"},
        Statement{"chapter_selection", "de", "Zuerst üben Sie die Aufgabe.",
                  "üben Sie die Aufgabe"},
        Statement{"chapter_matching", "de", "Sie sehen fünf Bilder.", "fünf Bilder"},
        Statement{"roughness_force", "de", "Der Hauptteil besteht aus fünf Blöcken.",
                  "fünf Blöcken"},
        Statement{"tools_matching", "de", "Sie fühlen vier Werkzeuge.", "vier Werkzeuge"}));

INSTANTIATE_TEST_SUITE_P(
    True, TextStatements,
    testing::Values(
        Statement{"semantic_differential", "en", "Mark on each of the eight scales."},
        Statement{"semantic_differential", "en", "You will feel one surface at a time."},
        Statement{"semantic_differential", "en", "Two to four surfaces are smooth."},
        Statement{"semantic_differential", "en", "Feel it for at least three minutes."},
        Statement{"semantic_differential", "en", "The first two surfaces are easy."},
        Statement{"semantic_differential", "en", "You may feel one of the surfaces again."},
        Statement{"amplitude_jnd", "en", "Compare the two soft surfaces."},
        Statement{"amplitude_jnd", "en", "There is a break every 5 minutes."},
        Statement{"amplitude_jnd", "en", "Every break lasts 2 minutes."},
        Statement{"amplitude_jnd", "en", "You may pause at any time."},
        Statement{"amplitude_jnd", "en", "Stroke each of them three times."},
        Statement{"amplitude_jnd", "en", "You may take a break at any time."},
        Statement{"amplitude_jnd", "en", "Stay on one surface until the tone sounds."},
        Statement{"amplitude_jnd", "en",
                  "No photographs are taken, in accordance with good practice."},
        Statement{"amplitude_jnd", "en", "You will not be blindfolded, and there are no pictures."},
        Statement{"amplitude_jnd", "en", "The practice takes about five minutes."},
        Statement{"amplitude_jnd", "en", "There are about 80 trials, with pauses of 1.5 minutes."},
        Statement{"roughness_force", "en",
                  "If two surfaces feel equally rough, give the same number."},
        Statement{"roughness_force", "en", "Two surfaces may feel the same."},
        Statement{"roughness_force", "en", "Use any scale you like; there is no upper limit."},
        Statement{"semantic_differential", "de", "Antworten Sie auf einer Skala von 0 bis 100."},
        Statement{"chapter_recognition", "de", "Klicken Sie auf ein Bild."},
        Statement{"amplitude_jnd", "de", "Drücken Sie leicht auf eine Oberfläche."},
        Statement{"amplitude_jnd", "de", "Üben Sie nur leichten Druck aus."},
        Statement{"amplitude_jnd", "de", "Es werden keine Bilder gemacht."},
        Statement{"amplitude_jnd", "de", "Fühlen Sie 2–4 Oberflächen, oder mehr."},
        Statement{"chapter_matching", "en", "Four pictures belong to the four surfaces."},
        Statement{"roughness_force", "en", "The main part has three blocks."},
        Statement{"amplitude_jnd", "de", "Sie vergleichen zwei raue Oberflächen."},
        Statement{"amplitude_jnd", "de", "Eine Oberfläche ist rauer."},
        Statement{"amplitude_jnd", "de", "Sie können jederzeit eine Pause machen."},
        Statement{"tools_matching", "de", "Sie fühlen nacheinander drei Werkzeuge."}));

TEST(TextWarnings, AreNotMadeForTheLibrary) {
  for (const LibraryProtocol& protocol : library_protocols()) {
    for (const char* const language : {"en", "de"}) {
      EXPECT_THAT(warnings_of(library_text(std::string(protocol.name), language)), IsEmpty())
          << protocol.name << ' ' << language;
    }
  }
}

/// A design that changes under a text that stays.
TEST(TextWarnings, NameTheTextsThatAChangedDesignLeavesBehind) {
  std::string text = library_text("semantic_differential", "en");
  const std::string placeholder = "{scales}";
  for (std::size_t at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder)) {
    text.replace(at, placeholder.size(), "eight");
  }
  json root = json::parse(text);
  EXPECT_THAT(warnings_of(text), IsEmpty());
  for (auto& [name, block] : root.at("blocks").items()) {
    block.at("questions").erase(block.at("questions").begin() + 4, block.at("questions").end());
  }
  root.erase("analysis");
  const std::vector<std::string> found = warnings_of(root.dump());
  ASSERT_FALSE(found.empty());
  for (const std::string& each : found) {
    EXPECT_THAT(each, HasSubstr("the text states \"eight scales\", but the number of scales is 4; "
                                "correct the text, or write {scales}"));
  }
}

TEST(TextWarnings, ReadAPageOfABlockForThisBlockAlone) {
  json root = json::parse(library_text("attributes_of_textures", "en"));
  root.at("blocks").at("ratings").at("page_prompt") = "Mark on the six scales.";
  const std::vector<std::string> found = warnings_of(root.dump());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found.front(), testing::StartsWith("/blocks/ratings/page_prompt: "));
}

TEST(TextWarnings, CompareMinutesWithTheSessionOfTheGroupThatReadsThem) {
  const auto warnings_for = [](const std::string& group) {
    json root = json::parse(library_text("semantic_differential", "en"));
    root["factors"]["light"]["levels"] = {"dawn", "dusk"};
    root["groups"]["factor"] = "light";
    json flow = json::array();
    for (int i = 0; i < 3; ++i) {  // an hour of reading, at three words a second
      std::string words{};
      for (int word = 0; word < 3600; ++word) words += "a ";
      flow.push_back({{"screen", words}, {"groups", {"dusk"}}});
    }
    flow.push_back({{"screen", "The session takes 80 minutes."}, {"groups", {group}}});
    for (const json& step : root.at("flow")) flow.push_back(step);
    root["flow"] = flow;
    return warnings_of(root.dump());
  };
  EXPECT_THAT(warnings_for("dusk"), IsEmpty());
  EXPECT_THAT(warnings_for("dawn"), testing::ElementsAre(HasSubstr("80 minutes")));
}

TEST(TextWarnings, AreMadeForNoOtherLanguage) {
  json root = json::parse(with_sentence("amplitude_jnd", "en", "You will feel three surfaces."));
  root["language"] = "fr";
  EXPECT_THAT(warnings_of(root.dump()), IsEmpty());
}

}  // namespace
}  // namespace asperity

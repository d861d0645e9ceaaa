// Translations of protocols: what they replace, and what their check names.

#include "protocols/file/translation.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/stored_protocol.h"
#include "protocols/texts/translatable_texts.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kProtocol = R"({
  "name": "felt",
  "title": "What was felt",
  "questions": {
    "felt": {"prompt": "Did you feel it?", "options": [{"value": "yes", "text": "Yes"}, "no"]},
    "how": {"prompt": "How?", "form": "text", "x-note": "ours"}
  },
  "blocks": {
    "main": {
      "questions": [
        {"name": "rough", "prompt": "How rough?", "scale": {"minimum": 5e-05, "labels": ["smooth", "rough"]}}
      ]
    }
  },
  "flow": [
    {"screen": "Welcome. Please sit down."},
    {"run": "main", "pause": {"text": "Rest.", "minimum_s": 1}},
    {"screen": "Welcome. Please sit down."},
    {"screen": "Thank you."}
  ]
})";

json texts() {
  return json::parse(R"({
    "/title": {"What was felt": "Was gefühlt wurde"},
    "/questions/felt/prompt": {"Did you…": "Haben Sie es gefühlt?"},
    "/questions/felt/options/yes/text": {"Yes": "Ja"},
    "/questions/felt/options/no/text": {"no": "nein"},
    "/questions/how/prompt": {"How?": "Wie?"},
    "/blocks/main/questions/rough/prompt": {"How rough?": "Wie \"rau\"?"},
    "/blocks/main/questions/rough/scale/labels": {"smooth": "glatt", "rough": "rau"},
    "/flow/screen": {"Welcome…": "Willkommen.", "Thank you.": "Danke."},
    "/flow/pause/text": {"Rest.": "Pause."}
  })");
}

TranslatedProtocol in_german(const json& texts, const std::string& protocol = kProtocol) {
  const std::string file = json{{"format", "asperity.translation/1"}, {"texts", texts}}.dump(1);
  return translated(protocol, "felt.json", {file, "felt.de.json", "de"});
}

std::vector<std::string> messages_of(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> messages{};
  for (const Diagnostic& each : diagnostics) {
    EXPECT_EQ(each.file, "felt.de.json");
    EXPECT_GT(each.line, 1) << "not at its entry";
    messages.push_back(each.message.english());
  }
  return messages;
}

TEST(Translation, ReplacesTheTextsAndNothingElse) {
  const TranslatedProtocol german = in_german(texts());
  EXPECT_THAT(messages_of(german.problems), IsEmpty());
  EXPECT_THAT(messages_of(german.warnings), IsEmpty());
  EXPECT_EQ(german.text, R"({
  "name": "felt", "language": "de",
  "title": "Was gefühlt wurde",
  "questions": {
    "felt": {"prompt": "Haben Sie es gefühlt?", "options": [{"value": "yes", "text": "Ja"}, {"value": "no", "text": "nein"}]},
    "how": {"prompt": "Wie?", "form": "text", "x-note": "ours"}
  },
  "blocks": {
    "main": {
      "questions": [
        {"name": "rough", "prompt": "Wie \"rau\"?", "scale": {"minimum": 5e-05, "labels": ["glatt", "rau"]}}
      ]
    }
  },
  "flow": [
    {"screen": "Willkommen."},
    {"run": "main", "pause": {"text": "Pause.", "minimum_s": 1}},
    {"screen": "Willkommen."},
    {"screen": "Danke."}
  ]
})");
  EXPECT_EQ(without_texts(german.text), without_texts(kProtocol));
  EXPECT_EQ(language_of(german.text), "de");
}

TEST(Translation, StatesItsLanguageInPlaceOfTheProtocols) {
  const TranslatedProtocol german = in_german(json::object(), R"({"language": "fr", "name": "a"})");
  EXPECT_EQ(german.text, R"({"language": "de", "name": "a"})");
}

TEST(Translation, HasAddressesWithoutPositions) {
  std::vector<std::string> addresses{};
  for (const TranslatableText& each : translatable_texts(json::parse(kProtocol))) {
    addresses.push_back(each.address);
  }
  EXPECT_THAT(addresses,
              ElementsAre("/title", "/questions/felt/prompt", "/questions/felt/options/yes/text",
                          "/questions/felt/options/no/text", "/questions/how/prompt",
                          "/blocks/main/questions/rough/prompt",
                          "/blocks/main/questions/rough/scale/labels",
                          "/blocks/main/questions/rough/scale/labels", "/flow/screen",
                          "/flow/pause/text", "/flow/screen", "/flow/screen"));
}

TEST(Translation, IsTheSameAfterAnInsertionIntoTheProtocol) {
  json longer = json::parse(kProtocol);
  longer["flow"].insert(longer["flow"].begin(), json{{"check", "device"}});
  longer["blocks"]["main"]["questions"].insert(longer["blocks"]["main"]["questions"].begin(),
                                               json{{"name", "new"}, {"prompt", "How?"}});
  const TranslatedProtocol german = in_german(texts(), longer.dump());
  EXPECT_THAT(
      messages_of(german.problems),
      ElementsAre(AllOf(HasSubstr("\"How?\" has no translation"),
                        HasSubstr(R"(add "/blocks/main/questions/new/prompt":{"How?":"…"})"))));
  EXPECT_EQ(json::parse(german.text)["flow"][4]["screen"], "Danke.");
}

TEST(Translation, NamesEntriesWithoutATextWithTheNearestAddress) {
  json of = texts();
  of["/questions/feld/prompt"] = {{"Did you feel it?", "Haben Sie es gefühlt?"}, {"a", "b"}};
  of["/questions/how/form"] = {{"text", "Text"}};
  EXPECT_THAT(messages_of(in_german(of).problems),
              ElementsAre(AllOf(HasSubstr("no text for participants or readers at the address "
                                          "\"/questions/feld/prompt\""),
                                HasSubstr("did you mean \"/questions/felt/prompt\"?")),
                          HasSubstr("\"/questions/how/form\"")));
}

TEST(Translation, NamesEntriesWhoseTextHasChanged) {
  json of = texts();
  of["/questions/how/prompt"] = {{"How did it feel?", "Wie hat es sich angefühlt?"}};
  EXPECT_THAT(messages_of(in_german(of).problems),
              ElementsAre(HasSubstr("\"How?\" has no translation"),
                          AllOf(HasSubstr("begins with these words; it has \"How?\""))));
  // Without the sign of further words the whole text is compared.
  of = texts();
  of["/flow/screen"] = {{"Welcome. Please", "Willkommen."}, {"Thank you.", "Danke."}};
  EXPECT_EQ(in_german(of).problems.size(), 2U);
}

TEST(Translation, NamesTextsWithoutAnEntryAndWarnsOfDescriptions) {
  json of = texts();
  of.erase("/flow/screen");
  of.erase("/questions/felt/options/no/text");
  of.erase("/title");
  const TranslatedProtocol german = in_german(of);
  EXPECT_THAT(messages_of(german.problems),
              ElementsAre(HasSubstr("\"no\" has no translation"),
                          HasSubstr("\"Welcome. Please sit down.\" has no translation"),
                          HasSubstr("\"Thank you.\" has no translation")));
  EXPECT_THAT(messages_of(german.warnings), ElementsAre(HasSubstr("\"What was felt\"")));
  EXPECT_EQ(json::parse(german.text)["title"], "What was felt");
}

TEST(Translation, RefusesWordsOfSeveralTextsAndTwoEntriesOfOne) {
  json of = texts();
  of["/flow/screen"] = {{"…", "Hallo."}};
  EXPECT_THAT(messages_of(in_german(of).problems),
              testing::Contains(HasSubstr("the beginning of several texts")));
  of = texts();
  of["/title"]["What…"] = "Was";
  EXPECT_THAT(messages_of(in_german(of).problems),
              ElementsAre(HasSubstr("another entry translates this text")));
}

TEST(Translation, PrefersTheTextThatItsWordsAre) {
  const std::string protocol =
      R"({"name": "a", "flow": [{"screen": "Wait…"}, {"screen": "Wait here."}]})";
  const TranslatedProtocol german = in_german(
      {{"/flow/screen", {{"Wait…", "Warten …"}, {"Wait here.", "Hier warten."}}}}, protocol);
  EXPECT_THAT(messages_of(german.problems), IsEmpty());
  EXPECT_THAT(german.text, HasSubstr(R"([{"screen": "Warten …"}, {"screen": "Hier warten."}])"));
}

TEST(Translation, IsNotThePlaceholderThatIsProposed) {
  for (const char* const text : {"…", "  "}) {
    json unfinished = texts();
    unfinished["/flow/pause/text"].begin().value() = text;
    EXPECT_THAT(messages_of(in_german(unfinished).problems),
                ElementsAre(HasSubstr("this text has no translation yet")));
  }
}

TEST(Translation, RefusesTextsThatTheProtocolCouldNotHave) {
  json of = texts();
  of["/title"] = {{"What was felt", std::string(201, 'a')}};
  EXPECT_THAT(messages_of(in_german(of).problems), ElementsAre(HasSubstr("200")));
  of = texts();
  of["/title"] = "Was gefühlt wurde";
  EXPECT_EQ(in_german(of).problems.size(), 1U) << "no object";
}

TEST(Translation, RefusesAFileThatIsNotATranslation) {
  const auto problems_of = [](const std::string& text) {
    return translated(kProtocol, "felt.json", {text, "felt.de.json", "de"}).problems;
  };
  for (const char* const text : {"", "no JSON", "[]", R"({"format": "asperity.translation/2"})",
                                 R"({"format": "asperity.translation/1", "text": {}})"}) {
    EXPECT_FALSE(problems_of(text).empty()) << text;
  }
  EXPECT_TRUE(is_translation(R"({"format": "asperity.translation/2"})"));
  EXPECT_FALSE(is_translation(kProtocol));
  EXPECT_FALSE(is_translation("no JSON"));
}

}  // namespace
}  // namespace asperity

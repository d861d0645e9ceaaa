// Every kind of experiment is complete: before the data, after them, in the library and in the documents.

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/outcome/study_analysis.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/kinds/response_table.h"
#include "renderers/built_in_models.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

std::string document(const std::string& path) {
  std::ifstream file(std::string(ASPERITY_SOURCE_DIR) + "/" + path);
  std::ostringstream text{};
  text << file.rdbuf();
  return text.str();
}

TEST(Kinds, HaveTheirPartsAndAreFoundByName) {
  for (const ExperimentKind* const kind : experiment_kinds()) {
    SCOPED_TRACE(kind->id);
    EXPECT_EQ(find_kind(kind->id), kind);
    EXPECT_FALSE(kind->name.empty());
    EXPECT_FALSE(kind->roles.empty());
    EXPECT_FALSE(kind->tests.empty()) << "the first is the family of a protocol that declares none";
    EXPECT_NE(kind->item_of, nullptr);
    EXPECT_NE(kind->check_block, nullptr);
    EXPECT_NE(kind->judge, nullptr);
    if (kind->responses == nullptr) continue;  // studies are simulated on the full physics only
    EXPECT_NE(kind->responses->parameters, nullptr);
    EXPECT_NE(kind->responses->respond, nullptr);
  }
  EXPECT_EQ(find_kind("telepathy"), nullptr);
}

TEST(Kinds, HaveAnAnalysisAndNoAnalysisIsWithoutAKind) {
  ASSERT_EQ(experiment_kinds().size(), study_analyses().size());
  for (std::size_t i = 0; i < experiment_kinds().size(); ++i) {
    const ExperimentKind& kind = *experiment_kinds()[i];
    const StudyAnalysis& analysis = *study_analyses()[i];
    SCOPED_TRACE(kind.id);
    EXPECT_EQ(analysis.kind, kind.id) << "both registries have one order";
    EXPECT_FALSE(analysis.name.empty());
    EXPECT_NE(analysis.analyze, nullptr);
    EXPECT_EQ(analysis.test_family != nullptr, kind.responses != nullptr)
        << "simulated studies are analysed by the tests of their family";
    EXPECT_NE(analysis.task, nullptr);
    EXPECT_NE(analysis.task_for_paper, nullptr);
    for (const KindTest& test : kind.tests) {
      EXPECT_TRUE(std::any_of(analysis.claims.begin(), analysis.claims.end(),
                              [&test](const TestClaim& claim) { return claim.test == test.name; }))
          << test.name << " has no words";
    }
    for (const TestClaim& claim : analysis.claims) {
      for (const std::string_view words : {claim.higher, claim.lower, claim.nothing}) {
        const bool names_chance = words.find("the chance level") != std::string_view::npos;
        EXPECT_EQ(names_chance, words.find("the chance level%3") != std::string_view::npos)
            << claim.test << ": the chance level has no place for its value";
      }
      EXPECT_TRUE(std::any_of(kind.tests.begin(), kind.tests.end(),
                              [&claim](const KindTest& test) { return claim.test == test.name; }))
          << claim.test << " is not a test of this kind";
    }
  }
}

TEST(Kinds, HaveAProtocolInTheLibrary) {
  for (const ExperimentKind* const kind : experiment_kinds()) {
    const auto library = library_protocols();
    EXPECT_TRUE(std::any_of(library.begin(), library.end(), [kind](const LibraryProtocol& each) {
      const std::string name(each.name);
      return read_protocol(each.text, name, declarations_of(built_in_models())).kind == kind->id;
    })) << kind->id;
  }
}

TEST(Kinds, AreInTheDocumentsAndTheSchema) {
  const std::string format = document("docs/formats/protocol.md");
  const std::string schema = protocol_schema().dump();
  for (const ExperimentKind* const kind : experiment_kinds()) {
    const std::string id(kind->id);
    EXPECT_THAT(format, HasSubstr("`" + id + "`"));
    EXPECT_THAT(schema, HasSubstr("\"" + id + "\""));
    for (const KindTest& test : kind->tests) {
      EXPECT_THAT(format, HasSubstr("`" + std::string(test.name) + "`")) << id;
    }
    for (const RequiredKey& key : kind->required) {
      EXPECT_THAT(format, HasSubstr("`" + std::string(key.name) + "`")) << id;
    }
  }
}

}  // namespace
}  // namespace asperity

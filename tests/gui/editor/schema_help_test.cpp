// What is said of a key.

#include "app/gui/editor/schema_help.h"

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"

namespace asperity {
namespace {

class SchemaHelpTest : public testing::Test {
 protected:
  KeyHelp of(const QStringList& place) const { return help_.of(place).value_or(KeyHelp{}); }

  SchemaHelp help_{declarations_of(built_in_models())};
};

TEST_F(SchemaHelpTest, GivesMeaningRangeAndWhetherAKeyIsRequired) {
  const KeyHelp level = of({"environment", "masking_noise", "level_dBA"});
  EXPECT_EQ(level.key, "level_dBA");
  EXPECT_EQ(level.meaning, "Level at the ear.");
  EXPECT_EQ(level.form, "number · from 0 to 85");
  EXPECT_EQ(of({"device", "rate_Hz"}).form, "number · from 100 to 10000 · default 1000");
  EXPECT_EQ(of({"design"}).form, "one of: chapter, improved · required");
}

TEST_F(SchemaHelpTest, FollowsReferencesNamesAndLists) {
  EXPECT_EQ(of({"blocks", "main", "phase"}).form,
            "one of: familiarisation, practice, main · default main");
  EXPECT_EQ(of({"textures", "anything"}).meaning,
            "A texture of the experiment: felt (a height field), seen (a picture), or both.");
  EXPECT_EQ(of({"flow", "3", "screen"}).meaning, "A text that the participant reads.");
  EXPECT_EQ(of({"flow", "3", "pause", "minimum_s"}).form, "number · from 0 to 3600 · required");
}

TEST_F(SchemaHelpTest, SaysWhatAForceModelDeclaresOfAParameter) {
  const ModelRegistry models = built_in_models();
  const ModelDeclaration& model = models.models().front().declaration;
  ASSERT_FALSE(model.parameters.empty());
  const Parameter& parameter = model.parameters.front();
  const KeyHelp help =
      of({"stimuli", "rendered", "parameters", QString::fromStdString(parameter.name)});
  EXPECT_EQ(help.meaning.toStdString(), parameter.meaning.english());
  EXPECT_TRUE(help.form.contains(QString::fromStdString(model.id)));
}

TEST_F(SchemaHelpTest, KnowsRemarksAndSaysNothingOfKeysThatTheFormatDoesNotHave) {
  EXPECT_EQ(of({"observer", "$comment"}).meaning, "A comment: the program ignores it.");
  EXPECT_FALSE(help_.of({"environment", "visoin"}));
  EXPECT_FALSE(help_.of({}));
}

}  // namespace
}  // namespace asperity

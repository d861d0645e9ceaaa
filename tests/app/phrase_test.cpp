// Words that can be said in another language.

#include "analysis/words/phrase.h"

#include <new>
#include <stdexcept>

#include <gtest/gtest.h>

#include "app/words/phrase_of_error.h"
#include "app/words/time_ago.h"

namespace asperity {
namespace {

/// German, of what a test says.
std::string german(const char* context, const char* words) {
  if (context == nullptr) return words;  // the same in every language
  const std::string of = std::string(context) + ": " + words;
  if (of == "Test: %1 of %2 were felt") return "gefühlt: %2, davon %1";
  if (of == "Test: the surface") return "die Oberfläche";
  if (of == "Test: everybody") return "übrigens alle";
  return words;
}

TEST(Phrase, IsFilledInItsPlaces) {
  EXPECT_EQ(phrase("Test", "%1 of %2 were felt").with("3", std::string("7")).english(),
            "3 of 7 were felt");
  EXPECT_EQ(phrase("Test", "nothing varies").english(), "nothing varies");
  EXPECT_TRUE(Phrase().english().empty());
}

TEST(Phrase, OfALibrarysErrorIsAboutWhatIsWrong) {
  EXPECT_EQ(phrase_of(std::bad_alloc()).english(),
            "too little memory is free; close other programs, then try again");
  EXPECT_EQ(phrase_of(std::runtime_error("the sentence; the remedy")).english(),
            "the sentence; the remedy");
}

TEST(TimeAgo, IsInHoursForTwoDaysAndThenInDays) {
  EXPECT_EQ(time_ago(0.4).english(), "less than an hour ago");
  EXPECT_EQ(time_ago(1.2).english(), "an hour ago");
  EXPECT_EQ(time_ago(26.0).english(), "26 hours ago");
  EXPECT_EQ(time_ago(7815.2).english(), "326 days ago");
}

TEST(Phrase, IsLookedUpBeforeItIsFilled) {
  const Phrase felt = phrase("Test", "%1 of %2 were felt").with("3", "7");
  EXPECT_EQ(felt.translated(german), "gefühlt: 7, davon 3");
  const Phrase inside =
      phrase("Test", "%1 of %2 were felt").with(phrase("Test", "the surface"), "7");
  EXPECT_EQ(inside.translated(german), "gefühlt: 7, davon die Oberfläche");
  EXPECT_EQ(inside.english(), "the surface of 7 were felt");
}

TEST(Phrase, LeavesWordsThatAreTheSameInEveryLanguage) {
  const Phrase label = std::string("the surface");
  EXPECT_FALSE(label.can_be_translated());
  EXPECT_EQ(label.translated(german), "the surface");
  EXPECT_TRUE(phrase("Test", "the surface").can_be_translated());
}

TEST(Phrase, DoesNotFillWhatAPlaceWasFilledWith) {
  EXPECT_EQ(phrase("Test", "%1 of %2 were felt").with("%2", "100 %").english(),
            "%2 of 100 % were felt");
  EXPECT_EQ(Phrase("41 %1").english(), "41 %1");
}

TEST(Phrase, CanStandByItselfInAnyLanguage) {
  const Phrase everybody = phrase("Test", "everybody").as_sentence();
  EXPECT_EQ(everybody.english(), "Everybody.");
  EXPECT_EQ(everybody.translated(german), "Übrigens alle.");
  EXPECT_EQ(Phrase("Done.").as_sentence().english(), "Done.");
  EXPECT_TRUE(Phrase().as_sentence().english().empty());
  const Phrase named = phrase("Test", "%1 was chosen");
  EXPECT_EQ(named.with("height_map").as_sentence().english(), "height_map was chosen.")
      << "a name stays as it is";
  EXPECT_EQ(named.with(phrase("Test", "everybody")).as_sentence().english(),
            "Everybody was chosen.");
}

TEST(Phrase, OfAnErrorIsWhatTheErrorSays) {
  const PhrasedError phrased(phrase("Test", "%1 of %2 were felt").with("3", "7"));
  EXPECT_STREQ(phrased.what(), "3 of 7 were felt");
  EXPECT_EQ(phrase_of(phrased).translated(german), "gefühlt: 7, davon 3");
  const PhrasedRefusal refusal(phrase("Test", "%1 of %2 were felt").with("3", "7"));
  EXPECT_EQ(phrase_of(refusal).translated(german), "gefühlt: 7, davon 3");
  EXPECT_THROW(throw PhrasedRefusal("the surface"), std::invalid_argument);
  EXPECT_EQ(phrase_of(std::runtime_error("the surface")).translated(german), "the surface");
}

}  // namespace
}  // namespace asperity

// Declares the shapes and words that several tables share.

#pragma once

#include <array>

#include "protocols/shapes/key.h"
#include "protocols/shapes/shape.h"

namespace asperity {

inline constexpr DisplayUnit kMillimetres{.unit = "mm", .power = -3};

/// The path of a file, relative to the study.
inline constexpr TextShape kFile{.longest = 400, .is_file = true};
inline constexpr TextShape kParagraph{.longest = 8000, .is_long = true};
/// Texts that participants read, and one that describes the protocol.
inline constexpr TextShape kShownText{.translated = Translated::always};
inline constexpr TextShape kShownParagraph{
    .longest = 8000, .is_long = true, .translated = Translated::always};
inline constexpr TextShape kDescription{
    .longest = 8000, .is_long = true, .translated = Translated::if_present};

inline constexpr ValueShape kLevelNumber = NumberShape{};
inline constexpr ValueShape kLevelText = TextShape{.may_be_empty = true, .name = {kLevelNames}};
inline constexpr std::array kLevelForms{kLevelNumber, kLevelText};
inline constexpr FormsShape kLevel{kLevelForms};
inline constexpr ValueShape kLevelShape = kLevel;
inline constexpr std::string_view kLevelMeaning = "A level: a number or a name.";

inline constexpr NameShape kFactorName{kFactorNames};
inline constexpr MapShape kSomeLevels{
    .entry = &kLevelShape, .meaning = kLevelMeaning, .key = kFactorName, .shortest = 1};

/// A question that states its form is additional: it is not that of the kind of experiment. A scale is analysed with the
/// kind, whether it states its form or not.
inline constexpr KeyCondition kOfTheKind = without("form");
inline constexpr KeyCondition kScaleOfTheKind{"form", {kAbsent, "scale"}};

/// The ids of the kinds of experiment (protocols/kinds/experiment_kind.h).
inline constexpr std::array<KeyWord, 8> kKinds{
    {{"selection", 0, "the most realistic of several renderings is chosen"},
     {"matching", 0, "felt textures are assigned to the same number of pictures"},
     {"recognition", 0, "one felt texture is recognised among pictures"},
     {"magnitude", 0, "the roughness of one felt surface is estimated as a number"},
     {"rating", 0, "one felt surface is rated on one or more scales"},
     {"paired_comparison", 0, "one of two felt surfaces is chosen"},
     {"discrimination", 0,
      "a standard and a comparison that differs from it in one parameter are felt, and one of the "
      "two is chosen"},
     {"similarity", 0, "the dissimilarity of two felt surfaces is rated"}}};

// The kinds that permit a key.
inline constexpr KeyCondition kWithPairs =  // "all_pairs"
    of_kinds({"selection", "paired_comparison", "similarity"});
inline constexpr KeyCondition kWithPictures = of_kinds({"matching", "recognition"});
inline constexpr KeyCondition kWithCannotTell =
    of_kinds({"selection", "recognition", "discrimination"});
inline constexpr KeyCondition kWithWords = of_kinds({"discrimination"});  // "options"
inline constexpr KeyCondition kWithCorrectFactor = of_kinds({"recognition"});
inline constexpr KeyCondition kWithRealism = of_kinds({"selection", "paired_comparison"});
inline constexpr KeyCondition kWithProportions = of_kinds({"matching", "recognition"});

inline constexpr NumberShape kStiffness{.above = 0.0, .maximum = 10'000.0, .unit = "N/m"};
inline constexpr NumberShape kFriction{.minimum = 0.0, .maximum = 2.0};

}  // namespace asperity

// Defines the keys of a construct.

#include "protocols/kind_keys/rating_keys.h"

#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

constexpr ValueShape kScaleName = NameShape{.registry = kAnswerNames, .among = kRatedScales};

constexpr auto kConstructKeys = keys_of(
    required_key(member_key<&ConstructDeclaration::scales>(
        "scales", "Scales",
        "Names of questions with a scale, all with the same minimum and maximum.",
        ListShape{.entry = &kScaleName,
                  .meaning = kNameMeaning,
                  .shortest = 2,
                  .longest = 64,
                  .is_distinct = true})),
    member_key<&ConstructDeclaration::reverse_keyed>(
        "reverse_keyed", "Reverse-keyed",
        "Those of the scales on which the attribute decreases; absent: none.",
        ListShape{
            .entry = &kScaleName, .meaning = kNameMeaning, .longest = 64, .is_distinct = true}));

}  // namespace

constexpr KeyTableOf<ConstructDeclaration> kConstructTable = table_of(
    "Scales that are to measure the same attribute of the items.", kConstructKeys, "construct");

}  // namespace asperity

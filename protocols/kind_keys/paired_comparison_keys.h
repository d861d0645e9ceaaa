// The keys that only a paired comparison has.

#pragma once

#include "protocols/kind_keys/paired_comparison.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

inline constexpr auto kTieKeys = keys_of(required_key(member_key<&PairQuestion::tie>(
    "text", "Text", "The text that is shown for this option.", kShownText)));

inline constexpr KeyTableOf<PairQuestion> kTieTable = table_of(
    "Paired comparison: an option after those for the surfaces, stored as \"tie\"; absent: one of "
    "the surfaces has to be chosen.",
    kTieKeys);

/// Of the question.
inline constexpr auto kPairQuestionKeys =
    owned_by({"paired_comparison"},
             keys_of(when(inner_key("tie", "Tie", kTieTable), kOfTheKind, without("scale"))));

}  // namespace asperity

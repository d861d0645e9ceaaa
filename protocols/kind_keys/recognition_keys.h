// The keys of a recognition.

#pragma once

#include "protocols/kind_keys/recognition.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

/// Of the question.
inline constexpr auto kRecognitionQuestionKeys =
    keys_of(when(member_key<&RecognitionQuestion::correct_factor>(
                     "correct_factor", "Factor of the correct answer",
                     "The factor whose level is the correct picture or option.",
                     NameShape{.registry = kFactorNames, .levels = "textures"}),
                 kWithCorrectFactor, kOfTheKind, without("scale")));

}  // namespace asperity

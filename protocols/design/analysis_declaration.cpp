#include "protocols/design/analysis_declaration.h"

#include <array>

namespace asperity {

namespace {

constexpr std::array kTests{
    TestName{"selection", "pairs", "every pair of items: is one chosen more often than the other"},
    TestName{"selection", "target_pairs", "only the pairs of the target with each other item"},
    TestName{"selection", "preference", "are all items chosen equally often"},
    TestName{"selection", "position", "are all positions chosen equally often"},
    TestName{"selection", "textures", "is the target chosen equally often with every texture"},
    TestName{"matching", "items", "are more items matched correctly than under guessing"},
    TestName{"matching", "whole", "are more trials completely correct than under guessing"},
    TestName{"matching", "textures",
             "of every texture: is it matched correctly more often than under guessing"},
    TestName{"matching", "sexes", "do women and men differ"},
    TestName{"recognition", "right", "is the proportion correct above the chance level"},
    TestName{"recognition", "textures",
             "of every texture: is it recognised more often than under guessing"},
    TestName{"recognition", "information", "do the responses depend on the stimulus"},
    TestName{"recognition", "sexes", "do women and men differ"},
    TestName{"magnitude", "spacing", "do estimates depend on the spacing"},
    TestName{"magnitude", "interaction", "does the curve over spacings depend on the condition"},
    TestName{"magnitude", "condition", "do estimates depend on the condition"},
    TestName{"magnitude", "peaks", "of every two conditions: do their peaks lie apart"}};

}  // namespace

std::span<const TestName> test_names() { return kTests; }

}  // namespace asperity

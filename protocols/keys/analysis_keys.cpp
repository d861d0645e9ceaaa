// Defines the keys of "analysis".

#include "protocols/keys/tables.h"
#include "protocols/kind_keys/discrimination_keys.h"
#include "protocols/kind_keys/rating_keys.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

constexpr ValueShape kTest = NameShape{kTestNames};

constexpr auto kAnalysisKeys = keys_of(
    when(member_key<&AnalysisDeclaration::target>(
             "target", "Target", "Selection: the item that is tested against the others.",
             NameShape{.registry = kItemNames, .among = kChosenItems}),
         of_kinds({"selection"})),
    member_key<&AnalysisDeclaration::family>(
        "family", "Family of tests",
        "Tests whose p values are Holm-corrected together: the confirmatory tests of the study. "
        "All others are exploratory. Reports compare women and men only if the test of the sexes "
        "is listed. Absent: the first test of the kind; of estimates by another factor than "
        "spacings, that of the exponent, or of the stimuli without a predictor.",
        ListShape{.entry = &kTest,
                  .meaning = "A test of this kind of protocol.",
                  .shortest = 1,
                  .longest = 16,
                  .is_distinct = true}),
    when(member_key<&AnalysisDeclaration::equivalence_margin>(
             "equivalence_margin", "Equivalence margin",
             "Matching and recognition: equivalence margin of the difference between the mean "
             "proportions correct of two groups of participants (two one-sided tests).",
             NumberShape{.above = 0.0, .below = 1.0}),
         kWithProportions),
    when(member_key<&AnalysisDeclaration::exclude>("exclude", "Exclusion", kExclusionTable),
         of_kinds({"discrimination"})),
    when(map_key<&AnalysisDeclaration::constructs, kConstructTable>(
             "constructs", "Constructs",
             "Rating: constructs, by name. Cronbach's alpha is computed over the scales of each.",
             {.longest = 64}),
         of_kinds({"rating"})));

}  // namespace

constexpr KeyTableOf<AnalysisDeclaration> kAnalysisTable =
    table_of("The tests, declared before data collection.", kAnalysisKeys);

}  // namespace asperity

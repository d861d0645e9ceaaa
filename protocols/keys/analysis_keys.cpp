// Defines the keys of "analysis".

#include "protocols/keys/common_shapes.h"
#include "protocols/keys/keys_of.h"
#include "protocols/keys/tables.h"

namespace asperity {

namespace {

constexpr ValueShape kScaleName = NameShape{kAnswerNames};
constexpr ValueShape kTest = TextShape{.longest = 64};

constexpr auto kConstructKeys = keys_of(
    required_key(member_key<&ConstructDeclaration::scales>(
        "scales", "Scales",
        "Names of questions with a scale, all with the same minimum and maximum.",
        ListShape{.entry = &kScaleName, .meaning = kNameMeaning, .shortest = 2, .longest = 64})),
    member_key<&ConstructDeclaration::reverse_keyed>(
        "reverse_keyed", "Reverse-keyed",
        "Those of the scales on which the attribute decreases; absent: none.",
        ListShape{.entry = &kScaleName, .meaning = kNameMeaning, .longest = 64}));

constexpr auto kExclusionKeys =
    keys_of(member_key<&CatchExclusion::more_errors_than>(
                "more_catch_errors_than", "Maximum number of errors",
                "Participants with more errors in catch trials than this number are excluded.",
                NumberShape{.minimum = 0.0, .maximum = 100'000.0, .is_whole = true}),
            member_key<&CatchExclusion::error_rate_above>(
                "catch_error_rate_above", "Maximum proportion of errors",
                "Participants with a greater proportion of errors in catch trials are excluded.",
                NumberShape{.minimum = 0.0, .below = 1.0}));
constexpr std::array<std::string_view, 2> kExclusions{"more_catch_errors_than",
                                                      "catch_error_rate_above"};

constexpr auto kAnalysisKeys = keys_of(
    member_key<&AnalysisDeclaration::target>(
        "target", "Target", "Selection: the item that is tested against the others.",
        NameShape{kItemNames}),
    member_key<&AnalysisDeclaration::family>(
        "family", "Family of tests",
        "Tests whose p values are Holm-corrected together: the confirmatory tests of the study. "
        "All others are exploratory. Reports compare women and men only if `sexes` is listed. "
        "Absent: pairs in a selection, items in a matching, right in a recognition, spacing in a "
        "magnitude (with a factor in place of the spacing: exponent, or stimuli without a "
        "predictor), ratings in a rating, pairs in a paired comparison, order in a "
        "discrimination.",
        ListShape{.entry = &kTest,
                  .meaning = "A test of this kind of protocol.",
                  .shortest = 1,
                  .longest = 16}),
    member_key<&AnalysisDeclaration::equivalence_margin>(
        "equivalence_margin", "Equivalence margin",
        "Matching and recognition: equivalence margin of the difference between the mean "
        "proportions correct of two groups of participants (two one-sided tests).",
        NumberShape{.above = 0.0, .below = 1.0}),
    member_key<&AnalysisDeclaration::exclude>("exclude", "Exclusion", kExclusionTable),
    map_key<&AnalysisDeclaration::constructs, kConstructTable>(
        "constructs", "Constructs",
        "Rating: constructs, by name. Cronbach's alpha is computed over the scales of each.",
        {.longest = 64}));

}  // namespace

constexpr KeyTableOf<AnalysisDeclaration> kAnalysisTable = opened(
    table_of("The tests, declared before data collection. Further keys are stored with the study "
             "and not interpreted.",
             kAnalysisKeys));

constexpr KeyTableOf<ConstructDeclaration> kConstructTable = table_of(
    "Scales that are to measure the same attribute of the items.", kConstructKeys, "construct");

constexpr KeyTableOf<CatchExclusion> kExclusionTable = decided_by(
    table_of(
        "Discrimination with catch trials: participants with more errors in them are excluded; "
        "results are reported with and without these participants. One of the two keys.",
        kExclusionKeys),
    kExclusions);

}  // namespace asperity

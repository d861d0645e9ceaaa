// Defines the keys of the exclusion of participants by their errors in catch trials.

#include "protocols/kind_keys/discrimination_keys.h"

namespace asperity {

namespace {

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

}  // namespace

constexpr KeyTableOf<CatchExclusion> kExclusionTable =
    decided_by(table_of("Discrimination with catch trials: participants with more errors in them "
                        "are excluded; results are reported with and without these participants. "
                        "One of the two limits is stated.",
                        kExclusionKeys),
               kExclusions);

}  // namespace asperity

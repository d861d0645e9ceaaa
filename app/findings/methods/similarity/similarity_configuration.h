// Qualifies the configuration of rated dissimilarities, for the analysis and for a text for a paper.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// The name of the findings of the family `similarity`, of the table of the configuration, and of its test.
inline constexpr const char* kConfiguration = "configuration";

/// Of the configuration; 0 without one.
std::size_t dimensions_in(const FoundNumbers& found);

/// Whether the configuration is that of metric scaling, because the non-metric one is degenerate.
bool is_metric(const FoundNumbers& found);
/// Stress-1 of configurations with such a level of measurement, by the number of dimensions.
QuantityName stress_quantity(const FoundNumbers& found);
/// Stress-1 of the reported configuration; nothing without one.
std::optional<double> stress_of_configuration(const FoundNumbers& found);

/// "0.084"
std::string stress_text(double stress);

/// Whether it is metric, because the non-metric one is degenerate; has too many dimensions for its items; or has one more than
/// cross-validation chose.
std::vector<Phrase> remarks_on_configuration(const FoundNumbers& found);

/// The same after an answer that states the stress; empty without a reason.
Phrase qualification_of_stress(const FoundNumbers& found);

}  // namespace asperity

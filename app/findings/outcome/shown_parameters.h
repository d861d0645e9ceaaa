// What the responses of a study show of the parameters of response tables: how far participants differ, noise and lapses.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "analysis/models/variance_components.h"
#include "app/findings/gathering/gathered_answers.h"
#include "protocols/kinds/response_table.h"

namespace asperity {

/// Parameters of the response table of a question (ResponseParameter) by name.
using ShownParameters = std::map<std::string, double, std::less<>>;

/// Adds the variance components of the numbers with which the question was answered: level, level_sd and noise_sd; returns them.
/// `cell_of`: what a response is about; `value_of`: its number as it is analysed, nothing for one that is left out. Nothing is added
/// where there are too few (variance_components).
std::optional<VarianceComponents> add_shown_components(
    const GatheredAnswers& gathered, const TabulatedQuestion& asked,
    const std::function<FindingKey(const GatheredAnswer&)>& cell_of,
    const std::function<std::optional<double>(double)>& value_of, ShownParameters& shown);

}  // namespace asperity

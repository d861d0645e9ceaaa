// Declares what the analysis of a protocol can name: the tests, items and scales of its main blocks.

#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "protocols/answers/scale_form.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Of the kinds that are analysed, in their order; kinds can have tests with the same name.
std::vector<const KindTest*> tests_of(const Protocol& protocol);

/// The items that can be chosen, of any kind.
std::set<std::string> chosen_items(const Protocol& protocol);

/// The scales of ratings, by the name of the question.
std::map<std::string, ScaleForm, std::less<>> rated_scales(const Protocol& protocol);

}  // namespace asperity

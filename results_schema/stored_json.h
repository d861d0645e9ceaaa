// JSON in a column of a study.

#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace asperity {

/// The value of a text that the store keeps as JSON. `column` names it: "session.observer_json".
/// Errors: ResultsError naming the column where the text is not JSON, which only another program can have written.
nlohmann::json stored_json(const std::string& text, const char* column);

}  // namespace asperity

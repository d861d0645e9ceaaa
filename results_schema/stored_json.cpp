// A column that its constraint no longer protects is refused by name.

#include "results_schema/stored_json.h"

#include <nlohmann/json.hpp>

#include "results_schema/study.h"

namespace asperity {

nlohmann::json stored_json(const std::string& text, const char* column) {
  nlohmann::json value = nlohmann::json::parse(text, nullptr, false);
  if (value.is_discarded()) {
    throw ResultsError(
        std::string("study.sqlite is damaged: a ") + column +
            " is not JSON; run asperity verify on the study, and restore it from a copy",
        "study.sqlite");
  }
  return value;
}

}  // namespace asperity

// Declares the check of the form of values, which returns the problems and the part that has the form.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/words/phrase.h"
#include "protocols/shapes/key.h"

namespace asperity {

/// A value that does not have the form of its key, or is missing.
struct FormProblem {
  std::string pointer{};
  Phrase message{};
  bool is_at_key = false;  ///< the key itself is not permitted; otherwise its value
};

/// Whether none of the problems concerns the value at `pointer`, a part of it, or a value that contains it.
bool has_form(const std::vector<FormProblem>& problems, std::string_view pointer);

/// The part of a value that has the form, and the problems of the rest.
struct ValidPart {
  /// The value without the members, entries and unknown keys whose form is wrong; nullopt if nothing of it has the form.
  /// Required keys may be missing.
  std::optional<nlohmann::json> value{};
  std::vector<FormProblem> problems{};  ///< empty: `value` is the complete value
};

/// Examines the value at `pointer` in one walk. Each problem is reported at one place in one sentence: a value of a wrong
/// type is not examined further.
///
/// A list without its wrong entries counts only if its length is still permitted, and a list in which an entry occurs
/// twice does not count. An object that a key decides does not count if it has none or several of these keys.
ValidPart valid_part(const nlohmann::json& value, const KeyTable& table,
                     const std::string& pointer);

/// The same for a value of a shape; `meaning` is that of its key.
ValidPart valid_part(const nlohmann::json& value, const ValueShape& shape, std::string_view meaning,
                     const std::string& pointer);

}  // namespace asperity

// A study of a library protocol whose answers are a formula, with nothing rendered.

#pragma once

#include <filesystem>
#include <string>

namespace asperity::test {

/// Makes a study in a new folder: eight participants with all sessions of the library protocol. Plan, course, practice and
/// answers are those of a session; times, exploration and forces are formulas like the answers (FormulaAnswers). A few attempts
/// are invalid and repeated, skipped, or flagged, and one is excluded. The last session of the last participant is stopped half-way in the
/// first protocol of each kind, and excluded in the others. Stimuli are files that contain their own path. Two calls make the same rows.
///
/// Errors: std::runtime_error for a name that is not in the library and for a protocol whose levels an external program states.
void make_formula_study(const std::string& protocol, const std::filesystem::path& folder);

}  // namespace asperity::test

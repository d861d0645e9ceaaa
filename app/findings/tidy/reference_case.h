// Reads a case with known results: a folder with case.json and the tables that it names.

#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "analysis/numbers/finding.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

struct ReferenceCase {
  std::string family{};
  TidyInput input{};
};

/// Reads `case.json` (`family`, `inputs`: a file name or a list of them, `options`) and its tables.
///
/// Errors: std::runtime_error or ResultsError naming the file.
ReferenceCase read_reference_case(const std::filesystem::path& folder);

/// `quantity,key,value`, one line per finding in their order: the value in the fewest digits that
/// give the same number when read, or the word. Quoted as specified by RFC 4180.
std::string case_csv_of(std::span<const Finding> findings);

}  // namespace asperity

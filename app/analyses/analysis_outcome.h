// What the analysis of a protocol's answers comes to: tables, findings and remarks.

#pragma once

#include <string>
#include <vector>

#include "analysis/finding.h"
#include "app/analyses/gathered_answers.h"
#include "results_schema/table.h"

namespace asperity {

/// A table for people and programs: column names are fixed words with units, numbers have all their
/// digits, missing is missing. Where `x_low` and `x_high` stand, they are one interval.
struct NamedTable {
  std::string name{};   ///< fixed, for programs: "table_1", "shares"
  std::string title{};  ///< for people, chance included
  Table table{};
  std::string note{};  ///< how to read it; may be empty
};

/// The answers of one group to one version of one protocol, analysed.
struct AnalysisOutcome {
  std::string protocol{};
  std::string version{};
  std::string kind{};
  std::string design{};
  AnswerGroup group = AnswerGroup::people;
  AnswerCount count{};
  std::size_t answers = 0;  ///< attempts that the tables count
  std::vector<NamedTable> tables{};
  std::vector<Finding> findings{};
  std::vector<std::string> remarks{};  ///< sentences, each to be read before believing a number
};

}  // namespace asperity

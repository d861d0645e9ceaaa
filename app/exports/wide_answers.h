// The responses of each participant as the table with one row per participant counts them.

#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/threshold_columns.h"

namespace asperity {

/// What was gathered for a WideTable, without names of columns and without words.
struct WideAnswers {
  /// Numbers in numerical order, names in alphabetical order.
  using Level = std::pair<double, std::string>;
  using Condition = std::vector<std::pair<std::string, Level>>;  ///< by name of the factor
  struct Asked {
    std::string protocol{};
    std::string version{};
    std::string source_sha256{};  ///< of the first of those that differ only in texts
    std::string question{};       ///< empty: the protocol as a whole
    auto operator<=>(const Asked&) const = default;
  };
  struct Tally {
    std::int64_t answers = 0;
    std::int64_t numbers = 0;
    double sum = 0.0;
    std::int64_t judged = 0;
    std::int64_t right = 0;
    std::map<std::string, std::int64_t> chosen{};

    void add(const Tally& other) {
      answers += other.answers;
      numbers += other.numbers;
      sum += other.sum;
      judged += other.judged;
      right += other.right;
      for (const auto& [option, times] : other.chosen) chosen[option] += times;
    }
  };
  struct Chosen {
    std::int64_t session_id = 0;
    std::set<int> options{};
    bool is_answered = false;
  };
  struct Person {
    std::vector<Cell> about{};
    std::map<Asked, std::map<Condition, Tally>> tallies{};
    std::map<Asked, Cell> said{};      ///< answers to questions of the session
    std::map<Asked, Chosen> chosen{};  ///< those of a multiple choice, by the number of the option
    std::map<Asked, bool>
        excluded{};  ///< by protocol: whether its rule for errors in catch trials excludes the participant
    std::map<Asked, bool> was_asked{};  ///< of the questions with a condition
    std::int64_t answers = 0;
    std::int64_t flagged = 0;
    std::int64_t left_out = 0;
    std::int64_t doubted = 0;
    std::int64_t of_procedures = 0;
    std::int64_t unfinished = 0;
  };

  std::vector<Person> people{};
  std::map<Asked, ThresholdColumns> discriminations{};
};

}  // namespace asperity

// Holds the check by the tables of keys to the check by the schema.

#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/file/json_document.h"
#include "protocols/file/schema_check.h"

namespace asperity::test {

/// The objects whose keys are declared in tables.
inline constexpr std::array kObjectsWithTables{"/device"};

/// Expects problems at the same places, each in one of the sentences that the schema gives there.
inline void expect_that_both_checks_agree(const std::string& text) {
  using Place = std::tuple<int, int, std::string>;
  const auto place_of = [](const Diagnostic& problem) {
    return Place(problem.line, problem.column, problem.pointer);
  };
  const JsonDocument document(text, "p.json");
  const std::vector<Diagnostic> by_schema = check_by_schema(document);
  const std::vector<Diagnostic> by_tables = check_schema(document);
  for (const std::string object : kObjectsWithTables) {
    const auto lies_in = [&object](const Diagnostic& problem) {
      return problem.pointer == object || problem.pointer.starts_with(object + '/');
    };
    std::set<Place> expected{};
    std::set<Place> found{};
    for (const Diagnostic& problem : by_schema) {
      if (lies_in(problem)) expected.insert(place_of(problem));
    }
    for (const Diagnostic& problem : by_tables) {
      if (!lies_in(problem)) continue;
      found.insert(place_of(problem));
      const bool is_same =
          std::any_of(by_schema.begin(), by_schema.end(), [&](const Diagnostic& other) {
            return place_of(other) == place_of(problem) && other.message == problem.message;
          });
      EXPECT_TRUE(is_same) << text_of(problem) << "\n" << text;
    }
    EXPECT_EQ(found, expected) << text;
  }
}

}  // namespace asperity::test

// The chapter's experiments as made-up studies, rebuilt answer by answer from its printed counts, and what tests read of them.

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>

#include "app/findings/study/analyze_study.h"
#include "tests/app/analysed_study.h"

namespace asperity {

inline testing::Matcher<const Phrase&> says(const std::string& words) {
  return testing::Property(&Phrase::english, testing::HasSubstr(words));
}

inline const std::vector<std::string> kModels{"height_map", "sinusoid", "stochastic"};
inline const std::vector<std::string> kTextures{"metal", "stone", "wood", "brick"};
inline const std::vector<std::string> kPictures{"metal", "stone",  "wood",
                                                "brick", "gravel", "grass"};

inline std::string person(int number) { return "p" + std::to_string(100 + number); }

/// The first ten are women, as in the chapter.
inline void add_twenty_people(MadeUpStudy& made) {
  for (int i = 0; i < 20; ++i) made.add_person(person(i), i < 10 ? "F" : "M");
}

inline std::string in_column(int column) { return R"({"column": )" + std::to_string(column) + "}"; }

inline MadeUpTrial choice_among_models(const std::string& chosen, const std::string& texture) {
  MadeUpTrial trial{};
  for (const std::string& model : kModels) {
    trial.surfaces.push_back(surface_of(model, model, texture));
  }
  trial.answers = {chosen};
  trial.options = kModels;
  return trial;
}

/// Table 1: of twenty people 12, 7 and 1 in the first column, 11, 8 and 1, and 13, 7 and 0.
inline AnalysisOutcome analyze_selections_of_the_chapter() {
  MadeUpStudy made;
  add_twenty_people(made);
  constexpr std::array<std::array<int, 3>, 3> kChosen{{{12, 7, 1}, {11, 8, 1}, {13, 7, 0}}};
  const std::int64_t protocol = made.add_protocol("selection", "selection");
  for (int i = 0; i < 20; ++i) {
    std::vector<MadeUpTrial> trials{};
    for (int column = 1; column <= 3; ++column) {
      const auto& counts = kChosen[static_cast<std::size_t>(column - 1)];
      const std::size_t model = i < counts[0] ? 0 : i < counts[0] + counts[1] ? 1 : 2;
      trials.push_back(choice_among_models(kModels[model], kTextures[0]));
      trials.back().factors_json = in_column(column);
    }
    made.add_session(person(i), protocol, trials);
  }
  return analyze_study(made.study()).at(0);
}

/// Worked out once: every row is a file synced to disk.
inline const AnalysisOutcome& selections_of_the_chapter() {
  static const AnalysisOutcome kOutcome = analyze_selections_of_the_chapter();
  return kOutcome;
}

inline MadeUpTrial made_up_matching(const std::vector<std::string>& answers) {
  MadeUpTrial trial{};
  for (const std::string& texture : kTextures) {
    trial.surfaces.push_back(surface_of(texture, "height_map", texture));
  }
  trial.answers = answers;
  trial.right = kTextures;
  trial.options = kTextures;
  return trial;
}

inline MadeUpTrial recognition(const std::string& felt, const std::string& answer) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(felt, "height_map", felt)};
  trial.answers = {answer};
  trial.right = {felt};
  trial.options = kPictures;
  return trial;
}

/// The cells of a row, found by its first cells; "" is a missing one.
inline const std::vector<Cell>& row_of(const Table& table, const std::vector<std::string>& keys) {
  for (const std::vector<Cell>& row : table.rows) {
    bool same = true;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      same = same && row[i] == (keys[i].empty() ? Cell{} : Cell{keys[i]});
    }
    if (same) return row;
  }
  throw std::runtime_error("no row " + keys.front());
}

inline const Cell& cell_named(const Table& table, const std::vector<std::string>& keys,
                              const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  if (found == table.columns.end()) throw std::runtime_error("no column " + column);
  return row_of(table, keys)[static_cast<std::size_t>(found - table.columns.begin())];
}

inline double number(const Table& table, const std::vector<std::string>& keys,
                     const std::string& column) {
  const Cell& cell = cell_named(table, keys, column);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  return std::get<double>(cell);
}

// Table 2 by sex: 9, 9 and 8 of ten women, 9, 10 and 9 of ten men have all four right. Whoever is
// wrong exchanges the last two.
inline AnalysisOutcome analyze_matchings_of_the_chapter() {
  MadeUpStudy made;
  add_twenty_people(made);
  constexpr std::array<int, 3> kWomen{9, 9, 8};
  constexpr std::array<int, 3> kMen{9, 10, 9};
  const std::int64_t protocol = made.add_protocol("matching", "matching");
  for (int i = 0; i < 20; ++i) {
    std::vector<MadeUpTrial> trials{};
    for (std::size_t column = 0; column < 3; ++column) {
      const bool right = i < 10 ? i < kWomen[column] : i - 10 < kMen[column];
      trials.push_back(right ? made_up_matching(kTextures)
                             : made_up_matching({"metal", "stone", "brick", "wood"}));
      trials.back().factors_json = in_column(static_cast<int>(column) + 1);
    }
    made.add_session(person(i), protocol, trials);
  }
  return analyze_study(made.study()).at(0);
}

/// Worked out once: every row is a file synced to disk.
inline const AnalysisOutcome& matchings_of_the_chapter() {
  static const AnalysisOutcome kOutcome = analyze_matchings_of_the_chapter();
  return kOutcome;
}

/// Six people choose between two models, four times each: 4, 4, 3, 3, 2 and 4 times the first.
inline AnalysisOutcome analyze_pairs(const std::string& source) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("pair", "selection", source);
  const std::array<int, 6> firsts{4, 4, 3, 3, 2, 4};
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    made.add_person("p" + std::to_string(i), "F");
    std::vector<MadeUpTrial> trials{};
    for (int trial = 0; trial < 4; ++trial) {
      MadeUpTrial& one = trials.emplace_back();
      one.options = {"old", "new"};
      if (trial % 2 == 1) std::swap(one.options[0], one.options[1]);
      for (const std::string& model : one.options) {
        one.surfaces.push_back(surface_of(model, model, trial < 2 ? "wood" : "metal"));
      }
      one.answers = {trial < firsts[i] ? "new" : "old"};
    }
    made.add_session("p" + std::to_string(i), protocol, trials);
  }
  return analyze_study(made.study()).front();
}

/// Two people, six goes: stone and metal are mixed up, the rest is right; gravel and grass are only
/// shown.
inline AnalysisOutcome analyze_recognitions() {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("recognition", "recognition");
  for (const char* label : {"a", "b"}) {
    made.add_person(label, label[0] == 'a' ? "F" : "M");
    std::vector<MadeUpTrial> trials{recognition("stone", "metal"), recognition("stone", "stone"),
                                    recognition("metal", "stone"), recognition("metal", "metal"),
                                    recognition("wood", "wood"),   recognition("brick", "brick")};
    if (label[0] == 'b') trials[2] = recognition("metal", "metal");
    made.add_session(label, protocol, trials);
  }
  return analyze_study(made.study()).front();
}

}  // namespace asperity

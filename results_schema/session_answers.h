// What was answered in a session, as analyses count it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "results_schema/analysis_use.h"
#include "results_schema/rows.h"

namespace asperity {

/// The few columns of a session's attempts that an analysis counts. A study may have a million
/// attempts, so that each word stands once, in `words`, and is identified by its place there.
struct SessionAnswers {
  struct Trial {
    int trial = 0;
    AnalysisUse use = AnalysisUse::counted;
    std::uint32_t block = 0;
    std::uint32_t factors_json = 0;
    int repetition = 1;     ///< as PlannedTrialRow::repetition
    int block_ordinal = 1;  ///< as PlannedTrialRow::block_ordinal
    /// As PlannedTrialRow::track and ::step.
    std::optional<int> track{};
    std::optional<int> step{};
  };
  struct Surface {
    int position = 1;  ///< as PresentationRow::position
    std::uint32_t item = 0;
    std::uint32_t model = 0;
    std::uint32_t texture = 0;
    std::optional<double> matched_texture_force_N{};
    std::optional<double> achieved_texture_force_N{};
  };
  /// How one surface was explored in one attempt, from its compliance rows and its visits. Nothing where a quantity was not stored, or had no
  /// samples: the force on a surface that was not touched is not 0.
  struct Exploration {
    std::optional<double> contact_s{};
    /// From the rows of visits. Nothing in attempts without any;
    /// 0 of a surface that was not touched in an attempt with visits to others.
    std::optional<double> visits{};
    std::optional<double> path_m{};
    std::optional<double> strokes{};
    std::optional<double> stroke_length_m{};  ///< mean over strokes
    /// Means and standard deviations over the samples of contact.
    std::optional<double> force_N{};
    std::optional<double> force_sd_N{};
    std::optional<double> speed_m_per_s{};
    std::optional<double> speed_sd_m_per_s{};
  };
  struct Reply {
    std::uint32_t question = 0;
    int item = 1;  ///< as ResponseRow::item
    std::uint32_t answer = 0;
    std::uint32_t options_json = 0;
    std::optional<bool> correct{};
    std::optional<double> number{};  ///< as ResponseRow::answer_number
    std::optional<double> from_cue_s{};
    bool was_asked = true;  ///< its condition was met
  };
  struct Attempt {
    int trial = 0;
    AttemptOutcome outcome = AttemptOutcome::answered;
    AnalysisUse use = AnalysisUse::counted;
    bool valid = true;  ///< and not set aside
    bool excluded = false;
    bool flagged = false;
    std::size_t first_surface = 0;
    std::size_t surfaces = 0;
    std::size_t first_reply = 0;
    std::size_t replies = 0;
  };

  std::vector<std::string> words{};
  std::vector<Trial> trials{};  ///< the plan, in order
  /// PlannedTrialRow::plan_json of the anchors, by trial.
  std::map<int, std::string> anchor_plans{};
  std::vector<Attempt> attempts{};          ///< by trial, attempt
  std::vector<Surface> surfaces{};          ///< of an attempt together, by position
  std::vector<Exploration> explorations{};  ///< as `surfaces`; empty where they were not read
  std::vector<Reply> replies{};             ///< of an attempt together, by question and item

  std::span<const Surface> surfaces_of(const Attempt& attempt) const {
    return std::span(surfaces).subspan(attempt.first_surface, attempt.surfaces);
  }
  std::span<const Exploration> explorations_of(const Attempt& attempt) const {
    return explorations.empty()
               ? std::span<const Exploration>()
               : std::span(explorations).subspan(attempt.first_surface, attempt.surfaces);
  }
  std::span<const Reply> replies_of(const Attempt& attempt) const {
    return std::span(replies).subspan(attempt.first_reply, attempt.replies);
  }
};

/// What is read of a session's attempts: the exploration has five rows per surface, most of what is stored of an attempt.
enum class AnswerParts { answers, answers_and_exploration };

/// How far a session has come.
struct SessionCounts {
  int planned_trials = 0;
  bool planned_is_estimated = false;  ///< the number depends on responses that are still to come
  int done_trials = 0;  ///< with an attempt that is valid, or skipped and not set aside since
  int attempts = 0;
  int notes = 0;
  /// From the first to the last attempt of each stretch of uninterrupted running.
  double running_s = 0.0;
};

}  // namespace asperity

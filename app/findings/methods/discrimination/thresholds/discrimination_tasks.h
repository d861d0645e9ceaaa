// Represents the responses of a discrimination as choices of the comparison by value of the parameter.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "app/findings/gathering/gathered_answers.h"
#include "protocols/design/dimension.h"
#include "protocols/kind_keys/discrimination_design.h"

namespace asperity {

/// What the trials of one or more blocks of a discrimination have in common. How a block states its levels (as values,
/// differences, percentages, …) is not part of it, and whether a procedure chose its levels is not compared.
struct DiscriminationTask {
  std::string name{};      ///< of the first of these blocks
  std::string question{};  ///< name of the question
  std::string prompt{};    ///< its text
  const DiscriminationDesign* design = &two_alternatives();
  /// One response is correct, the comparison where a surface is chosen; otherwise no response is correct.
  bool is_performance = true;
  /// The surfaces were presented one after the other; otherwise side by side or on request, where the first surface is
  /// that on the left or in front, or the one that the participant knows as A.
  bool is_sequential = true;
  /// Of a comparison: whether the question asks for less of the parameter, as the protocol states; nothing if it does not.
  std::optional<DiscriminationQuestion::AsksFor> asks_for{};
  Dimension varied{};  ///< with the unit of the parameter and the value of the standard
  /// Whether a procedure chose the levels of the block with `name`; proportions over such levels depend on the procedure and are
  /// never reported.
  bool has_levels_of_procedure = false;

  double standard() const { return *varied.standard; }
  /// Whether the standard has nothing of the parameter, so that the comparison is detected.
  bool is_detection() const { return is_performance && standard() == 0.0; }
  bool operator==(const DiscriminationTask& other) const;
};

/// The task of a block as stored; nothing where it states no judgement, parameter or value of the standard, or a design that
/// this version does not have.
std::optional<DiscriminationTask> discrimination_task(const std::string& block_name,
                                                      const Protocol::Block& block);

/// Whether a response counts as a hit of a function of the comparison: the choice of the comparison, the correct choice of
/// three surfaces, or "yes" or "different". `comparisons`: surfaces of the trial that are comparisons.
bool is_hit_response(const DiscriminationTask& task, std::size_t comparisons,
                     const std::string& answer);

/// Whether the psychometric function is that of the choices of the standard: the question asks for less of the parameter, or,
/// where the protocol does not state it, the choices of the comparison decrease with the parameter (`trend_of_choices`).
bool counts_standard(const DiscriminationTask& task, double trend);

/// Responses to the trials with one value of the parameter. Responses "cannot tell" are trials, but not hits.
struct ChoiceCount {
  std::uint64_t hits = 0;
  std::uint64_t trials = 0;
  std::uint64_t unsure = 0;  ///< responses "cannot tell"
};

/// The hits with every response "cannot tell" as the mean of a guess, 1/alternatives of a hit [Kaernbach 2001]: the proportion
/// that a participant has who guesses instead.
///
/// [Kaernbach 2001] Kaernbach: Adaptive threshold estimation with unforced-choice tasks.
double split_hits(const ChoiceCount& count, std::size_t alternatives);
/// `split_hits` divided by the trials.
double split_proportion(const ChoiceCount& count, std::size_t alternatives);
/// The sum over all values.
ChoiceCount sum_of_choices(const std::map<double, ChoiceCount>& by_value);

/// Hits of a psychometric function by value of the parameter: correct responses, or choices of the surface whose choices
/// increase with the value. Of a design with trials without a signal the responses "yes" or "different", those without a
/// signal at the value of the standard.
using HitsByValue = std::map<double, ChoiceCount>;

/// The covariance of hits and values over the trials of all together, divided by its standard deviation under random
/// assignment of the responses to the trials: approximately standard normal where hits do not depend on the value, negative
/// where they decrease with it; 0 where all values or all responses are equal. A response "cannot tell" counts as half a hit.
double trend_of_choices(std::span<const HitsByValue> all);

struct DiscriminationTrial {
  std::uint32_t person = 0;   ///< index of the gathered people
  std::size_t condition = 0;  ///< index of the conditions
  /// Of the parameter, of the comparison; in a trial without a signal that of the standard.
  double value = 0.0;
  std::size_t comparisons = 1;  ///< surfaces that are comparisons
  bool is_signal = true;        ///< always where a surface is chosen
  /// Whether the response is a hit (`is_hit_response`).
  bool chose_comparison = false;
  bool is_unsure = false;  ///< the response is "cannot tell": neither surface was chosen
  bool comparison_first = false;
  /// Of a choice of three surfaces: the places of the correct and of the chosen one, from 0.
  std::size_t correct_place = 0;
  std::size_t chosen_place = 0;
  std::optional<double> confidence{};  ///< of the response, where it was rated
  std::uint32_t block = kNoWord;       ///< word of its name
  bool by_procedure = false;           ///< a procedure chose the level from the responses
  /// As in GatheredAnswer. The numbers of tracks are unique within a run of a block, so that session, block ordinal and
  /// track identify a track of a participant.
  int session = 1;
  int block_ordinal = 1;
  int track = 0;
  int step = 0;
  bool session_is_unfinished = false;
  std::size_t first_surface = 0;  ///< the first presented one, as in GatheredAnswer
};

/// The trials of one task, in the order of the responses.
struct DiscriminationStudy {
  DiscriminationTask task{};
  bool has_levels_of_procedure = false;
  /// The block where several have responses, and combinations of the levels of all other factors that have several and are
  /// not drawn for every trial: "strong, wood, wavelength_m 0.0025" (words_of_condition); "all" without these.
  std::vector<std::string> conditions{};
  /// The same without the level that the protocol's groups have, so that the groups share them; empty where nothing else
  /// varies.
  std::vector<std::string> conditions_in_group{};
  std::vector<DiscriminationTrial> trials{};
  /// The comparison is chosen less often as the parameter increases, as after the question which surface is smoother: the
  /// psychometric function is that of the choices of the standard. Only without correct responses.
  bool counts_standard = false;
  /// Without correct responses: the trend of the choices is not significantly different from 0, so that `counts_standard` may
  /// be wrong.
  bool is_direction_uncertain = false;
  std::size_t left_out = 0;  ///< responses without a value of the parameter

  bool is_hit(const DiscriminationTrial& trial) const {
    return !trial.is_unsure && trial.chose_comparison != counts_standard;
  }
  /// Whether a response is "cannot tell".
  bool has_unsure() const;
  void count(const DiscriminationTrial& trial, ChoiceCount& count) const;
};

/// A study per task, in the order of the names of the blocks; tasks without a response are absent.
std::vector<DiscriminationStudy> discrimination_studies(const GatheredAnswers& gathered);

}  // namespace asperity

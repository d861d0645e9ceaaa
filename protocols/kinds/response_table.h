// The response table of a kind of experiment: the numbers that its responses depend on, and a function that draws a response to a
// planned trial from them, without rendering.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/numbers/random.h"
#include "protocols/answers/question.h"
#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"

namespace asperity {

/// The numbers that a parameter can have.
enum class ParameterRange { any, not_negative, positive, proportion };

/// A number that the responses to a question depend on.
struct ResponseParameter {
  enum class Part {
    effect,  ///< what a test of the protocol's family is to find; `null_value` where there is nothing to find
    effect_sd,  ///< its standard deviation over participants: it has to be stated
    other,  ///< anything else: criterion, noise, lapses, differences between participants; effects that no test concerns
  };

  std::string name{};  ///< in its question: "difference", "difference_sd"
  Part part = Part::other;
  ParameterRange range = ParameterRange::any;
  std::string unit = "1";         ///< "1" of a pure number
  Phrase meaning{};               ///< a clause
  std::optional<double> value{};  ///< that is usually assumed; none: it has to be stated
  double null_value = 0.0;        ///< of an effect
  std::string
      tests{};  ///< of an effect: the names of the tests of the family that it concerns, "pairs, preference"
};

/// Whether the value is in the range, and what the range is, after "must be".
bool is_in_range(ParameterRange range, double value) noexcept;
std::string text_of(ParameterRange range);

/// A question of a block, with what its response table depends on.
struct TabulatedQuestion {
  const Protocol& protocol;
  const Protocol::Block& block;
  const Protocol::TrialQuestionTemplate& question;
  std::vector<std::string>
      family{};  ///< names of the tests of the kind of the question that are corrected together
  /// The items of the block's surfaces: numbers ascending, otherwise by name.
  std::vector<std::string> items{};
  /// The factors with several levels in the trials of the block, by name, without that of the varied parameter and those that
  /// are drawn for every trial; and the levels, in the order of the protocol.
  std::vector<std::pair<std::string, std::vector<std::string>>> factors{};
  /// The values of the varied parameter, ascending; of a procedure those of its grid.
  std::vector<double> values{};
};

/// The factor of the groups of participants with its levels; null where the block has no several groups.
const std::pair<std::string, std::vector<std::string>>* groups_in(
    const TabulatedQuestion& asked) noexcept;

/// The name of the difference between the last and the first level of a factor of groups.
inline std::string difference_between(const std::string& factor) { return factor + ".difference"; }

/// Of the question of a block. `possible`: all trials that can occur (`possible_trials`).
TabulatedQuestion tabulated_question(const Protocol& protocol, const Protocol::Block& block,
                                     const Protocol::TrialQuestionTemplate& question,
                                     const std::vector<Trial>& possible);

/// The values of the parameters of a question.
class ResponseValues final {
 public:
  void set(std::string name, double value) { values_.emplace_back(std::move(name), value); }
  /// Errors: std::logic_error for a parameter that the table does not have.
  double at(std::string_view name) const;

 private:
  std::vector<std::pair<std::string, double>> values_{};
};

/// A trial to which a simulated participant responds.
///
/// Everything that is drawn is a function of the three streams: of the study (how textures differ), of the participant (how the
/// participant differs from others, the same in all trials and blocks with a question of this name), and of this response.
struct TabulatedTrial {
  const TabulatedQuestion& asked;
  const Trial& trial;
  const Question& question;  ///< as planned, with its options
  const ResponseValues& values;
  Random of_study;
  Random of_participant;
  Random of_response;
  /// Whether the response of the trial to the question of its block's own kind is correct; nothing where no response is, or for
  /// that question itself.
  std::optional<bool> is_correct{};

  /// The value of NAME plus a normal deviation of the participant with the standard deviation NAME_sd.
  double own(std::string_view name) const;
  /// A normal deviation of the participant, for a level of something: standard deviation `sd`.
  double own_of(std::string_view name, std::string_view level, double sd) const;
  /// Whether the response is a lapse, with the probability `lapse`: independent of what is felt.
  bool lapses() const;
  /// The level of a factor in this trial, from −½ for the first to ½ for the last level, equally spaced.
  double place_of(std::string_view factor) const;
};

/// How responses of a kind are simulated without rendering. The counterpart on the full physics is ExperimentKind::judge.
///
/// Effects vary over participants: every effect has a parameter with the ending "_sd", and a table never assumes that it is 0. Effects
/// between groups of participants have none: a participant is in one group, and what varies is the effect that differs between them.
struct ResponseTable {
  std::vector<ResponseParameter> (*parameters)(const TabulatedQuestion& asked) = nullptr;
  /// Why responses to this question cannot be simulated this way, as a sentence without its end; empty where they can. Null:
  /// they always can.
  Phrase (*refusal)(const TabulatedQuestion& asked) = nullptr;
  Answer (*respond)(const TabulatedTrial& trial) = nullptr;
};

/// The place of a name among several, from −½ for the first to ½ for the last, equally spaced; 0 of a single one and of one that
/// is not among them.
double place_among(const std::vector<std::string>& names, std::string_view name) noexcept;

/// The unit of a rating.
inline constexpr const char* kScaleUnits = "scale units";

/// The name in quotation marks, in full.
std::string quoted_name(const std::string& name);

/// "on the scale from 0 (\"smooth\") to 100 (\"rough\")"; without labels "on the scale from 0 to 100".
Phrase scale_text(const ScaleForm& form);

/// The meaning of an effect between the last and the first of several names, with what it assumes of the others: `mean rating of
/// "wood" minus that of "brick"; the items between them are equally spaced, in the order "brick", "metal", "wood"`.
struct EndComparison {
  Phrase of_ends{};  ///< of the last name (%1) and the first (%2), and of the details (%3)
  /// Of the comparison (%1) and the order (%2).
  Phrase in_order =
      phrase("Responses", "%1; the items between them are equally spaced, in the order %2");
  Phrase details{};
};
Phrase text_of(const EndComparison& comparison, const std::vector<std::string>& names);

/// Collects the parameters of a table.
class ParameterList final {
 public:
  explicit ParameterList(const TabulatedQuestion& asked) : asked_(asked) {}

  /// An effect and the standard deviation of it over participants, NAME_sd, in `sd_unit`. If the family has one of `tests`,
  /// both have to be stated; otherwise the effect is assumed to be null and its standard deviation to be `usual_sd`.
  struct Effect {
    ResponseParameter effect{};
    std::vector<std::string> tests{};
    /// Tests that compare the effect between participants or textures: with one of them in the family, the effect and its standard
    /// deviation have to be stated as well, although the test does not concern the effect.
    std::vector<std::string> compared_in{};
    std::string sd_unit = "1";
    Phrase sd_meaning{};
    double usual_sd = 0.0;
  };
  void effect(Effect effect);
  /// An effect between groups of participants, which has no standard deviation. It concerns the test `groups`: if the family has
  /// it, the effect has to be stated; otherwise it is assumed to be null.
  void effect_of_groups(ResponseParameter effect);
  /// A standard deviation over participants that was added before: where the family compares groups, in which it is the error, it
  /// has no usual value.
  void varies_within_groups(const std::string& sd);
  void assumed(ResponseParameter parameter) { parameters_.push_back(std::move(parameter)); }
  /// A rating on a scale of this range: `level` with a value and a meaning, `level_sd`, `noise_sd` and `lapse`.
  void scale(double range, ResponseParameter level, Phrase level_sd, Phrase noise_sd);
  /// `lapse`: the probability of a response that does not depend on the surfaces.
  void lapse();
  std::vector<ResponseParameter> take() { return std::move(parameters_); }

 private:
  /// The names of the tests of the family that are among these.
  std::string in_family(const std::vector<std::string>& tests) const;

  const TabulatedQuestion& asked_;
  std::vector<ResponseParameter> parameters_{};
};

/// A number from the standard logistic distribution, and from the standard Gumbel distribution: the greatest of utilities plus
/// Gumbel numbers is chosen in proportion to the exponentials of the utilities.
double logistic(Random& random);
double gumbel(Random& random);

}  // namespace asperity

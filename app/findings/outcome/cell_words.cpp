// Tables of code and phrase by column; names of parameters lose the suffix of their unit.

#include "app/findings/outcome/cell_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

#include "analysis/numbers/unit_of_name.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/test_methods.h"
#include "app/records/felt_octaves.h"
#include "app/words/text_parts.h"
#include "protocols/design/analysis_declaration.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

using CellWords = std::map<std::string, Phrase>;

const CellWords& words_of_measures() {
  static const CellWords kWords{
      {kAnchorCorrect, phrase("CellWords", "proportion correct; change: last − first")},
      {kAnchorEstimate, phrase("CellWords", "estimate; change: last/first")},
      {kAnchorRating, phrase("CellWords", "rating; change: last − first")},
      {"balanced_share", phrase("CellWords", "proportion correct, mean over the textures")},
      {"by_chance_in_all", phrase("CellWords", "correctly matched items expected under guessing")},
      {"correct_of_halves", phrase("CellWords", "proportion correct; change: second − first half")},
      {"contact_s", phrase("CellWords", "contact time, s")},
      {"d_prime", phrase("CellWords", "d′")},
      {"equal_items", phrase("CellWords", "equal items")},
      {"force_N", phrase("CellWords", "mean normal force, N")},
      {"force_sd_N", phrase("CellWords", "SD of the normal force, N")},
      {"goodness_of_fit", phrase("CellWords", "goodness of fit")},
      {"items_of_halves",
       phrase("CellWords", "proportion of correctly matched items; change: second − first half")},
      {"information_at_most", phrase("CellWords", "stimulus entropy H(S)")},
      {"information_if_errors_equal",
       phrase("CellWords", "equal-error (Fano) estimate of the transmitted information")},
      {"information_jackknife", phrase("CellWords", "transmitted information, jackknife")},
      {"information_miller",
       phrase("CellWords", "transmitted information, bias-corrected (Miller 1955)")},
      {"information_miller_madow",
       phrase("CellWords", "transmitted information, bias-corrected (Miller–Madow)")},
      {"information_plug_in", phrase("CellWords", "transmitted information, plug-in")},
      {"jnd", phrase("CellWords", "just-noticeable difference (JND)")},
      {"jnd_dprime1", phrase("CellWords", "JND at d′ = 1")},
      {"jnd_posterior", phrase("CellWords", "JND, posterior mean")},
      {"kappa", phrase("CellWords", "Cohen’s κ")},
      {"log_tie", phrase("CellWords", "ties, ln ν")},
      {"mallows_theta", phrase("CellWords", "Mallows’ θ (0 under guessing)")},
      {"order_effect", phrase("CellWords", "order effect, log odds")},
      {"path_m", phrase("CellWords", "path in contact, m")},
      {"pse", phrase("CellWords", "point of subjective equality (PSE)")},
      {"response_s", phrase("CellWords", "response time, s")},
      {"right_items_in_all", phrase("CellWords", "correctly matched items")},
      {"right_items_per_go", phrase("CellWords", "correctly matched items per trial")},
      {"share_of_pictures_right",
       phrase("CellWords", "proportion correct, “cannot tell” left out")},
      {"speed_m_per_s", phrase("CellWords", "mean speed, m/s")},
      {"speed_sd_m_per_s", phrase("CellWords", "SD of the speed, m/s")},
      {"stroke_length_m", phrase("CellWords", "stroke length, m")},
      {"strokes", phrase("CellWords", "strokes")},
      {"time_of_halves",
       phrase("CellWords", "response time, s; change: ratio of the second to the first half")},
      {"time_per_10_trials", phrase("CellWords", "response time; change: ratio per 10 trials")},
      {"visits", phrase("CellWords", "visits")},
      {"weber", phrase("CellWords", "Weber fraction")},
      {"z", phrase("CellWords", "z of the correctly matched items")}};
  return kWords;
}

/// Measured properties of items; those of the exploration as in the tables of the exploration.
const CellWords& words_of_properties() {
  static const CellWords kWords = [] {
    CellWords words{{"texture_force_N", phrase("CellWords", "RMS of the texture force, N")}};
    for (const char* const explored :
         {"force_N", "force_sd_N", "speed_m_per_s", "speed_sd_m_per_s"}) {
      words[explored] = words_of_measures().at(explored);
    }
    constexpr std::array kBorders_mm{"10", "5", "2.5", "1.25", "0.625", "0.3125"};
    for (std::size_t octave = 0; octave < kOctaveProperties.size(); ++octave) {
      words[kOctaveProperties[octave]] =
          phrase("CellWords", "force in waves of %1 to %2 mm, RMS relative to the normal force")
              .with(kBorders_mm[octave + 1], kBorders_mm[octave]);
    }
    return words;
  }();
  return kWords;
}

const CellWords& words_of_test_names() {
  static const CellWords kWords{
      {"accompanying_scales", phrase("CellWords", "accompanying scales")},
      {"condition", phrase("CellWords", "condition")},
      {"configuration", phrase("CellWords", "configuration")},
      {"conditions", phrase("CellWords", "conditions")},
      {"exponent", phrase("CellWords", "exponent of the power function")},
      {kGroupProfilesTest, phrase("CellWords", "profiles of the groups")},
      {kGroupsTest, phrase("CellWords", "groups")},
      {"identical", phrase("CellWords", "different and identical surfaces")},
      {"information", phrase("CellWords", "information")},
      {"interaction", phrase("CellWords", "spacing by condition")},
      {"items", phrase("CellWords", "matched items")},
      {"order", phrase("CellWords", "position of the comparison")},
      {"pairs", phrase("CellWords", "pairs")},
      {"peaks", phrase("CellWords", "peaks")},
      {"point_of_subjective_equality", phrase("CellWords", "point of subjective equality")},
      {"position", phrase("CellWords", "position")},
      {"preference", phrase("CellWords", "choices of the items")},
      {"properties", phrase("CellWords", "measured properties")},
      {"rated_pairs", phrase("CellWords", "pairs of items")},
      {"rating_model", phrase("CellWords", "analysis of variance of the ratings")},
      {"ratings", phrase("CellWords", "ratings of the items")},
      {"right", phrase("CellWords", "proportion correct")},
      {"sexes", phrase("CellWords", "women and men")},
      {"spacing", phrase("CellWords", "spacing")},
      {"stimuli", phrase("CellWords", "stimulus")},
      {"stimuli_by_condition", phrase("CellWords", "stimulus by condition")},
      {"target_pairs", phrase("CellWords", "pairs with the target")},
      {"textures", phrase("CellWords", "textures")},
      {"whole", phrase("CellWords", "all items correct")}};
  return kWords;
}

const CellWords& words_of_trial_factors() {
  static const CellWords kWords{
      {"all", phrase("CellWords", "all trials")},
      {"block", phrase("CellWords", "block")},
      {"block_place", phrase("CellWords", "block position")},
      {"column", phrase("CellWords", "repetition")},
      {"comparison_first", phrase("CellWords", "comparison presented first")},
      {"condition", phrase("CellWords", "condition")},
      {"force_difference", phrase("CellWords", "difference of the normal forces")},
      {"level_difference", phrase("CellWords", "difference of the levels")},
      {"session_place", phrase("CellWords", "session number")},
      {"spacing_m", phrase("CellWords", "spacing (m)")},
      {"speed_difference", phrase("CellWords", "difference of the speeds")},
      {"surface", phrase("CellWords", "surface")},
      {"texture", phrase("CellWords", "texture")},
      {"trial_place", phrase("CellWords", "trial, per 10")}};
  return kWords;
}

const CellWords& words_of_trial_groups() {
  static const CellWords kWords{
      {"all", phrase("CellWords", "all trials")},
      {"chosen", phrase("CellWords", "chosen item")},
      {"correctness", phrase("CellWords", "correctness of the response")},
      {"difference", phrase("CellWords", "difference, correct − incorrect")},
      {"presented", phrase("CellWords", "presented item")}};
  return kWords;
}

const CellWords& words_of_levels() {
  static const CellWords kWords{{"correct", phrase("CellWords", "correct")},
                                {"incorrect", phrase("CellWords", "incorrect")},
                                {"tie", phrase("CellWords", "tie")}};
  return kWords;
}

const CellWords& words_of_units() {
  static const CellWords kWords{{"1", phrase("CellWords", "–")},
                                {"answers", phrase("CellWords", "responses")},
                                {"bit", phrase("CellWords", "bit")},
                                {"goes", phrase("CellWords", "trials")},
                                {"items", phrase("CellWords", "items")},
                                {"participants", phrase("CellWords", "participants")}};
  return kWords;
}

const CellWords& words_of_single_units() {
  static const CellWords kWords{{"answers", phrase("CellWords", "response")},
                                {"goes", phrase("CellWords", "trial")},
                                {"items", phrase("CellWords", "item")},
                                {"participants", phrase("CellWords", "participant")}};
  return kWords;
}

const CellWords& words_of_reasons() {
  static const CellWords kWords{
      {"dependent", phrase("CellWords", "cannot be distinguished from the effects above")},
      {"not_connected", phrase("CellWords", "the rated pairs do not connect all items")},
      {"no_variance", phrase("CellWords", "the ratings do not vary")},
      {"no_participant_variance",
       phrase("CellWords", "the variance between participants is estimated as 0")},
      {"no_residual_variance", phrase("CellWords", "there is no error variance")},
      {"item_without_response", phrase("CellWords", "an item has no response")},
      {"too_few_items", phrase("CellWords", "too few items")},
      {"too_few_participants", phrase("CellWords", "too few participants")},
      {"too_few_raters", phrase("CellWords", "too few raters")},
      {"too_few_rows", phrase("CellWords", "too few measurements")},
      {"too_few_scales", phrase("CellWords", "too few scales")},
      {"too_few_surfaces", phrase("CellWords", "too few surfaces")},
      {"too_few_targets", phrase("CellWords", "too few targets")},
      {"too_few_textures", phrase("CellWords", "too few textures")},
      {"cannot be tested with one participant",
       phrase("CellWords", "cannot be tested with one participant")},
      {"nothing_varies", phrase("CellWords", "all stimuli or all responses are the same")},
      {"all_wrong", phrase("CellWords", "no response is correct")},
      {"at_end_of_prior", phrase("CellWords", "at an end of the prior")},
      {"above_levels", phrase("CellWords", "above the presented levels")},
      {"below_levels", phrase("CellWords", "below the presented levels")},
      {"conditions_between_participants",
       phrase("CellWords",
              "no participant has trials in every condition, and the test compares conditions "
              "within participants")},
      {"repetitions_are_textures",
       phrase("CellWords", "each repetition presents other textures than the others")},
      {"near_ceiling", phrase("CellWords", "nearly all responses are correct or of the target")},
      {"near_floor", phrase("CellWords", "hardly any response is correct or of the target")},
      {"no_data", phrase("CellWords", "no responses")},
      {"all_same_response", phrase("CellWords", "every response is the same")},
      {"no_choice_of_surface",
       phrase("CellWords",
              "no response is a choice between two surfaces, so that there is no order effect")},
      {"no_point_of_equality",
       phrase("CellWords",
              "responses are correct or incorrect, so that there is no point of "
              "subjective equality")},
      {"no_bound",
       phrase("CellWords", "no mean: neither an upper nor a lower bound without the others")},
      {"lower_bound", phrase("CellWords", "lower bound: the others are above the levels")},
      {"upper_bound", phrase("CellWords", "upper bound: the others are below the levels")},
      {"no_thresholds", phrase("CellWords", "too few thresholds could be estimated")},
      {"not_converged", phrase("CellWords", "no maximum of the likelihood was found")},
      {"not_defined", phrase("CellWords", "not defined")},
      {"not_increasing", phrase("CellWords", "responses do not depend on the level as expected")},
      {"one_level", phrase("CellWords", "only one level was presented")},
      {"too_few_levels",
       phrase("CellWords", "fewer levels were presented than the function has parameters")},
      {"one_order",
       phrase("CellWords", "too few participants felt the comparison in both positions")},
      {"no_interval",
       phrase("CellWords", "no CI, because the responses hardly determine the threshold")},
      {"outside_levels", phrase("CellWords", "outside the presented levels")},
      {"quasi_separated", phrase("CellWords", "only one level has both responses")},
      {"separated", phrase("CellWords", "no level has both responses")},
      {"separated_choices",
       phrase("CellWords", "the effects predict every choice, so that an effect is infinite")},
      {"slope_at_bound", phrase("CellWords", "steeper than the presented levels can resolve")},
      {"slope_at_limit", phrase("CellWords", "the slope is at a limit of the fit")},
      {"no_interior_maximum", phrase("CellWords", "no significant interior maximum")},
      {"at least one condition has no interior maximum",
       phrase("CellWords", "at least one condition has no interior maximum")},
      {"no_maximum", phrase("CellWords", "the parabola opens upwards")},
      {"outside_range", phrase("CellWords", "outside the range of the tested spacings")},
      {"not every model is presented in every trial",
       phrase("CellWords", "not every model is presented in every trial")},
      {"no_differences", phrase("CellWords", "all pairs were rated equally dissimilar")},
      {"permuted_fit_perfectly",
       phrase("CellWords",
              "too few surfaces for this number of dimensions, in which many permuted ratings fit "
              "perfectly")},
      {"no_identical_pairs", phrase("CellWords", "no identical pairs were presented")},
      {"no_predictor",
       phrase("CellWords",
              "there are fewer than three values of the predictor, or the predictor "
              "was not measured for every stimulus")},
      {"no_properties",
       phrase("CellWords",
              "there is no configuration, or no property was measured for every item")},
      {"no_difference", phrase("CellWords", "no participant has a difference that is not zero")},
      {"one_difference",
       phrase("CellWords", "only one participant has a difference that is not zero")},
      {"only_ties", phrase("CellWords", "all comparisons of the pair were ties")},
      {"pairs_incomplete",
       phrase("CellWords", "fewer than two participants compared every pair equally often")},
      {"too_few_to_say", phrase("CellWords", "too few participants for a conclusion")},
      {"no_correct_responses",
       phrase("CellWords", "no scale accompanies a question with correct responses")},
      {"no_variance_of_differences",
       phrase("CellWords",
              "there are fewer than two participants, or their differences are equal")},
      {"not_both_correct_and_incorrect",
       phrase("CellWords", "no participant has both correct and incorrect responses")},
      {"no_pair_offered", phrase("CellWords", "two models were never presented in the same trial")},
      {"no_responses", phrase("CellWords", "no responses to test")},
      {"no_target_or_one_texture",
       phrase("CellWords", "the protocol declares no target, or there is only one texture")},
      {"no_two_peaks", phrase("CellWords", "fewer than two conditions have a peak")},
      {"one_condition", phrase("CellWords", "there is only one condition")},
      {"one_item", phrase("CellWords", "only one item was rated on this scale")},
      {"fewer_than_two_shared_items",
       phrase("CellWords", "two groups have fewer than two items in common")},
      {"groups_share_no_condition", phrase("CellWords", "the groups share no condition")},
      {"no_block_of_both",
       phrase("CellWords", "no block of the assignment has participants of both groups")},
      {"one_in_each_group", phrase("CellWords", "each of the groups has one participant")},
      {"no_numbers_of_group",
       phrase("CellWords", "there is no estimate of any participant of one of the groups")},
      {"one_group", phrase("CellWords", "the participants are not in two groups of the protocol")},
      {"one_sex", phrase("CellWords", "the participants do not include both women and men")},
      {"pictures_differ", phrase("CellWords", "the pictures differ between trials")},
      {"target_never_chosen", phrase("CellWords", "no participant ever chose the target")},
      {"target_not_offered",
       phrase("CellWords", "the target was never presented with another model")},
      {"textures_unbalanced",
       phrase("CellWords", "the participants have not judged every texture equally often")},
      {"trials_of_different_sizes",
       phrase("CellWords", "the number of models differs between trials")}};
  return kWords;
}

/// Values as R and other programs write them.
const CellWords& words_in_any_column() {
  static const CellWords kWords{{"-Inf", phrase("CellWords", "−∞")},
                                {"Inf", phrase("CellWords", "∞")},
                                {"Other or not told", phrase("CellWords", "Other or not reported")},
                                {"all participants", phrase("CellWords", "all participants")},
                                {"cannot_tell", phrase("CellWords", "cannot tell")}};
  return kWords;
}

/// The words of a code; of one that is not in the table those of any column.
Phrase word_in(const CellWords& words, const std::string& code) {
  const auto found = words.find(code);
  return found == words.end() ? words_of_name(code) : found->second;
}

/// "above_levels", "jnd, weber: above_levels; slope: not_increasing".
Phrase words_of_several_reasons(const std::string& text) {
  if (text.find(": ") == std::string::npos) return word_in(words_of_reasons(), text);
  Phrase all{};
  for (const std::string& part : parts_of(text, ';')) {
    const std::size_t colon = part.find(": ");
    if (colon == std::string::npos) return text;
    Phrase measures{};
    for (std::string measure : parts_of(part.substr(0, colon), ',')) {
      measure.erase(0, measure.find_first_not_of(' '));
      const Phrase one = word_in(words_of_measures(), measure);
      measures = measures.empty() ? one : phrase("CellWords", "%1, %2").with(measures, one);
    }
    const Phrase one = phrase("CellWords", "%1: %2")
                           .with(measures, word_in(words_of_reasons(), part.substr(colon + 2)));
    all = all.empty() ? one : phrase("CellWords", "%1; %2").with(all, one);
  }
  return all;
}

const CellWords& words_of_catch_types() {
  static const CellWords kWords{{"easy", phrase("CellWords", "easy")},
                                {"identical_pair", phrase("CellWords", "identical pair")},
                                {"no_signal", phrase("CellWords", "no signal")}};
  return kWords;
}

const CellWords& words_of_anchor_places() {
  static const CellWords kWords{{"start", phrase("CellWords", "start")},
                                {"middle", phrase("CellWords", "middle")},
                                {"end", phrase("CellWords", "end")}};
  return kWords;
}

const CellWords& words_of_sexes() {
  static const CellWords kWords{{"Female", phrase("AnalysisWords", "Female")},
                                {"Male", phrase("AnalysisWords", "Male")},
                                {"Total", phrase("AnalysisWords", "Total")}};
  return kWords;
}

}  // namespace

std::string words_of_parameter(const std::string& key) {
  std::string words(named_quantity(key).quantity);
  std::replace(words.begin(), words.end(), '_', ' ');
  // A name has no apostrophe.
  if (words == "youngs modulus") return "Young’s modulus";
  if (words == "poisson ratio") return "Poisson’s ratio";
  return words;
}

std::string unit_of_parameter(const std::string& key) {
  return std::string(named_quantity(key).unit);
}

std::string words_of_condition(const std::string& condition) {
  std::string words{};
  std::string key{};  // the word before, and what precedes its name: "(wavelength_m"
  for (const std::string& part : parts_of(condition, ' ')) {
    const std::size_t begin = key.find_first_not_of('(');
    const std::string name = begin == std::string::npos ? std::string() : key.substr(begin);
    const std::string unit = unit_of_parameter(name);
    const std::size_t end = part.find_last_of("0123456789.") + 1;
    const std::optional<double> number = number_in(part.substr(0, end));
    if (!unit.empty() && number) {
      words += key.substr(0, begin) + words_of_parameter(name) + ' ' +
               stated_quantity(*number, unit) + part.substr(end) + ' ';
      key.clear();
      continue;
    }
    if (!key.empty()) words += key + ' ';
    key = part;
  }
  words += key;
  if (words.ends_with(' ')) words.pop_back();
  return words;
}

Phrase words_of_name(const std::string& stored) {
  const auto found = words_in_any_column().find(stored);
  return found == words_in_any_column().end() ? Phrase(stored) : found->second;
}

Phrase words_of_measure(const std::string& code) { return word_in(words_of_measures(), code); }

Phrase words_of_property(const std::string& code) { return word_in(words_of_properties(), code); }

Phrase words_of_test(const std::string& name) { return word_in(words_of_test_names(), name); }

Phrase words_of_test(const std::string& name, const TestSubject& about) {
  if (about.empty()) return words_of_test(name);
  return phrase("CellWords", "%1: %2").with(words_of_test(name), words_of_subject(about));
}

Phrase words_of_tests(const std::string& names) {
  Phrase all{};
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(", ", begin), names.size());
    const Phrase one = words_of_test(names.substr(begin, end - begin));
    all = all.empty() ? one : phrase("CellWords", "%1, %2").with(all, one);
    begin = end + 2;
  }
  return all;
}

Phrase words_of_subject(const TestSubject& about) {
  const auto& [of, first, second] = about;
  if (of.empty() && first == "F" && second == "M") return phrase("CellWords", "women, men");
  if (!first.empty()) {
    return words_of_condition((of.empty() ? "" : of + ": ") + first + " / " + second);
  }
  if (const auto property = words_of_properties().find(of);
      property != words_of_properties().end()) {
    return property->second;
  }
  if (!unit_of_parameter(of).empty() && of.find(' ') == std::string::npos) {
    return words_of_parameter(of);
  }
  return words_of_name(words_of_condition(of));
}

Phrase words_of_method(const std::string& code, const std::string& permutations) {
  const Phrase name = test_method_name(code);
  if (name.empty()) return code;
  if (permutations.empty()) return name;
  if (permutations == "exact") return phrase("CellWords", "%1, exact").with(name);
  return phrase("CellWords", "%1, %2 permutations drawn at random").with(name, permutations);
}

Phrase words_of_count(std::size_t count, const std::string& unit) {
  const CellWords& units = count == 1 ? words_of_single_units() : words_of_units();
  return phrase("CellWords", "%1 %2").with(std::to_string(count), word_in(units, unit));
}

Phrase words_of_unit(const std::string& unit) { return word_in(words_of_units(), unit); }

Phrase words_of_status(const std::string& code) {
  return code.find(": ") == std::string::npos ? word_in(words_of_reasons(), code)
                                              : words_of_several_reasons(code);
}

Phrase words_of_factor(const std::string& code) {
  const bool is_parameter =
      !words_of_trial_factors().contains(code) && !unit_of_parameter(code).empty();
  return is_parameter ? Phrase(words_of_parameter(code)) : word_in(words_of_trial_factors(), code);
}

Phrase words_of_trial_group(const std::string& code) {
  return word_in(words_of_trial_groups(), code);
}

Phrase words_of_level(const std::string& code) { return word_in(words_of_levels(), code); }

Phrase words_of_catch_type(const std::string& code) {
  return word_in(words_of_catch_types(), code);
}

Phrase words_of_anchor_place(const std::string& code) {
  return word_in(words_of_anchor_places(), code);
}

Phrase words_of_role(const std::string& code) {
  return code == "confirmatory" ? phrase("CellWords", "confirmatory")
                                : phrase("CellWords", "exploratory");
}

Phrase words_of_condition_or_all(const std::string& condition) {
  return condition == "all" ? phrase("CellWords", "all trials")
                            : words_of_name(words_of_condition(condition));
}

Phrase words_of_item(const std::string& item) { return words_of_name(words_of_condition(item)); }

Phrase words_of_sex(const std::string& sex) { return word_in(words_of_sexes(), sex); }

Phrase words_of_repetition(const std::string& level) {
  return level == "all" ? phrase("AnalysisWords", "all") : Phrase(level);
}

}  // namespace asperity

#include "app/gui/data/analysis_words.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/shared/exploration.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

struct Word {
  std::string_view stored{};
  const char* shown = nullptr;
};

constexpr std::array kHeadings{
    Word{"F", QT_TRANSLATE_NOOP("AnalysisWords", "F")},
    Word{"about", QT_TRANSLATE_NOOP("AnalysisWords", "comparison")},
    Word{"above_smallest", QT_TRANSLATE_NOOP("AnalysisWords", "squared error above the smallest")},
    Word{"above_smallest_se", QT_TRANSLATE_NOOP("AnalysisWords", "its standard error")},
    Word{"achieved_maximum_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, maximum, N")},
    Word{"achieved_mean_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, mean, N")},
    Word{"achieved_minimum_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, minimum, N")},
    Word{"achieved_sd_N", QT_TRANSLATE_NOOP("AnalysisWords", "achieved, SD, N")},
    Word{"against", QT_TRANSLATE_NOOP("AnalysisWords", "other item")},
    Word{"agreement_r", QT_TRANSLATE_NOOP("AnalysisWords", "r with the other participants")},
    Word{"all", QT_TRANSLATE_NOOP("AnalysisWords", "all")},
    Word{"alpha", QT_TRANSLATE_NOOP("AnalysisWords", "Cronbach’s α")},
    Word{"alpha 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "Cronbach’s α, 95 % CI")},
    Word{"angle_deg", QT_TRANSLATE_NOOP("AnalysisWords", "angle, °")},
    Word{"answers", QT_TRANSLATE_NOOP("AnalysisWords", "responses")},
    Word{"block", QT_TRANSLATE_NOOP("AnalysisWords", "block")},
    Word{"block_ordinal", QT_TRANSLATE_NOOP("AnalysisWords", "number of the block")},
    Word{"by", QT_TRANSLATE_NOOP("AnalysisWords", "trials grouped by")},
    Word{"by_chance", QT_TRANSLATE_NOOP("AnalysisWords", "expected under guessing")},
    Word{"cells", QT_TRANSLATE_NOOP("AnalysisWords", "cells")},
    Word{"chance", QT_TRANSLATE_NOOP("AnalysisWords", "chance level")},
    Word{"chance 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "95 % interval under guessing")},
    Word{"change", QT_TRANSLATE_NOOP("AnalysisWords", "change")},
    Word{"change 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "change, 95 % CI")},
    Word{"chosen", QT_TRANSLATE_NOOP("AnalysisWords", "chosen")},
    Word{"a_z", QT_TRANSLATE_NOOP("AnalysisWords", "A_z")},
    Word{"chi_squared", QT_TRANSLATE_NOOP("AnalysisWords", "χ²(1)")},
    Word{"d_a", QT_TRANSLATE_NOOP("AnalysisWords", "d_a")},
    Word{"roc_area", QT_TRANSLATE_NOOP("AnalysisWords", "area under the ROC")},
    Word{"sd_ratio", QT_TRANSLATE_NOOP("AnalysisWords", "SD of signal/noise")},
    Word{"chosen_a", QT_TRANSLATE_NOOP("AnalysisWords", "A chosen")},
    Word{"chosen_b", QT_TRANSLATE_NOOP("AnalysisWords", "B chosen")},
    Word{"chosen_c", QT_TRANSLATE_NOOP("AnalysisWords", "C chosen")},
    Word{"circular_triads", QT_TRANSLATE_NOOP("AnalysisWords", "circular triads")},
    Word{"clopper_pearson 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "Clopper–Pearson 95 % CI")},
    Word{"column", QT_TRANSLATE_NOOP("AnalysisWords", "repetition")},
    Word{"component", QT_TRANSLATE_NOOP("AnalysisWords", "component")},
    Word{"condition", QT_TRANSLATE_NOOP("AnalysisWords", "condition")},
    Word{"construct", QT_TRANSLATE_NOOP("AnalysisWords", "construct")},
    Word{"correct", QT_TRANSLATE_NOOP("AnalysisWords", "correct")},
    Word{"corrected", QT_TRANSLATE_NOOP("AnalysisWords", "corrected")},
    Word{"criterion", QT_TRANSLATE_NOOP("AnalysisWords", "criterion")},
    Word{"criterion_k", QT_TRANSLATE_NOOP("AnalysisWords", "criterion k, differencing")},
    Word{"d_prime", QT_TRANSLATE_NOOP("AnalysisWords", "d′")},
    Word{"d_prime 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "d′, 95 % CI")},
    Word{"d_prime_corrected", QT_TRANSLATE_NOOP("AnalysisWords", "d′, corrected")},
    Word{"d_prime_independent", QT_TRANSLATE_NOOP("AnalysisWords", "d′, independent observations")},
    Word{"descending", QT_TRANSLATE_NOOP("AnalysisWords", "descending")},
    Word{"deviance", QT_TRANSLATE_NOOP("AnalysisWords", "deviance")},
    Word{"df", QT_TRANSLATE_NOOP("AnalysisWords", "df")},
    Word{"df1", QT_TRANSLATE_NOOP("AnalysisWords", "df₁")},
    Word{"df2", QT_TRANSLATE_NOOP("AnalysisWords", "df₂")},
    Word{"difference", QT_TRANSLATE_NOOP("AnalysisWords", "difference")},
    Word{"difference 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "difference, 95 % CI")},
    Word{"different", QT_TRANSLATE_NOOP("AnalysisWords", "responses “different”")},
    Word{"dimensions", QT_TRANSLATE_NOOP("AnalysisWords", "dimensions")},
    Word{"disparity", QT_TRANSLATE_NOOP("AnalysisWords", "disparity")},
    Word{"dissimilarity", QT_TRANSLATE_NOOP("AnalysisWords", "dissimilarity")},
    Word{"distance", QT_TRANSLATE_NOOP("AnalysisWords", "distance")},
    Word{"effect", QT_TRANSLATE_NOOP("AnalysisWords", "effect")},
    Word{"effect_size", QT_TRANSLATE_NOOP("AnalysisWords", "effect size, 95 % CI")},
    Word{"eigenvalue", QT_TRANSLATE_NOOP("AnalysisWords", "eigenvalue")},
    Word{"epsilon", QT_TRANSLATE_NOOP("AnalysisWords", "ε")},
    Word{"end", QT_TRANSLATE_NOOP("AnalysisWords", "end")},
    Word{"errors", QT_TRANSLATE_NOOP("AnalysisWords", "errors")},
    Word{"excluded", QT_TRANSLATE_NOOP("AnalysisWords", "excluded")},
    Word{"exponent", QT_TRANSLATE_NOOP("AnalysisWords", "exponent")},
    Word{"exponent 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "exponent, 95 % CI")},
    Word{"factor", QT_TRANSLATE_NOOP("AnalysisWords", "factor")},
    Word{"false_alarm_rate", QT_TRANSLATE_NOOP("AnalysisWords", "false-alarm rate")},
    Word{"family", QT_TRANSLATE_NOOP("AnalysisWords", "family")},
    Word{"felt", QT_TRANSLATE_NOOP("AnalysisWords", "stimulus")},
    Word{"felt_as_other", QT_TRANSLATE_NOOP("AnalysisWords", "confusions with the other")},
    Word{"fieller_m 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "Fieller 95 % CI, m")},
    Word{"first", QT_TRANSLATE_NOOP("AnalysisWords", "first")},
    Word{"first_half", QT_TRANSLATE_NOOP("AnalysisWords", "first half")},
    Word{"first_responses", QT_TRANSLATE_NOOP("AnalysisWords", "responses, comparison first")},
    Word{"fit", QT_TRANSLATE_NOOP("AnalysisWords", "fit")},
    Word{"geometric_mean", QT_TRANSLATE_NOOP("AnalysisWords", "geometric mean")},
    Word{"geometric_mean 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "geometric mean, 95 % CI")},
    Word{"goes", QT_TRANSLATE_NOOP("AnalysisWords", "trials")},
    Word{"half_axis_major", QT_TRANSLATE_NOOP("AnalysisWords", "ellipse, major half axis")},
    Word{"half_axis_minor", QT_TRANSLATE_NOOP("AnalysisWords", "ellipse, minor half axis")},
    Word{"height", QT_TRANSLATE_NOOP("AnalysisWords", "height")},
    Word{"high_label", QT_TRANSLATE_NOOP("AnalysisWords", "label of the maximum")},
    Word{"hit", QT_TRANSLATE_NOOP("AnalysisWords", "hit")},
    Word{"hit_rate", QT_TRANSLATE_NOOP("AnalysisWords", "hit rate")},
    Word{"hits", QT_TRANSLATE_NOOP("AnalysisWords", "hits")},
    Word{"inverted_u", QT_TRANSLATE_NOOP("AnalysisWords", "inverted U")},
    Word{"item", QT_TRANSLATE_NOOP("AnalysisWords", "item")},
    Word{"items", QT_TRANSLATE_NOOP("AnalysisWords", "items")},
    Word{"jnd", QT_TRANSLATE_NOOP("AnalysisWords", "JND")},
    Word{"jnd 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "JND, 95 % CI")},
    Word{"jnd_dprime1", QT_TRANSLATE_NOOP("AnalysisWords", "JND at d′ = 1")},
    Word{"jnd_dprime1 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "JND at d′ = 1, 95 % CI")},
    Word{"jnd_posterior", QT_TRANSLATE_NOOP("AnalysisWords", "JND, posterior mean")},
    Word{"jnd_posterior 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "JND, posterior, 95 % CrI")},
    Word{"join", QT_TRANSLATE_NOOP("AnalysisWords", "join")},
    Word{"left_out", QT_TRANSLATE_NOOP("AnalysisWords", "left out")},
    Word{"level", QT_TRANSLATE_NOOP("AnalysisWords", "level")},
    Word{"limit", QT_TRANSLATE_NOOP("AnalysisWords", "limit")},
    Word{"log_odds", QT_TRANSLATE_NOOP("AnalysisWords", "log odds ratio")},
    Word{"log_odds 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "log odds ratio, 95 % CI")},
    Word{"log_worth", QT_TRANSLATE_NOOP("AnalysisWords", "log-worth")},
    Word{"log_worth 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "log-worth, 95 % CI")},
    Word{"low_label", QT_TRANSLATE_NOOP("AnalysisWords", "label of the minimum")},
    Word{"matched_mean_N", QT_TRANSLATE_NOOP("AnalysisWords", "intended, mean, N")},
    Word{"maximum", QT_TRANSLATE_NOOP("AnalysisWords", "maximum")},
    Word{"mean", QT_TRANSLATE_NOOP("AnalysisWords", "mean")},
    Word{"mean 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "mean, 95 % CI")},
    Word{"mean_rank", QT_TRANSLATE_NOOP("AnalysisWords", "mean rank")},
    Word{"measure", QT_TRANSLATE_NOOP("AnalysisWords", "measure")},
    Word{"measurements", QT_TRANSLATE_NOOP("AnalysisWords", "measurements")},
    Word{"median", QT_TRANSLATE_NOOP("AnalysisWords", "median")},
    Word{"method", QT_TRANSLATE_NOOP("AnalysisWords", "method")},
    Word{"metric_stress_1", QT_TRANSLATE_NOOP("AnalysisWords", "stress-1, metric")},
    Word{"middle", QT_TRANSLATE_NOOP("AnalysisWords", "middle")},
    Word{"minimum", QT_TRANSLATE_NOOP("AnalysisWords", "minimum")},
    Word{"model", QT_TRANSLATE_NOOP("AnalysisWords", "model")},
    Word{"n", QT_TRANSLATE_NOOP("AnalysisWords", "n")},
    Word{"name", QT_TRANSLATE_NOOP("AnalysisWords", "name")},
    Word{"noise_trials", QT_TRANSLATE_NOOP("AnalysisWords", "trials without a signal")},
    Word{"normalised", QT_TRANSLATE_NOOP("AnalysisWords", "normalised")},
    Word{"normalised 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "normalised, 95 % CI")},
    Word{"odds_ratio", QT_TRANSLATE_NOOP("AnalysisWords", "odds ratio")},
    Word{"odds_ratio 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "odds ratio, 95 % CI")},
    Word{"of", QT_TRANSLATE_NOOP("AnalysisWords", "total")},
    Word{"orders_r", QT_TRANSLATE_NOOP("AnalysisWords", "r of both orders")},
    Word{"other", QT_TRANSLATE_NOOP("AnalysisWords", "other")},
    Word{"other_as_felt", QT_TRANSLATE_NOOP("AnalysisWords", "reverse confusions")},
    Word{"p", QT_TRANSLATE_NOOP("AnalysisWords", "p")},
    Word{"p_holm", QT_TRANSLATE_NOOP("AnalysisWords", "p, Holm")},
    Word{"p_interior", QT_TRANSLATE_NOOP("AnalysisWords", "p, interior maximum")},
    Word{"p_smallest", QT_TRANSLATE_NOOP("AnalysisWords", "smallest attainable p")},
    Word{"pair", QT_TRANSLATE_NOOP("AnalysisWords", "pair")},
    Word{"partial_eta_squared", QT_TRANSLATE_NOOP("AnalysisWords", "partial η²")},
    Word{"participant", QT_TRANSLATE_NOOP("AnalysisWords", "participant")},
    Word{"peak_m", QT_TRANSLATE_NOOP("AnalysisWords", "peak, m")},
    Word{"peak_m 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "peak, m, 95 % CI")},
    Word{"person", QT_TRANSLATE_NOOP("AnalysisWords", "participant")},
    Word{"persons", QT_TRANSLATE_NOOP("AnalysisWords", "participants")},
    Word{"place", QT_TRANSLATE_NOOP("AnalysisWords", "place")},
    Word{"points", QT_TRANSLATE_NOOP("AnalysisWords", "points")},
    Word{"position", QT_TRANSLATE_NOOP("AnalysisWords", "position")},
    Word{"prediction_error", QT_TRANSLATE_NOOP("AnalysisWords", "prediction error")},
    Word{"predictor", QT_TRANSLATE_NOOP("AnalysisWords", "predictor")},
    Word{"property", QT_TRANSLATE_NOOP("AnalysisWords", "property")},
    Word{"proportion", QT_TRANSLATE_NOOP("AnalysisWords", "proportion")},
    Word{"proportion 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "proportion, 95 % CI")},
    Word{"proportion_corrected", QT_TRANSLATE_NOOP("AnalysisWords", "proportion, corrected")},
    Word{"proportion_corrected 95 %",
         QT_TRANSLATE_NOOP("AnalysisWords", "proportion, corrected, 95 % CI")},
    Word{"pse", QT_TRANSLATE_NOOP("AnalysisWords", "PSE")},
    Word{"pse 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "PSE, 95 % CI")},
    Word{"question", QT_TRANSLATE_NOOP("AnalysisWords", "question")},
    Word{"r_squared", QT_TRANSLATE_NOOP("AnalysisWords", "R²")},
    Word{"ratio", QT_TRANSLATE_NOOP("AnalysisWords", "ratio")},
    Word{"ratio 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "ratio, 95 % CI")},
    Word{"raw", QT_TRANSLATE_NOOP("AnalysisWords", "raw")},
    Word{"reference", QT_TRANSLATE_NOOP("AnalysisWords", "reference")},
    Word{"repeated_r", QT_TRANSLATE_NOOP("AnalysisWords", "r of repeated ratings")},
    Word{"response", QT_TRANSLATE_NOOP("AnalysisWords", "response")},
    Word{"responses", QT_TRANSLATE_NOOP("AnalysisWords", "responses")},
    Word{"retained", QT_TRANSLATE_NOOP("AnalysisWords", "retained")},
    Word{"reverse_keyed", QT_TRANSLATE_NOOP("AnalysisWords", "reverse-keyed")},
    Word{"right", QT_TRANSLATE_NOOP("AnalysisWords", "correct")},
    Word{"role", QT_TRANSLATE_NOOP("AnalysisWords", "role")},
    Word{"rounds", QT_TRANSLATE_NOOP("AnalysisWords", "rounds")},
    Word{"scale", QT_TRANSLATE_NOOP("AnalysisWords", "scale")},
    Word{"scales", QT_TRANSLATE_NOOP("AnalysisWords", "scales")},
    Word{"sd", QT_TRANSLATE_NOOP("AnalysisWords", "SD")},
    Word{"second", QT_TRANSLATE_NOOP("AnalysisWords", "second")},
    Word{"second_half", QT_TRANSLATE_NOOP("AnalysisWords", "second half")},
    Word{"second_responses", QT_TRANSLATE_NOOP("AnalysisWords", "responses, comparison second")},
    Word{"session", QT_TRANSLATE_NOOP("AnalysisWords", "session")},
    Word{"share", QT_TRANSLATE_NOOP("AnalysisWords", "proportion")},
    Word{"share 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "proportion, 95 % CI")},
    Word{"share_first", QT_TRANSLATE_NOOP("AnalysisWords", "comparison chosen, first")},
    Word{"share_second", QT_TRANSLATE_NOOP("AnalysisWords", "comparison chosen, second")},
    Word{"signal_trials", QT_TRANSLATE_NOOP("AnalysisWords", "trials with a signal")},
    Word{"similarity", QT_TRANSLATE_NOOP("AnalysisWords", "similarity")},
    Word{"spacing_m", QT_TRANSLATE_NOOP("AnalysisWords", "spacing, m")},
    Word{"start", QT_TRANSLATE_NOOP("AnalysisWords", "start")},
    Word{"statistic", QT_TRANSLATE_NOOP("AnalysisWords", "statistic")},
    Word{"status", QT_TRANSLATE_NOOP("AnalysisWords", "reason")},
    Word{"step", QT_TRANSLATE_NOOP("AnalysisWords", "trial of the track")},
    Word{"stimulus", QT_TRANSLATE_NOOP("AnalysisWords", "stimulus")},
    Word{"stress_1", QT_TRANSLATE_NOOP("AnalysisWords", "stress-1")},
    Word{"surfaces", QT_TRANSLATE_NOOP("AnalysisWords", "surfaces")},
    Word{"t", QT_TRANSLATE_NOOP("AnalysisWords", "t")},
    Word{"task", QT_TRANSLATE_NOOP("AnalysisWords", "task")},
    Word{"test", QT_TRANSLATE_NOOP("AnalysisWords", "test")},
    Word{"texture", QT_TRANSLATE_NOOP("AnalysisWords", "texture")},
    Word{"ties", QT_TRANSLATE_NOOP("AnalysisWords", "ties")},
    Word{"time_s", QT_TRANSLATE_NOOP("AnalysisWords", "response time, s")},
    Word{"time_s 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "response time, s, 95 % CI")},
    Word{"track", QT_TRANSLATE_NOOP("AnalysisWords", "track")},
    Word{"trials", QT_TRANSLATE_NOOP("AnalysisWords", "trials")},
    Word{"type", QT_TRANSLATE_NOOP("AnalysisWords", "type")},
    Word{"unfinished_tracks", QT_TRANSLATE_NOOP("AnalysisWords", "unfinished tracks")},
    Word{"unsure", QT_TRANSLATE_NOOP("AnalysisWords", "responses “cannot tell”")},
    Word{"unit", QT_TRANSLATE_NOOP("AnalysisWords", "unit")},
    Word{"value", QT_TRANSLATE_NOOP("AnalysisWords", "value")},
    Word{"value 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "value, 95 % CI")},
    Word{"weber", QT_TRANSLATE_NOOP("AnalysisWords", "Weber fraction")},
    Word{"weber 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "Weber fraction, 95 % CI")},
    Word{"without_threshold", QT_TRANSLATE_NOOP("AnalysisWords", "repetitions without threshold")},
    Word{"wilson 95 %", QT_TRANSLATE_NOOP("AnalysisWords", "Wilson 95 % CI")},
    Word{"worth", QT_TRANSLATE_NOOP("AnalysisWords", "worth")},
    Word{"x", QT_TRANSLATE_NOOP("AnalysisWords", "x")},
    Word{"y", QT_TRANSLATE_NOOP("AnalysisWords", "y")},
    Word{"z", QT_TRANSLATE_NOOP("AnalysisWords", "z")},
    Word{"zeta", QT_TRANSLATE_NOOP("AnalysisWords", "ζ")}};

constexpr std::array kPersons{
    Word{"Female", QT_TRANSLATE_NOOP("AnalysisWords", "Female")},
    Word{"Male", QT_TRANSLATE_NOOP("AnalysisWords", "Male")},
    Word{"Other or not told", QT_TRANSLATE_NOOP("AnalysisWords", "Other or not reported")},
    Word{"Total", QT_TRANSLATE_NOOP("AnalysisWords", "Total")}};

/// Null where the program has no word of its own for it.
const char* shown_in(const auto& words, const std::string& stored) {
  const auto* found = std::find_if(words.begin(), words.end(),
                                   [&](const Word& word) { return word.stored == stored; });
  return found == words.end() ? nullptr : found->shown;
}

}  // namespace

QString AnalysisWords::of_heading(const NamedTable& table, const std::string& column) {
  const bool is_picture = table.name == kConfusion && column != table.table.columns.front();
  if (is_picture) return QString::fromStdString(column);
  if (table.name == "loadings" && column == "of") return tr("quantity");
  if (is_explored_quantity(table, column)) {
    return words_as_published(words_of_cell("measure", column));
  }
  if (const char* shown = shown_in(kHeadings, column)) return tr(shown);
  constexpr std::string_view kColumn = "column_";  // and the level of the factor
  if (column.starts_with(kColumn)) {
    return tr("repetition %1").arg(QString::fromStdString(column.substr(kColumn.size())));
  }
  constexpr std::string_view kDimension = "dimension_";  // and its number
  if (column.starts_with(kDimension)) {
    return tr("dimension %1").arg(QString::fromStdString(column.substr(kDimension.size())));
  }
  constexpr std::string_view kWeight = "weight_";
  if (column.starts_with(kWeight)) {
    return tr("weight %1").arg(QString::fromStdString(column.substr(kWeight.size())));
  }
  return QString::fromStdString(column);
}

QString AnalysisWords::of_cell(const std::string& column, const std::string& text) {
  const char* shown = nullptr;
  if (column == "person") shown = shown_in(kPersons, text);
  if ((column == "column" || column == "answers") && text == "all") shown = "all";
  if (column == "item" && text == "cannot_tell") {
    shown = QT_TRANSLATE_NOOP("AnalysisWords", "cannot tell");
  }
  return shown == nullptr ? words_as_published(words_of_cell(column, text)) : tr(shown);
}

}  // namespace asperity

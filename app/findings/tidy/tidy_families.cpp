// One row per family, in alphabetical order, with its columns, its options and its function.

#include "app/findings/tidy/tidy_families.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/words/text_parts.h"
#include "protocols/design/wording.h"

namespace asperity {
namespace {

constexpr std::array kFamilies{
    TidyFamily{"components",
               "item,scale,score: one score per item and scale; with the column subject, one per "
               "participant, item and scale",
               "conf", components_findings, "conf"},
    TidyFamily{
        "description",
        "subject,value and one column per factor: one measurement per row, value empty where "
        "there is none",
        "average: of the measurements of a participant: mean, median; factors: columns with "
        "their levels, as {\"texture\": [\"wood\", \"metal\"]}",
        description_findings, "average,factors"},
    TidyFamily{
        "dprime",
        "id,design,signal_yes,signal_n,noise_yes,noise_n,m and optionally subject: counts of a "
        "task, one per row; design: yesno, 2afc, mafc, samediff, abx, oddity; of mafc and oddity "
        "signal_yes of signal_n are correct, and m is the number of alternatives of mafc",
        "conf", dprime_findings, "conf"},
    TidyFamily{"equivalence",
               "subject,a,b: pairs of values; or subject,value: one sample against 0; or "
               "subject,group,value: two samples; one row per participant",
               "lower, upper: equivalence bounds, both or neither; alpha of each one-sided "
               "test; groups: names of the two samples, in order; conf",
               equivalence_findings, "lower,upper,alpha,groups,conf"},
    TidyFamily{
        "glmm",
        "subject,item,correct,trials and one column per factor and covariate: the responses of "
        "a participant to an item under a condition; without the column item where "
        "random=subject",
        "link: logit, probit; random: subject, item or both; fixed: factors with their "
        "levels, as {\"tip\": [\"a\", \"b\"]}; covariates: columns of numbers; chance: "
        "proportion against which the intercept is tested; conf",
        glmm_findings, "link,random,fixed,covariates,chance,conf"},
    TidyFamily{"group", "subject,group,correct,trials: one participant per row",
               "groups: names of the two groups, in order; conf", group_findings, "groups,conf"},
    TidyFamily{
        "group_values",
        "subject,group,value: one participant per row, value empty where the participant has "
        "no number; or subject,group,item,value: one item of a participant per row",
        "groups: names of the two groups, in order; scale, without items: difference or "
        "ratio of the (geometric) means; conf",
        group_values_findings, "groups,scale,conf"},
    TidyFamily{"icc",
               "target,rater,score: one rating per target and rater (or repetition), empty where "
               "there is none",
               "conf", icc_findings, "conf"},
    TidyFamily{
        "learning",
        "subject,trial,time_s: one response per row, time_s empty where there is no "
        "response time; or subject,trial,correct,items: correct responses of a trial; trials "
        "numbered from 1 for each participant",
        "blocks: largest number of ranges of trials, 12 if absent; conf", learning_findings,
        "blocks,conf"},
    TidyFamily{
        "lmm",
        "subject,y and one column per factor and covariate: one measurement per row, y empty "
        "where there is none",
        "fixed: factors with their levels, as {\"texture\": [\"wood\", \"metal\"]}; "
        "covariates: columns of numbers; scale: linear, log; conf",
        lmm_findings, "fixed,covariates,scale,conf"},
    TidyFamily{
        "magnitude",
        "subject,probe,spacing,estimate and optionally rep: one estimate per row, empty where "
        "there is none; the estimates of a cell are averaged as logarithms; with a column item, "
        "estimates are compared by item, and spacing is its predictor or absent; and b,s1,s2,...: "
        "resampled participants",
        "zero_rule: exclude, halfmin; normalisation: geomean, standard, none; "
        "standard_spacing or standard_item; modulus; conf",
        magnitude_findings, "zero_rule,normalisation,standard_spacing,standard_item,modulus,conf",
        2},
    TidyFamily{
        "matching",
        "subject,trial,stimulus,response and optionally group: one row per "
        "place of a trial, response empty where it was left blank; and optionally times: number of "
        "identical trials",
        "conf; parts: all, summary, totals", matching_findings, "conf,parts"},
    TidyFamily{"mds",
               "item,other,dissimilarity: each pair of items once, dissimilarity empty where it "
               "was not judged",
               "items (all, in order); dimensions: of the configuration, 2 if absent", mds_findings,
               "items,dimensions"},
    TidyFamily{"ordinal", "subject,item,score: one response per row, on ordered categories",
               "items (all that were rated; effects refer to the first), conf", ordinal_findings,
               "items,conf"},
    TidyFamily{
        "paired",
        "subject,first,second,winner: the item that was preferred to the other, or tie, empty "
        "where there is no judgement; and optionally times: number of identical judgements",
        "items (all that were compared), conf", paired_findings, "items,conf"},
    TidyFamily{
        "power",
        "id,kind,n,k,p0,p1,alpha,theta,d,f,rho,eps,probs: one plan per row, with id, kind, n, "
        "alpha and the columns that its kind needs",
        "", power_findings, ""},
    TidyFamily{
        "proportion",
        "id,k,n,p0: hits k of n trials each, chance level p0; and conf, if it differs between rows",
        "conf, unless the table has this column", proportion_findings, "conf"},
    TidyFamily{
        "psi", "trial,response: one trial per row, response 1 or 0, empty where there is none",
        "shape: logistic, normal; stim: the possible levels; alpha, gamma, lambda: values of "
        "the parameters; beta: values of log10 of the slope; nuisance: parameters over which "
        "is marginalised",
        psi_findings, "shape,stim,alpha,beta,gamma,lambda,nuisance"},
    TidyFamily{"psyfit",
               "condition,x,n,k: k correct of n trials at level x; optionally unsure: responses "
               "\"cannot tell\" among n, and m: number of alternatives; and b,k1,k2,...: resampled "
               "k of the first condition",
               "shape: logistic, normal, gumbel, weibull; gamma, lambda: a rate or free; "
               "lambda_max; pt: performance at the threshold, between gamma and 1 - lambda; "
               "bootstrap: draws of the parametric bootstrap, 1000 where absent, 0 for none; conf",
               psyfit_findings, "shape,gamma,lambda,lambda_max,pt,bootstrap,conf", 2},
    TidyFamily{"questplus",
               "trial,response: one trial per row, response 1 or 0, empty where there is none",
               "shape: weibull_db (levels in dB), normal; stim: the possible levels; gamma: the "
               "guess rate; alpha, beta, lambda: values of the parameters, beta of normal as a "
               "standard deviation",
               questplus_findings, "shape,stim,gamma,alpha,beta,lambda"},
    TidyFamily{"ranking",
               "subject,trial,item,rank: 1 for the best, empty for an item that was presented and "
               "ranks behind all that were ranked; an item that was not presented has no row; and "
               "optionally times: number of identical trials",
               "items (all that were presented in any trial), conf", ranking_findings,
               "items,conf"},
    TidyFamily{
        "rating",
        "subject,item,score: one score per subject and item, the larger the better, ties allowed",
        "items (all that were rated), conf; parts: all, items", rating_findings,
        "items,conf,parts"},
    TidyFamily{"recognition",
               "subject,stimulus,response: one trial per row, response empty where there is none",
               "labels: names of the stimuli, in order; conf; parts: all, participants",
               recognition_findings, "labels,conf,parts"},
    TidyFamily{"response_times",
               "subject,time_s and one column per factor: one response per row, time_s empty where "
               "there is no response time",
               "factors: columns with their levels, as {\"texture\": [\"wood\", \"metal\"]}; "
               "conf",
               response_times_findings, "factors,conf"},
    TidyFamily{
        "rmanova",
        "subject,y and one column per factor: one measurement per row; several measurements of a "
        "participant in a cell are averaged, and their number is reported",
        "within: factors with their levels, as {\"spacing\": [1, 2, 4]}; between: none or one, as "
        "{\"group\": [\"a\", \"b\"]}; type: 2, 3; trend: a "
        "factor; trend_scale: linear, log10; conf",
        rmanova_findings, "within,between,type,trend,trend_scale,conf"},
    TidyFamily{"roc",
               "condition,rating,noise,signal and optionally subject: trials without and with a "
               "signal by rating, a higher one being more certain that there was a signal",
               "conf", roc_findings, "conf"},
    TidyFamily{"seedpaper",
               "three tables of margins: exp,renderer,count; exp,sex,correct,n of matching; "
               "exp,sex,correct,n of recognition",
               "", seedpaper_findings, "", 3},
    TidyFamily{"selection",
               "subject,sample,choice: the best of several, empty where none was chosen",
               "renderers (all that can be chosen), target (one of them), conf; parts: all, pairs",
               selection_findings, "renderers,target,conf,parts"},
    TidyFamily{
        "similarity",
        "subject,first,second,dissimilarity: one judgement of a pair per row, first and second in "
        "the order of presentation, the same item for an identical pair; and "
        "item,property,value: physical properties of the items",
        "items (all, in order); dimensions: of the configuration, by cross-validation if absent; "
        "conf; parts: all, tests",
        similarity_findings, "items,dimensions,conf,parts", 2},
    TidyFamily{
        "staircase",
        "track,trial,response: one trial per row, response 1 for a correct one, 0 for an "
        "incorrect one, empty where there is none",
        "tracks: the rule of each track, as {\"a\": {\"start\": 10, \"n_down\": 2, \"n_up\": "
        "1, \"step\": [2, 1], \"scale\": \"linear\", \"discard\": 2}}; scale: linear, log10, "
        "db, ratio; also step_up_ratio, min, max, even",
        staircase_findings, "tracks"},
};

}  // namespace

void refuse_unknown_options(const TidyFamily& family, const FamilyOptions& options) {
  const std::vector<std::string> known = family.option_names.empty()
                                             ? std::vector<std::string>{}
                                             : parts_of(std::string(family.option_names), ',');
  for (const std::string& name : options.names()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string meant = did_you_mean(name, known);
    throw std::runtime_error(std::string(family.name) + " has no option \"" + name + '"' +
                             (known.empty()   ? "; leave it out"
                              : meant.empty() ? "; choose one of: " + std::string(family.options)
                                              : meant));
  }
}

void refuse_further_tables(const TidyFamily& family, const TidyInput& input) {
  if (input.tables.size() <= family.most_tables) return;
  const std::string tables = family.most_tables == 1
                                 ? "one table"
                                 : "at most " + std::to_string(family.most_tables) + " tables";
  throw std::runtime_error(input.tables[family.most_tables].name() + ": " +
                           std::string(family.name) + " takes " + tables + ": " +
                           std::string(family.tables) +
                           (family.most_tables == 1 ? "; combine the data in one table"
                                                    : "; leave out the further tables"));
}

std::string TidyInput::label_of(const FindingKey& key) {
  const std::string label = key.text();
  if (key.size() > 1) keys.emplace(label, key);
  return label;
}

const TidyTable& TidyInput::table(std::size_t index) const {
  if (index < tables.size()) return tables[index];
  throw std::runtime_error("this analysis needs at least " + counted(index + 1, "table", "tables") +
                           ", and the number given is " + std::to_string(tables.size()) +
                           "; name the others after the first");
}

std::span<const TidyFamily> tidy_families() { return kFamilies; }

std::string family_names() {
  std::string names{};
  for (const TidyFamily& family : kFamilies) {
    names += (names.empty() ? "" : ", ") + std::string(family.name);
  }
  return names;
}

const TidyFamily& tidy_family(const std::string& name) {
  const auto found =
      std::find_if(kFamilies.begin(), kFamilies.end(),
                   [&name](const TidyFamily& family) { return family.name == name; });
  if (found != kFamilies.end()) return *found;
  throw std::runtime_error("there is no family of analyses \"" + name +
                           "\"; choose one of: " + family_names());
}

}  // namespace asperity

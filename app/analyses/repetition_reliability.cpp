#include "app/analyses/repetition_reliability.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/number_text.h"
#include "app/analyses/reading_number.h"
#include "app/analyses/study_findings.h"

namespace asperity {

namespace {

constexpr const char* kReliability = "reliability";

struct MeanScore {
  double sum = 0.0;
  std::size_t n = 0;
};

/// "ICC(3,1) = 0.71, 95 % CI [0.38, 0.91]", without the interval where there is none.
Phrase correlation_text(const std::string& name, const Finding& icc) {
  if (!icc.value) return phrase("Analysis", "%1 is not defined").with(name);
  if (!icc.low || !icc.high) return phrase("Analysis", "%1 = %2").with(name, fixed(*icc.value, 2));
  return phrase("Analysis", "%1 = %2, 95 % CI [%3, %4]")
      .with(name, fixed(*icc.value, 2), fixed(*icc.low, 2), fixed(*icc.high, 2));
}

}  // namespace

void ask_reliability(const GatheredAnswers& gathered, std::span<const RepeatedScore> scores,
                     AnalysisOutcome& outcome) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, MeanScore> means{};
  std::set<std::uint32_t> repetitions{};
  for (const RepeatedScore& score : scores) {
    if (gathered.word(score.column).empty()) return;  // not an experiment in repetitions
    repetitions.insert(score.column);
    MeanScore& mean = means[{score.person, score.column}];
    mean.sum += score.proportion;
    ++mean.n;
  }
  if (repetitions.size() < 2) return;
  std::string text = "target,rater,score\n";
  for (const auto& [of, mean] : means) {
    text += gathered.people[of.first].label + ',' + gathered.word(of.second) + ',' +
            number_text(mean.sum / static_cast<double>(mean.n)) + '\n';
  }
  TidyInput input{};
  input.tables.emplace_back(text, "the repetitions");
  const std::vector<Finding> findings = analysis_of(kReliability, "icc", std::move(input));
  const FoundNumbers found(findings);
  const Finding* one = found.find("icc", "ICC3");
  const Finding* agreement = found.find("icc", "ICC2");
  const Finding* all = found.find("icc", "ICC3k");
  const Finding* none = found.find("icc");
  if (none != nullptr && none->word == "too_few") return;
  keep_findings(findings, outcome);
  const Phrase answer =
      one == nullptr || agreement == nullptr || all == nullptr
          ? phrase("Analysis",
                   "Not defined: all participants have the same result in every repetition.")
          : phrase("Analysis",
                   "Of one repetition %1 (consistency), %2 (agreement); of the mean of the %3 "
                   "repetitions %4. N = %5 participants.")
                .with(correlation_text("ICC(3,1)", *one), correlation_text("ICC(2,1)", *agreement),
                      std::to_string(repetitions.size()), correlation_text("ICC(3,k)", *all),
                      std::to_string(one->n));
  add_question(outcome, kReliability,
               phrase("Analysis", "How reliable are the participants' results over repetitions?"),
               answer,
               phrase("Analysis",
                      "Intraclass correlations of the participants' proportions correct in each "
                      "repetition. They are low also where participants differ little from each "
                      "other."),
               "", one != nullptr ? one : none);
}

}  // namespace asperity

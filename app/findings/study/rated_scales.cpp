#include "app/findings/study/rated_scales.h"

#include <algorithm>
#include <optional>
#include <set>

#include "app/findings/study/study_findings.h"
#include "protocols/answers/scale_form.h"

namespace asperity {

namespace {

/// What is rated in a trial: its surface. Where a scale accompanies several surfaces, all of them, in
/// whatever order they were felt.
std::string rated_item(const GatheredAnswers& gathered, const GatheredAnswer& answer) {
  std::multiset<std::string> names{};
  for (const FeltSurface& surface : gathered.surfaces_of(answer)) {
    names.insert(gathered.word(surface.item));
  }
  std::string item{};
  for (const std::string& name : names) item += (item.empty() ? "" : "+") + name;
  return item;
}

/// Whether the protocol's family names a test of ratings that can only be one of accompanying scales.
bool tests_accompanying_ratings(const GatheredAnswers& gathered) {
  const std::vector<std::string>& family = gathered.declared.family;
  return gathered.only_accompanies &&
         std::any_of(family.begin(), family.end(), [](const std::string& name) {
           return name == "ratings" || name == "rated_pairs" || name == "rating_model";
         });
}

}  // namespace

std::vector<RatedScale> rated_scales(const GatheredAnswers& gathered) {
  const bool takes_all = tests_accompanying_ratings(gathered);
  std::map<std::string, std::vector<RatedScale::Response>> responses{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::optional<double>& number = gathered.reply_of(answer).number;
    if (!number || (answer.accompanied && !takes_all)) continue;
    responses[gathered.word(answer.question)].push_back(
        {answer.person, rated_item(gathered, answer), answer.repetition, *number});
  }
  std::vector<RatedScale> scales{};
  for (const StoredProtocol::TrialQuestion& question : gathered.questions) {
    const auto found = responses.find(question.name);
    if (found == responses.end()) continue;
    RatedScale& scale = scales.emplace_back();
    scale.name = question.name;
    scale.points = question.points;
    scale.minimum = question.minimum.value_or(ScaleForm{}.minimum);
    scale.maximum = question.maximum.value_or(ScaleForm{}.maximum);
    scale.responses = std::move(found->second);
    responses.erase(found);
    struct Sum {
      double total = 0.0;
      std::size_t n = 0;
    };
    std::map<std::pair<std::uint32_t, std::string>, Sum> sums{};
    std::set<std::string> items{};
    for (const RatedScale::Response& response : scale.responses) {
      Sum& sum = sums[{response.person, response.item}];
      sum.total += response.score;
      ++sum.n;
      items.insert(response.item);
    }
    for (const auto& [of, sum] : sums) scale.means[of] = sum.total / static_cast<double>(sum.n);
    scale.items.assign(items.begin(), items.end());
  }
  return scales;
}

std::vector<Finding> findings_of(const char* analysis, const char* family, const RatedScale& scale,
                                 TidyInput input) {
  std::vector<Finding> findings = analysis_of(analysis, family, std::move(input));
  for (Finding& finding : findings) {
    finding.key = scale.name + (finding.key.empty() ? "" : "|" + finding.key);
  }
  return findings;
}

}  // namespace asperity

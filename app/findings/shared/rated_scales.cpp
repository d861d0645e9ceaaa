// Names items by their surfaces, or by the levels of factors where all surfaces have one name, and averages.

#include "app/findings/shared/rated_scales.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "app/findings/outcome/study_findings.h"
#include "protocols/answers/scale_form.h"
#include "results_schema/tables/table.h"

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

/// Names the surfaces of a scale by the levels of the factors that determine them, where they have neither different
/// textures, models nor names: "amplitude_m 5e-05, wavelength_m 0.0025". The name of the factor precedes a number,
/// which would have no meaning without it.
class LevelItems final {
 public:
  LevelItems(const GatheredAnswers& gathered, const std::vector<const GatheredAnswer*>& answers)
      : gathered_(gathered) {
    for (const GatheredAnswer* const answer : answers) {
      for (const auto& [factor, level] : levels_of(*answer)) levels_[factor].insert(level);
    }
    std::erase_if(levels_, [](const auto& factor) { return factor.second.size() < 2; });
  }

  /// `otherwise`: in a trial without such a level.
  std::string item(const GatheredAnswer& answer, const std::string& otherwise) {
    std::string name{};
    Place place{};
    for (const auto& [factor, level] : levels_of(answer)) {
      if (!levels_.contains(factor)) continue;
      const std::optional<double> number = number_in(level);
      name += (name.empty() ? "" : ", ") + (number ? factor + ' ' + level : level);
      place.emplace_back(number.value_or(std::numeric_limits<double>::infinity()), level);
    }
    if (name.empty()) name = otherwise;
    items_.emplace(std::move(place), name);
    return name;
  }
  /// Those that were named, with numbers by value.
  std::vector<std::string> items() const {
    std::vector<std::string> names{};
    for (const auto& [place, name] : items_) names.push_back(name);
    return names;
  }

 private:
  using Place = std::vector<std::pair<double, std::string>>;

  std::map<std::string, std::string> levels_of(const GatheredAnswer& answer) const {
    std::map<std::string, std::string> levels{};
    const auto block = gathered_.surface_factors.find(gathered_.word(answer.block));
    if (block == gathered_.surface_factors.end()) return levels;
    for (const std::string& factor : block->second) {
      const std::uint32_t level = gathered_.level(answer, factor);
      if (level != kNoWord) levels[factor] = gathered_.word(level);
    }
    return levels;
  }

  const GatheredAnswers& gathered_;
  std::map<std::string, std::set<std::string>> levels_{};
  std::map<Place, std::string> items_{};
};

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
  std::map<std::string, std::vector<const GatheredAnswer*>> answers{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!gathered.reply_of(answer).number || (answer.accompanied && !takes_all)) continue;
    answers[gathered.word(answer.question)].push_back(&answer);
  }
  std::vector<RatedScale> scales{};
  for (const Protocol::TrialQuestionTemplate& question : gathered.questions) {
    const auto found = answers.find(question.name);
    if (found == answers.end()) continue;
    RatedScale& scale = scales.emplace_back();
    scale.name = question.name;
    const ScaleForm& form = scale_of(question);
    if (form.points > 0) scale.points = form.points;
    scale.minimum = form.minimum;
    scale.maximum = form.maximum;
    if (!form.labels.empty()) {
      scale.low_label = form.labels.front();
      scale.high_label = form.labels.back();
    }
    std::set<std::string> items{};
    for (const GatheredAnswer* const answer : found->second) {
      items.insert(rated_item(gathered, *answer));
    }
    LevelItems levels(gathered, found->second);
    for (const GatheredAnswer* const answer : found->second) {
      std::string item = rated_item(gathered, *answer);
      if (items.size() == 1) item = levels.item(*answer, item);
      scale.responses.push_back({answer->person, std::move(item), answer->repetition,
                                 *gathered.reply_of(*answer).number});
    }
    if (items.size() == 1) {
      scale.items = levels.items();
    } else {
      scale.items.assign(items.begin(), items.end());
    }
    answers.erase(found);
    struct Sum {
      double total = 0.0;
      std::size_t n = 0;
    };
    std::map<std::pair<std::uint32_t, std::string>, Sum> sums{};
    for (const RatedScale::Response& response : scale.responses) {
      Sum& sum = sums[{response.person, response.item}];
      sum.total += response.score;
      ++sum.n;
    }
    for (const auto& [of, sum] : sums) scale.means[of] = sum.total / static_cast<double>(sum.n);
  }
  return scales;
}

std::vector<Finding> findings_of(const char* analysis, const char* family, const RatedScale& scale,
                                 TidyInput input) {
  std::vector<Finding> findings = analysis_of(analysis, family, std::move(input));
  for (Finding& finding : findings) {
    finding.key = {scale.name, finding.key};
  }
  return findings;
}

}  // namespace asperity

// Averages the proportions of choices of each place over the places of the correct surface.

#include "app/findings/methods/discrimination/thresholds/choices_by_place.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "analysis/numbers/proportion.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/simulated_coverage.h"

namespace asperity {

namespace {

std::uint64_t sum_of(const std::array<std::uint64_t, kPlacesOfChoice>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

}  // namespace

std::uint64_t PlacesOfPerson::responses() const {
  std::uint64_t all = 0;
  for (const auto& of_place : choices) all += sum_of(of_place);
  return all;
}

bool PlacesOfPerson::has_all() const {
  return std::all_of(choices.begin(), choices.end(),
                     [](const auto& of_place) { return sum_of(of_place) > 0; });
}

double PlacesOfPerson::proportion_of(std::size_t place) const {
  double sum = 0.0;
  for (const auto& of_place : choices) {
    sum += static_cast<double>(of_place.at(place)) / static_cast<double>(sum_of(of_place));
  }
  return sum / static_cast<double>(kPlacesOfChoice);
}

std::vector<PlacesOfPerson> places_of(const DiscriminationStudy& study) {
  std::map<std::uint32_t, PlacesOfPerson> by_person{};
  for (const DiscriminationTrial& trial : study.trials) {
    PlacesOfPerson& own = by_person[trial.person];
    own.person = trial.person;
    ++own.choices.at(trial.correct_place).at(trial.chosen_place);
  }
  std::vector<PlacesOfPerson> places{};
  for (const auto& [person, own] : by_person) places.push_back(own);
  return places;
}

FindingKey key_of_place(const std::string& task, std::size_t place) {
  return {task, kCodesOfPlaces.at(place)};
}

std::vector<Finding> place_findings(std::span<const PlacesOfPerson> places,
                                    const std::string& task) {
  FindingList list{};
  for (std::size_t place = 0; place < kPlacesOfChoice; ++place) {
    std::vector<double> proportions{};
    for (const PlacesOfPerson& own : places) {
      if (own.has_all()) proportions.push_back(own.proportion_of(place));
    }
    if (proportions.empty()) return {};
    add_mean_of_group("place.proportion", key_of_place(task, place), proportions,
                      {.possible = ConfidenceInterval{0.0, 1.0},
                       .of = "mean of the participants' proportions of choices of this place, "
                             "averaged over the places of the correct surface; 1/3 without a "
                             "preference"},
                      list);
  }
  std::vector<Finding> findings = list.take();
  for (Finding& finding : findings) {
    finding.analysis = kOrderEffect;
    if (finding.low && finding.high) finding.method += simulated_coverage({93, 100});
  }
  return findings;
}

}  // namespace asperity

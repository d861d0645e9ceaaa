// Joins steps of five years until each band has enough participants, human and virtual ones apart.

#include "app/exports/age_bands.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace asperity {
namespace {

constexpr int kStep_years = 5;

int step_below(double age_years) {
  return static_cast<int>(std::floor(age_years / kStep_years)) * kStep_years;
}

std::size_t index_of(const ParticipantRow& participant) { return participant.is_virtual ? 1 : 0; }

}  // namespace

std::string AgeBands::Band::name() const {
  // A spreadsheet would read "10-12" as a date.
  return std::to_string(from_years) +
         (to_years ? " to " + std::to_string(*to_years) : std::string(" and older"));
}

AgeBands::AgeBands(const std::vector<ParticipantRow>& participants) {
  std::array<std::vector<double>, 2> ages_years{};
  for (const ParticipantRow& participant : participants) {
    if (participant.age_years) ages_years[index_of(participant)].push_back(*participant.age_years);
  }
  for (std::size_t i = 0; i < bands_.size(); ++i) bands_[i] = bands_of(ages_years[i]);
}

std::vector<AgeBands::Band> AgeBands::bands_of(const std::vector<double>& ages_years) {
  std::map<int, std::size_t> participants_at{};
  for (const double age_years : ages_years) ++participants_at[step_below(age_years)];
  std::vector<Band> bands{};
  std::optional<Band> growing{};
  std::size_t participants = 0;
  for (const auto& [from_years, count] : participants_at) {
    if (!growing) growing = Band{from_years, from_years};
    growing->to_years = from_years + kStep_years - 1;
    participants += count;
    if (participants < kFewest) continue;
    bands.push_back(*std::exchange(growing, std::nullopt));
    participants = 0;
  }
  if (growing && !bands.empty()) bands.back().to_years.reset();
  return bands;
}

std::optional<std::string> AgeBands::of(const ParticipantRow& participant) const {
  if (!participant.age_years) return {};
  for (const Band& band : bands_[index_of(participant)]) {
    const bool is_in = *participant.age_years >= band.from_years &&
                       (!band.to_years || *participant.age_years < *band.to_years + 1);
    if (is_in) return band.name();
  }
  return {};
}

std::vector<std::string> AgeBands::names() const {
  std::set<Band> all{};
  for (const std::vector<Band>& bands : bands_) all.insert(bands.begin(), bands.end());
  std::vector<std::string> names{};
  for (const Band& band : all) names.push_back(band.name());
  return names;
}

}  // namespace asperity

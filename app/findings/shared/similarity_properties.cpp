// Collects exploration, texture forces, octaves of recorded forces, and levels where all items are numbers.

#include "app/findings/shared/similarity_properties.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "app/findings/gathering/answer_columns.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

/// Rows of items, properties and their values.
class PropertyRows {
 public:
  void add(const std::string& item, const std::string& property, double value) {
    items_.add(item);
    properties_.add(property);
    values_.push_back(value);
  }
  TidyTable table() && {
    return {{{"item", std::move(items_).take()},
             {"property", std::move(properties_).take()},
             {"value", std::move(values_)}},
            "the properties of the items"};
  }

 private:
  LabelRows items_{};
  LabelRows properties_{};
  NumberColumn values_{};
};

/// How the items were explored, as means over the participants.
void add_exploration(const GatheredAnswers& gathered, const std::vector<std::string>& items,
                     PropertyRows& rows) {
  struct Measured {
    Explored quantity{};
    const char* name = "";
  };
  constexpr std::array kMeasured{Measured{Explored::force_N, "force_N"},
                                 Measured{Explored::force_sd_N, "force_sd_N"},
                                 Measured{Explored::speed_m_per_s, "speed_m_per_s"},
                                 Measured{Explored::speed_sd_m_per_s, "speed_sd_m_per_s"}};
  for (const Measured& measured : kMeasured) {
    for (const std::string& item : items) {
      const std::optional<std::uint32_t> word = gathered.words.find(item);
      if (!word) continue;
      const auto own = gathered.exploration.own_values({.by = ExploredBy::item, .level = *word},
                                                       measured.quantity);
      if (own.empty()) continue;
      double sum = 0.0;
      for (const OwnValue& value : own) sum += value.value;
      rows.add(item, measured.name, sum / static_cast<double>(own.size()));
    }
  }
}

/// The mean RMS of the texture forces of the items.
void add_texture_forces(const GatheredAnswers& gathered, const std::vector<std::string>& items,
                        PropertyRows& rows) {
  for (const std::string& item : items) {
    const std::optional<std::uint32_t> word = gathered.words.find(item);
    if (!word) continue;
    const auto force = gathered.item_forces.find(*word);
    if (force == gathered.item_forces.end()) continue;
    rows.add(item, "texture_force_N", force->second.mean_N());
  }
}

/// The wavelengths in the forces that were felt, as far as they were recorded.
void add_felt_octaves(const GatheredAnswers& gathered, const std::vector<std::string>& items,
                      PropertyRows& rows) {
  for (std::size_t octave = 0; octave < kFeltOctaves; ++octave) {
    for (const std::string& item : items) {
      const auto felt = gathered.felt_octaves.find(item);
      if (felt == gathered.felt_octaves.end() || felt->second.presentations == 0) continue;
      rows.add(item, kOctaveProperties[octave], felt->second.mean_ratio(octave));
    }
  }
}

/// The levels, where all items are numbers.
void add_levels(const std::vector<std::string>& items, PropertyRows& rows) {
  std::vector<double> levels{};
  for (const std::string& item : items) {
    if (const std::optional<double> level = number_in(item)) levels.push_back(*level);
  }
  if (levels.size() < items.size()) return;
  for (std::size_t i = 0; i < items.size(); ++i) rows.add(items[i], "level", levels[i]);
}

}  // namespace

TidyTable properties_of_items(const GatheredAnswers& gathered,
                              const std::vector<std::string>& items) {
  PropertyRows rows{};
  add_exploration(gathered, items, rows);
  add_texture_forces(gathered, items, rows);
  add_felt_octaves(gathered, items, rows);
  add_levels(items, rows);
  return std::move(rows).table();
}

std::map<std::string, double> property_of_items(const GatheredAnswers& gathered,
                                                const std::vector<std::string>& items,
                                                const std::string& property) {
  const TidyTable table = properties_of_items(gathered, items);
  std::map<std::string, double> values{};
  if (table.rows() == 0) return values;
  const LabelColumn names = table.all_labels("item");
  const LabelColumn properties = table.all_labels("property");
  const std::vector<double> numbers = table.all_numbers("value");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (properties.names[properties.codes[row]] != property) continue;
    values.emplace(names.names[names.codes[row]], numbers[row]);
  }
  return values;
}

}  // namespace asperity

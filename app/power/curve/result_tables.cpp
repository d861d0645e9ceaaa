// Makes one row per number of participants or planned power, with rounded and missing cells.

#include "app/power/curve/result_tables.h"

#include <cstdint>
#include <optional>
#include <variant>

#include <nlohmann/json.hpp>

#include "analysis/numbers/rounded_text.h"
#include "app/findings/outcome/test_methods.h"

namespace asperity {

namespace {

Cell rounded_cell(const std::optional<double>& number) {
  return number ? Cell(without_rounding_errors(*number)) : Cell(std::monostate{});
}

Cell stored_count(std::uint64_t count) { return static_cast<std::int64_t>(count); }

Cell stored_count(const std::optional<std::size_t>& count) {
  return count ? Cell(static_cast<std::int64_t>(*count)) : Cell(std::monostate{});
}

}  // namespace

std::string methods_text(const PowerCurve& curve) {
  std::string text{};
  for (const std::string& code : curve.methods) {
    text += (text.empty() ? "" : " or ") + text_with_sides(code);
  }
  return text;
}

Table power_table(std::span<const PowerCurve> curves) {
  Table table{.columns = {"effect", "family", "test", "method", "participants", "studies",
                          "significant", "power", "power_low", "power_high", "fitted_power",
                          "without_p", "median_width", "p90_width"}};
  for (const PowerCurve& curve : curves) {
    for (const TestAtSize& size : curve.sizes) {
      table.rows.push_back({curve.effect, curve.family, curve.test, methods_text(curve),
                            std::int64_t{size.power.participants}, stored_count(size.studies),
                            stored_count(size.significant), size.power.power,
                            rounded_cell(size.power.interval.low),
                            rounded_cell(size.power.interval.high), rounded_cell(size.power.fitted),
                            stored_count(size.without_p), rounded_cell(size.median_width),
                            rounded_cell(size.p90_width)});
    }
  }
  return table;
}

Table sample_table(std::span<const PowerCurve> curves, const SampleRules& rules) {
  Table table{.columns = {"effect", "family", "test", "power", "status", "participants",
                          "participants_low", "participants_high", "planned",
                          "recruited_on_average", "recruited_assured"}};
  for (const PowerCurve& curve : curves) {
    for (const double power : kWantedPowers) {
      const PlannedSample sample = planned_sample(curve, power, rules);
      std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{
          curve.effect, curve.family, curve.test, power, code_of(sample.reached),
          stored_count(sample.participants), stored_count(sample.low), stored_count(sample.high),
          stored_count(sample.planned), Cell{}, Cell{}});
      if (!sample.recruited) continue;
      row[9] = stored_count(sample.recruited->on_average);
      row[10] = stored_count(sample.recruited->assured);
    }
  }
  return table;
}

nlohmann::ordered_json json_of(const Table& table) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const std::vector<Cell>& row : table.rows) {
    nlohmann::ordered_json& object = json.emplace_back(nlohmann::ordered_json::object());
    for (std::size_t i = 0; i < row.size(); ++i) {
      nlohmann::ordered_json& value = object[table.columns[i]];
      std::visit(
          [&value](const auto& cell) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(cell)>, std::monostate>) {
              value = cell;
            }
          },
          row[i]);
    }
  }
  return json;
}

}  // namespace asperity

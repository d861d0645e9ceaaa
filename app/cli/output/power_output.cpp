// Prints assumptions, curves and samples as aligned tables, and writes tables, figure, text and JSON.

#include "app/cli/output/power_output.h"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"
#include "app/cli/output/terminal.h"
#include "app/findings/outcome/study_test.h"
#include "app/power/curve/ethics_statement.h"
#include "app/power/curve/result_tables.h"
#include "app/power/curve/true_size.h"
#include "app/study_files/program.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

Table assumption_table(const std::vector<Assumption>& assumptions) {
  Table table{.columns = {"assumption", "value", "unit", "source", "meaning"}};
  for (const Assumption& one : assumptions) {
    table.rows.push_back({one.name, one.value ? Cell(*one.value) : Cell(std::monostate{}), one.unit,
                          one.source + (is_from_pilot(one) ? " (pilot)" : ""),
                          one.meaning.english()});
  }
  return table;
}

constexpr int kDigits = 3;  // significant ones, on a terminal

std::string rounded_number(double number) { return number_text(with_digits(number, kDigits)); }

Cell rounded_cell(const std::optional<double>& number) {
  return number ? Cell(with_digits(*number, kDigits)) : Cell(std::monostate{});
}

std::string limit_text(const std::optional<std::size_t>& limit) {
  return limit ? std::to_string(*limit) : "n/a";
}

/// Each with its source and, below, its meaning.
void print_assumptions(const std::vector<Assumption>& assumptions) {
  for (const Assumption& one : assumptions) {
    const std::string unit = one.unit == "1" ? "" : ' ' + one.unit;
    const std::string value = one.value ? rounded_number(*one.value) + unit : "n/a";
    std::cout << wrapped_text(one.name + " = " + value + "; source: " + one.source +
                                  (is_from_pilot(one) ? " (pilot)" : ""),
                              kTerminalColumns)
              << '\n'
              << wrapped_text(one.meaning.english(), kTerminalColumns, "    ") << '\n';
  }
}

std::string heading_of(const PowerCurve& curve) {
  if (curve.test.empty()) {
    return "Family \"" + curve.family + "\": at least one of its tests is significant";
  }
  const std::string methods = methods_text(curve);
  return "Test \"" + curve.test + "\" of the family \"" + curve.family + '"' +
         (methods.empty() ? "" : ": " + methods);
}

/// Why studies have no p, for a line below their number; empty where all have one.
std::string reasons_text(const PowerCurve& curve) {
  std::string reasons{};
  for (const std::string& status : curve.statuses) {
    reasons += (reasons.empty() ? "without_p: " : "; ") + status;
  }
  return reasons;
}

/// The columns of `power_table`, without those that the heading states.
Table shown_power(const PowerCurve& curve) {
  Table table{.columns = {"participants", "significant", "power", "95 % CI", "fitted", "without_p",
                          "median_width", "p90_width"}};
  for (const TestAtSize& size : curve.sizes) {
    const PowerOfSize& of = size.power;
    table.rows.push_back(
        {std::int64_t{of.participants}, static_cast<std::int64_t>(size.significant),
         rounded_cell(of.power),
         '[' + rounded_number(of.interval.low) + ", " + rounded_number(of.interval.high) + ']',
         rounded_cell(of.fitted), static_cast<std::int64_t>(size.without_p),
         rounded_cell(size.median_width), rounded_cell(size.p90_width)});
  }
  return table;
}

/// The same of `sample_table`.
Table shown_sample(const PowerCurve& curve, const SampleRules& rules) {
  Table table{.columns = {"power", "status", "participants", "95 % CI", "planned",
                          "recruited_on_average", "recruited_assured"}};
  for (const double power : kWantedPowers) {
    const PlannedSample sample = planned_sample(curve, power, rules);
    const auto count = [](const std::optional<std::size_t>& number) {
      return number ? Cell(static_cast<std::int64_t>(*number)) : Cell(std::monostate{});
    };
    const auto recruited = [&](std::size_t Recruitment::*number) {
      return sample.recruited ? Cell(static_cast<std::int64_t>((*sample.recruited).*number))
                              : Cell(std::monostate{});
    };
    table.rows.push_back({power, code_of(sample.reached), count(sample.participants),
                          '[' + limit_text(sample.low) + ", " + limit_text(sample.high) + ']',
                          count(sample.planned), recruited(&Recruitment::on_average),
                          recruited(&Recruitment::assured)});
  }
  return table;
}

void print_curves(const PowerReport& report) {
  const PowerCurve* previous = nullptr;
  for (const PowerCurve& curve : report.power.curves) {
    if (previous == nullptr || previous->effect != curve.effect) {
      std::cout << '\n' << wrapped_text("Effect: " + curve.effect, kTerminalColumns) << '\n';
    }
    previous = &curve;
    std::cout << '\n'
              << wrapped_text(heading_of(curve), kTerminalColumns) << '\n'
              << aligned(shown_power(curve));
    if (const std::string reasons = reasons_text(curve); !reasons.empty()) {
      std::cout << wrapped_text(reasons, kTerminalColumns) << '\n';
    }
    std::cout << aligned(shown_sample(curve, report.rules));
  }
}

PlannedStudy planned_study(const PowerReport& report, std::size_t effect) {
  PlannedStudy study{.protocol = report.protocol.name + ' ' + report.protocol.version,
                     .program = "Asperity " + program_version(),
                     .assumptions = report.levels[effect].assumptions,
                     .is_on_physics = report.order.physics_sha256.has_value(),
                     .stated_effects = report.levels[effect].stated,
                     .runs = report.power.runs,
                     .rules = report.rules};
  for (const PowerCurve& curve : report.power.curves) {
    if (curve.effect == report.order.effects[effect]) study.curves.push_back(curve);
  }
  return study;
}

struct Statement {
  std::string effect{};
  double power = 0.8;
  std::string text{};
};

std::vector<Statement> statements_of(const PowerReport& report) {
  std::vector<Statement> statements{};
  for (std::size_t effect = 0; effect < report.levels.size(); ++effect) {
    if (report.levels[effect].is_null) continue;
    const PlannedStudy study = planned_study(report, effect);
    for (const double wanted : kWantedPowers) {
      statements.push_back({.effect = report.levels[effect].text,
                            .power = wanted,
                            .text = ethics_statement(study, wanted)});
    }
  }
  return statements;
}

}  // namespace

void print_power(const PowerReport& report) {
  const Protocol& protocol = report.protocol;
  const SimulatedPower& power = report.power;
  std::cout << protocol.name << ' ' << protocol.version << ": about "
            << fixed(report.cost.total_s / 60.0, 0) << " min a session, "
            << counted(static_cast<std::size_t>(protocol.sessions), "session")
            << " per participant, rounds of " << counted(report.rules.multiple, "participant")
            << "\n\n";
  if (report.order.physics_sha256) {
    std::cout << "responses: the protocol's virtual observers on the full physics\n\n";
  } else {
    std::cout << (report.levels.size() > 1 ? "Assumptions, with the first effect:\n"
                                           : "Assumptions:\n");
    print_assumptions(report.levels.front().assumptions);
    std::cout << '\n';
  }
  std::cout << wrapped_text(
                   std::to_string(power.runs) +
                       " simulated studies of each effect and number of participants, seed " +
                       std::to_string(report.order.seed) +
                       ". The power is an estimate; its intervals are 95 % Monte-Carlo CIs "
                       "(Clopper–Pearson).",
                   kTerminalColumns)
            << '\n';
  print_curves(report);
  for (const Statement& statement : statements_of(report)) {
    if (statement.power != kWantedPowers.front() || statement.text.empty()) continue;
    std::cout << '\n'
              << wrapped_text("Statement for an ethics form or a preregistration, of the effect " +
                                  statement.effect + ':',
                              kTerminalColumns)
              << '\n'
              << wrapped_text(statement.text, kTerminalColumns) << '\n';
  }
}

nlohmann::ordered_json json_of(const PowerReport& report) {
  nlohmann::ordered_json json{{"format", "asperity.power/1"},
                              {"protocol", report.protocol.name},
                              {"version", report.protocol.version},
                              {"seed", report.order.seed},
                              {"runs", report.power.runs},
                              {"responses", report.order.physics_sha256 ? "physics" : "tables"},
                              {"level_of_significance", StudyTest::kLevel},
                              {"multiple", report.rules.multiple},
                              {"session_s", report.cost.total_s},
                              {"dropout", report.rules.attrition.dropout},
                              {"exclusion", report.rules.attrition.exclusion}};
  json["assumptions"] = nlohmann::ordered_json::object();
  for (const EffectLevel& level : report.levels) {
    json["assumptions"][level.text] = json_of(assumption_table(level.assumptions));
  }
  json["power"] = json_of(power_table(report.power.curves));
  json["sample_size"] = json_of(sample_table(report.power.curves, report.rules));
  json["statements"] = nlohmann::ordered_json::array();
  for (const Statement& statement : statements_of(report)) {
    json["statements"].push_back(
        {{"effect", statement.effect}, {"power", statement.power}, {"text", statement.text}});
  }
  return json;
}

void write_power(const std::filesystem::path& folder, const PowerReport& report) {
  write_file(folder / "power.tsv", tsv_of(power_table(report.power.curves)), Overwrite::allow);
  write_file(folder / "sample_size.tsv", tsv_of(sample_table(report.power.curves, report.rules)),
             Overwrite::allow);
  if (report.order.physics_sha256) return;
  write_file(folder / "assumptions.json", json_of(report.levels.front().assumptions),
             Overwrite::allow);
}

void say_true_sizes(const PowerReport& report) {
  const bool has_null = std::any_of(report.levels.begin(), report.levels.end(),
                                    [](const EffectLevel& level) { return level.is_null; });
  if (!has_null && !report.order.physics_sha256) {
    say("asperity: the true size of the tests, without an effect, was not simulated; repeat the "
        "command with the value null for every effect (--effect NAME=null) to simulate it");
  }
  for (const PowerCurve& curve : report.power.curves) {
    const auto level = std::find_if(report.levels.begin(), report.levels.end(),
                                    [&](const auto& one) { return one.text == curve.effect; });
    if (level == report.levels.end() || !level->is_null) continue;
    for (const TestAtSize& size : curve.sizes) {
      const std::string text = true_size_text(curve, size);
      if (!text.empty()) say("asperity: warning: " + text);
    }
  }
}

}  // namespace asperity

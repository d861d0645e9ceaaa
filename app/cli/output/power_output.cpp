#include "app/cli/output/power_output.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "analysis/number_text.h"
#include "analysis/rounded_text.h"
#include "app/cli/output/terminal.h"
#include "app/findings/study/study_test.h"
#include "app/power/curve/ethics_sentence.h"
#include "app/power/curve/result_tables.h"
#include "app/study_files/program.h"

namespace asperity {

namespace {

Table assumption_table(const std::vector<Assumption>& assumptions) {
  Table table{.columns = {"assumption", "value", "unit", "source", "meaning"}};
  for (const Assumption& one : assumptions) {
    table.rows.push_back({one.name, one.value ? Cell(*one.value) : Cell(std::monostate{}), one.unit,
                          one.source + (is_from_pilot(one) ? " (pilot)" : ""), one.meaning});
  }
  return table;
}

/// With three significant digits, for a terminal.
Table rounded(Table table) {
  constexpr int kDigits = 3;
  for (std::vector<Cell>& row : table.rows) {
    for (Cell& cell : row) {
      if (double* const number = std::get_if<double>(&cell))
        *number = with_digits(*number, kDigits);
    }
  }
  return table;
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

struct Sentence {
  std::string effect{};
  double power = 0.8;
  std::string text{};
};

std::vector<Sentence> sentences_of(const PowerReport& report) {
  std::vector<Sentence> sentences{};
  for (std::size_t effect = 0; effect < report.levels.size(); ++effect) {
    if (report.levels[effect].is_null) continue;
    const PlannedStudy study = planned_study(report, effect);
    for (const double wanted : kWantedPowers) {
      sentences.push_back({.effect = report.levels[effect].text,
                           .power = wanted,
                           .text = ethics_sentence(study, wanted)});
    }
  }
  return sentences;
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
    std::cout << aligned(assumption_table(report.levels.front().assumptions)) << '\n';
  }
  std::cout << power.runs << " simulated studies of each effect and number of participants, seed "
            << report.order.seed << "; intervals: 95 % (Clopper–Pearson)\n\n"
            << aligned(rounded(power_table(report.power.curves))) << '\n'
            << aligned(rounded(sample_table(report.power.curves, report.rules)));
  for (const Sentence& sentence : sentences_of(report)) {
    if (sentence.power == kWantedPowers.front() && !sentence.text.empty())
      std::cout << '\n' << sentence.text << '\n';
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
  json["sentences"] = nlohmann::ordered_json::array();
  for (const Sentence& sentence : sentences_of(report)) {
    json["sentences"].push_back(
        {{"effect", sentence.effect}, {"power", sentence.power}, {"text", sentence.text}});
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
  constexpr double kErrors = 3.0;  // of many tests and sizes, two would often be exceeded by chance
  for (const PowerCurve& curve : report.power.curves) {
    const auto level = std::find_if(report.levels.begin(), report.levels.end(),
                                    [&](const auto& one) { return one.text == curve.effect; });
    if (level == report.levels.end() || !level->is_null) continue;
    for (const TestAtSize& size : curve.sizes) {
      const PowerOfSize& found = size.power;
      const double error = std::sqrt(StudyTest::kLevel * (1.0 - StudyTest::kLevel) /
                                     static_cast<double>(size.studies));
      if (found.power <= StudyTest::kLevel + kErrors * error) continue;
      say("asperity: warning: without an effect, " +
          (curve.test.empty() ? "the family " + curve.family : "the test " + curve.test) +
          " is significant in " + fixed(100.0 * found.power, 1) + " % of the studies with " +
          std::to_string(found.participants) + " participants, 95 % Monte-Carlo CI [" +
          fixed(100.0 * found.interval.low, 1) + ", " + fixed(100.0 * found.interval.high, 1) +
          "]: its true size exceeds the level of significance");
    }
  }
}

}  // namespace asperity

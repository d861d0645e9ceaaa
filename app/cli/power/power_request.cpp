// Validates the combination of options, and completes the order from tables or from the full physics.

#include "app/cli/power/power_request.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/options/number_list.h"
#include "app/cli/output/terminal.h"
#include "app/power/calibration.h"
#include "app/power/curve/effect_levels.h"
#include "app/power/curve/ethics_statement.h"
#include "app/power/power_model.h"
#include "app/study_files/program.h"
#include "app/words/text_parts.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr int kMostParticipants = 10000;

/// FROM:TO:STEP or N,N,…
std::vector<int> numbers_in(const std::string& text) {
  const std::string expected =
      "write FROM:TO:STEP, such as 10:40:5, or N,N,…, whole numbers in ascending order from 1 to " +
      std::to_string(kMostParticipants);
  const auto refuse = [&] { throw WrongUsage("--participants " + text + ": " + expected); };
  const bool is_range = text.find(':') != std::string::npos;
  std::vector<int> numbers{};
  for (const double number : numbers_of("--participants", text, is_range ? ':' : ',', expected)) {
    if (number != std::floor(number) || number < 1.0 || number > kMostParticipants) refuse();
    if (!is_range && !numbers.empty() && number <= numbers.back()) refuse();
    numbers.push_back(static_cast<int>(number));
  }
  if (!is_range) return numbers;
  if (numbers.size() != 3 || numbers[0] > numbers[1]) refuse();
  std::vector<int> range{};
  for (int number = numbers[0]; number <= numbers[1]; number += numbers[2]) range.push_back(number);
  return range;
}

std::vector<StatedEffect> effects_of(const PowerOptions& options) {
  std::vector<StatedEffect> stated{};
  for (const std::string& text : options.effects) {
    try {
      stated.push_back(stated_effect_in(text));
    } catch (const std::invalid_argument& error) {
      throw WrongUsage(std::string("--effect: ") + error.what());
    }
  }
  return stated;
}

/// Takes what the responses of a study show, and prints what that is.
std::vector<Assumption> calibrated_by(const std::string& folder, const Protocol& protocol,
                                      const std::vector<Assumption>& usual) {
  const Study study = Study::open(folder, Access::read_only);
  std::vector<Assumption> calibrated = calibrated_by_study(usual, protocol, study);
  say_condition(study);
  std::vector<std::string> taken{};
  for (std::size_t i = 0; i < usual.size(); ++i) {
    if (calibrated[i].source != usual[i].source) taken.push_back(calibrated[i].name);
  }
  say(taken.empty() ? "asperity: warning: the responses of the study " + folder +
                          " show none of the assumptions; all keep their usual values"
                    : "asperity: taken from the study " + folder + ": " + listed(taken));
  return calibrated;
}

/// Sets what --assume states.
void assume(const PowerOptions& options, std::vector<Assumption>& assumptions) {
  for (const std::string& text : options.assumed) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::optional<double> value =
        number_in(std::string_view(text).substr(std::min(equals + 1, text.size())));
    if (!value) {
      throw WrongUsage("--assume " + text +
                       ": write NAME=VALUE with a number, such as order_sd=0.3");
    }
    try {
      set_assumption(assumptions, text.substr(0, equals), *value, options.assumed_source);
    } catch (const std::runtime_error& error) {
      throw WrongUsage("--assume " + text + ": " + error.what());
    }
  }
}

/// All of the order except its effects, and the rules of the sample.
void complete_order(PowerReport& report, const PowerOptions& options) {
  for (const EffectLevel& level : report.levels) report.order.effects.push_back(level.text);
  report.order.participants = numbers_in(options.participants);
  report.order.seed = *options.seed;
  report.order.runs = options.runs;
  report.order.protocol_sha256 = sha256_of(report.protocol.source);
  report.order.program = version_line();
  report.rules.multiple = static_cast<std::size_t>(participants_per_round(report.protocol));
  report.rules.attrition = options.attrition;
}

}  // namespace

void require_one_source(const PowerOptions& options) {
  if (!options.physics) {
    if (options.study.empty()) return;
    throw WrongUsage(
        "--study names the files that are rendered on the full physics; add --physics, or leave it "
        "out");
  }
  const std::array<std::pair<const char*, bool>, 7> of_tables{
      {{"--effect", !options.effects.empty()},
       {"--effect-source", options.effect_source != kStatedSource},
       {"--assume", !options.assumed.empty()},
       {"--assume-source", options.assumed_source != kAssumedSource},
       {"--assumptions", !options.assumptions.empty()},
       {"--calibrate", !options.calibrated_by.empty()},
       {"--list-assumptions", options.list_assumptions}}};
  for (const auto& [option, is_given] : of_tables) {
    if (!is_given) continue;
    throw WrongUsage(
        std::string(option) +
        " belongs to response tables and has no effect with --physics: there the virtual observers "
        "feel the rendered stimuli, and the effects are those of \"observer\" and of the stimuli "
        "in the protocol. Change them there, or leave out " +
        option + " or --physics");
  }
}

std::vector<int> participants_of(const PowerOptions& options) {
  return numbers_in(options.participants);
}

std::vector<Assumption> stated_assumptions(const PowerOptions& options, const Protocol& protocol) {
  std::vector<Assumption> assumptions = assumptions_of(protocol);
  if (!options.calibrated_by.empty()) {
    assumptions = calibrated_by(options.calibrated_by, protocol, assumptions);
  }
  if (!options.assumptions.empty()) {
    assumptions = with_assumptions_of_file(std::move(assumptions), options.assumptions);
  }
  assume(options, assumptions);
  return assumptions;
}

PowerReport report_of_tables(const PowerOptions& options, const ProtocolCheck& check,
                             const std::vector<Assumption>& assumptions) {
  const std::vector<StatedEffect> stated = effects_of(options);
  PowerReport report{.protocol = *check.protocol, .cost = check.cost};
  try {
    report.levels = effect_levels(assumptions, stated, options.effect_source);
    report.order.assumptions_sha256 = sha256_of(json_of(without_stated(assumptions, stated)));
  } catch (const std::invalid_argument& error) {
    throw WrongUsage(std::string("--effect: ") + error.what());
  }
  complete_order(report, options);
  return report;
}

PowerReport report_of_physics(const PowerOptions& options, const ProtocolCheck& check,
                              const PhysicsStudies& studies) {
  PowerReport report{.protocol = *check.protocol, .cost = check.cost};
  report.levels = {{.text = "virtual observers"}};
  report.order.assumptions_sha256 = sha256_of(json_of(std::vector<Assumption>{}));
  report.order.physics_sha256 = sha256_of(studies.declaration());
  complete_order(report, options);
  return report;
}
void say_warnings(const PowerReport& report) {
  const auto multiple = static_cast<int>(report.rules.multiple);
  const bool has_incomplete =
      std::any_of(report.order.participants.begin(), report.order.participants.end(),
                  [multiple](int number) { return number % multiple != 0; });
  if (has_incomplete) {
    say("asperity: warning: one round of counterbalancing rows and groups has " +
        std::to_string(multiple) +
        " participants; a number of --participants that is not a multiple of it has an incomplete "
        "last round");
  }
  for (const Assumption& one : report.levels.front().assumptions) {
    if (!is_from_pilot(one)) continue;
    say("asperity: warning: the effect " + one.name + " is taken from a pilot (" + one.source +
        "), whose estimate is uncertain and, if it was selected for being significant, too large; "
        "state the smallest effect of interest with --effect, or both ends of the pilot's "
        "interval");
  }
}

}  // namespace asperity

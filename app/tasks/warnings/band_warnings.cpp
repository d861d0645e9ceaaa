// Takes the highest frequency from the band of the force model, and adds a remedy by model.

#include "app/tasks/warnings/band_warnings.h"

#include <algorithm>
#include <set>
#include <string>

#include "analysis/numbers/number_text.h"
#include "app/session/explored_stimuli.h"
#include "protocols/design/wording.h"

namespace asperity {
namespace {

Phrase remedy_for_band(const ForceModel& model) {
  const auto& parameters = model.declaration.parameters;
  const bool has_noise_rate =
      std::any_of(parameters.begin(), parameters.end(),
                  [](const Parameter& parameter) { return parameter.name == "noise_rate_Hz"; });
  return (has_noise_rate ? phrase("Protocols",
                                  "lower noise_rate_Hz to the rate of the servo loop, or raise %1 "
                                  "of the device")
                         : phrase("Protocols", "raise %1 of the device"))
      .with(key_name("rate_Hz"));
}

}  // namespace

std::vector<Diagnostic> warnings_about_bands(const CheckedProtocol& checked,
                                             StimulusBuilder& builder) {
  const Protocol& protocol = checked.protocol;
  constexpr double kRounding = 1.0 + 1e-9;
  std::vector<Diagnostic> warnings{};
  std::set<std::string> reported{};  // one texture stands for the others of a stimulus
  for_each_stimulus(protocol, checked.trials(), {}, [&](const ExploredStimulus& one) {
    const StimulusDescription& stimulus = one.planned.stimulus;
    const std::string& where = one.planned.stimulus_template;
    if (!builder.can_make(stimulus) || reported.contains(where)) return;
    const PreparedStimulus prepared = builder.unmatched(stimulus);
    constexpr double kAtRest_m_per_s = 0.0;
    const double highest_Hz = band_Hz(*prepared.model, prepared.inputs, kAtRest_m_per_s);
    if (highest_Hz <= kRounding * 0.5 * protocol.rate_Hz) return;
    reported.insert(where);
    warnings.push_back(checked.at_stimulus(
        where, phrase("Protocols",
                      "the force of the stimulus %1 changes with time at frequencies up to %2 Hz, "
                      "above the Nyquist frequency of the servo loop, half of %3 Hz: these "
                      "frequencies would be aliased; %4")
                   .with(in_quotes(stimulus.name), number_text(highest_Hz),
                         number_text(protocol.rate_Hz), remedy_for_band(*prepared.model))));
  });
  return warnings;
}

}  // namespace asperity

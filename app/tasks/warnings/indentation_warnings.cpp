// Passes the intended normal force to the law of indentation of each model, which states a problem.

#include "app/tasks/warnings/indentation_warnings.h"

#include <memory>
#include <optional>
#include <set>

#include "app/session/attempt_measures.h"
#include "app/session/explored_stimuli.h"
#include "protocols/design/wording.h"
#include "renderers/force/indentation_law.h"

namespace asperity {

std::vector<Diagnostic> warnings_about_indentation(const CheckedProtocol& checked,
                                                   StimulusBuilder& builder) {
  std::vector<Diagnostic> warnings{};
  std::set<std::string> reported{};  // one texture stands for the others of a stimulus
  for_each_stimulus(checked.protocol, checked.trials(), {}, [&](const ExploredStimulus& one) {
    const StimulusDescription& stimulus = one.planned.stimulus;
    if (!builder.can_make(stimulus)) return;
    const std::string where = one.planned.stimulus_template + '\n' + one.exploration.name;
    if (reported.contains(where)) return;
    const PreparedStimulus prepared = builder.unmatched(stimulus);
    if (prepared.model->declaration.needs_bodies) return;
    RendererInputs inputs = prepared.inputs;
    inputs.parameters = complete_values(prepared.model->declaration, inputs.parameters);
    const std::unique_ptr<ForceRenderer> renderer = prepared.model->make(inputs);
    const auto* const law = dynamic_cast<const IndentationLaw*>(renderer.get());
    if (law == nullptr) return;
    const std::optional<Phrase> problem =
        law->indentation_problem(habits_for(one.exploration, stimulus.patch).normal_force_N);
    if (!problem) return;
    reported.insert(where);
    warnings.push_back(checked.at_stimulus(
        one.planned.stimulus_template,
        phrase("Protocols", "the stimulus %1 in the exploration %2: %3")
            .with(in_quotes(stimulus.name), in_quotes(one.exploration.name), *problem)));
  });
  return warnings;
}

}  // namespace asperity

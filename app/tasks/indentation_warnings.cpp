#include "app/tasks/indentation_warnings.h"

#include <memory>
#include <optional>
#include <set>

#include "app/session/attempt_measures.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/plan.h"
#include "renderers/force/indentation_law.h"

namespace asperity {

std::vector<Diagnostic> warnings_about_indentation(const Protocol& protocol,
                                                   const std::string& file_name,
                                                   StimulusBuilder& builder) {
  std::vector<Diagnostic> warnings{};
  std::set<std::string> compared{};
  std::set<std::string> reported{};  // one texture stands for the others of a stimulus
  for (const Trial& trial : possible_trials(protocol)) {
    const Exploration& exploration = exploration_of(protocol, trial);
    for (const PlannedPresentation& planned : trial.presentations) {
      const StimulusDescription& stimulus = planned.stimulus;
      if (!builder.can_make(stimulus)) continue;
      if (!compared.insert(stimulus.name + '\n' + exploration.name).second) continue;
      const std::string where = planned.stimulus_template + '\n' + exploration.name;
      if (reported.contains(where)) continue;
      const PreparedStimulus prepared = builder.unmatched(stimulus);
      if (prepared.model->declaration.needs_bodies) continue;
      RendererInputs inputs = prepared.inputs;
      inputs.parameters = complete_values(prepared.model->declaration, inputs.parameters);
      const std::unique_ptr<ForceRenderer> renderer = prepared.model->make(inputs);
      const auto* const law = dynamic_cast<const IndentationLaw*>(renderer.get());
      if (law == nullptr) continue;
      const std::optional<std::string> problem =
          law->indentation_problem(habits_for(exploration, stimulus.patch).normal_force_N);
      if (!problem) continue;
      reported.insert(where);
      warnings.push_back(place_of_stimulus(protocol, file_name, planned.stimulus_template));
      warnings.back().message = "the stimulus \"" + stimulus.name + "\" in the exploration \"" +
                                exploration.name + "\": " + *problem;
    }
  }
  return warnings;
}

}  // namespace asperity

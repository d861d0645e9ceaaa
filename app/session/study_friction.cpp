// Implements the search for the first session with a point model.

#include "app/session/study_friction.h"

#include <algorithm>
#include <vector>

#include "app/study_files/parameter_json.h"
#include "renderers/force/friction.h"
#include "results_schema/study.h"
#include "results_schema/table.h"

namespace asperity {

std::optional<SessionRow> session_with_earlier_friction(const std::filesystem::path& study,
                                                        const ModelRegistry& models) {
  if (study.empty() || !Study::exists(study)) return {};
  try {
    const Study own = Study::open(study, Access::read_only);
    std::vector<SessionRow> sessions = own.sessions();
    std::sort(sessions.begin(), sessions.end(),
              [](const SessionRow& one, const SessionRow& other) { return one.id < other.id; });
    for (const SessionRow& session : sessions) {
      for (const AttemptRow& attempt : own.attempts(session.id)) {
        for (const PresentationRow& presentation : attempt.presentations) {
          const ForceModel* const model = models.find(presentation.model);
          if (model == nullptr || friction_of_new_studies(model->declaration).empty()) continue;
          if (states_friction_law(parameter_values_in(presentation.parameters_json))) return {};
          return session;
        }
      }
    }
  } catch (const ResultsError&) {
    // Sessions of this study cannot be stored either; what is only checked is checked as in a new study.
  }
  return {};
}

UnstatedFriction unstated_friction_of(const std::optional<std::filesystem::path>& study,
                                      const ModelRegistry& models) {
  return study && session_with_earlier_friction(*study, models) ? UnstatedFriction::declared
                                                                : UnstatedFriction::of_new_studies;
}

ParameterValues values_of(UnstatedFriction friction, const ForceModel& model) {
  return friction == UnstatedFriction::declared ? ParameterValues{}
                                                : friction_of_new_studies(model.declaration);
}

}  // namespace asperity

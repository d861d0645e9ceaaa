#include "app/tasks/stimulus_warnings.h"

#include <iterator>

#include "app/tasks/arrangement_warnings.h"
#include "app/tasks/band_warnings.h"
#include "app/tasks/force_warnings.h"
#include "app/tasks/indentation_warnings.h"
#include "app/tasks/observer_warnings.h"
#include "app/tasks/slew_warnings.h"

namespace asperity {

std::vector<Diagnostic> warnings_about_stimuli(const Protocol& protocol,
                                               const std::string& file_name,
                                               StimulusBuilder& builder) {
  std::vector<Diagnostic> warnings{};
  for (const auto find :
       {warnings_about_arrangements, warnings_about_forces, warnings_about_bands,
        warnings_about_slew, warnings_about_indentation, warnings_about_observer}) {
    std::vector<Diagnostic> found = find(protocol, file_name, builder);
    warnings.insert(warnings.end(), std::make_move_iterator(found.begin()),
                    std::make_move_iterator(found.end()));
  }
  return warnings;
}

}  // namespace asperity

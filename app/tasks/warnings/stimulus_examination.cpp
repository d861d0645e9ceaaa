// Runs the checks that need renderers, and appends their problems and warnings to those of a protocol.

#include "app/tasks/warnings/stimulus_examination.h"

#include <utility>

#include "app/tasks/warnings/compute_warnings.h"
#include "app/tasks/warnings/plugin_stimuli.h"
#include "app/tasks/warnings/stimulus_warnings.h"
#include "app/tasks/warnings/texture_warnings.h"
#include "protocols/file/protocol_problems.h"

namespace asperity {

StimulusExamination examine_stimuli(const CheckedProtocol& checked,
                                    const std::filesystem::path& study, StimulusBuilder& builder,
                                    const StimuliCourse& course) {
  StimulusExamination found{};
  const auto is_over = [&] { return !found.problems.empty() || course.stop.stop_requested(); };
  append(found.warnings, warnings_about_compute(checked.protocol, checked.file_name));
  found.problems = problems_of_plugin_stimuli(checked, builder);
  if (is_over()) return found;
  if (!study.empty()) {
    append(found.warnings, warnings_about_textures(checked, study));
    RehearsedStimuli rehearsed = rehearse_with_warnings(checked, builder, course.stop);
    found.problems = std::move(rehearsed.problems);
    append(found.warnings, std::move(rehearsed.warnings));
    if (is_over()) return found;
  }
  append(found.warnings, warnings_about_stimuli(checked, builder, course));
  return found;
}

void add_examination(ProtocolCheck& check, const StimulusExamination& examination) {
  append(check.diagnostics, examination.problems);
  append(check.warnings, examination.warnings);
  sort_by_line(check.diagnostics);
  sort_by_line(check.warnings);
}

}  // namespace asperity

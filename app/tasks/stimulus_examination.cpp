#include "app/tasks/stimulus_examination.h"

#include <iterator>
#include <utility>

#include "app/tasks/compute_warnings.h"
#include "app/tasks/plugin_stimuli.h"
#include "app/tasks/stimulus_warnings.h"
#include "app/tasks/texture_warnings.h"
#include "protocols/file/protocol_problems.h"

namespace asperity {
namespace {

void append(std::vector<Diagnostic>& to, std::vector<Diagnostic> added) {
  to.insert(to.end(), std::make_move_iterator(added.begin()), std::make_move_iterator(added.end()));
}

}  // namespace

StimulusExamination examine_stimuli(const Protocol& protocol, const std::string& file_name,
                                    const std::filesystem::path& study, StimulusBuilder& builder,
                                    const StimuliCourse& course) {
  StimulusExamination found{};
  const auto is_over = [&] { return !found.problems.empty() || course.stop.stop_requested(); };
  append(found.warnings, warnings_about_compute(protocol, file_name));
  found.problems = problems_of_plugin_stimuli(protocol, file_name, builder);
  if (is_over()) return found;
  if (!study.empty()) {
    append(found.warnings, warnings_about_textures(protocol, file_name, study));
    RehearsedStimuli rehearsed = rehearse_with_warnings(protocol, file_name, builder, course.stop);
    found.problems = std::move(rehearsed.problems);
    append(found.warnings, std::move(rehearsed.warnings));
    if (is_over()) return found;
  }
  append(found.warnings, warnings_about_stimuli(protocol, file_name, builder, course));
  return found;
}

void add_examination(ProtocolCheck& check, const StimulusExamination& examination) {
  append(check.diagnostics, examination.problems);
  append(check.warnings, examination.warnings);
  sort_by_line(check.diagnostics);
  sort_by_line(check.warnings);
}

}  // namespace asperity

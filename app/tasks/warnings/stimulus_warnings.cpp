// Calls each kind of warning in turn, and divides the progress between the two longest.

#include "app/tasks/warnings/stimulus_warnings.h"

#include <array>
#include <functional>

#include "app/tasks/warnings/arrangement_warnings.h"
#include "app/tasks/warnings/band_warnings.h"
#include "app/tasks/warnings/force_warnings.h"
#include "app/tasks/warnings/indentation_warnings.h"
#include "app/tasks/warnings/observer_warnings.h"
#include "app/tasks/warnings/slew_warnings.h"

namespace asperity {
namespace {

/// The course of a half: `begin` is 0 or 0.5.
StimuliCourse half_of(const StimuliCourse& course, double begin) {
  StimuliCourse half{.stop = course.stop};
  if (course.progress) {
    half.progress = [&course, begin](double done) { course.progress(begin + 0.5 * done); };
  }
  return half;
}

}  // namespace

std::vector<Diagnostic> warnings_about_stimuli(const CheckedProtocol& checked,
                                               StimulusBuilder& builder,
                                               const StimuliCourse& course) {
  using Part = std::function<std::vector<Diagnostic>()>;
  const std::array<Part, 6> parts{
      [&] { return warnings_about_arrangements(checked, builder); },
      [&] { return warnings_about_forces(checked, builder, half_of(course, 0.0)); },
      [&] { return warnings_about_bands(checked, builder); },
      [&] { return warnings_about_slew(checked, builder, half_of(course, 0.5)); },
      [&] { return warnings_about_indentation(checked, builder); },
      [&] { return warnings_about_observer(checked, builder); }};
  std::vector<Diagnostic> warnings{};
  for (const Part& part : parts) {
    if (course.stop.stop_requested()) break;
    append(warnings, part());
  }
  return warnings;
}

}  // namespace asperity

// Makes and strokes every stimulus of two bodies of a protocol, as a session does.

#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Finds the problems at which a session would fail in a trial: every stimulus of two bodies is
/// made once as in a session, and the simulated device's hand strokes at its place until it touches
/// it. Takes a second or two. The files have been checked before.
std::vector<Diagnostic> rehearse(const CheckedProtocol& checked, StimulusBuilder& builder);

/// The same, with the stimuli that violate an assumption of their model: for every stimulus that
/// the hand touches, a warning for each assumption that is violated in at least half of the
/// contact, with the texture and, for `fine_detail`, both numbers. The stroke continues for 20 ms
/// after the first contact: violations in other places or under a pressing hand are not
/// reported. When a `stop` is requested, the remaining stimuli are left out.
struct RehearsedStimuli {
  std::vector<Diagnostic> problems{};
  std::vector<Diagnostic> warnings{};
};
RehearsedStimuli rehearse_with_warnings(const CheckedProtocol& checked, StimulusBuilder& builder,
                                        const std::stop_token& stop = {});

/// Everything that a stimulus is rendered from, as a name.
std::string name_of_making(const StimulusDescription& stimulus);

}  // namespace asperity

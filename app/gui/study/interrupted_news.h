// Reports an interrupted session in a banner, with the button that resumes it.

#pragma once

#include <functional>
#include <vector>

#include <QtCore/QString>

#include "app/gui/base/session_wish.h"
#include "app/tasks/interrupted_sessions.h"

namespace asperity {

class Banner;

/// Reports the first of `sessions`, and that there are others; without sessions the banner is
/// hidden. `study`: its name, if it is not the open one. If the session cannot be resumed, the
/// button shows the sessions instead.
void report_interrupted(Banner& banner, const std::vector<InterruptedSession>& sessions,
                        const QString& study, std::function<void(const SessionWish&)> resume,
                        std::function<void()> show_sessions);

}  // namespace asperity

// The news that a session was broken off, with the button that goes on with it.

#pragma once

#include <functional>
#include <vector>

#include <QtCore/QString>

#include "app/gui/base/session_wish.h"
#include "app/tasks/broken_off.h"

namespace asperity {

class Banner;

/// Tells of the first of `sessions`, and that there are others; with none the banner is hidden.
/// `study`: its name, where it is not the one that is open. One that cannot go on is shown instead.
void tell_broken_off(Banner& banner, const std::vector<BrokenOffSession>& sessions,
                     const QString& study, std::function<void(const SessionWish&)> go_on,
                     std::function<void()> show_sessions);

}  // namespace asperity

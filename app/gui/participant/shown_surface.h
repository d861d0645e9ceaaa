// Which of the plan's surfaces a session shows now.

#pragma once

#include <algorithm>

#include "app/session/session_monitor.h"

namespace asperity {

/// Null while none is felt. Lives as long as the facts.
inline const PlannedPresentation* shown_surface(const SessionFacts& facts,
                                                const SessionSnapshot& now) {
  if (!facts.plan || now.surface == 0) return nullptr;
  const auto& trials = facts.plan->trials;
  const auto trial = std::find_if(trials.begin(), trials.end(),
                                  [&now](const Trial& one) { return one.ordinal == now.trial; });
  if (trial == trials.end()) return nullptr;
  const auto& surfaces = trial->presentations;
  const auto surface =
      std::find_if(surfaces.begin(), surfaces.end(),
                   [&now](const PlannedPresentation& one) { return one.position == now.surface; });
  return surface == surfaces.end() ? nullptr : &*surface;
}

}  // namespace asperity

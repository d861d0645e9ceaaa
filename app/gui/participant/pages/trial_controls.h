// The keys and controls that the scenes of a trial, and all questions, have in common.

#pragma once

#include <optional>

#include <QtCore/QString>

#include "app/gui/participant/pages/participant_item.h"

namespace asperity {

class PageFrame;
class ParticipantPage;

bool is_return(int key) noexcept;

/// Which surfaces have a meaning by their letter.
enum class SurfaceKeys { all, that_can_go };

/// Space, the key of an option, the letter of a surface. Without options a number counts as the choice
/// of one, so that an answer before there is anything to choose from is refused by name, not ignored.
std::optional<ParticipantAction> key_of_trial(const ParticipantScene& scene, int key,
                                              const QString& typed, SurfaceKeys surfaces);
/// Those, and Return.
std::optional<ParticipantAction> key_of_question(const ParticipantScene& scene, int key,
                                                 const QString& typed,
                                                 SurfaceKeys surfaces = SurfaceKeys::that_can_go);

/// Confirms, or skips an optional question without an answer; where it is allowed, feels again.
void add_question_controls(PageFrame& frame, const ParticipantPage& page, bool is_ready);

}  // namespace asperity

// The pictures among the options of a question, in rows of squares as large as fits.

#pragma once

#include <cstddef>

#include <QtCore/QRectF>
#include <QtCore/QSizeF>

#include "app/gui/participant/pages/participant_item.h"

namespace asperity {

class PageFrame;

bool shows_pictures(const ParticipantScene& scene);
/// The side of every picture in this room.
double picture_side(const PageFrame& frame, QSizeF room);
/// Pictures of half the size that they would have without a question over them, or large enough.
bool is_enough_for_pictures(const PageFrame& frame, QSizeF room);
void add_pictures(PageFrame& frame, const QRectF& room);
/// The options in words that stand with pictures ("I cannot tell"): as controls.
void add_words_as_controls(PageFrame& frame);
/// An option in words; its place is the caller's.
ParticipantItem option_in_words(const PageFrame& frame, std::size_t index);

}  // namespace asperity

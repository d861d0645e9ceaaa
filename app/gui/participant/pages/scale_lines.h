// The lines and points of scales: layout, drawing, keys and pointer, of trials and of the questionnaire.

#pragma once

#include <optional>
#include <span>

#include <QtCore/QPointF>
#include <QtCore/QString>

#include "app/gui/participant/pages/participant_item.h"

namespace asperity {

class PageFrame;
class ParticipantBrush;

/// The question of the scene over its scales: in rows, or one with a label for every point as a list.
void lay_out_scales(PageFrame& frame, std::span<const ParticipantScene::Scale> scales);
void draw_scale(ParticipantBrush& brush, const ParticipantItem& item);
/// An arrow moves the mark or selects a scale; in a list the key of a point chooses it.
std::optional<ParticipantAction> key_of_scales(std::span<const ParticipantScene::Scale> scales,
                                               int key, const QString& typed);
/// Where a pointer at `at` sets the mark, from 0 to 1, at one of the steps; nothing for another item.
std::optional<double> position_on_scale(const ParticipantItem& item, QPointF at);

}  // namespace asperity

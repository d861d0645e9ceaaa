// What is computed from the records of an attempt: servo quality, times, compliance.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/session/rig/contact_reader.h"
#include "device/virtual_hand.h"
#include "protocols/design/protocol.h"
#include "renderers/servo/tick_record.h"
#include "results_schema/rows.h"

namespace asperity {

/// How well the loop ran. `lost_records` are those the ring had no room for. A deadline is missed in contact when a
/// surface is touched in the late tick or in the one before, whose force was held meanwhile.
ServoQualityRow servo_quality_of(std::span<const TickRecord> records, double rate_Hz,
                                 std::uint64_t lost_records);

/// When a surface was there: fills onset, contact, offset and contact time.
void fill_times(std::span<const TickRecord> records, std::uint64_t presentation, double rate_Hz,
                PresentationRow& row);

/// Force, speed, contact time and strokes of one surface against what the protocol asks for. All
/// are computed, whether or not the protocol declares a band. Force is the pressing force in every tick
/// (ContactReader), speed that of every stroke (HandStrokes).
std::vector<ComplianceRow> compliance_of(std::span<const TickRecord> records,
                                         std::uint64_t presentation, double rate_Hz,
                                         const Exploration& exploration,
                                         JudgedForce force = JudgedForce::sent);

/// A hand that aims at what an exploration asks for.
HandHabits habits_for(const Exploration& exploration, const SurfacePatch& patch);

}  // namespace asperity

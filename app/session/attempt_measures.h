// Measures computed from the records of an attempt: servo quality, times, compliance.

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

/// How well the loop kept time. `lost_records` counts the records for which the ring had no room. A
/// deadline counts as missed in contact when a surface is touched in the late tick or in the one
/// before it, whose force was held meanwhile.
ServoQualityRow servo_quality_of(std::span<const TickRecord> records, double rate_Hz,
                                 std::uint64_t lost_records);

/// The number of gaps in contact (TickFlag::gap_in_contact) with one surface: it was touched in the tick after the gap, or
/// in the one before it, whose force was held meanwhile. A gap in which the hand slides from one surface to another counts
/// for both.
std::int64_t gaps_in_contact_of(std::span<const TickRecord> records, std::uint64_t presentation);

/// Fills in when the surface was presented: onset, contact, offset and contact time.
void fill_times(std::span<const TickRecord> records, std::uint64_t presentation, double rate_Hz,
                PresentationRow& row);

/// Force, speed, contact time and strokes of one surface, compared with the bands of the protocol.
/// All are computed, whether or not the protocol declares a band. Force is the pressing force in
/// every tick (ContactReader); speed is that of every stroke (HandStrokes).
///
/// `strokes_of_visit`: where a visit ends after so many strokes; the strokes that a hand adds until it has lifted count
/// neither in number nor in length.
std::vector<ComplianceRow> compliance_of(std::span<const TickRecord> records,
                                         std::uint64_t presentation, double rate_Hz,
                                         const Exploration& exploration,
                                         JudgedForce force = JudgedForce::sent,
                                         std::optional<int> strokes_of_visit = {});

/// The habits of a hand that aims at the instructed exploration.
HandHabits habits_for(const Exploration& exploration, const SurfacePatch& patch);
/// The same over patches of a workspace that lie side by side, in the device's frame: the hand strokes within one patch after the
/// other, with strokes that are shortened, and wander less, where a patch is too narrow for them. It stays outside the
/// blend at the sides of a patch (kBlend_m) and the border at which the force fades. A visit has the
/// strokes that the exploration requests, divided by `minimum_visits`, if these visits fit into the longest contact.
HandHabits habits_over_patches(const Exploration& exploration, const SurfacePatch& workspace,
                               std::span<const SurfacePatch> patches, int minimum_visits);

}  // namespace asperity

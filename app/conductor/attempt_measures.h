// What the records of an attempt say: servo quality, compliance, features, texture force.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/force_features.h"
#include "app/conductor/stimulus_builder.h"
#include "device/virtual_hand.h"
#include "protocols/protocol.h"
#include "renderers/tick_record.h"
#include "results_schema/rows.h"

namespace asperity {

/// How well the loop ran. `lost_records` are those the ring had no room for.
ServoQualityRow servo_quality_of(std::span<const TickRecord> records, double rate_Hz,
                                 std::uint64_t lost_records);

/// When a surface was there: fills onset, contact, offset and contact time.
void fill_times(std::span<const TickRecord> records, std::uint64_t presentation, double rate_Hz,
                PresentationRow& row);

/// Features of the force that the hand got (ramp and limits included) while it touched the surface.
ForceFeatures features_of(std::span<const TickRecord> records, std::uint64_t presentation);

/// Force, speed, contact time and strokes of one surface against what the protocol asks for. All
/// are computed, whether or not the protocol declares a band.
std::vector<ComplianceRow> compliance_of(std::span<const TickRecord> records,
                                         std::uint64_t presentation, double rate_Hz,
                                         const Exploration& exploration);

/// RMS of the texture force along the path of this attempt: the rendered force minus that of the
/// same model without texture and friction, in the stated band, over stretches of unbroken contact
/// at full gain. Nothing when no stretch lasts a quarter of a second.
std::optional<double> achieved_texture_force_N(std::span<const TickRecord> records,
                                               std::uint64_t presentation, double rate_Hz,
                                               const PreparedStimulus& stimulus,
                                               const EqualForce& band);

/// A hand that aims at what an exploration asks for.
HandHabits habits_for(const Exploration& exploration, const SurfacePatch& patch);

}  // namespace asperity

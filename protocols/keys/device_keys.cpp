// Defines the keys of "device" and of its limits.

#include "protocols/keys/tables.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using Limits = std::map<std::string, double>;

constexpr NumberShape kCount{.minimum = 0.0, .maximum = 1e6, .is_whole = true};
constexpr NumberShape kSeconds{
    .minimum = 0.0, .maximum = 1.0, .unit = "s", .display = {.unit = "ms", .power = -3}};
constexpr NumberShape kMetres{
    .minimum = 0.0, .maximum = 1.0, .unit = "m", .display = {.unit = "µm", .power = -6}};
constexpr NumberShape kNewtons{.minimum = 0.0, .maximum = 100.0, .unit = "N"};

constexpr auto kDeviceLimitKeys = keys_of(
    with_computed_default(
        entry_key<Limits>("rate_Hz", "Rate", "Lowest rate of the servo loop, in Hz.",
                          NumberShape{.above = 0.0, .maximum = 10'000.0, .unit = "Hz"}),
        "95 % of the rate of the servo loop"),
    entry_key<Limits>("lateness_p50_s", "Median lateness", "Largest median lateness of a tick.",
                      kSeconds),
    with_computed_default(
        entry_key<Limits>("lateness_p99_s", "99th percentile of lateness",
                          "Largest 99th percentile of the lateness of a tick. Default: one period.",
                          kSeconds),
        "one period"),
    entry_key<Limits>("lateness_max_s", "Greatest lateness", "Largest lateness of any tick.",
                      kSeconds),
    entry_key<Limits>("missed_deadlines", "Missed deadlines",
                      "Largest number of ticks in two seconds that are more than a period late.",
                      kCount),
    entry_key<Limits>("position_noise_m", "Position noise",
                      "Largest standard deviation of positions at rest.", kMetres),
    entry_key<Limits>("friction_N", "Friction", "Largest friction of the device.", kNewtons),
    entry_key<Limits>("damping_N_s_per_m", "Damping", "Lowest damping of the device.",
                      NumberShape{.minimum = 0.0, .maximum = 1000.0, .unit = "N s/m"}),
    entry_key<Limits>("position_resolution_m", "Position resolution",
                      "Largest step between positions.", kMetres),
    entry_key<Limits>("latency_s", "Latency", "Longest time from a force to the measured motion.",
                      kSeconds),
    entry_key<Limits>(
        "moving_mass_kg", "Moving mass", "Largest moving mass.",
        NumberShape{
            .minimum = 0.0, .maximum = 100.0, .unit = "kg", .display = {.unit = "g", .power = -3}}),
    entry_key<Limits>(
        "resonance_Hz", "Lowest resonance",
        "Lower limit of the lowest resonance; a device without a resonance meets this limit.",
        NumberShape{.minimum = 0.0, .maximum = 10'000.0, .unit = "Hz"}),
    entry_key<Limits>("stiffness_N_per_m", "Stiffness",
                      "Lower limit of the stiffest spring on which the handle comes to rest. "
                      "device-test tries up to 8000 N/m.",
                      NumberShape{.minimum = 0.0, .maximum = 8000.0, .unit = "N/m"}),
    entry_key<Limits>("force_resolution_N", "Force resolution",
                      "Upper limit of the weakest force that moves the handle.", kNewtons),
    with_computed_default(
        entry_key<Limits>("workspace_reached", "Fraction of the workspace",
                          "Smallest fraction of the workspace that is reached. Default: 0.8.",
                          NumberShape{.minimum = 0.0, .maximum = 1.0}),
        "`0.8`"));

constexpr auto kPlacesOfContacts = words_of<bool>(
    {{"cpu", false, "on the processor"}, {"gpu", true, "on the first OpenCL device"}});

constexpr auto kDeviceKeys = keys_of(
    member_key<&Protocol::rate_Hz>(
        "rate_Hz", "Rate of the servo loop", "Rate of the servo loop.",
        NumberShape{.minimum = 100.0, .maximum = 10'000.0, .unit = "Hz"}),
    member_key<&Protocol::force_limit_N>("force_limit_N", "Force limit",
                                         "Upper limit of the force.",
                                         NumberShape{.above = 0.0, .maximum = 20.0, .unit = "N"}),
    member_key<&Protocol::maximum_missed_deadlines>(
        "maximum_missed_deadlines", "Missed deadlines per attempt",
        "An attempt with more missed deadlines than this while a surface is touched is invalid.",
        kCount),
    member_key<&Protocol::maximum_gaps_in_contact>(
        "maximum_gaps_in_contact", "Gaps per attempt",
        "An attempt with more gaps than this is invalid: times of more than two periods between "
        "two ticks while a surface is touched.",
        kCount),
    member_key<&Protocol::maximum_lost_records>(
        "maximum_lost_records", "Lost records per attempt",
        "An attempt with more lost records than this is invalid.", kCount),
    member_key<&Protocol::profile_maximum_age_days>(
        "profile_maximum_age_days", "Maximum age of the profile",
        "A session with a participant who is not virtual requires a device profile that is at most "
        "this old and has no failed item.",
        NumberShape{.above = 0.0, .maximum = 10'000.0, .unit = "days"}),
    member_key<&Protocol::refuses_rehearsal_warnings>(
        "refuse_rehearsal_warnings", "Refuse unsuitable devices",
        "A session with a participant who is not virtual is refused if the study has no profile of "
        "the device, or if, according to its profile, the device cannot render a stimulus or "
        "violates a limit.",
        TruthShape{}),
    member_key<&Protocol::computes_on_gpu>(
        "compute", "Evaluation of contacts",
        "Where the contacts of two textured bodies are evaluated: cpu, on the processor; gpu, on "
        "the first OpenCL device of the computer, sampled again in every tick and in double "
        "precision. A computer without one refuses the session.",
        kPlacesOfContacts),
    member_key<&Protocol::input_only>(
        "input_only", "Input only",
        "Whether the study needs only the hand's movement: Run then accepts a device that exerts "
        "no force. Otherwise sessions on such a device are pilots, unless the participant is "
        "virtual.",
        TruthShape{}),
    member_key<&Protocol::device_limits>("limits", "Limits on the device", kDeviceLimitsTable));

}  // namespace

constexpr KeyTableOf<Protocol> kDeviceTable =
    table_of("Requirements of the haptic device.", kDeviceKeys);

constexpr KeyTableOf<Limits> kDeviceLimitsTable = table_of(
    "Limits that device-test and sessions apply to the device. An item without a limit here has "
    "the default limit, if there is one.",
    kDeviceLimitKeys);

}  // namespace asperity

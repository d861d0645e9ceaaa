// Defines the keys of "observer": the judgements of a virtual participant.

#include "protocols/keys/tables.h"
#include "protocols/kind_keys/discrimination_keys.h"
#include "protocols/kind_keys/magnitude_keys.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using Observer = ObserverDeclaration;
using Expectation = Observer::Expectation;
using MagnitudeOf = Observer::MagnitudeOf;

constexpr auto kExpectations = words_of<Expectation>(
    {{"none", Expectation::none, "a selection, a matching or a recognition is guessed"},
     {"true_surface", Expectation::true_surface, "the texture's true height field"},
     {"prior", Expectation::prior, "the features that the texture states"}});

constexpr auto kMagnitudes =
    words_of<MagnitudeOf>({{"lateral_force", MagnitudeOf::lateral_force,
                            "the lateral force, relative to the mean normal force"},
                           {"normal_force", MagnitudeOf::normal_force,
                            "the normal force, relative to the mean normal force"},
                           {"held_tool", MagnitudeOf::held_tool, "the acceleration of a held tool"},
                           {"compliance", MagnitudeOf::compliance,
                            "the depth to which the surface yields over the normal force"}});

constexpr auto kCommonKeys = keys_of(
    member_key<&Observer::expectation>(
        "expectation", "Expectation",
        "Expectation of a texture: none (a selection, a matching or a recognition is then "
        "guessed), its true height field (if it is felt on bodies only: these bodies), or the "
        "stated prior.",
        kExpectations),
    member_key<&Observer::gaussian_wavelength_m>(
        "gaussian_wavelength_m", "Cut-off wavelength",
        "With true height fields as the expectation: cut-off wavelength of the Gaussian low-pass "
        "whose result is subtracted from the expected heights, as from heights of a photograph. "
        "Absent: nothing is subtracted.",
        NumberShape{.minimum = 0.0001, .maximum = 1.0, .unit = "m", .display = kMillimetres}),
    member_key<&Observer::deaf>("deaf", "Forces ignored", "Whether the felt forces are ignored.",
                                TruthShape{}),
    member_key<&Observer::feature_noise>("feature_noise", "Noise",
                                         "Standard deviation of the noise added to every feature.",
                                         NumberShape{.minimum = 0.0, .maximum = 100.0}),
    member_key<&Observer::position_bias>("position_bias", "Position bias",
                                         "Evidence added to the first position.",
                                         NumberShape{.minimum = -100.0, .maximum = 100.0}),
    member_key<&Observer::lapse>("lapse", "Lapse rate", "Lapse rate: the probability of a guess.",
                                 NumberShape{.minimum = 0.0, .maximum = 1.0}),
    member_key<&Observer::magnitude_of>(
        "magnitude_of", "Judged quantity",
        "Magnitude, paired comparison, discrimination and rating: the judged quantity, which is a "
        "felt force relative to the mean normal force, the acceleration of a held tool, or the "
        "depth to which the surface yields over the normal force.",
        kMagnitudes));

constexpr auto kObserverKeys = joined(
    kCommonKeys, joined(in_part<Observer>(kMagnitudeObserverKeys,
                                          [](void* owner) -> void* {
                                            return &static_cast<Observer*>(owner)->magnitude;
                                          }),
                        in_part<Observer>(kDiscriminationObserverKeys, [](void* owner) -> void* {
                          return &static_cast<Observer*>(owner)->discrimination;
                        })));

}  // namespace

constexpr KeyTableOf<Observer> kObserverTable =
    table_of("Model of a virtual participant's judgements.", kObserverKeys);

}  // namespace asperity

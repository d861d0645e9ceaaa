// Defines the keys of "environment": what the participant sees and hears.

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

constexpr auto kVisions = words_of<Vision>(
    {{"free", Vision::free, "hand, device and screen"},
     {"hand_occluded", Vision::hand_occluded, "the screen but not the hand"},
     {"blindfold", Vision::blindfold, "nothing: an eye mask is worn while surfaces are felt"}});

constexpr auto kVisualTextures =
    words_of<VisualTexture>({{"on", VisualTexture::on, "the surface shows its relief"},
                             {"off", VisualTexture::off, "the surface is plain"},
                             {"neutral", VisualTexture::neutral,
                              "the surface shows a pattern that belongs to no texture"}});

constexpr auto kPictures =
    words_of<bool>({{"as_they_are", false, "unchanged"}, {"grey", true, "in greyscale"}});

using NoiseKind = Protocol::Noise::Kind;
constexpr auto kNoises = words_of<NoiseKind>({{"none", NoiseKind::none, "no noise"},
                                              {"white", NoiseKind::white, "white noise"},
                                              {"pink", NoiseKind::pink, "pink noise"}});

constexpr ValueShape kSpeechFile = kFile;

constexpr auto kSceneKeys = keys_of(
    required_key(member_key<&Protocol::scene>("visual_texture", "Visual texture",
                                              "Whether the surface shows its relief, is plain, or "
                                              "shows a pattern that belongs to no texture.",
                                              kVisualTextures)));

constexpr auto kPicturesKeys = keys_of(member_key<&Protocol::shows_pictures_in_grey>(
    "show", "Colours", "Unchanged, or in greyscale, so that colour is not a cue.", kPictures));

constexpr auto kNoiseKeys =
    keys_of(required_key(member_key<&Protocol::Noise::kind>("kind", "Spectrum",
                                                            "Spectrum of the noise.", kNoises)),
            when(member_key<&Protocol::Noise::level_dBA>(
                     "level_dBA", "Sound level", "Level at the ear.",
                     NumberShape{.minimum = 0.0, .maximum = 85.0, .unit = "dBA"}),
                 reported_as("the noise \"none\" has no level; remove this key",
                             where("kind", {"white", "pink"}))));

constexpr auto kEnvironmentKeys = keys_of(
    member_key<&Protocol::vision>(
        "vision", "Vision",
        "What the participant sees: everything, the screen but not the hand, or nothing.",
        kVisions),
    inner_key("scene", "Scene", kSceneTable), inner_key("pictures", "Pictures", kPicturesTable),
    member_key<&Protocol::speech>(
        "speech", "Recorded speech",
        "Recorded speech instead of tones: cue → WAV file, relative to the study.",
        MapShape{.entry = &kSpeechFile, .has_names = false}),
    member_key<&Protocol::masking_noise>("masking_noise", "Masking noise", kNoiseTable));

}  // namespace

constexpr KeyTableOf<Protocol> kEnvironmentTable =
    table_of("What the participant sees and hears.", kEnvironmentKeys);

constexpr KeyTableOf<Protocol> kSceneTable = table_of(
    "Object, tool and probe, shown to the participant while a surface is felt; absent: nothing is "
    "shown.",
    kSceneKeys);

constexpr KeyTableOf<Protocol> kPicturesTable =
    table_of("Presentation of photographs to the participant.", kPicturesKeys);

constexpr KeyTableOf<Protocol::Noise> kNoiseTable =
    table_of("Noise over headphones that masks the sound of the device.", kNoiseKeys);

}  // namespace asperity

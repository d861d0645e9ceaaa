// Defines the keys of a texture.

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

constexpr ValueShape kAssetFile = kFile;
constexpr NumberShape kFeature{.minimum = -20.0, .maximum = 5.0};
constexpr ValueShape kBandFeature = kFeature;

constexpr auto kFeaturesKeys = keys_of(
    required_key(member_key<&ForceFeatures::spectrum>(
        "spectrum", "Spectrum",
        "Ten numbers: ln(band RMS / mean normal force), longest wavelength first.",
        ListShape{.entry = &kBandFeature,
                  .meaning = "ln(band RMS / mean normal force).",
                  .shortest = 10,
                  .longest = 10})),
    required_key(member_key<&ForceFeatures::size>(
        "size", "Size", "ln(RMS of the texture force / mean normal force).", kFeature)),
    required_key(member_key<&ForceFeatures::roughness>(
        "roughness", "Roughness",
        "ln(RMS of the lateral force in all bands together / mean normal force).", kFeature)));

constexpr auto kTextureKeys = keys_of(
    member_key<&Texture::code>("code", "Code",
                               "Name of the texture for blinded experimenters, for example the "
                               "label on a physical sample.",
                               TextShape{.longest = 40}),
    member_key<&Texture::height_field>(
        "height_field", "Height field",
        "Height field that is rendered (a PNG with its sidecar); absent: no rendered counterpart.",
        kFile),
    member_key<&Texture::picture>("picture", "Picture", "Picture that is shown.", kFile),
    member_key<&Texture::true_height_field>(
        "true_height_field", "True height field",
        "The true heights of a procedural texture, for virtual participants.", kFile),
    member_key<&Texture::assets>(
        "assets", "Further files",
        "Further files that force models need: role → file, relative to the study. The models "
        "declare the roles (see `asperity models`): \"recording\" of the model \"recorded\", "
        "\"vibration_models\" of \"data_driven\".",
        MapShape{.entry = &kAssetFile, .has_names = false}),
    member_key<&Texture::spacing_m>(
        "spacing_m", "Spacing",
        "Spacing of the texture: the distance between its elements, for the analysis of estimates.",
        NumberShape{.above = 0.0, .maximum = 1.0, .unit = "m", .display = kMillimetres}),
    member_key<&Texture::prior>("prior", "Expected features", kFeaturesTable),
    member_key<&Texture::note>(
        "note", "Note",
        "Further information for readers of the data, for example an assumed width.",
        kDescription));

}  // namespace

constexpr KeyTableOf<Texture> kTextureTable =
    table_of("A texture of the experiment: felt (a height field), seen (a picture), or both.",
             kTextureKeys, "texture");

constexpr KeyTableOf<ForceFeatures> kFeaturesTable = table_of(
    "Expected force features of the texture, as natural logarithms (see \"Definitions of the "
    "features\" in docs/formats/protocol.md).",
    kFeaturesKeys, "features");

}  // namespace asperity

// Defines the keys of a stimulus.

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

constexpr ValueShape kParameter = BoundShape{&kLevelShape};
constexpr ValueShape kModelName = NameShape{kModelNames};
constexpr ValueShape kTextureName = NameShape{"textures"};
constexpr ValueShape kBodyName = NameShape{"bodies"};

constexpr auto kEqualForceKeys = keys_of(
    member_key<&EqualForce::rms_N>("rms_N", "RMS", "Target RMS of the texture force.",
                                   NumberShape{.above = 0.0, .maximum = 20.0, .unit = "N"}),
    member_key<&EqualForce::to_model>("to_model", "Model",
                                      "The model whose texture force is the target.",
                                      NameShape{kModelNames}),
    member_key<&EqualForce::band_low_Hz>("band_low_Hz", "Lower limit of the band",
                                         "Lower limit of the band in which the RMS is computed.",
                                         NumberShape{.minimum = 0.0, .unit = "Hz"}),
    member_key<&EqualForce::band_high_Hz>("band_high_Hz", "Upper limit of the band",
                                          "Upper limit of the band in which the RMS is computed.",
                                          NumberShape{.above = 0.0, .unit = "Hz"}));
constexpr std::array<std::string_view, 2> kTargets{"rms_N", "to_model"};

constexpr auto kStimulusMaterialKeys =
    keys_of(member_key<&StimulusTemplate::stiffness_N_per_m>(
                "stiffness_N_per_m", "Stiffness", "Stiffness normal to the surface.", kStiffness),
            member_key<&StimulusTemplate::friction>("friction", "Friction",
                                                    "Coulomb friction coefficient.", kFriction));

constexpr auto kStimulusKeys = keys_of(
    required_key(member_key<&StimulusTemplate::model>(
        "model", "Force model", "A force model, or the factor whose level it is.",
        BoundShape{&kModelName})),
    member_key<&StimulusTemplate::texture>("texture", "Texture",
                                           "A texture, or the factor whose level it is.",
                                           BoundShape{&kTextureName}),
    member_key<&StimulusTemplate::surface>(
        "surface", "Surface",
        "The body that is touched: by the tool of a model that requires bodies, or by the point of "
        "any other model, in place of the plane.",
        BoundShape{&kBodyName}),
    member_key<&StimulusTemplate::tool>("tool", "Tool",
                                        "The body in the hand, for a model that requires bodies.",
                                        BoundShape{&kBodyName}),
    member_key<&StimulusTemplate::parameters>(
        "parameters", "Parameters",
        "Parameters of the force model by name (see `asperity models`); a missing parameter has "
        "the value that the height field of the texture suggests, and without a suggestion the "
        "model's default.",
        MapShape{.entry = &kParameter,
                 .meaning = "A value, or the factor whose level it is.",
                 .has_names = false}),
    member_key<&StimulusTemplate::equal_force>("equal_force", "Equal force", kEqualForceTable),
    inner_key("material", "Material", kStimulusMaterialTable));

}  // namespace

constexpr KeyTableOf<StimulusTemplate> kStimulusTable =
    table_of("A force model with a texture and parameters, each of which can be bound to a factor.",
             kStimulusKeys, "stimulus");

constexpr KeyTableOf<EqualForce> kEqualForceTable =
    decided_by(table_of("Determines the model's amplitude parameter so that the RMS texture force "
                        "equals a stated value or that of another model with the same texture.",
                        kEqualForceKeys),
               kTargets);

constexpr KeyTableOf<StimulusTemplate> kStimulusMaterialTable = table_of(
    "Stiffness and friction of this stimulus, in place of those of the protocol's material.",
    kStimulusMaterialKeys);

}  // namespace asperity

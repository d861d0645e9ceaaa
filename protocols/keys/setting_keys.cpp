// Defines the keys of "recording", "instability", "surface" and "material".

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

constexpr auto kRecordingKeys = keys_of(
    member_key<&Protocol::record>("every_tick", "Record every tick",
                                  "Whether all ticks of all attempts are recorded.", TruthShape{}));

using OnExcess = InstabilityRule::OnExcess;
constexpr auto kOnExcess =
    words_of<OnExcess>({{"flag", OnExcess::flag, "the attempt is flagged"},
                        {"repeat_now", OnExcess::repeat_now, "the attempt is repeated at once"}});

constexpr auto kInstabilityKeys = keys_of(
    required_key(member_key<&InstabilityRule::buzz_max>(
        "buzz_max", "Greatest vibration",
        "Greatest vibration of a surface above 150 Hz, relative to its texture force.",
        NumberShape{.above = 0.0, .maximum = 100.0})),
    member_key<&InstabilityRule::on>("on", "Consequence",
                                     "An attempt with more vibration is flagged, or repeated at "
                                     "once: twice at most, after which it is flagged.",
                                     kOnExcess));

constexpr ValueShape kCoordinate =
    NumberShape{.minimum = -1.0, .maximum = 1.0, .unit = "m", .display = kMillimetres};
constexpr ValueShape kExtent =
    NumberShape{.above = 0.0, .maximum = 2.0, .unit = "m", .display = kMillimetres};

constexpr auto kTilings =
    words_of<Tiling>({{"bounded", Tiling::bounded, "the height outside is that of the border"},
                      {"repeat", Tiling::repeat, "repeated"},
                      {"mirror", Tiling::mirror, "repeated, every other copy mirrored"}});
constexpr auto kEdges = words_of<PatchEdge>(
    {{"wall", PatchEdge::wall, "a wall"}, {"fade", PatchEdge::fade, "a fading force"}});

constexpr auto kSurfaceKeys = keys_of(
    member_key<&SurfacePatch::centre_m>(
        "centre_m", "Centre", "Centre of the patch in the device's frame: x, y, z.",
        ListShape{.entry = &kCoordinate, .meaning = "A coordinate.", .shortest = 3, .longest = 3}),
    member_key<&SurfacePatch::extent_m>(
        "extent_m", "Extent", "Extent of the patch along x and y.",
        ListShape{.entry = &kExtent, .meaning = "An extent.", .shortest = 2, .longest = 2}),
    member_key<&SurfacePatch::tiling>("tiling", "Beyond the height field",
                                      "Continuation of the height field beyond its border.",
                                      kTilings),
    member_key<&SurfacePatch::edge>("edge", "Border",
                                    "The border of the patch: a wall, or a fading force. A wall "
                                    "acts in contact, from the place where contact began.",
                                    kEdges),
    member_key<&SurfacePatch::edge_width_m>(
        "edge_width_m", "Width of the border", "Width of the border over which the force fades.",
        NumberShape{.minimum = 0.0, .maximum = 0.5, .unit = "m", .display = kMillimetres}),
    member_key<&SurfacePatch::motion_scale>("motion_scale", "Scale of motion",
                                            "Ratio of motion on the surface to motion of the hand.",
                                            NumberShape{.above = 0.0, .maximum = 100.0}));

constexpr auto kMaterialKeys =
    keys_of(member_key<&Material::stiffness_N_per_m>(
                "stiffness_N_per_m", "Stiffness", "Stiffness normal to the surface.", kStiffness),
            member_key<&Material::friction>("friction", "Friction", "Coulomb friction coefficient.",
                                            kFriction));

}  // namespace

constexpr KeyTableOf<Protocol> kRecordingTable = table_of("The recorded data.", kRecordingKeys);

constexpr KeyTableOf<InstabilityRule> kInstabilityTable = table_of(
    "Consequence of a vibration that the force model does not contain. The vibration of every "
    "surface is stored, with or without a consequence.",
    kInstabilityKeys);

constexpr KeyTableOf<SurfacePatch> kSurfaceTable =
    table_of("The patch of the workspace in which textures are felt.", kSurfaceKeys);

constexpr KeyTableOf<Material> kMaterialTable =
    table_of("Stiffness and friction of every surface, without its texture.", kMaterialKeys);

}  // namespace asperity

// Defines the keys of a body.

#include <string>
#include <variant>

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr NumberShape kSize{.minimum = 0.001, .maximum = 1.0, .unit = "m", .display = kMillimetres};
constexpr ValueShape kSizeEntry = kSize;

constexpr std::array<KeyWord, 5> kShapes{{{"plate", 0, "a plate"},
                                          {"box", 0, "a box"},
                                          {"cylinder", 0, "a cylinder"},
                                          {"disc", 0, "a cylinder a tenth as long as wide"},
                                          {"sphere", 0, "a sphere"}}};

// The rows are read in their order: a size belongs to the shape before it. Whether the sizes are those of the shape is a
// question of meaning.
void store_shape(const json& value, BodyDescription& body) {
  const auto shape = value.get<std::string>();
  if (shape == "plate") body.shape = PlateShape{};
  if (shape == "box") body.shape = BoxShape{};
  if (shape == "cylinder" || shape == "disc") body.shape = CylinderShape{};
  if (shape == "sphere") body.shape = SphereShape{};
}

template <class Use>
void use_shape(BodyDescription& body, const Use& use) {
  if (body.shape) std::visit(use, *body.shape);
}

void store_size(const json& value, BodyDescription& body) {
  use_shape(body, [&value](auto& shape) {
    if constexpr (requires { shape.size_m; }) {
      store_value(ListShape{.entry = &kSizeEntry}, value, shape.size_m);
    }
  });
}

void store_diameter(const json& value, BodyDescription& body) {
  use_shape(body, [&value](auto& shape) {
    if constexpr (requires { shape.length_m; }) {
      shape = disc_of(value.get<double>());  // a cylinder states its length
    } else if constexpr (requires { shape.diameter_m; }) {
      shape.diameter_m = value.get<double>();
    }
  });
}

void store_length(const json& value, BodyDescription& body) {
  use_shape(body, [&value](auto& shape) {
    if constexpr (requires { shape.length_m; }) shape.length_m = value.get<double>();
  });
}

constexpr auto kAxes = words_of<BodyAxis>(
    {{"x", BodyAxis::x, "along x"}, {"y", BodyAxis::y, "along y"}, {"z", BodyAxis::z, "along z"}});

constexpr auto kBodyKeys = keys_of(
    member_key<&BodyDescription::mesh>(
        "mesh", "Mesh",
        "Textured mesh made by `asperity bake`; the origin of its frame is the centre of the patch "
        "(surface) or the tip (tool).",
        kFile),
    custom_key<&store_shape>("shape", "Shape",
                             "A shape instead of a mesh; a surface's highest point lies in the "
                             "plane of the patch, a tool's lowest point is its tip.",
                             WordShape{kShapes}),
    custom_key<&store_size>(
        "size_m", "Size", "Size of a plate or a box along x, y and z.",
        ListShape{.entry = &kSizeEntry, .meaning = "A size.", .shortest = 3, .longest = 3}),
    custom_key<&store_diameter>("diameter_m", "Diameter",
                                "Diameter of a cylinder, a disc or a sphere. The thickness of a "
                                "disc is a tenth of its diameter.",
                                kSize),
    custom_key<&store_length>("length_m", "Length", "Length of a cylinder along its axis.", kSize),
    member_key<&BodyDescription::axis>("axis", "Axis",
                                       "Direction of the axis of a cylinder or a disc, or of the "
                                       "axis through the poles of a sphere.",
                                       kAxes),
    member_key<&BodyDescription::texture>(
        "texture", "Texture",
        "The texture whose height field is applied to the shape: on a plate's upper side, on all "
        "sides of a box, around a cylinder or a sphere. Absent: a surface has the texture of its "
        "stimulus, and a tool is smooth.",
        NameShape{"textures"}));

}  // namespace

constexpr KeyTableOf<BodyDescription> kBodyTable = table_of(
    "A solid body: a mesh with a haptic texture, or a shape with or without a relief on it.",
    kBodyKeys, "body");

}  // namespace asperity

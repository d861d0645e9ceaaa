// Makes the mesh of a shape or reads one from a file, once, when its surface is first requested.

#include "app/gui/workbench/stroked_body.h"

#include "analysis/words/phrased_error.h"
#include "app/study_files/textured_mesh_files.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {

namespace {

constexpr double kUsualDiameter_m = 0.06;
constexpr double kCylinderLength_m = 0.2;  // longer than the usual relief

TexturedMesh mesh_of(const BodyChoice& choice) {
  if (choice.shape == "sphere") return body_mesh(SphereShape{choice.diameter_m}, nullptr);
  if (choice.shape == "cylinder") {
    return turned(body_mesh(CylinderShape{choice.diameter_m, kCylinderLength_m}, nullptr),
                  BodyAxis::y);
  }
  if (choice.mesh.empty()) {
    throw PhrasedRefusal(
        phrase("StrokedBody",
               "no mesh is chosen; choose the file of a textured mesh, as \"asperity "
               "bake\" makes it"));
  }
  return load_textured_mesh(choice.mesh).stored->mesh;
}

}  // namespace

std::vector<Parameter> body_parameters() {
  return {
      {.name = "body",
       .kind = ParameterKind::choice,
       .choices = {"plane", "sphere", "cylinder", "mesh"},
       .default_value = std::string("plane"),
       .meaning = phrase("StrokedBody", "Body on which the models of a point render the relief")},
      {.name = "body_diameter_m",
       .kind = ParameterKind::number,
       .unit = "m",
       .minimum = 0.01,
       .maximum = 1.0,
       .default_value = kUsualDiameter_m,
       .meaning = phrase("StrokedBody",
                         "Diameter of the sphere, or of the cylinder, whose axis is along y")}};
}

std::shared_ptr<const BodySurface> StrokedBody::surface() {
  std::call_once(made_, [this] {
    if (choice_.shape == "plane") return;
    surface_ = std::make_shared<const BodySurface>(placed(mesh_of(choice_), BodyRole::surface));
  });
  return surface_;
}

}  // namespace asperity

// The picture of everything in the workspace that does not move: the object on its table.

#pragma once

#include <memory>
#include <stop_token>

#include <QtGui/QColor>
#include <QtGui/QImage>
#include <glm/vec3.hpp>

#include "app/gui/scene/workspace_camera.h"
#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

struct WorkspacePicture {
  /// Used for `SurfaceLook::relief` only; null is plain.
  std::shared_ptr<const HeightField> relief{};
  SurfaceLook look = SurfaceLook::plain;
  QColor ground{};  ///< of the surrounding page
  /// Replaces the slab; the origin of its frame is at the centre of the patch.
  std::shared_ptr<const TexturedMesh> body{};
  glm::dvec3 body_m{0.0};  ///< that centre, in the device's frame
};

/// Slopes are scaled to the RMS kShownSlope, so that reliefs of one shape look the same at every amplitude. A stop
/// returns a null image. Takes some 0.4 s for 1280 × 720 with a relief, a quarter of that without.
QImage draw_workspace(const WorkspaceCamera& camera, const WorkspacePicture& picture,
                      const std::stop_token& stop = {});

}  // namespace asperity

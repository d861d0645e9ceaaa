// Repairs the triangles of a file so that they are the surface of closed bodies, and reports every change.

#pragma once

#include <string>

#include "stimuli/meshes/mesh_findings.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

struct RepairedMesh {
  TriangleMesh mesh{};
  MeshFindings found{};
};

/// The mesh as the surface of closed bodies: every edge has two faces that run through it in
/// opposite directions, the faces at each vertex form one fan, every part encloses a volume and
/// faces outwards (a cavity: inwards), and every vertex has a face.
///
/// Vertices with equal coordinates become one. At an edge of several faces the faces with the body
/// between them are paired, and the others are separated. A hole is closed by a fan about the
/// middle of its border. Faces without area between three different points remain, because they connect the
/// surface. Self-intersections are not searched for and remain unchanged.
///
/// The result depends on the input only; the order of vertices and faces is kept.
///
/// Errors: std::invalid_argument, a sentence that begins with `name`: a coordinate that is not
/// finite, a diagonal outside 0.1 mm to 10 m, a surface with one side only, an opening wider than the
/// limit, a mesh without a volume. Also a limit for holes that is negative or NaN.
RepairedMesh repair_mesh(TriangleMesh mesh, const MeshRepairLimits& limits,
                         const std::string& name);

}  // namespace asperity

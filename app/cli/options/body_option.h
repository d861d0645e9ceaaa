// What `--stimulus` and `--tool` name: a file, or a shape with its sizes.

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/meshes/solid_body.h"

namespace asperity {

/// FILE, or a shape with its sizes in metres and perhaps the file of a height field on it:
///
///   plane:[FILE.png,]X_m,Y_m     plane:FILE.png, one width and length of the field
///   box:[FILE.png,]X_m,Y_m,Z_m   cylinder:[FILE.png,]D_m,L_m
///   sphere:[FILE.png,]D_m        disc:[FILE.png,]D_m
///
/// A plane is a plate 10 mm thick with its upper side in the plane z = 0; the others are made about
/// the origin (textured_shape.h).
struct BodyOption {
  std::string text{};  ///< as it was written
  enum class Kind { file, plane, box, cylinder, sphere, disc } kind = Kind::file;
  std::optional<std::filesystem::path> file{};
  std::vector<double> sizes_m{};

  /// A height field by itself: FILE.png or plane:FILE.png, as every model of a plane takes it.
  bool is_plain_height_field() const;
};

/// Errors: std::runtime_error saying which forms there are, for sizes that are too few, too many or
/// no numbers. `option` is what the person wrote before it, e.g. "--tool".
BodyOption body_option(const std::string& option, const std::string& text);

/// The mesh: a file is a textured mesh, or a height field on a plate where it ends in .png.
///
/// Errors: what files and shapes throw, a sentence that names the option's text.
std::shared_ptr<const TexturedMesh> load_body(const BodyOption& body);

}  // namespace asperity

// Holds a table of shapes with their sizes, and parses NAME:SIZE…; any other text names a file.

#include "app/cli/options/body_option.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "app/study_files/height_field_files.h"
#include "app/study_files/textured_mesh_files.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

struct Form {
  BodyOption::Kind kind = BodyOption::Kind::file;
  std::string_view prefix{};
  std::size_t sizes = 0;
  std::string_view meant{};
};

constexpr std::array kForms{
    Form{BodyOption::Kind::plane, "plane:", 2, "plane:FILE.png or plane:[FILE.png,]X_m,Y_m"},
    Form{BodyOption::Kind::box, "box:", 3, "box:[FILE.png,]X_m,Y_m,Z_m"},
    Form{BodyOption::Kind::cylinder, "cylinder:", 2, "cylinder:[FILE.png,]D_m,L_m"},
    Form{BodyOption::Kind::sphere, "sphere:", 1, "sphere:[FILE.png,]D_m"},
    Form{BodyOption::Kind::disc, "disc:", 1, "disc:[FILE.png,]D_m"}};

constexpr double kThickness_m = 0.01;  // of a plane: deeper than anything is pressed into it

Shape shape_of(const BodyOption& body, const HeightField* field) {
  const std::vector<double>& sizes_m = body.sizes_m;
  switch (body.kind) {
    case BodyOption::Kind::file:
    case BodyOption::Kind::plane: {
      const double x_m = sizes_m.empty() ? field->width_m() : sizes_m[0];
      const double y_m = sizes_m.empty() ? field->length_m() : sizes_m[1];
      return PlateShape{{x_m, y_m, kThickness_m}};
    }
    case BodyOption::Kind::box:
      return BoxShape{{sizes_m[0], sizes_m[1], sizes_m[2]}};
    case BodyOption::Kind::cylinder:
      return CylinderShape{.diameter_m = sizes_m[0], .length_m = sizes_m[1]};
    case BodyOption::Kind::sphere:
      return SphereShape{.diameter_m = sizes_m[0]};
    case BodyOption::Kind::disc:
      return disc_of(sizes_m[0]);
  }
  throw std::logic_error("the kind of a body is not a BodyOption::Kind; use one of its values");
}

/// `rest`: what is left in front of the sizes.
void refuse_size_with_unit(const std::string& option, const std::string& rest, const Form& form) {
  const std::string size = rest.substr(rest.rfind(',') + 1);
  const bool begins_as_number = !size.empty() && size.find_first_of("0123456789.") == 0;
  if (!begins_as_number || std::filesystem::exists(size)) return;
  throw std::runtime_error(option + ": the size \"" + size + "\" is not a number; write " +
                           std::string(form.meant) + ", with sizes in metres without a unit");
}

/// "cube:0.01": a word and a colon in front of something that is not a file.
void refuse_unknown_shape(const std::string& option, const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || std::filesystem::exists(text)) return;
  const bool is_word =
      colon > 1 && std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon),
                               [](char c) { return c >= 'a' && c <= 'z'; });
  if (!is_word) return;
  std::string forms{};
  for (const Form& form : kForms) forms += (forms.empty() ? "" : ", ") + std::string(form.meant);
  throw std::runtime_error(option + ' ' + text + ": there is no shape \"" + text.substr(0, colon) +
                           "\"; write one of " + forms + ", with sizes in metres");
}

}  // namespace

bool BodyOption::is_plain_height_field() const {
  return sizes_m.empty() &&
         (kind == Kind::plane || (kind == Kind::file && file->extension() == ".png"));
}

BodyOption body_option(const std::string& option, const std::string& text) {
  BodyOption body{};
  body.text = text;
  for (const Form& form : kForms) {
    if (!text.starts_with(form.prefix)) continue;
    body.kind = form.kind;
    std::string rest = text.substr(form.prefix.size());
    // Sizes from the end; what is left in front of them is a file, whose name may hold commas.
    while (!rest.empty()) {
      const std::size_t comma = rest.rfind(',');
      const std::size_t start = comma == std::string::npos ? 0 : comma + 1;
      const std::optional<double> size_m = number_in(std::string_view(rest).substr(start));
      if (!size_m || body.sizes_m.size() == form.sizes) break;
      body.sizes_m.insert(body.sizes_m.begin(), *size_m);
      rest.erase(comma == std::string::npos ? 0 : comma);
    }
    if (!rest.empty()) body.file = rest;
    const bool is_whole_field =
        form.kind == BodyOption::Kind::plane && body.sizes_m.empty() && body.file;
    if (body.sizes_m.size() != form.sizes && !is_whole_field) {
      refuse_size_with_unit(option + ' ' + text, rest, form);
      throw std::runtime_error(option + ' ' + text + " has the wrong number of sizes: write " +
                               std::string(form.meant) + ", with sizes in metres");
    }
    return body;
  }
  refuse_unknown_shape(option, text);
  for (const Form& form : kForms) {
    // A shape without its sizes is no file, unless somebody called one so.
    if (text + ':' != form.prefix || std::filesystem::exists(text)) continue;
    throw std::runtime_error(option + ' ' + text + " states no size: write " +
                             std::string(form.meant) + ", with sizes in metres");
  }
  body.file = text;
  return body;
}

std::shared_ptr<const TexturedMesh> load_body(const BodyOption& body) {
  if (body.kind == BodyOption::Kind::file && body.file->extension() != ".png") {
    const LoadedTexturedMesh loaded = load_textured_mesh(*body.file);
    return {loaded.stored, &loaded.stored->mesh};
  }
  std::shared_ptr<const HeightField> field{};
  if (body.file) field = load_height_field(*body.file).field;
  try {
    return std::make_shared<const TexturedMesh>(
        body_mesh(shape_of(body, field.get()), field.get()));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(body.text + ": " + error.what());
  }
}

}  // namespace asperity

// Finds the maker of a kind and checks what it is asked for.

#include "stimuli/synthetic_surface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/number_text.h"
#include "stimuli/surface_makers.h"

namespace asperity {

namespace {

std::vector<SurfaceMaker> all_makers() {
  std::vector<SurfaceMaker> makers = pattern_makers();
  for (SurfaceMaker& maker : material_makers()) makers.push_back(std::move(maker));
  return makers;
}

}  // namespace

std::vector<SurfaceDeclaration> synthetic_surfaces() {
  std::vector<SurfaceDeclaration> declarations;
  for (SurfaceMaker& maker : all_makers()) declarations.push_back(std::move(maker.declaration));
  return declarations;
}

HeightField make_surface(std::string_view kind, const ParameterValues& values,
                         const SurfaceCanvas& canvas) {
  if (!(canvas.width_m >= 1e-3 && canvas.width_m <= 1.0)) {
    throw std::invalid_argument("width_m is " + number_text(canvas.width_m) +
                                " m; a synthetic surface is 0.001 to 1 m wide.");
  }
  if (canvas.pixels < 16 || canvas.pixels > 8192) {
    throw std::invalid_argument("pixels is " + std::to_string(canvas.pixels) +
                                "; a synthetic surface has 16 to 8192 a side.");
  }
  const std::vector<SurfaceMaker> makers = all_makers();
  const auto maker = std::find_if(makers.begin(), makers.end(), [&](const SurfaceMaker& candidate) {
    return candidate.declaration.kind == kind;
  });
  if (maker == makers.end()) {
    std::string names;
    for (const SurfaceMaker& known : makers) {
      names += (names.empty() ? "" : ", ") + known.declaration.kind;
    }
    throw std::invalid_argument("There is no synthetic surface \"" + std::string(kind) +
                                "\"; there are " + names + ".");
  }
  const ParameterValues complete =
      complete_values(maker->declaration.kind, maker->declaration.parameters, values);
  return {{.rows = canvas.pixels, .columns = canvas.pixels, .pitch_m = pitch_of(canvas)},
          maker->make(complete, canvas)};
}

Parameter length_parameter(std::string_view name, double minimum_m, double maximum_m,
                           double default_m, std::string_view meaning) {
  Parameter parameter = plain_parameter(name, minimum_m, maximum_m, default_m, meaning);
  parameter.unit = "m";
  return parameter;
}

Parameter plain_parameter(std::string_view name, double minimum, double maximum,
                          double default_value, std::string_view meaning) {
  return {.name = std::string(name),
          .kind = ParameterKind::number,
          .unit = "1",
          .minimum = minimum,
          .maximum = maximum,
          .choices = {},
          .default_value = default_value,
          .meaning = std::string(meaning)};
}

double pitch_of(const SurfaceCanvas& canvas) noexcept {
  return canvas.width_m / static_cast<double>(canvas.pixels);
}

void require_resolved(const ParameterValues& values, std::string_view name,
                      const SurfaceCanvas& canvas) {
  const double length_m = number_of(values, name);
  const double pitch_m = pitch_of(canvas);
  if (length_m < 2.0 * pitch_m) {
    throw std::invalid_argument(std::string(name) + " is " + number_text(length_m) + " m, but " +
                                std::to_string(canvas.pixels) + " pixels over " +
                                number_text(canvas.width_m) + " m show nothing shorter than " +
                                number_text(2.0 * pitch_m) + " m; ask for more pixels.");
  }
}

SurfacePoint point_of(const SurfaceCanvas& canvas, std::size_t row, std::size_t column) noexcept {
  const double pitch_m = pitch_of(canvas);
  const double middle = 0.5 * static_cast<double>(canvas.pixels - 1);
  return {.x_m = (static_cast<double>(column) - middle) * pitch_m,
          .y_m = (middle - static_cast<double>(row)) * pitch_m};
}

}  // namespace asperity

// The cones of the roughness protocols: strokes meet them, wherever they begin.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "app/study_files/height_field_files.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "tests/app/demo_study.h"

namespace asperity {
namespace {

/// A straight stroke on a height field.
struct Line {
  double x_m = 0.0;
  double y_m = 0.0;
  double length_m = 0.0;
  double direction_rad = 0.0;
};

/// The tip of 1 mm, with its lowest point on the ground, touches a top of radius 0.05 mm and height h up to √(2Rh − h²) +
/// 0.05 mm = 0.45 mm aside.
bool meets_a_cone(const HeightField& field, const Line& line) {
  constexpr double kReach_m = 0.4e-3;
  constexpr double kStep_m = 1e-4;
  constexpr double kPartOfCone_m = 1e-4;
  const double along_x = std::cos(line.direction_rad);
  const double along_y = std::sin(line.direction_rad);
  for (double way_m = 0.0; way_m <= line.length_m; way_m += kStep_m) {
    for (double aside_m = -kReach_m; aside_m <= kReach_m; aside_m += kStep_m) {
      const double x_m = line.x_m + way_m * along_x - aside_m * along_y;
      const double y_m = line.y_m + way_m * along_y + aside_m * along_x;
      if (field.sample(x_m, y_m, Tiling::repeat).height_m > kPartOfCone_m) return true;
    }
  }
  return false;
}

double share_without_cones(const HeightField& field, double length_m, double direction_rad) {
  constexpr int kLines = 300;
  Random random(1);
  int without = 0;
  for (int i = 0; i < kLines; ++i) {
    const Line line{.x_m = field.width_m() * random.uniform(),
                    .y_m = field.width_m() * random.uniform(),
                    .length_m = length_m,
                    .direction_rad = direction_rad};
    if (!meets_a_cone(field, line)) ++without;
  }
  return static_cast<double>(without) / kLines;
}

TEST_F(DemoStudy, HasConesThatNearlyEveryStrokeMeets) {
  const ModelRegistry models = built_in_models();
  int protocols = 0;
  for (const LibraryProtocol& library : library_protocols()) {
    const std::string name(library.name);
    if (name != "roughness_diameter" && name != "roughness_force" && name != "roughness_speed") {
      continue;
    }
    ++protocols;
    const Protocol protocol = read_protocol(library.text, name, declarations_of(models));
    const auto coarsest = std::max_element(
        protocol.estimation->spacing_m.begin(), protocol.estimation->spacing_m.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
    const std::string file = protocol.textures.at(coarsest->first).height_field.value();
    const HeightField& field = *load_height_field(study / file).field;
    for (const auto& [condition, hand] : protocol.explorations) {
      const double length_m = hand.stroke_length_m.target.value();
      for (const double deviation_rad : {-0.0873, 0.0, 0.0873}) {  // 5°
        EXPECT_LE(share_without_cones(field, length_m, hand.direction_rad + deviation_rad), 0.02)
            << name << ", " << condition << ", " << deviation_rad;
      }
      // Along the rows, which have an angle of arctan(3/4): what the angle avoids.
      EXPECT_GT(share_without_cones(field, length_m, hand.direction_rad + 0.643501), 0.3);
    }
  }
  EXPECT_EQ(protocols, 3);
}

}  // namespace
}  // namespace asperity

// asperity fit-model, and the force model that renders its table.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/number_text.h"
#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The RMS of the force across a stroke of 60 mm/s along x at 1 N, in its second half.
double rendered_rms_N(const fs::path& place, const fs::path& models, const std::string& variance) {
  std::string path = "time_s\tx_m\ty_m\tz_m\n";
  for (int i = 0; i < 8000; ++i) {
    path += text_of_number(i / 1000.0) + '\t' + text_of_number(0.06 * i / 1000.0) + "\t0\t-0.002\n";
  }
  write_text(place / "path.tsv", path);
  const Outcome rendered = asperity(
      {"render", "--model", "data_driven", "--asset", "vibration_models=" + models.string(),
       "--param", "variance=" + variance, "--param", "axis=binormal", "--friction", "0", "--path",
       place / "path.tsv", "--out", place / "forces.tsv", "--force"});
  EXPECT_EQ(rendered.status, 0) << rendered.err;
  const std::vector<std::string> across = tsv(text_of(place / "forces.tsv")).column("fy_N");
  double sum = 0.0;
  for (std::size_t i = across.size() / 2; i < across.size(); ++i) {
    sum += std::pow(number_in(across[i]).value(), 2);
  }
  return std::sqrt(2.0 * sum / static_cast<double>(across.size()));
}

// The relief's own forces at 60 mm/s, in three strokes, are those that the model renders at this speed.
TEST(FitModel, OfTheRecordingOfAReliefIsRenderedWithItsForce) {
  const TemporaryFolder place{};
  ASSERT_EQ(asperity({"synth", "sandpaper", "--pixels", "512", "--param", "grain_height_m=0.0001",
                      "--param", "grain_spacing_m=0.001", "--out", place / "rough.png"})
                .status,
            0);
  ASSERT_EQ(
      asperity({"texture-recording", "--relief", place / "rough.png", "--out", place / "rough.tsv"})
          .status,
      0);
  const Outcome fitted =
      asperity({"fit-model", place / "rough.tsv", "--out", place / "models.tsv"});
  ASSERT_EQ(fitted.status, 0) << fitted.err;
  EXPECT_THAT(fitted.out, AllOf(HasSubstr("9 strokes, 3 models of order"), HasSubstr("(by BIC)")));
  EXPECT_THAT(fitted.err, AllOf(HasSubstr("there is one normal force"),
                                testing::Not(HasSubstr("there is one speed"))));
  const auto recorded = tsv(text_of(place / "rough.tsv"));
  const auto strokes = recorded.column("stroke");
  const auto forces = recorded.column("force_N");
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i] < "4" || strokes[i] > "6") continue;
    sum += std::pow(number_in(forces[i]).value(), 2);
    count += 1.0;
  }
  EXPECT_NEAR(
      rendered_rms_N(place.path(), place / "models.tsv", "logarithmic") / std::sqrt(sum / count),
      1.0, 0.15);
  // The printed σ is that of the file.
  const std::vector<std::string> variances =
      tsv(text_of(place / "models.tsv")).column("variance_m2_per_s4");
  ASSERT_EQ(variances.size(), 3U);
  EXPECT_THAT(fitted.out, HasSubstr("sigma_m_per_s2"));
  for (const std::string& variance : variances) {
    EXPECT_THAT(fitted.out,
                HasSubstr(' ' + fixed(std::sqrt(number_in(variance).value()), 4) + '\n'));
  }
  // Nothing is overwritten.
  EXPECT_EQ(asperity({"fit-model", place / "rough.tsv", "--out", place / "models.tsv"}).status, 1);
  const Outcome fixed = asperity(
      {"fit-model", place / "rough.tsv", "--order", "6", "--out", place / "models.tsv", "--force"});
  EXPECT_THAT(fixed.out, HasSubstr("3 models of order 6 (as given)"));
}

// White noise of 0.04 m²/s⁴ at 60 mm/s, with silence at rest: 0.2 m/s² times 50 g.
TEST(FitModel, ImportsATextureOfTheToolkit) {
  const TemporaryFolder place{};
  const auto model = [](const std::string& speed, const std::string& variance) {
    return "<model><ARlsf><value>1.0471975511965976</value><value>2.0943951023931953</value>"
           "</ARlsf><var>" +
           variance + "</var><speedMod>" + speed + "</speedMod><forceMod>1</forceMod></model>";
  };
  const std::string xml =
      "<modelSet><AccelUnits>m/s^2</AccelUnits><SpeedUnits>mm/s</SpeedUnits>"
      "<ForceUnits>N</ForceUnits>\n<SampleRate>1000</SampleRate><mu>0.31</mu>" +
      model("0", "0") + model("60", "0.04") + "</modelSet>\n";
  write_text(place / "Models_Ours.xml", xml);
  const Outcome imported =
      asperity({"fit-model", "--import", place / "Models_Ours.xml", "--out", place / "ours.tsv"});
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_THAT(imported.out, AllOf(HasSubstr("2 models of order 2"), HasSubstr("1 silent"),
                                  HasSubstr("0.31"), testing::Not(HasSubstr("moving averages"))));
  EXPECT_NEAR(rendered_rms_N(place.path(), place / "ours.tsv", "linear"),
              0.05 * 0.2 * 0.06 / std::hypot(0.06, 0.01), 0.0008);
  write_text(place / "Models_Ours.xml", "<modelSet>\n<AccelUnits>g</AccelUnits></modelSet>");
  const Outcome refused = asperity(
      {"fit-model", "--import", place / "Models_Ours.xml", "--out", place / "ours.tsv", "--force"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("Models_Ours.xml:2: AccelUnits is \"g\""));
}

TEST(FitModel, NeedsOneSource) {
  const TemporaryFolder place{};
  const Outcome none = asperity({"fit-model", "--out", place / "x.tsv"});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("or --import FILE.xml"));
  EXPECT_EQ(asperity({"fit-model", "a.tsv", "--import", "b.xml", "--out", place / "x.tsv"}).status,
            2);
}

}  // namespace
}  // namespace asperity::test

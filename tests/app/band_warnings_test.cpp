// Warnings about noise that changes more often than the servo loop runs.

#include "app/tasks/warnings/band_warnings.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/tasks/warnings/stimulus_warnings.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// `amplitude_jnd` with noise of this rate at this servo rate.
std::vector<Diagnostic> warned_of_noise(double noise_rate_Hz, double servo_rate_Hz,
                                        const std::string& index = "time") {
  for (const auto& each : library_protocols()) {
    if (each.name != "amplitude_jnd") continue;
    auto source = nlohmann::ordered_json::parse(each.text);
    source["device"]["rate_Hz"] = servo_rate_Hz;
    const nlohmann::ordered_json noise{
        {"model", "stochastic"},
        {"parameters", {{"noise_sd_N", 0.05}, {"noise_rate_Hz", noise_rate_Hz}, {"index", index}}}};
    for (auto& [name, stimulus] : source["stimuli"].items()) stimulus = noise;
    for (auto& [name, block] : source["blocks"].items()) {
      if (block.contains("vary")) block["vary"]["parameter"] = "noise_sd_N";
    }
    const ModelRegistry models = built_in_models();
    const Protocol protocol = read_protocol(source.dump(2), "p.json", declarations_of(models));
    StimulusBuilder without_files(models, {});
    return warnings_about_stimuli({protocol, "p.json"}, without_files);
  }
  throw std::logic_error("the library has no amplitude_jnd");
}

TEST(BandWarnings, NameNoiseThatIsFasterThanTheServoLoop) {
  const std::vector<Diagnostic> found = warned_of_noise(1000, 400);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].message.english(),
              AllOf(HasSubstr("at frequencies up to 500 Hz, above the Nyquist "
                              "frequency of the servo loop, half of 400 Hz"),
                    HasSubstr("raise \"rate_Hz\"")));
}

TEST(BandWarnings, AreNoneUpToTheServoRateAndForNoiseAlongThePath) {
  EXPECT_THAT(warned_of_noise(1000, 1000), IsEmpty());
  EXPECT_THAT(warned_of_noise(400, 400), IsEmpty());
  EXPECT_THAT(warned_of_noise(1000, 400, "distance"), IsEmpty());
}

}  // namespace
}  // namespace asperity

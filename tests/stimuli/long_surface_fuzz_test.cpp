// Ten minutes of mutated files for each format of a measured surface.

#include <cstdlib>
#include <ctime>
#include <iostream>

#include <gtest/gtest.h>

#include "tests/stimuli/surface_fuzz.h"

namespace asperity::test {
namespace {

/// ASPERITY_FUZZ_CPU_S, or 600.
double processor_seconds() {
  const char* const given = std::getenv("ASPERITY_FUZZ_CPU_S");
  return given == nullptr ? 600.0 : std::strtod(given, nullptr);
}

class LongSurfaceFuzz : public testing::TestWithParam<SurfaceFormat> {};

TEST_P(LongSurfaceFuzz, ChangedBytesAreReadOrRefused) {
  const double most_s = processor_seconds();
  const FuzzTally tally = fuzz_surfaces(GetParam(), [most_s](const FuzzTally&) {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC >= most_s;
  });
  std::cout << name_of(GetParam()) << ": " << tally.accepted << " files accepted, " << tally.refused
            << " refused\n";
  EXPECT_GT(tally.accepted, 0U);
  EXPECT_GT(tally.refused, 0U);
}

INSTANTIATE_TEST_SUITE_P(Formats, LongSurfaceFuzz,
                         testing::Values(SurfaceFormat::x3p, SurfaceFormat::sur, SurfaceFormat::gwy,
                                         SurfaceFormat::tiff),
                         [](const auto& one) { return std::string(name_of(one.param)); });

}  // namespace
}  // namespace asperity::test

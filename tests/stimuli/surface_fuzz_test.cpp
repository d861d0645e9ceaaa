// Whatever a file of a measured surface contains, the result is a surface or a refusal.

#include "tests/stimuli/surface_fuzz.h"

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

class SurfaceFuzz : public testing::TestWithParam<SurfaceFormat> {};

TEST_P(SurfaceFuzz, ChangedBytesAreReadOrRefused) {
  constexpr std::size_t kFiles = 1500;
  const FuzzTally tally = fuzz_surfaces(GetParam(), [](const FuzzTally& so_far) {
    return so_far.accepted + so_far.refused == kFiles;
  });
  EXPECT_GT(tally.accepted, kFiles / 50);
  EXPECT_GT(tally.refused, kFiles / 10);
}

INSTANTIATE_TEST_SUITE_P(Formats, SurfaceFuzz,
                         testing::Values(SurfaceFormat::x3p, SurfaceFormat::sur, SurfaceFormat::gwy,
                                         SurfaceFormat::tiff),
                         [](const auto& one) { return std::string(name_of(one.param)); });

}  // namespace
}  // namespace asperity::test

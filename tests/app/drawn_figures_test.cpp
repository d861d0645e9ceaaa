// Figures that a command may replace because it drew them, and those that it may not.

#include "app/study_files/drawn_figures.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

class DrawnFiguresOfAResult : public testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_ / "out"); }
  void draw(const char* content) const { write_file(figure_, content, Overwrite::allow); }
  Overwrite overwrite() const { return drawn_.overwrite_of(figure_, Overwrite::refuse); }

  TemporaryFolder folder_{};
  fs::path figure_ = folder_ / "power.svg";
  DrawnFigures drawn_{folder_ / "out" / "figures.json"};
};

TEST_F(DrawnFiguresOfAResult, AreReplacedAsLongAsTheyAreUnchanged) {
  draw("first");
  EXPECT_EQ(overwrite(), Overwrite::refuse);  // not drawn by the command
  drawn_.record(figure_);
  EXPECT_EQ(overwrite(), Overwrite::allow);
  draw("edited by hand");
  EXPECT_EQ(overwrite(), Overwrite::refuse);
  EXPECT_EQ(drawn_.overwrite_of(figure_, Overwrite::allow), Overwrite::allow);
}

TEST_F(DrawnFiguresOfAResult, AreKnownByTheirName) {
  draw("first");
  drawn_.record(figure_);
  const fs::path other = folder_ / "other.svg";
  write_file(other, "first", Overwrite::refuse);
  EXPECT_EQ(drawn_.overwrite_of(other, Overwrite::refuse), Overwrite::refuse);
  drawn_.record(other);
  EXPECT_EQ(overwrite(), Overwrite::allow) << "a second figure does not displace the first";
}

TEST_F(DrawnFiguresOfAResult, AreNotKnownFromADamagedRecord) {
  draw("first");
  write_file(folder_ / "out" / "figures.json", "{\"format\": 1", Overwrite::allow);
  EXPECT_EQ(overwrite(), Overwrite::refuse);
  drawn_.record(figure_);
  EXPECT_EQ(overwrite(), Overwrite::allow);
}

}  // namespace
}  // namespace asperity

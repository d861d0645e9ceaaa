// The name that is proposed for a stimulus from the name of a file.

#include "app/gui/workbench/save_panel.h"

#include <fstream>

#include <QtCore/QTemporaryDir>
#include <gtest/gtest.h>

namespace asperity {
namespace {

class ProposedName : public testing::Test {
 protected:
  std::string of(const std::string& file) const {
    return proposed_name(std::filesystem::path("/pictures") / file, stimuli()).toStdString();
  }
  void take(const std::string& file) const { std::ofstream(stimuli() / file) << "taken"; }
  std::filesystem::path stimuli() const { return folder_.path().toStdString(); }

  QTemporaryDir folder_{};
};

TEST_F(ProposedName, IsThePlainPartOfTheFilesName) {
  EXPECT_EQ(of("Brick.JPG"), "brick");
  EXPECT_EQ(of("IMG 2024 (1).jpg"), "img_2024_1");
  EXPECT_EQ(of("Wände & Böden.png"), "wande_boden");
  EXPECT_EQ(of("石.png"), "relief");
  EXPECT_EQ(of("0123456789012345678901234567890123456789012345678901.png"),
            "0123456789012345678901234567890123456789");
}

TEST_F(ProposedName, IsNoPhotographsName) {
  EXPECT_EQ(of("brick_photo.png"), "brick");
  EXPECT_EQ(of("brick photo_photo.png"), "brick");
  EXPECT_EQ(of("_photo.png"), "photo");
  EXPECT_EQ(of("cut_to_forty_letters_it_would_end_in_photograph.png"),
            "cut_to_forty_letters_it_would_end_in_pho");
  EXPECT_EQ(of("0123456789012345678901234567890123_photograph.png"),
            "0123456789012345678901234567890123");
}

TEST_F(ProposedName, ReplacesNothing) {
  take("brick.png");
  EXPECT_EQ(of("brick.png"), "brick_2");
  take("brick_2_photo.png");
  EXPECT_EQ(of("brick_photo.png"), "brick_3");
  take("brick_3.png.json");
  EXPECT_EQ(of("brick.png"), "brick_4");
}

}  // namespace
}  // namespace asperity

// Height fields on disk: their files come together or not at all.

#include "app/study_files/height_field_files.h"

#include <chrono>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

HeightField ramp(float top_m) {
  std::vector<float> heights_m(64);
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    heights_m[i] = top_m * static_cast<float>(i) / 63.0F;
  }
  return {HeightField::Grid{8, 8, 1e-4}, std::move(heights_m)};
}

void save(const std::filesystem::path& png, float top_m, Overwrite overwrite) {
  save_height_field(png, ramp(top_m), {"test", {}, {}, "", "", ""}, overwrite);
}

std::ptrdiff_t files_in_folder(const TemporaryFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

/// What is there and cannot be replaced without --force, though nothing answers to its name.
void block(const std::filesystem::path& file) { std::filesystem::create_symlink("nothing", file); }

TEST(HeightFieldFiles, AreNoneWhereOneOfThemCannotBeWritten) {
  for (const char* blocked : {"a.png", "a.png.json"}) {
    const TemporaryFolder folder;
    block(folder / blocked);
    EXPECT_THAT(refusal_of<ResultsError>([&] { save(folder / "a.png", 1e-4F, Overwrite::refuse); }),
                HasSubstr(blocked));
    EXPECT_EQ(files_in_folder(folder), 1) << blocked;
    std::filesystem::remove(folder / blocked);
    save(folder / "a.png", 1e-4F, Overwrite::refuse);  // the same command again
    EXPECT_NO_THROW(load_height_field(folder / "a.png"));
  }
}

// A program that was killed between the two leaves the sidecar.
TEST(HeightFieldFiles, AreCompletedByTheSameCommandAndByNoOther) {
  const TemporaryFolder folder;
  save(folder / "a.png", 1e-4F, Overwrite::refuse);
  std::filesystem::remove(folder / "a.png");
  EXPECT_THAT(refusal_of<ResultsError>([&] { save(folder / "a.png", 2e-4F, Overwrite::refuse); }),
              HasSubstr("a.png.json already exists"));
  save(folder / "a.png", 1e-4F, Overwrite::refuse);
  EXPECT_NO_THROW(load_height_field(folder / "a.png"));
  EXPECT_THAT(refusal_of<ResultsError>([&] { save(folder / "a.png", 1e-4F, Overwrite::refuse); }),
              HasSubstr("a.png already exists"));
}

// A program that was killed before the last one leaves pictures as well.
TEST(HeightFieldFiles, AreCompletedWithTheirPictures) {
  const TemporaryFolder folder;
  const auto save_with = [&folder](const std::string& picture) {
    save_height_field(folder / "a.png", ramp(1e-4F), {"test", {}, {}, "", "", ""},
                      Overwrite::refuse, {{folder / "photo.png", picture}});
  };
  save_with("picture");
  std::filesystem::remove(folder / "a.png");
  EXPECT_THAT(refusal_of<ResultsError>([&] { save_with("other"); }),
              HasSubstr("photo.png already exists; use --force to replace it"));
  EXPECT_EQ(read_file(folder / "photo.png"), "picture");
  save_with("picture");
  EXPECT_NO_THROW(load_height_field(folder / "a.png"));
}

TEST(HeightFieldFiles, AreReplacedTogether) {
  const TemporaryFolder folder;
  save(folder / "a.png", 1e-4F, Overwrite::refuse);
  save(folder / "a.png", 2e-4F, Overwrite::allow);
  EXPECT_NEAR(load_height_field(folder / "a.png").field->maximum_m(), 2e-4, 1e-8);
  EXPECT_EQ(files_in_folder(folder), 2);
}

TEST(KeptHeightFields, AreReadAgainWhenAFileHasChanged) {
  const TemporaryFolder folder;
  const std::filesystem::path png = folder / "a.png";
  save(png, 1e-4F, Overwrite::refuse);
  KeptHeightFields kept{};
  const LoadedHeightField first = kept.load(png);
  EXPECT_NEAR(first.field->maximum_m(), 1e-4, 1e-8);
  EXPECT_EQ(kept.load(png).field, first.field) << "the same object";
  save(png, 2e-4F, Overwrite::allow);
  // Whatever the steps of the file system's clock.
  std::filesystem::last_write_time(
      sidecar_of(png), std::filesystem::last_write_time(sidecar_of(png)) + std::chrono::seconds(1));
  EXPECT_NEAR(kept.load(png).field->maximum_m(), 2e-4, 1e-8);
  EXPECT_NE(kept.load(png).sha256, first.sha256);
  std::filesystem::remove(png);
  EXPECT_THROW(kept.load(png), std::exception);
  save(png, 3e-4F, Overwrite::allow);
  EXPECT_NEAR(kept.load(png).field->maximum_m(), 3e-4, 1e-8);
}

TEST(KeptHeightFields, AreForgottenUnlessTheyHaveBeenLoadedMeanwhile) {
  const TemporaryFolder folder;
  for (const char* const name : {"a.png", "b.png"}) save(folder / name, 1e-4F, Overwrite::refuse);
  KeptHeightFields kept{};
  const std::weak_ptr<const HeightField> a = kept.load(folder / "a.png").field;
  const std::weak_ptr<const HeightField> b = kept.load(folder / "b.png").field;
  kept.forget_unused();
  EXPECT_FALSE(a.expired());
  EXPECT_FALSE(b.expired());
  kept.load(folder / "a.png");
  kept.forget_unused();
  EXPECT_FALSE(a.expired());
  EXPECT_TRUE(b.expired());
}

}  // namespace
}  // namespace asperity

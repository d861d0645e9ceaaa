// The workbench from a dropped photograph to saved files, and what it says about recipes.

#include "app/gui/workbench/workbench_page.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSlider>
#include <gtest/gtest.h>

#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/window/study_window.h"
#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/opened_picture.h"
#include "app/gui/workbench/recipe_panel.h"
#include "app/gui/workbench/relief_view.h"
#include "app/gui/workbench/signal_plots.h"
#include "stimuli/photographs/synthetic_photograph.h"
#include "tests/gui/support/accessible.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"
#include "tests/gui/workbench/page_of_the_workbench.h"

namespace asperity {
namespace {

void put(std::string& bytes, std::uint32_t number, int size) {
  for (int k = 0; k < size; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xFFU);
}

/// A square grey TIFF of 16 bits in one strip.
void write_tiff(const std::filesystem::path& file, std::uint32_t side,
                const std::vector<std::uint16_t>& levels) {
  const std::uint32_t bytes_of_pixels = side * side * 2;
  std::string bytes = "II*";
  put(bytes, 0, 1);
  put(bytes, 8 + bytes_of_pixels, 4);  // where the directory is
  for (const std::uint16_t level : levels) put(bytes, level, 2);
  const std::vector<std::array<std::uint32_t, 2>> entries{
      {256, side}, {257, side},           {258, 16}, {259, 1}, {262, 1}, {273, 8}, {277, 1},
      {278, side}, {279, bytes_of_pixels}};
  put(bytes, static_cast<std::uint32_t>(entries.size()), 2);
  for (const auto& [tag, value] : entries) {
    put(bytes, tag, 2);
    put(bytes, 4, 2);  // 32-bit numbers, one of each
    put(bytes, 1, 4);
    put(bytes, value, 4);
  }
  put(bytes, 0, 4);
  write_file(file, bytes, Overwrite::refuse);
}

/// The JPEG with a camera's note (EXIF) that it is to be turned by a quarter.
void write_turned(const std::filesystem::path& file, const std::string& jpeg) {
  std::string exif("Exif\0\0II*\0", 10);
  put(exif, 8, 4);
  put(exif, 1, 2);       // one entry:
  put(exif, 0x0112, 2);  // the orientation,
  put(exif, 3, 2);       // a 16-bit number,
  put(exif, 1, 4);
  put(exif, 6, 4);  // turned to the right
  put(exif, 0, 4);
  std::string segment("\xFF\xE1", 2);
  const std::size_t length = exif.size() + 2;
  segment += static_cast<char>(length >> 8U);
  segment += static_cast<char>(length & 0xFFU);
  write_file(file, jpeg.substr(0, 2) + segment + exif + jpeg.substr(2), Overwrite::refuse);
}

TEST_F(Workbench, ShowsEveryStepOfADroppedPhotograph) {
  EXPECT_EQ(page_->field(), nullptr);
  drop(photograph("brick", 256));
  ASSERT_NE(page_->field(), nullptr);
  auto& strip = find<StepStrip>("steps");
  for (int step = 0; step < kSteps; ++step) {
    EXPECT_FALSE(strip.picture(static_cast<Step>(step)).isNull()) << step;
  }
  EXPECT_EQ(strip.chosen(), Step::relief);
  EXPECT_FALSE(find<ReliefView>("relief").picture().isNull());
  EXPECT_FALSE(find<SignalPlots>("profile").signal_series().empty());
  EXPECT_FALSE(find<QLabel>("advice").text().isEmpty());
  click("step_2");
  EXPECT_FALSE(find<QLabel>("step_picture").pixmap().isNull());
  EXPECT_TRUE(find<QLabel>("step_picture").isVisible());
}

TEST_F(BrickOnTheWorkbench, ComputesTheHeightsThatTheRecipeSays) {
  const std::filesystem::path file = photograph("brick", 256);
  drop(file);
  const GreyImage grey = load_photograph(file).photograph.grey;
  EXPECT_EQ(page_->field()->heights_m(),
            texture_from_photograph(grey, TextureRecipe{}, "brick").field.heights_m());
  type("gaussian_wavelength_m", "8");
  type("rms_m", "250");
  find<QComboBox>("kind").setCurrentIndex(1);
  settle();
  TextureRecipe recipe{};
  recipe.gaussian_wavelength_m = 0.008;
  recipe.rms_m = 250e-6;
  recipe.sign = HeightSign::dark_is_high;
  EXPECT_EQ(parameter_values(page_->recipe()), parameter_values(recipe));
  EXPECT_EQ(page_->field()->heights_m(),
            texture_from_photograph(grey, recipe, "brick").field.heights_m());
}

// The direction of the light determines the sign, whatever was chosen before.
TEST_F(BrickOnTheWorkbench, RecoversTheReliefFromItsShadingInLightFromOneSide) {
  const std::filesystem::path file = photograph("stone", 256, PhotographCase::lambert);
  drop(file);
  find<QComboBox>("kind").setCurrentIndex(1);
  auto& method = find<QComboBox>("method");
  method.setCurrentIndex(method.findText("Pentland (1990)"));
  emit method.activated(method.currentIndex());
  type("light_azimuth_deg", "20");
  settle();
  TextureRecipe recipe{};
  recipe.method = "pentland";
  recipe.light_azimuth_deg = 20.0;
  EXPECT_EQ(parameter_values(page_->recipe()), parameter_values(recipe));
  EXPECT_EQ(page_->field()->heights_m(),
            texture_from_photograph(load_photograph(file).photograph.grey, recipe, "stone")
                .field.heights_m());
}

TEST_F(Workbench, IsProvisionalUntilItIsChosenWhatThePhotographShows) {
  drop_all({photograph("brick", 256)});
  EXPECT_EQ(find<QComboBox>("kind").currentIndex(), -1);
  EXPECT_TRUE(find<QLabel>("expectation").text().contains("provisional"));
  EXPECT_FALSE(find<QPushButton>("save").isEnabled());
  EXPECT_TRUE(find<QLabel>("name_problem").text().contains("Choose what the photograph shows"));
  find<QComboBox>("kind").setCurrentIndex(1);
  settle();
  EXPECT_TRUE(find<QPushButton>("save").isEnabled());
  EXPECT_EQ(page_->recipe().sign, HeightSign::dark_is_high);
  EXPECT_TRUE(find<QLabel>("expectation").text().startsWith("Dark is high"));
  find<QComboBox>("kind").setCurrentIndex(2);
  EXPECT_TRUE(find<QLabel>("expectation").text().contains("paint becomes relief"));
  // The next photograph is chosen anew.
  drop_all({photograph("stone", 256)});
  EXPECT_EQ(find<QComboBox>("kind").currentIndex(), -1);
  EXPECT_FALSE(find<QPushButton>("save").isEnabled());
  // The direction of the light determines the sign.
  auto& method = find<QComboBox>("method");
  method.setCurrentIndex(method.findText("Pentland (1990)"));
  emit method.activated(method.currentIndex());
  settle();
  EXPECT_TRUE(find<QPushButton>("save").isEnabled());
}

// The same for a picture in even light and in light from one side: the user knows it, and not the picture.
TEST_F(BrickOnTheWorkbench, AsksAboutTheLightBeforeItRecommendsAMethod) {
  for (const PhotographCase photograph_case :
       {PhotographCase::bright_height, PhotographCase::lambert}) {
    drop_all({photograph("stone", 256, photograph_case)});
    auto& light = find<QComboBox>("light");
    const auto recommended = [this] { return find<QLabel>("recommendation").text(); };
    EXPECT_EQ(light.currentIndex(), -1);
    EXPECT_FALSE(recommended().contains("Recommended")) << recommended().toStdString();
    EXPECT_TRUE(recommended().contains("Answer the question first"));
    light.setCurrentIndex(0);
    EXPECT_TRUE(recommended().contains("Brightness with a spectral tilt of 0.5, because"))
        << recommended().toStdString();
    light.setCurrentIndex(1);
    EXPECT_TRUE(recommended().contains("Recommended method: Pentland (1990)"))
        << recommended().toStdString();
    EXPECT_TRUE(recommended().contains("slope towards the light"));
  }
  // The answer stays with the picture, on a page that takes the place of this one.
  const WorkbenchPage::Work work = page_->work();
  find<QComboBox>("light").setCurrentIndex(0);
  page_->resume(work);
  settle();
  EXPECT_EQ(find<QComboBox>("light").currentIndex(), 1);
  EXPECT_TRUE(find<QLabel>("recommendation").text().contains("Pentland"));
}

TEST_F(BrickOnTheWorkbench, UsesTheRecommendedMethod) {
  drop_all({photograph("stone", 256, PhotographCase::bright_height)});
  auto& use = find<QPushButton>("use_recommendation");
  EXPECT_FALSE(use.isVisible()) << "the light is not stated";
  auto& light = find<QComboBox>("light");
  light.setCurrentIndex(0);
  use.click();
  EXPECT_EQ(page_->work().recipe.method, "brightness");
  EXPECT_DOUBLE_EQ(page_->work().recipe.spectral_tilt, 0.5);
  EXPECT_EQ(find<QComboBox>("method").currentText(), "Brightness");
  EXPECT_FALSE(use.isVisible()) << "nothing is left to change";
  light.setCurrentIndex(1);
  EXPECT_TRUE(use.isVisible());
}

TEST_F(BrickOnTheWorkbench, HasAControlForEveryParameterOfTheRecipe) {
  for (const Parameter& parameter : texture_recipe_parameters()) {
    auto* control = page_->findChild<QWidget*>(QString::fromStdString(parameter.name));
    ASSERT_NE(control, nullptr) << parameter.name;
    EXPECT_TRUE(control->isEnabled()) << parameter.name;
    if (parameter.kind != ParameterKind::number) continue;
    const ParameterValue before = complete_parameter_values(page_->recipe()).at(parameter.name);
    QTest::keyClick(control, Qt::Key_Up);
    EXPECT_NE(complete_parameter_values(page_->recipe()).at(parameter.name), before)
        << parameter.name;
  }
  settle();
}

TEST_F(BrickOnTheWorkbench, IsCoarserWhileASliderIsHeldAndFineAgainAfterwards) {
  drop(photograph("brick", 512));
  auto& slider = find<QSlider>("slider_rms_m");
  slider.setSliderDown(true);
  slider.setSliderPosition(400);
  settle();
  EXPECT_EQ(page_->field()->grid().columns, kDraggedSide);
  slider.setSliderDown(false);
  settle();
  EXPECT_EQ(page_->field()->grid().columns, 512U);
  EXPECT_NEAR(page_->field()->rms_m(), page_->recipe().rms_m, 1e-3 * page_->recipe().rms_m);
}

TEST_F(BrickOnTheWorkbench, EndsWithTheNewestOfManyChanges) {
  for (const char* height : {"10", "20", "30", "40", "50", "60", "70"}) type("rms_m", height);
  settle();
  EXPECT_NEAR(page_->field()->rms_m(), 70e-6, 1e-9);
}

TEST_F(BrickOnTheWorkbench, SaysWhatAPhotographInSideLightIsWorth) {
  drop(photograph("stone", 256, PhotographCase::lambert));
  EXPECT_TRUE(find<QLabel>("hint").isVisible());
  EXPECT_TRUE(find<QLabel>("hint").text().contains("light from one side"));
  EXPECT_TRUE(find<QLabel>("advice").text().contains("anisotropy"));
}

TEST_F(Workbench, SaysWhatTheSignDependsOnNextToItsChoiceWhateverElseThePhotographShows) {
  RecipePanel panel{};
  OpenedPicture opened{};
  opened.resemblances = {PhotographResemblance::directed, PhotographResemblance::bright_spots};
  panel.show_opened(opened);
  const QString hint = child<QLabel>(panel, "hint").text();
  ASSERT_TRUE(hint.contains("light mortar")) << hint.toStdString();
  EXPECT_TRUE(hint.contains("light from one side"));
  EXPECT_LT(hint.indexOf("light mortar"), hint.indexOf("light from one side"));
}

TEST_F(BrickOnTheWorkbench, ShowsALongNameFromItsBeginning) {
  const std::filesystem::path plain = photograph("brick", 256);
  const std::filesystem::path file =
      plain.parent_path() / "a_wall_of_bricks_in_the_sun_as_it_was_in_the_morning_of_may.png";
  std::filesystem::copy_file(plain, file);
  drop(file);
  EXPECT_EQ(find<QLineEdit>("name").cursorPosition(), 0);
  EXPECT_TRUE(find<QLineEdit>("name").text().startsWith("a_wall_of_bricks"));
}

TEST_F(Workbench, SavesFilesThatAreReadBackAndTellsTheStudy) {
  const std::filesystem::path file = photograph("brick", 256);
  drop(file);
  QSignalSpy changed(study_.get(), &OpenStudy::changed);
  find<QLineEdit>("name").setText("old_wall");
  click("save");
  settle();
  EXPECT_EQ(changed.count(), 1);
  const std::filesystem::path stimuli = study_folder() / "stimuli";
  const LoadedHeightField loaded = load_height_field(stimuli / "old_wall.png");
  const double step_m = (page_->field()->maximum_m() - page_->field()->minimum_m()) / 65535.0;
  for (std::size_t i = 0; i < loaded.field->heights_m().size(); ++i) {
    ASSERT_NEAR(loaded.field->heights_m()[i], page_->field()->heights_m()[i], step_m);
  }
  EXPECT_EQ(read_file(stimuli / "old_wall_photo.png", kPictureFile), read_file(file, kPictureFile));
}

TEST_F(Workbench, SavesAPhotographInItsColours) {
  const QImage brick(QString::fromStdString(photograph("brick", 128).string()));
  QImage coloured = brick.convertToFormat(QImage::Format_RGB32);
  for (int row = 0; row < coloured.height(); ++row) {
    for (int column = 0; column < coloured.width(); ++column) {
      const int grey = qGray(coloured.pixel(column, row));
      coloured.setPixel(column, row, qRgb(grey, grey / 2, grey / 4));
    }
  }
  const std::filesystem::path file = folder() / "wall.jpg";
  ASSERT_TRUE(coloured.save(QString::fromStdString(file.string()), "JPG", 95));
  drop(file);
  click("save");
  settle();
  const QImage saved(
      QString::fromStdString((study_folder() / "stimuli" / "wall_photo.png").string()));
  ASSERT_EQ(saved.size(), coloured.size());
  EXPECT_EQ(saved, QImage(QString::fromStdString(file.string())).convertToFormat(saved.format()));
  const QRgb pixel = saved.pixel(64, 64);
  EXPECT_GT(qRed(pixel), qBlue(pixel) + 20);
}

TEST_F(Workbench, SavesALargePhotographWhole) {
  const GreyImage brick = load_photograph(photograph("brick", 256)).photograph.grey;
  GreyImage frieze{.rows = 64, .columns = 1100, .values = {}};
  for (std::size_t i = 0; i < frieze.rows; ++i) {
    for (std::size_t j = 0; j < frieze.columns; ++j) {
      frieze.values.push_back(brick.values[i * 256 + j % 256]);
    }
  }
  save_picture(folder() / "frieze.png", frieze, Overwrite::refuse);
  drop(folder() / "frieze.png");
  EXPECT_EQ(page_->field()->grid().columns, kPreviewSide);
  find<QLineEdit>("name").setText("wall");
  click("save");
  settle();
  EXPECT_EQ(load_height_field(study_folder() / "stimuli/wall.png").field->grid().columns, 1100U);
}

TEST_F(Workbench, ReplacesAStimulusOnlyWhenToldTo) {
  drop(photograph("brick", 256));
  click("save");
  settle();
  const std::filesystem::path png = study_folder() / "stimuli/brick.png";
  const std::string before = load_height_field(png).sha256;
  type("rms_m", "300");
  settle();
  click("save");
  settle();
  auto& banner = find<Banner>("banner");
  EXPECT_TRUE(banner.isVisible());
  EXPECT_TRUE(banner.text().contains("already"));
  EXPECT_EQ(load_height_field(png).sha256, before);
  const auto replace = [&banner] {
    for (QPushButton* button : banner.findChildren<QPushButton*>()) {
      if (button->text().startsWith("Replace")) QTest::mouseClick(button, Qt::LeftButton);
    }
  };
  // What is replaced is what the button says, whatever name has been typed since.
  std::filesystem::copy_file(png, study_folder() / "stimuli/other.png");
  find<QLineEdit>("name").setText("other");
  replace();
  settle();
  EXPECT_EQ(read_file(study_folder() / "stimuli/other.png"), read_file(png));
  EXPECT_TRUE(banner.text().contains("other"));
  find<QLineEdit>("name").setText("brick");
  click("save");
  settle();
  replace();
  settle();
  EXPECT_NEAR(load_height_field(png).field->rms_m(), 300e-6, 1e-6);
}

TEST_F(BrickOnTheWorkbench, SaysWhyANameCannotBeSaved) {
  auto& name = find<QLineEdit>("name");
  for (const char* bad : {"", "a/b", "x y", "wall_photo", "../wall"}) {
    name.setText(bad);
    EXPECT_FALSE(find<QPushButton>("save").isEnabled()) << bad;
    EXPECT_FALSE(find<QLabel>("name_problem").text().isEmpty()) << bad;
  }
  name.setText("wall-2");
  EXPECT_TRUE(find<QPushButton>("save").isEnabled());
}

TEST_F(Workbench, ProposesANameThatCanBeSavedForThePhotographOfAStimulus) {
  drop(photograph("brick", 128));
  click("save");
  settle();
  EXPECT_TRUE(find<QLabel>("name_problem").text().contains("asked before it is replaced"));
  drop(study_folder() / "stimuli/brick_photo.png");
  EXPECT_EQ(find<QLineEdit>("name").text(), "brick_2");
  click("save");
  settle();
  EXPECT_TRUE(std::filesystem::exists(study_folder() / "stimuli/brick_2.png"));
  find<QLineEdit>("name").setText("brick_photo");
  EXPECT_FALSE(find<QPushButton>("save").isEnabled());
  EXPECT_TRUE(find<QLabel>("name_problem").text().contains("Names ending in _photo are reserved"));
}

TEST_F(Workbench, IsUnsavedWhenTheRecipeIsChangedWhileItIsBeingSaved) {
  drop(photograph("brick", 256));
  EXPECT_FALSE(page_->property("keep").toString().isEmpty());
  click("save");
  type("rms_m", "250");
  settle();
  EXPECT_TRUE(find<Banner>("banner").text().startsWith("Saved"));
  EXPECT_FALSE(page_->property("keep").toString().isEmpty());
  find<QLineEdit>("name").setText("rougher");
  click("save");
  settle();
  EXPECT_TRUE(page_->property("keep").toString().isEmpty());
}

TEST_F(Workbench, SavesAllOrNothingWhenSavingIsCancelled) {
  drop(photograph("brick", 256));
  click("save");
  find<TaskLine>("saving").findChild<QPushButton*>("task_cancel")->click();
  settle();
  const std::filesystem::path stimuli = study_folder() / "stimuli";
  // A machine that is busy elsewhere may notice too late.
  const bool in_time = find<Banner>("banner").text().contains("was cancelled");
  for (const char* name : {"brick.png", "brick.png.json", "brick_photo.png"}) {
    EXPECT_EQ(std::filesystem::exists(stimuli / name), !in_time) << name;
  }
  EXPECT_TRUE(find<QPushButton>("save").isEnabled());
}

TEST_F(Workbench, ForgetsAFileWhoseReadingIsCancelled) {
  const std::filesystem::path stone = photograph("stone", 256);
  const std::filesystem::path brick = photograph("brick", 128);
  page_->open_file(stone);
  find<TaskLine>("reading").findChild<QPushButton*>("task_cancel")->click();
  EXPECT_TRUE(page_->is_settled());
  EXPECT_TRUE(find<Banner>("banner").text().contains("was cancelled"));
  drop(brick);  // by then the other has been read to its end, for nobody
  EXPECT_EQ(page_->field()->grid().columns, 128U);
  EXPECT_EQ(find<QLineEdit>("name").text(), "brick");
  EXPECT_FALSE(find<Banner>("banner").isVisible());
}

TEST_F(BrickOnTheWorkbench, SaysOfEverythingThatIsNoPictureWhatItIs) {
  const auto before = page_->field();
  const std::filesystem::path wide = folder() / "wide.png";
  ASSERT_TRUE(QImage(30000, 16, QImage::Format_Grayscale8).save(wide.c_str()));
  const std::filesystem::path words = folder() / "words.png";
  std::ofstream(words) << "a shopping list";
  const std::filesystem::path nothing = folder() / "nothing.jpg";
  std::ofstream(nothing).flush();
  std::filesystem::create_directory(folder() / "pictures.png");
  const std::filesystem::path half = folder() / "half.png";
  std::filesystem::copy_file(folder() / "brick.png", half);
  std::filesystem::resize_file(half, std::filesystem::file_size(half) / 2);
  // Reading it would wait for somebody to write.
  ASSERT_EQ(mkfifo((folder() / "pipe.png").c_str(), 0600), 0);
  const std::filesystem::path huge = folder() / "huge.tif";
  std::ofstream(huge).flush();
  std::filesystem::resize_file(huge, std::uintmax_t{3} << 30U);  // a hole; nobody may read it
  const std::vector<std::pair<std::filesystem::path, const char*>> drops{
      {wide, "30000 by 16 pixels; at most 16384"},
      {words, "is not a picture in a supported format"},
      {nothing, "is empty"},
      {folder() / "pictures.png", "is a folder"},
      {half, "is truncated or damaged"},
      {folder() / "pipe.png", "is not a picture file"},
      {huge, "3.0 GiB in size; pictures of up to 2 GiB"},
      {folder() / "gone.png", "was not found"}};
  for (const auto& [file, words_for_it] : drops) {
    drop(file);
    const auto& banner = find<Banner>("banner");
    EXPECT_TRUE(banner.isVisible()) << file;
    EXPECT_TRUE(banner.text().contains(words_for_it)) << banner.text().toStdString();
    EXPECT_TRUE(banner.text().contains(QString::fromStdString(file.filename().string())));
    EXPECT_EQ(page_->field(), before) << file;
  }
}

TEST_F(Workbench, TakesTheFirstOfSeveralFilesAndSaysSo) {
  const std::filesystem::path brick = photograph("brick", 128);
  std::vector<std::filesystem::path> files{brick};
  for (int k = 1; k < 10; ++k) files.push_back(folder() / ("other" + std::to_string(k) + ".png"));
  drop_all(files);
  ASSERT_NE(page_->field(), nullptr);
  EXPECT_TRUE(find<Banner>("banner").text().startsWith("10 files were dropped"));
  EXPECT_TRUE(find<Banner>("banner").text().contains("brick.png"));
  std::rotate(files.begin(), files.begin() + 1, files.end());
  drop_all(files);  // the first is not there
  EXPECT_TRUE(find<Banner>("banner").text().contains("10 files were dropped"));
  EXPECT_TRUE(find<Banner>("banner").text().contains("other1.png was not found"));
}

TEST_F(Workbench, ReadsSixteenBitsOfATiff) {
  const GreyImage brick = load_photograph(photograph("brick", 128)).photograph.grey;
  GreyImage deep{brick.rows, brick.columns, {}};
  std::vector<std::uint16_t> levels{};
  for (std::size_t i = 0; i < brick.values.size(); ++i) {
    // In steps that eight bits do not have.
    levels.push_back(static_cast<std::uint16_t>(30000.0F + 5000.0F * brick.values[i]));
    deep.values.push_back(static_cast<float>(levels.back()) / 65535.0F);
  }
  write_tiff(folder() / "deep.tif", 128, levels);
  drop(folder() / "deep.tif");
  ASSERT_NE(page_->field(), nullptr) << find<Banner>("banner").text().toStdString();
  EXPECT_EQ(page_->field()->heights_m(),
            texture_from_photograph(deep, {}, "deep").field.heights_m());
}

TEST_F(BrickOnTheWorkbench, SaysThatTransparencyIsLeftOut) {
  const QImage brick(QString::fromStdString(photograph("brick", 128).string()));
  QImage clear = brick.convertToFormat(QImage::Format_ARGB32);
  for (int x = 0; x < 64; ++x) clear.setPixel(x, 5, clear.pixel(x, 5) & 0x00FFFFFFU);
  const std::filesystem::path file = folder() / "clear.png";
  ASSERT_TRUE(clear.save(file.c_str()));
  drop(file);
  ASSERT_NE(page_->field(), nullptr);
  EXPECT_TRUE(find<Banner>("banner").text().contains("alpha channel, which is ignored"));
  const QImage shown = find<StepStrip>("steps").picture(Step::photograph);
  EXPECT_EQ(shown.pixel(9, 5), brick.pixel(9, 5)) << "as it counts";
  drop(folder() / "brick.png");
  EXPECT_FALSE(find<Banner>("banner").isVisible());
}

TEST_F(BrickOnTheWorkbench, SaysThatAPictureLiesAsItIsStored) {
  const QImage brick(QString::fromStdString(photograph("brick", 128).string()));
  const QImage upright = brick.copy(0, 0, 128, 64);
  const std::filesystem::path plain = folder() / "plain.jpg";
  ASSERT_TRUE(upright.save(plain.c_str(), "JPG", 95));
  const std::filesystem::path turned = folder() / "turned.jpg";
  write_turned(turned, read_file(plain));
  drop(turned);
  ASSERT_NE(page_->field(), nullptr) << find<Banner>("banner").text().toStdString();
  EXPECT_TRUE(find<Banner>("banner").text().contains("is shown without this rotation"));
  EXPECT_EQ(page_->field()->grid().columns, 128U);
  EXPECT_EQ(find<StepStrip>("steps").picture(Step::photograph).width(), 128);
  drop(plain);
  EXPECT_FALSE(find<Banner>("banner").isVisible());
}

TEST_F(BrickOnTheWorkbench, KeepsWhatItHasWhenAFileCannotBeUsed) {
  const auto before = page_->field();
  const std::filesystem::path broken = folder() / "broken.png";
  std::ofstream(broken) << "this is no picture";
  drop(broken);
  EXPECT_TRUE(find<Banner>("banner").isVisible());
  EXPECT_TRUE(find<Banner>("banner").text().contains("broken.png"));
  EXPECT_EQ(page_->field(), before);

  const std::filesystem::path tiny = folder() / "tiny.png";
  save_picture(tiny, {.rows = 8, .columns = 8, .values = std::vector<float>(64, 0.5F)},
               Overwrite::refuse);
  drop(tiny);
  EXPECT_TRUE(find<Banner>("banner").text().contains("16"));
  EXPECT_EQ(page_->field(), before);
  EXPECT_TRUE(find<ReliefView>("relief").isVisible());
}

TEST_F(BrickOnTheWorkbench, KeepsTheLastReliefUnderARecipeThatCannotBe) {
  const auto before = page_->field();
  type("gaussian_wavelength_m", "0.5");
  settle();
  EXPECT_TRUE(find<Banner>("recipe_banner").isVisible());
  EXPECT_TRUE(find<Banner>("recipe_banner").text().contains("two pixels"));
  EXPECT_EQ(page_->field(), before);
  type("gaussian_wavelength_m", "6");
  settle();
  EXPECT_FALSE(find<Banner>("recipe_banner").isVisible());
  EXPECT_NE(page_->field(), before);
}

TEST_F(Workbench, ShowsAReliefOfTheStudyWithoutARecipe) {
  drop(photograph("brick", 256));
  click("save");
  settle();
  page_->open_file(study_folder() / "stimuli/brick.png");
  settle();
  EXPECT_TRUE(find<QLabel>("finished").isVisible());
  EXPECT_TRUE(find<QLabel>("finished").text().contains("<b>brick</b>: "));
  // It has neither steps nor a recipe and is saved already: the relief has their room.
  for (const char* name : {"save", "kind", "steps", "comparison"}) {
    EXPECT_FALSE(find<QWidget>(name).isVisible()) << name;
  }
  take_screenshot(*page_, "workbench-finished");
  click("mode_comparing");
  settle();
  EXPECT_FALSE(find<QLabel>("finished").isVisible());
  EXPECT_TRUE(find<QWidget>("comparison").isVisible());
  drop(photograph("brick", 256));
  click("mode_making");
  settle();
  for (const char* name : {"save", "kind", "steps"}) {
    EXPECT_TRUE(find<QWidget>(name).isVisible()) << name;
  }
}

TEST_F(Workbench, OpensAMeasuredSurfaceAsAFinishedRelief) {
  const std::filesystem::path surfaces =
      std::filesystem::path(ASPERITY_SOURCE_DIR) / "tests/stimuli/surfaces";
  for (const char* name : {"by_gwyddion.gwy", "by_gwyddion.sur", "by_x3ptools.x3p"}) {
    drop(surfaces / name);
    ASSERT_NE(page_->field(), nullptr) << name;
    EXPECT_NEAR(page_->field()->mean_m(), 0.0, 1e-9) << name;
    EXPECT_TRUE(find<QLabel>("finished").text().contains("was measured")) << name;
    EXPECT_FALSE(find<QWidget>("save").isVisible()) << name;
  }
  const auto before = page_->field();
  drop(surfaces / "by_tifffile.tif");
  EXPECT_TRUE(find<Banner>("banner").text().contains("neither their unit nor the width"));
  EXPECT_EQ(page_->field(), before);
}

TEST_F(BrickOnTheWorkbench, TurnsUnderTheMouseAndMovesTheLightWithTheRightButton) {
  auto& relief = find<ReliefView>("relief");
  const ReliefLook before = relief.look();
  const QImage picture = relief.picture();
  const auto drag = [&relief](Qt::MouseButton button) {
    QTest::mousePress(&relief, button, {}, {200, 150});
    QMouseEvent moved(QEvent::MouseMove, QPointF(260, 170), relief.mapToGlobal(QPointF(260, 170)),
                      Qt::NoButton, button, Qt::NoModifier);
    QApplication::sendEvent(&relief, &moved);
    QTest::mouseRelease(&relief, button, {}, {260, 170});
  };
  drag(Qt::LeftButton);
  EXPECT_NE(relief.look().turn_rad, before.turn_rad);
  EXPECT_EQ(relief.look().light_azimuth_rad, before.light_azimuth_rad);
  settle();
  EXPECT_NE(relief.picture(), picture);
  const double turned_rad = relief.look().turn_rad;
  drag(Qt::RightButton);
  EXPECT_NE(relief.look().light_azimuth_rad, before.light_azimuth_rad);
  EXPECT_EQ(relief.look().turn_rad, turned_rad);
  QTest::keyClick(&relief, Qt::Key_Home);
  EXPECT_EQ(relief.look().turn_rad, before.turn_rad);
}

TEST_F(BrickOnTheWorkbench, ShowsTheProfileUnderTheMouse) {
  auto& relief = find<ReliefView>("relief");
  const double y_m = 0.02;
  QTest::mouseMove(&relief, relief.position_of({0.01, y_m}).toPoint());
  const auto& profile = find<SignalPlots>("profile").signal_series().front();
  const HeightField& field = *page_->field();
  // The pixel that the mouse met is not exactly the point: some row near it.
  const auto row_at = [&](double at_m) {
    return static_cast<int>(0.5 * 255 - at_m / field.grid().pitch_m);
  };
  bool found = false;
  for (int row = row_at(y_m) - 3; row <= row_at(y_m) + 3; ++row) {
    bool same = true;
    for (int j = 0; j < 256; ++j) {
      same &= profile.y[j] ==
              1e6 * static_cast<double>(field.heights_m()[static_cast<std::size_t>(row * 256 + j)]);
    }
    found |= same;
  }
  EXPECT_TRUE(found);
}

TEST_F(BrickOnTheWorkbench, VisitsBannersInTheOrderOfReading) {
  const std::array banners{&find<Banner>("banner"), &find<Banner>("recipe_banner")};
  for (Banner* banner : banners) banner->show_news(State::look, "A message", "Try again");
  const auto steps = [] { return steps_against_reading(*page_).filter("banner_"); };
  EXPECT_TRUE(eventually([&steps] { return steps().empty(); })) << steps().join('\n').toStdString();
  for (Banner* banner : banners) {
    EXPECT_TRUE(banner->isVisible());
    banner->hide();
  }
}

TEST_F(Workbench, LooksFinished) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) return;  // nothing to look at
  const std::filesystem::path brick = photograph("brick", 1024);
  const std::filesystem::path stone = photograph("stone", 1024, PhotographCase::lambert);
  const auto shoot = [this](const QString& name) {
    for (const QSize& size : {QSize{1366, 768}, QSize{1366, 784}, QSize{1920, 1080}}) {
      page_->resize(size);
      settle();
      take_screenshot(*page_, QString("%1_%2x%3").arg(name).arg(size.width()).arg(size.height()),
                      size);
    }
  };
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, choice);
    const QString look = choice == ThemeChoice::light ? "" : "-dark";
    page_ = std::make_unique<WorkbenchPage>(*study_);
    page_->show();
    shoot("workbench-empty" + look);
    drop(stone);
    shoot("workbench-stone" + look);
    drop(brick);
    shoot("workbench-brick" + look);
    drop_all({folder() / "gone.png", brick});
    auto& reading = find<TaskLine>("reading");
    reading.set_words("Reading brick.png …");
    reading.show();  // as while a large picture is read
    shoot("workbench-refused" + look);
    reading.hide();
    find<Banner>("banner").hide();
    click("step_2");
    shoot("workbench-step" + look);
    click("mode_comparing");
    find<QCheckBox>("model_lateral_gradient").setChecked(true);
    settle();
    click("stroke_across");
    auto& comparison = find<ForceComparison>("comparison");
    ASSERT_TRUE(eventually([&comparison] { return comparison.stroke().path().size() > 1200; }));
    shoot("workbench-forces" + look);
  }
  apply_theme(*qApp, ThemeChoice::light);
}

}  // namespace
}  // namespace asperity

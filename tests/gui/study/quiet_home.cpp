// Makes each study once, and copies it into a temporary home for every test.

#include "tests/gui/study/quiet_home.h"

#include <cmath>
#include <numbers>

#include <QtCore/QSettings>

#include "app/study_files/height_field_files.h"
#include "protocols/file/library_protocols.h"
#include "results_schema/study.h"
#include "stimuli/photographs/preview.h"
#include "tests/gui/study/lively_study.h"

namespace asperity {

namespace {

HeightField waves_across(double count) {
  constexpr std::size_t kPixels = 64;
  std::vector<float> heights_m(kPixels * kPixels);
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    const double column = static_cast<double>(i % kPixels) / kPixels;
    const double row = static_cast<double>(i / kPixels) / kPixels;
    heights_m[i] =
        static_cast<float>(1e-4 * std::sin(2.0 * std::numbers::pi * count * (column + 0.3 * row)));
  }
  return HeightField({kPixels, kPixels, 0.1 / kPixels}, std::move(heights_m));
}

void fill_with_the_chapter(const std::filesystem::path& folder) {
  Study::create(folder, "demo");
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (!protocol.name.starts_with("chapter_")) continue;
    write_file(folder / "protocols" / (std::string(protocol.name) + ".json"), protocol.text,
               Overwrite::refuse);
  }
  double waves = 6.0;
  for (const std::string name : {"metal", "stone", "wood", "brick", "sandpaper", "pebbles"}) {
    const std::filesystem::path file = folder / "stimuli" / name;
    const HeightField field = waves_across(waves++);
    save_height_field(file.string() + "_true.png", field, {.kind = name}, Overwrite::refuse);
    save_picture(file.string() + "_photo.png", height_picture(field), Overwrite::refuse);
    if (name == "sandpaper" || name == "pebbles") continue;
    save_height_field(file.string() + ".png", field, {.kind = "photograph"}, Overwrite::refuse);
  }
}

/// A study that is made once and copied.
struct Pattern {
  template <class... Fill>
  explicit Pattern(Fill... fill) {
    (fill(study), ...);
  }

  TemporaryFolder folder{};
  std::filesystem::path study = folder / "demo";
};

}  // namespace

QuietHome::QuietHome() : former_home_(qgetenv("HOME")) {
  qputenv("HOME", home().c_str());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                     QString::fromStdString((home() / "settings").string()));
  QSettings{}.clear();
}

QuietHome::~QuietHome() { qputenv("HOME", former_home_); }

std::filesystem::path QuietHome::copied(const std::filesystem::path& pattern) const {
  const std::filesystem::path folder = home() / "studies" / "demo";
  std::filesystem::create_directories(folder.parent_path());
  copy(pattern, folder, std::filesystem::copy_options::recursive);
  return folder;
}

std::filesystem::path QuietHome::small_demo_study() const {
  static const Pattern pattern(fill_with_the_chapter);
  return copied(pattern.study);
}

std::filesystem::path QuietHome::lively_study() const {
  static const Pattern pattern(fill_with_the_chapter, fill_with_participants);
  return copied(pattern.study);
}

}  // namespace asperity

// The stimuli of a study: its files, and the bodies of its protocols.

#include <filesystem>
#include <string>
#include <utility>

#include "app/gui/base/open_study.h"
#include "app/gui/base/study_table.h"
#include "protocols/file/library_protocols.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/study/pages_of_a_window.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

TEST_F(StudyPages, ShowStimuliWithWhatUsesThem) {
  open_demo();
  const StudyTable& table = table_of("stimuli", "stimuli_table", 16);
  // Where "brick_photo.png" stands is for the locale to say.
  const int brick = static_cast<int>(column(table, 0).indexOf("brick.png"));
  const int photo = static_cast<int>(column(table, 0).indexOf("brick_photo.png"));
  ASSERT_GE(brick, 0);
  ASSERT_GE(photo, 0);
  EXPECT_EQ(table.text_at(brick, 1), "height field (photograph)");
  EXPECT_EQ(table.text_at(brick, 2), "100 × 100");
  EXPECT_EQ(table.text_at(brick, 3), "64 × 64");
  EXPECT_TRUE(table.text_at(brick, 6).contains("chapter_recognition"));
  EXPECT_EQ(table.text_at(photo, 1), "picture");
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
    window_.resize(size);
    EXPECT_TRUE(eventually([&] { return cut_cells(table).isEmpty(); }))
        << size.width() << ": " << cut_cells(table).join(" | ").toStdString();
  }
  std::filesystem::remove(window_.study()->folder() / "stimuli" / "brick.png");
  EXPECT_TRUE(eventually([&] { return table.shown_rows() == 15; }));
}

TEST_F(StudyPages, ShowTheBodiesOfProtocolsWithAPicture) {
  open_demo();
  std::string protocol{};
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name == "tools_matching") protocol = each.text;
  }
  const std::pair<std::string, std::string> reliefs[] = {{"file_fine", "metal"},
                                                         {"file_medium", "stone"},
                                                         {"file_coarse", "wood"},
                                                         {"file_plate", "brick"}};
  for (const auto& [theirs, ours] : reliefs) {
    for (std::size_t at = 0; (at = protocol.find(theirs)) != std::string::npos;) {
      protocol.replace(at, theirs.size(), ours);
    }
  }
  write_file(window_.study()->folder() / "protocols" / "tools.json", protocol, Overwrite::refuse);
  const StudyTable& table = table_of("stimuli", "stimuli_table", 20);
  const auto row_of = [&table](const QString& name) {
    int row = 0;
    while (row < table.shown_rows() && table.text_at(row, 0) != name) ++row;
    return row;
  };
  const int fine = row_of("fine");
  ASSERT_LT(fine, 20);
  EXPECT_TRUE(table.text_at(fine, 1).startsWith("cylinder of "));
  EXPECT_EQ(table.text_at(fine, 2), "7.64 × 8 × 7.64");
  EXPECT_EQ(table.text_at(fine, 6), "tools_matching");
  EXPECT_TRUE(table.text_at(row_of("studded_plate"), 1).startsWith("plate of "));
  const QIcon icon = table.model()->index(fine, 0).data(Qt::DecorationRole).value<QIcon>();
  const QImage picture = icon.pixmap(72, 72).toImage();
  // The body in the middle, nothing around it.
  EXPECT_GT(picture.pixelColor(picture.width() / 2, picture.height() / 2).alpha(), 200);
  EXPECT_EQ(picture.pixelColor(1, 1).alpha(), 0);
  take_screenshot(window_, "study-stimuli-bodies");
}

}  // namespace
}  // namespace asperity

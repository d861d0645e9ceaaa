// Stimuli are renamed, deleted and copied on their page, with the consequences shown before.

#include <QtWidgets/QListWidget>

#include "app/gui/base/command_lines.h"
#include "app/gui/study/copy_stimuli_dialog.h"
#include "app/study_files/rendering_files.h"
#include "tests/gui/stimuli/window_with_reliefs.h"

namespace asperity {
namespace {

using testing::HasSubstr;

class StimuliPageTest : public WindowWithReliefs {};

TEST_F(StimuliPageTest, RenamesAStimulusWithItsReferences) {
  StudyTable& table = stimuli(3);
  EXPECT_FALSE(child<QPushButton>(window_, "stimulus_rename").isEnabled());
  EXPECT_EQ(words("stimulus_reason"), "Choose a stimulus to open, rename or delete it.");
  table.select("stimuli/brick.png");
  click("stimulus_rename");
  auto& name = child<QLineEdit>(window_, "stimulus_name");
  ASSERT_TRUE(eventually([&] { return name.isVisible(); }));
  EXPECT_EQ(words("stimulus_question"),
            "New name of brick.png (without its ending). Renamed with it: brick.png.json. The "
            "references are changed in: semantic_differential.json.");
  EXPECT_EQ(name.text(), "brick");
  EXPECT_TRUE(name.hasFocus());
  take_screenshots(window_, "stimuli-rename");
  QTest::keyClicks(&name, "noise");
  QTest::keyClick(&name, Qt::Key_Return);
  ASSERT_TRUE(eventually([&] { return news().contains("already has a file noise.png"); }))
      << news().toStdString();
  name.selectAll();
  QTest::keyClicks(&name, "wall");
  const auto& actions = child<QWidget>(window_, "stimulus_actions");
  EXPECT_EQ(command_of(actions).toStdString(), rename_stimulus_line(stimulus("brick.png"), "wall"));
  QTest::keyClick(&name, Qt::Key_Return);
  for (const char* const button : {"stimulus_rename", "stimulus_delete", "stimulus_act"}) {
    EXPECT_FALSE(child<QPushButton>(window_, button).isEnabled()) << button;
  }
  emit name.returnPressed();  // a second Return renames nothing
  ASSERT_TRUE(eventually([&] { return table.selected_key() == "stimuli/wall.png"; }));
  EXPECT_FALSE(name.isVisible());
  EXPECT_FALSE(news().contains("brick")) << news().toStdString();
  EXPECT_TRUE(child<QPushButton>(window_, "stimulus_rename").isEnabled());
  EXPECT_FALSE(std::filesystem::exists(stimulus("brick.png")));
  EXPECT_THAT(read_file(protocol_), HasSubstr("\"stimuli/wall.png\""));
  EXPECT_THAT(read_file(protocol_), testing::Not(HasSubstr("\"stimuli/brick.png\"")));
}

TEST_F(StimuliPageTest, DeletesOnlyWhatNothingRefersTo) {
  save_height_field(stimulus("spare.png"),
                    make_surface("noise", {}, {.width_m = 0.02, .pixels = 128}), {.kind = "noise"},
                    Overwrite::refuse);
  StudyTable& table = stimuli(4);
  table.select("stimuli/noise.png");
  click("stimulus_delete");
  ASSERT_TRUE(eventually([&] { return !news().isEmpty(); }));
  EXPECT_EQ(
      news().trimmed(),
      "noise.png is used by semantic_differential.json. Remove it there before you delete it.");
  EXPECT_FALSE(child<QLabel>(window_, "stimulus_question").isVisible());
  table.select("stimuli/spare.png");
  click("stimulus_delete");
  auto& act = child<QPushButton>(window_, "stimulus_act");
  ASSERT_TRUE(eventually([&] { return act.isVisible(); }));
  EXPECT_EQ(
      words("stimulus_question"),
      "Delete spare.png.json, spare.png? Nothing refers to it. The files cannot be restored.");
  EXPECT_TRUE(child<QPushButton>(window_, "stimulus_cancel").hasFocus())
      << "Return deletes nothing";
  EXPECT_EQ(nameless_controls(window_), QStringList{});
  EXPECT_EQ(steps_against_reading(window_), QStringList{});
  EXPECT_EQ(command_of(child<QWidget>(window_, "stimulus_actions")).toStdString(),
            delete_stimulus_line(stimulus("spare.png")));
  QTest::keyClick(&act, Qt::Key_Escape);
  EXPECT_FALSE(act.isVisible());
  EXPECT_TRUE(std::filesystem::exists(stimulus("spare.png")));
  click("stimulus_delete");
  ASSERT_TRUE(eventually([&] { return act.isVisible(); }));
  click("stimulus_act");
  ASSERT_TRUE(eventually([&] { return table.shown_rows() == 3; }));
  EXPECT_FALSE(std::filesystem::exists(stimulus("spare.png")));
  EXPECT_FALSE(std::filesystem::exists(stimulus("spare.png.json")));
}

TEST_F(StimuliPageTest, StatesWhosePhotographAPictureIs) {
  save_picture(stimulus("brick_photo.png"), {2, 2, {0.0F, 1.0F, 1.0F, 0.0F}}, Overwrite::refuse);
  stimuli(4).select("stimuli/brick_photo.png");
  auto& act = child<QPushButton>(window_, "stimulus_act");
  click("stimulus_delete");
  ASSERT_TRUE(eventually([&] { return act.isVisible(); }));
  EXPECT_EQ(words("stimulus_question"),
            "Delete brick_photo.png? It is the photograph of brick.png. The file cannot be "
            "restored.");
  QTest::keyClick(&act, Qt::Key_Escape);
  click("stimulus_rename");
  ASSERT_TRUE(eventually([&] { return act.isVisible(); }));
  EXPECT_EQ(words("stimulus_question"),
            "New name of brick_photo.png (without its ending). No reference is changed. It is the "
            "photograph of brick.png, which has none under another name.");
}

TEST_F(StimuliPageTest, CopiesFromAnotherStudyWhatIsNotThere) {
  const std::filesystem::path other = home() / "other";
  new_study(other);
  for (const auto& [name, seed] : {std::pair{"brick.png", 9}, std::pair{"sand.png", 3}}) {
    save_height_field(
        other / "stimuli" / name,
        make_surface("noise", {},
                     {.width_m = 0.02, .pixels = 128, .seed = static_cast<std::uint64_t>(seed)}),
        {.kind = "noise"}, Overwrite::refuse);
  }
  const std::string before = read_file(stimulus("brick.png"));
  StudyTable& table = stimuli(3);
  click("stimuli_copy");
  auto& dialog = child<CopyStimuliDialog>(window_, "copy_stimuli_dialog");
  EXPECT_FALSE(child<QPushButton>(dialog, "copy_copy").isEnabled());
  dialog.show_study(other);
  auto& list = child<QListWidget>(dialog, "copy_list");
  ASSERT_TRUE(eventually([&] { return list.count() == 2; }));
  EXPECT_EQ(list.item(0)->text(), "brick.png (this study has another file of this name)");
  EXPECT_FALSE(list.item(0)->flags().testFlag(Qt::ItemIsUserCheckable));
  list.item(1)->setCheckState(Qt::Checked);
  EXPECT_EQ(nameless_controls(dialog), QStringList{});
  take_screenshots(dialog, "copy-stimuli");
  EXPECT_EQ(state_in(dialog, "copy_state"),
            "✓ Files to copy: sand.png.json, sand.png. No file is replaced.");
  EXPECT_TRUE(child<QPushButton>(dialog, "copy_copy").isEnabled());
  EXPECT_EQ(command_of(dialog).toStdString(),
            copy_stimuli_line({other / "stimuli" / "sand.png"}, folder()));
  dialog.show_study(home());
  EXPECT_FALSE(child<QPushButton>(dialog, "copy_copy").isEnabled());
  auto& state = child<StateLabel>(dialog, "copy_state");
  ASSERT_TRUE(eventually([&] { return state.state() == State::stop; }));
  EXPECT_FALSE(child<QPushButton>(dialog, "copy_copy").isEnabled()) << "not a study";
  dialog.show_study(other);
  ASSERT_TRUE(eventually([&] { return list.count() == 2; }));
  list.item(1)->setCheckState(Qt::Checked);
  click("copy_copy", dialog);
  ASSERT_TRUE(eventually([&] { return table.shown_rows() == 4; }));
  EXPECT_TRUE(news().contains("1 stimulus was copied.")) << news().toStdString();
  EXPECT_EQ(load_height_field(stimulus("sand.png")).sha256,
            load_height_field(other / "stimuli" / "sand.png").sha256);
  EXPECT_EQ(read_file(stimulus("brick.png")), before);
}

}  // namespace
}  // namespace asperity

// The compared force models are saved as renderings, and their values are copied into a protocol in the editor.

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>

#include "app/gui/base/command_lines.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/study/use_rendering_dialog.h"
#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/parameter_form.h"
#include "app/gui/workbench/workbench_page.h"
#include "app/study_files/rendering_files.h"
#include "app/study_files/study_protocols.h"
#include "tests/gui/stimuli/window_with_reliefs.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class RenderingsTest : public WindowWithReliefs {
 protected:
  WorkbenchPage& compare(const char* relief) {
    stimuli(3).select(QString("stimuli/") + relief);
    click("stimulus_open");
    auto& page = child<WorkbenchPage>(window_, "workbench");
    settle(page);
    QTest::mouseClick(&child<QAbstractButton>(page, "mode_comparing"), Qt::LeftButton);
    settle(page);
    return page;
  }
  static void settle(const WorkbenchPage& page) {
    require([&] { return page.is_settled() && page.field() != nullptr; }, "settled workbench");
  }
  static void choose_only(const WorkbenchPage& page, const char* model) {
    for (auto* box : page.findChildren<QCheckBox*>()) {
      if (box->objectName().startsWith("model_")) {
        box->setChecked(box->objectName() == QString("model_") + model);
      }
    }
    settle(page);
  }
  UseRenderingDialog& dialog() {
    require([this] { return window_.findChild<UseRenderingDialog*>() != nullptr; }, "dialog");
    auto& found = child<UseRenderingDialog>(window_, "use_rendering_dialog");
    require([&] { return child<StateLabel>(found, "use_state").state() != State::unknown; },
            "checked protocol");
    return found;
  }
  static QString state(const QWidget& dialog) { return state_in(dialog, "use_state"); }
  ProtocolEditorPage& editor() { return child<ProtocolEditorPage>(window_, "editor_page"); }
};

TEST_F(RenderingsTest, AreSavedFromTheWorkbenchWithTheirValues) {
  WorkbenchPage& page = compare("brick.png");
  choose_only(page, "height_map");
  auto& scale =
      child<QDoubleSpinBox>(child<ParameterForm>(page, "form_height_map"), "height_scale");
  scale.setFocus();
  scale.selectAll();
  QTest::keyClicks(&scale, "2");
  QTest::keyClick(&scale, Qt::Key_Tab);
  settle(page);
  EXPECT_EQ(words("rendering_note"),
            "Will be saved in stimuli/ as brick_height_map.rendering.json.");
  take_screenshots(window_, "workbench-renderings");
  click("rendering_save");
  ASSERT_TRUE(eventually([&] { return !rendering_files(folder()).empty(); }));
  settle(page);
  const Rendering saved = load_rendering(rendering_file(folder(), "brick_height_map"));
  EXPECT_EQ(number_of(saved.parameters, "height_scale"), 2.0);
  EXPECT_EQ(saved.texture.sha256, load_height_field(stimulus("brick.png")).sha256);
  EXPECT_EQ(saved.material.friction, 0.2);
  const std::string before = read_file(rendering_file(folder(), "brick_height_map"));
  scale.setValue(3.0);
  emit scale.editingFinished();
  settle(page);
  click("rendering_save");
  ASSERT_TRUE(eventually([&] { return news().contains("were not saved"); }))
      << news().toStdString();
  EXPECT_EQ(read_file(rendering_file(folder(), "brick_height_map")), before)
      << "nothing is replaced";
}

TEST_F(RenderingsTest, AreReachedInASmallWindow) {
  const WorkbenchPage& page = compare("brick.png");
  const auto place_of = [&page](const char* name) {
    const auto& control = child<QWidget>(page, name);
    return QRect(control.mapTo(&page, QPoint(0, 0)), control.size());
  };
  const auto is_whole = [&](const char* name) {
    return page.rect().contains(place_of(name)) &&
           place_of(name).width() >= child<QWidget>(page, name).sizeHint().width();
  };
  const auto& area = child<QScrollArea>(page, "workspace");
  window_.resize(910, 512);
  for (const char* const name :
       {"mode_making", "mode_comparing", "open_height_field", "open_photograph"}) {
    EXPECT_TRUE(eventually([&] { return is_whole(name); })) << name;
  }
  EXPECT_TRUE(eventually([&] {
    return place_of("mode_comparing").bottom() < place_of("open_photograph").top() &&
           place_of("open_photograph").bottom() < place_of("workspace").top();
  }));
  const auto& use = child<QPushButton>(page, "rendering_use");
  EXPECT_TRUE(eventually([&] {
    const QRect place(use.mapTo(area.widget(), QPoint(0, 0)), use.size());
    return area.widget()->rect().contains(place);
  }));
  window_.resize(1280, 720);
  EXPECT_TRUE(eventually([&] {
    return place_of("mode_comparing").center().y() == place_of("open_photograph").center().y();
  }));
  EXPECT_TRUE(eventually([&] { return is_whole("rendering_use"); }));
  EXPECT_TRUE(eventually([&] {
    return !area.horizontalScrollBar()->isVisible() && !area.verticalScrollBar()->isVisible();
  }));
}

TEST_F(RenderingsTest, AreNotSavedForAReliefThatHasChanged) {
  choose_only(compare("brick.png"), "height_map");
  save_height_field(stimulus("brick.png"),
                    make_surface("noise", {}, {.width_m = 0.02, .pixels = 128, .seed = 9}),
                    {.kind = "noise"}, Overwrite::allow);
  click("rendering_save");
  ASSERT_TRUE(eventually([&] { return news().contains("has changed since it was opened"); }))
      << news().toStdString();
  EXPECT_TRUE(rendering_files(folder()).empty());
}

TEST_F(RenderingsTest, AreNotThoseOfModelsThatNeedMore) {
  WorkbenchPage& page = compare("brick.png");
  choose_only(page, "recorded");
  EXPECT_FALSE(child<QPushButton>(page, "rendering_save").isEnabled());
  EXPECT_EQ(words("rendering_note"),
            "A rendering contains neither bodies nor recordings; left out: Recorded.");
  choose_only(page, "height_map");
  EXPECT_TRUE(child<QPushButton>(page, "rendering_save").isEnabled());
  auto& body = child<QComboBox>(child<ParameterForm>(page, "surface"), "body");
  body.setCurrentIndex(1);
  emit body.activated(1);
  settle(page);
  EXPECT_FALSE(child<QPushButton>(page, "rendering_save").isEnabled());
  EXPECT_TRUE(words("rendering_note").startsWith("A rendering lies on the plane."))
      << words("rendering_note").toStdString();
}

TEST_F(RenderingsTest, AreUsedInAProtocolAsOneStepOfTheEditor) {
  WorkbenchPage& page = compare("brick.png");
  choose_only(page, "lateral_gradient");
  click("rendering_use");
  UseRenderingDialog& use = dialog();
  EXPECT_EQ(child<QComboBox>(use, "use_protocol").currentText(), "semantic_differential");
  EXPECT_EQ(child<QComboBox>(use, "use_surface").currentText(), "Replace “rendered”");
  EXPECT_TRUE(child<QCheckBox>(use, "use_keeps_texture").isChecked());
  EXPECT_EQ(child<QCheckBox>(use, "use_keeps_texture").text(),
            "Keep its textures, the levels of “texture”");
  EXPECT_EQ(state(use), "✓ The changed protocol is valid.");
  auto& changes = child<StudyTable>(use, "use_changes");
  QStringList rows{};
  for (int row = 0; row < changes.shown_rows(); ++row) {
    rows << changes.text_at(row, 0) + ": " + changes.text_at(row, 1) + " > " +
                changes.text_at(row, 2);
  }
  EXPECT_TRUE(
      rows.contains("Surfaces › Stimuli › rendered › Force model: height_map > lateral_gradient"))
      << rows.join('\n').toStdString();
  EXPECT_TRUE(
      rows.contains("Surfaces › Stimuli › rendered › x-rendering: none > brick_lateral_gradient"));
  EXPECT_EQ(nameless_controls(use), QStringList{});
  EXPECT_EQ(steps_against_reading(use), QStringList{});
  take_screenshots(use, "use-rendering");
  EXPECT_EQ(command_of(use).toStdString(),
            use_rendering_line(rendering_file(folder(), "brick_lateral_gradient"), protocol_,
                               {.replaced = "rendered", .keeps_texture = true}, {}));
  const std::string before = read_file(protocol_);
  click("use_change", use);
  ASSERT_TRUE(eventually([&] { return window_.shown_page() == "editor"; }));
  EXPECT_EQ(editor().file(), protocol_);
  EXPECT_TRUE(editor().has_unsaved_changes());
  EXPECT_THAT(editor().content(), HasSubstr("\"x-rendering\": \"brick_lateral_gradient\""));
  EXPECT_EQ(read_file(protocol_), before) << "saved in the editor alone";
  EXPECT_TRUE(news().contains("Undo takes them back")) << news().toStdString();
  ASSERT_TRUE(eventually([&] { return editor().is_checked() && editor().result() != nullptr; }));
  EXPECT_TRUE(editor().result()->is_valid());
  child<ProtocolTextEdit>(window_, "editor_text").undo();
  EXPECT_EQ(editor().content(), before) << "one step";
}

TEST_F(RenderingsTest, AreUsedInTheProtocolThatWasChosenLast) {
  const std::filesystem::path second = protocol_.parent_path() / "a_second.json";
  write_file(second, with_protocol_name(read_file(protocol_), "a_second"), Overwrite::refuse);
  choose_only(compare("brick.png"), "lateral_gradient");
  click("rendering_use");
  UseRenderingDialog& use = dialog();
  auto& protocol = child<QComboBox>(use, "use_protocol");
  auto& change = child<QPushButton>(use, "use_change");
  protocol.setCurrentText("semantic_differential");
  QTest::qSleep(100);  // its check has begun, and is delivered after the next choice
  protocol.setCurrentText("a_second");
  EXPECT_FALSE(change.isEnabled());
  ASSERT_TRUE(eventually([&] { return change.isEnabled(); }));
  QTest::mouseClick(&change, Qt::LeftButton);
  ASSERT_TRUE(eventually([&] { return window_.shown_page() == "editor"; }));
  EXPECT_EQ(editor().file(), second);
  EXPECT_EQ(protocol_name(editor().content()), "a_second");
  EXPECT_THAT(editor().content(), HasSubstr("\"x-rendering\""));
}

TEST_F(RenderingsTest, AreNotUsedInAFileThatTheEditorCannotKeep) {
  std::string mixed = read_file(protocol_);
  mixed.replace(mixed.find('\n'), 1, "\r\n");
  write_file(protocol_, mixed, Overwrite::allow);
  choose_only(compare("brick.png"), "lateral_gradient");
  click("rendering_use");
  click("use_change", dialog());
  ASSERT_TRUE(eventually([&] { return window_.shown_page() == "editor"; }));
  EXPECT_TRUE(news().contains("its line endings are mixed")) << news().toStdString();
  EXPECT_FALSE(news().contains("meanwhile")) << news().toStdString();
  EXPECT_FALSE(editor().has_unsaved_changes());
  EXPECT_EQ(read_file(protocol_), mixed);
}

TEST_F(RenderingsTest, StateTheWarningsThatTheirUseCauses) {
  choose_only(compare("brick.png"), "lateral_gradient");
  click("rendering_use");
  UseRenderingDialog& use = dialog();
  EXPECT_EQ(state(use), "✓ The changed protocol is valid.");
  child<QCheckBox>(use, "use_keeps_texture").setChecked(false);
  EXPECT_TRUE(eventually([&] {
    return state(use) == "▲ The changed protocol is valid, with warnings.";
  })) << state(use).toStdString();
  const QString remarks = child<QLabel>(use, "use_remarks").text();
  EXPECT_TRUE(remarks.contains("▲ Task › Blocks › ratings: every trial presents the same surface"))
      << remarks.toStdString();
  EXPECT_FALSE(remarks.contains("break")) << "a warning that the protocol had before";
  EXPECT_TRUE(child<QPushButton>(use, "use_change").isEnabled());
}

TEST_F(RenderingsTest, AreAddedToTheTextThatIsBeingEdited) {
  save_rendering(folder(), "grainy",
                 {.model = "height_map",
                  .version = window_.study()->models().find("height_map")->declaration.version,
                  .texture = {"stimuli/noise.png", load_height_field(stimulus("noise.png")).sha256},
                  .parameters = complete_values(
                      window_.study()->models().find("height_map")->declaration, {})});
  window_.show_page("protocols");
  auto& protocols = child<StudyTable>(window_, "protocols_table");
  ASSERT_TRUE(eventually([&] { return protocols.shown_rows() == 1; }));
  protocols.select(QString::fromStdString(protocol_.string()));
  click("protocol_edit");
  auto& text = child<ProtocolTextEdit>(window_, "editor_text");
  text.moveCursor(QTextCursor::End);
  text.insertPlainText("\n");
  const std::string edited = editor().content();
  stimuli(4).select("stimuli/grainy.rendering.json");
  click("stimulus_use");
  UseRenderingDialog& use = dialog();
  child<QComboBox>(use, "use_surface").setCurrentText("Add a surface");
  ASSERT_TRUE(eventually([&] { return state(use).contains("No block presents the new surface"); }))
      << state(use).toStdString();
  click("use_change", use);
  ASSERT_TRUE(eventually([&] { return window_.shown_page() == "editor"; }));
  EXPECT_THAT(editor().content(), HasSubstr("\"grainy\":"));
  text.undo();
  EXPECT_EQ(editor().content(), edited);
}

TEST_F(RenderingsTest, WithAChangedTextureAreNamedAndOpenedInTheWorkbench) {
  const ModelDeclaration& model = window_.study()->models().find("lateral_gradient")->declaration;
  save_rendering(folder(), "old",
                 {.model = model.id,
                  .version = model.version,
                  .texture = {"stimuli/noise.png", std::string(64, '0')},
                  .parameters = complete_values(model, {}),
                  .material = {.stiffness_N_per_m = 800.0, .friction = 0.4}});
  StudyTable& table = stimuli(4);
  table.select("stimuli/old.rendering.json");
  QString kind{};
  for (int row = 0; row < table.shown_rows(); ++row) {
    if (table.text_at(row, 0) == "old.rendering.json") kind = table.text_at(row, 1);
  }
  EXPECT_TRUE(kind.startsWith("▲ stimuli/noise.png has changed")) << kind.toStdString();
  take_screenshots(window_, "stimuli-rendering");
  click("stimulus_open");
  auto& page = child<WorkbenchPage>(window_, "workbench");
  settle(page);
  EXPECT_TRUE(news().contains("stimuli/noise.png has changed")) << news().toStdString();
  const auto choices = child<ForceComparison>(page, "comparison").choices();
  EXPECT_TRUE(choices.chosen.at("lateral_gradient"));
  EXPECT_FALSE(choices.chosen.at("height_map"));
  EXPECT_EQ(number_of(choices.surface.given, "friction"), 0.4);
}

TEST_F(RenderingsTest, AreUsedInAProtocolFromATemplate) {
  std::filesystem::remove(protocol_);
  WorkbenchPage& page = compare("wood.png");
  choose_only(page, "height_map");
  click("rendering_use");
  UseRenderingDialog& use = dialog();
  EXPECT_EQ(state(use), "▲ The study has no protocol yet. Create one from a template.");
  click("use_template", use);
  auto& choice = child<QDialog>(use, "template_dialog");
  auto& templates = child<StudyTable>(choice, "template_table");
  ASSERT_TRUE(eventually([&] { return templates.shown_rows() == 26; }));
  templates.select("semantic_differential");
  const auto& create = child<QPushButton>(choice, "template_create");
  ASSERT_TRUE(eventually([&] { return create.isEnabled(); })) << "its textures are chosen";
  click("template_create", choice);
  ASSERT_TRUE(eventually([&] { return state(use).startsWith("✓"); })) << state(use).toStdString();
  EXPECT_EQ(child<QComboBox>(use, "use_protocol").currentText(), "semantic_differential");
  EXPECT_TRUE(child<QPushButton>(use, "use_change").isEnabled());
}

}  // namespace
}  // namespace asperity

// Textures with known heights are computed in the window as `asperity synth` computes them.

#include "app/gui/workbench/surface_dialog.h"

#include <QtCore/QProcess>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLineEdit>

#include "app/gui/base/settings.h"
#include "app/gui/workbench/parameter_form.h"
#include "tests/gui/stimuli/window_with_reliefs.h"

namespace asperity {
namespace {

class SurfaceDialogTest : public WindowWithReliefs {
 protected:
  SurfaceDialog& open() {
    stimuli(3);
    click("stimuli_generate");
    auto& dialog = child<SurfaceDialog>(window_, "surface_dialog");
    settle(dialog);
    return dialog;
  }
  static void settle(const SurfaceDialog& dialog) {
    require([&] { return dialog.is_settled(); }, "settled dialog");
  }
  static void type(const QWidget& form, const char* name, const char* text) {
    auto& field = child<QDoubleSpinBox>(form, name);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Tab);
  }
};

TEST_F(SurfaceDialogTest, OffersWhatTheSurfacesDeclare) {
  SurfaceDialog& dialog = open();
  const auto surfaces = synthetic_surfaces();
  auto& kinds = child<QComboBox>(dialog, "surface_kind");
  ASSERT_EQ(kinds.count(), static_cast<int>(surfaces.size()));
  for (int i = 0; i < kinds.count(); ++i) {
    const SurfaceDeclaration& surface = surfaces[static_cast<std::size_t>(i)];
    kinds.setCurrentIndex(i);
    settle(dialog);
    auto& form = child<ParameterForm>(dialog, ("surface_" + surface.kind).c_str());
    EXPECT_TRUE(form.isVisible()) << surface.kind;
    EXPECT_EQ(form.parameters().size(), surface.parameters.size());
    EXPECT_FALSE(child<QLabel>(dialog, "surface_picture").pixmap().isNull());
    EXPECT_TRUE(child<QPushButton>(dialog, "surface_save").isEnabled()) << surface.kind;
  }
  EXPECT_EQ(nameless_controls(dialog), QStringList{});
  EXPECT_EQ(steps_against_reading(dialog), QStringList{});
}

TEST_F(SurfaceDialogTest, NamesSurfacesAndParametersInGermanInGermanWindows) {
  apply_language("de");
  SurfaceDialog& dialog = open();
  auto& kinds = child<QComboBox>(dialog, "surface_kind");
  kinds.setCurrentText("Gitter");
  settle(dialog);
  EXPECT_EQ(child<QLineEdit>(dialog, "surface_name").text(), "grating") << "the word in files";
  const auto& form = child<ParameterForm>(dialog, "surface_grating");
  EXPECT_EQ(child<QDoubleSpinBox>(form, "ridge_width_m").accessibleName(), "Stegbreite");
  take_screenshot(dialog, "german-surface-dialog", {1280, 720});
  apply_language("en");
}

TEST_F(SurfaceDialogTest, ShowsAndSavesTheNewestValues) {
  SurfaceDialog& dialog = open();
  child<QComboBox>(dialog, "surface_kind").setCurrentText("Grating");
  settle(dialog);
  const QString before = child<QLabel>(dialog, "surface_facts").text();
  type(child<ParameterForm>(dialog, "surface_grating"), "height_m", "250");
  type(child<ParameterForm>(dialog, "surface_canvas"), "pixels", "512");
  settle(dialog);
  EXPECT_NE(child<QLabel>(dialog, "surface_facts").text(), before);
  EXPECT_TRUE(child<QLabel>(dialog, "surface_facts").text().contains("250"))
      << before.toStdString();
  take_screenshots(dialog, "surface-dialog");
  auto& name = child<QLineEdit>(dialog, "surface_name");
  EXPECT_EQ(name.text(), "grating");
  name.setText("brick");
  EXPECT_FALSE(child<QPushButton>(dialog, "surface_save").isEnabled());
  EXPECT_EQ(state_in(dialog, "surface_state"),
            "✕ The study already has a stimulus “brick”. Choose another name.");
  name.setText("ridges");
  click("surface_save", dialog);
  StudyTable& table = stimuli(4);
  EXPECT_TRUE(eventually([&] { return table.selected_key() == "stimuli/ridges.png"; }));
  const LoadedHeightField saved = load_height_field(stimulus("ridges.png"));
  EXPECT_EQ(saved.field->grid().rows, 512U);
  EXPECT_NEAR(saved.field->maximum_m() - saved.field->minimum_m(), 250e-6, 1e-6);
}

TEST_F(SurfaceDialogTest, ShowsTheCommandThatGivesTheSameFiles) {
  SurfaceDialog& dialog = open();
  child<QComboBox>(dialog, "surface_kind").setCurrentText("Noise");
  type(child<ParameterForm>(dialog, "surface_noise"), "rms_m", "37.5");
  type(child<ParameterForm>(dialog, "surface_canvas"), "pixels", "512");
  type(child<ParameterForm>(dialog, "surface_canvas"), "seed", "12");
  child<QLineEdit>(dialog, "surface_name").setText("made");
  settle(dialog);
  click("show_commands", dialog);
  const QString line = child<QLineEdit>(window_, "command_1").text();
  EXPECT_TRUE(line.startsWith("asperity synth noise --out ")) << line.toStdString();
  child<QWidget>(window_, "commands").close();
  click("surface_save", dialog);
  stimuli(4);
  const std::string png = read_file(stimulus("made.png"));
  const std::string sidecar = read_file(stimulus("made.png.json"));
  std::filesystem::remove(stimulus("made.png"));
  std::filesystem::remove(stimulus("made.png.json"));
  QProcess shell;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  const std::filesystem::path program = ASPERITY_PROGRAM;
  environment.insert("PATH", QString::fromStdString(program.parent_path().string()) + ':' +
                                 environment.value("PATH"));
  shell.setProcessEnvironment(environment);
  shell.start("/bin/sh", {"-c", line});
  ASSERT_TRUE(shell.waitForFinished(kPatience_ms));
  EXPECT_EQ(shell.exitCode(), 0) << shell.readAllStandardError().toStdString();
  EXPECT_EQ(read_file(stimulus("made.png")), png);
  EXPECT_EQ(read_file(stimulus("made.png.json")), sidecar);
}

TEST_F(SurfaceDialogTest, StatesWhyASurfaceCannotBeComputed) {
  SurfaceDialog& dialog = open();
  child<QComboBox>(dialog, "surface_kind").setCurrentText("Sinusoid");
  settle(dialog);
  type(child<ParameterForm>(dialog, "surface_sinusoid"), "spacing_m", "3.3");
  settle(dialog);
  EXPECT_EQ(
      child<QLabel>(dialog, "surface_warnings").text(),
      "▲ 100 mm along x contain 30.3 spacings of 3.3 mm. Where the surface is repeated, the "
      "last one is cut, which makes an unintended step. Choose a width of 99 mm or 102.3 mm.");
  type(child<ParameterForm>(dialog, "surface_canvas"), "pixels", "128");
  settle(dialog);
  EXPECT_TRUE(child<QLabel>(dialog, "surface_warnings")
                  .text()
                  .endsWith("Choose at least 243 samples per side."))
      << child<QLabel>(dialog, "surface_warnings").text().toStdString();
  type(child<ParameterForm>(dialog, "surface_canvas"), "pixels", "16");
  settle(dialog);
  EXPECT_FALSE(child<QPushButton>(dialog, "surface_save").isEnabled());
  EXPECT_EQ(child<StateLabel>(dialog, "surface_state").state(), State::stop);
}

}  // namespace
}  // namespace asperity

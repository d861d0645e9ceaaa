// The precision of a protocol next to the editor: what has to be stated, figures that follow the inputs, and when nothing is computed.

#include <memory>
#include <string>

#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/study_table.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/precision/assumption_fields.h"
#include "app/gui/precision/precision_view.h"
#include "protocols/file/protocol_reader.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/accessible.h"
#include "tests/gui/support/screenshot.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

constexpr const char* kOrder = "comparisons.rougher.order";
constexpr const char* kOrderSd = "comparisons.rougher.order_sd";
constexpr int kLongerThanAPortion_ms = 1500;

class PrecisionOfAProtocol : public QuietHome {
 protected:
  PrecisionOfAProtocol() {
    view_.resize(480, 600);
    view_.show();
  }
  static std::shared_ptr<const Protocol> read(const std::string& text) {
    return std::make_shared<const Protocol>(
        read_protocol(text, "protocol", test::models_of_library()));
  }
  void show(const std::string& name, const std::string& text) {
    view_.show_protocol(home() / (name + ".json"), read(text));
  }
  void show(const std::string& name) { show(name, test::library_text(name)); }
  /// With every value.
  void show_jnd() {
    show("amplitude_jnd");
    require([this] { return view_.findChild<QLineEdit*>(kOrderSd) != nullptr; }, "fields");
    type(kOrder, "0.4");
    type(kOrderSd, "0,3");  // a comma is a decimal point as well
    participants().setValue(12);
  }
  void type(const char* field, const char* value) {
    QTest::keyClicks(&child<QLineEdit>(view_, field), value);
  }
  QSpinBox& participants() { return child<QSpinBox>(view_, "precision_participants"); }
  QString state() const { return child<QLabel>(view_, "precision_state").text(); }
  QString source_of(const char* field) const {
    return child<QLabel>(view_, ("source_" + std::string(field)).c_str()).text();
  }
  bool has_studies(std::int64_t least = 1) {
    return eventually([&] { return view_.studies() >= least; });
  }
  /// The value of the first row with these words in its name and figure; empty if there is none.
  QString value_of(const QString& name, const QString& figure) const {
    const auto& table = child<StudyTable>(view_, "precision_table");
    for (int row = 0; row < table.shown_rows(); ++row) {
      if (table.text_at(row, 0).contains(name) && table.text_at(row, 0).contains(figure)) {
        return table.text_at(row, 1);
      }
    }
    return {};
  }
  /// Whether no further study is simulated.
  bool is_still() {
    const std::int64_t before = view_.studies();
    QTest::qWait(kLongerThanAPortion_ms);
    return view_.studies() == before;
  }

  OpenStudy study_{small_demo_study()};
  PrecisionView view_{study_};
};

TEST_F(PrecisionOfAProtocol, NamesThreeOfManyMissingValuesInTheLanguageOfTheWindows) {
  apply_language("de");
  show("semantic_differential");
  ASSERT_TRUE(eventually([this] { return state().contains("diese Werte angeben"); }))
      << state().toStdString();
  EXPECT_TRUE(state().contains(": Differenz; ")) << state().toStdString();
  EXPECT_TRUE(state().endsWith("; und 13 weitere")) << state().toStdString();
  EXPECT_EQ(assumption_caption("main.felt.condition.peak_ratio_sd"),
            "main, felt: Verhältnis der Maxima (Bedingung), SD");
  EXPECT_EQ(assumption_caption("main.felt.texture.ratio"), "main, felt: Verhältnis (texture)")
      << "the name of a factor is no word of the program";
  apply_language("en");
}

TEST_F(PrecisionOfAProtocol, NamesTheValuesThatAreMissing) {
  show("amplitude_jnd");
  ASSERT_TRUE(eventually([this] { return state().contains("State these values"); }))
      << state().toStdString();
  EXPECT_TRUE(state().contains("comparisons, rougher: order;")) << state().toStdString();
  EXPECT_TRUE(state().endsWith("comparisons, rougher: order, SD")) << state().toStdString();
  EXPECT_EQ(child<QLineEdit>(view_, kOrder).text(), "");
  EXPECT_EQ(source_of(kOrder), "not stated");
  EXPECT_EQ(child<QSpinBox>(view_, "precision_participants").value(), 24) << "as planned";
  EXPECT_EQ(source_of("comparisons.rougher.lapse"), "assumed");
  EXPECT_EQ(child<QLineEdit>(view_, "comparisons.rougher.threshold").text(), "7.07") << "in µm";
  EXPECT_TRUE(is_still());
  EXPECT_EQ(view_.studies(), 0);
}

TEST_F(PrecisionOfAProtocol, CutsNoAssumptionInANarrowColumn) {
  view_.resize(320, 600);
  show("semantic_differential");
  const char* const field = "ratings.rough.level";
  require([&] { return view_.findChild<QLineEdit*>(field) != nullptr; }, "fields");
  QApplication::processEvents();
  const auto& fields = *view_.findChild<AssumptionFields*>();
  EXPECT_LE(fields.width(), fields.parentWidget()->width());
}

TEST_F(PrecisionOfAProtocol, ShowsFiguresWithTheirMonteCarloErrors) {
  show_jnd();
  EXPECT_EQ(source_of(kOrder), "stated");
  ASSERT_TRUE(has_studies());
  EXPECT_TRUE(state().contains("of 1000 simulated studies")) << state().toStdString();
  EXPECT_TRUE(value_of("order", "Power").contains(" % ["))
      << value_of("order", "Power").toStdString();
  ASSERT_TRUE(has_studies(50));
  EXPECT_TRUE(value_of("order (difference of proportions)", "Standard error").contains('['));
  EXPECT_TRUE(value_of("comparisons, rougher: threshold", "Standard error").contains("µm ["));
}

TEST_F(PrecisionOfAProtocol, FollowsTheInputs) {
  show_jnd();
  ASSERT_TRUE(has_studies(50));
  const QString before = value_of("order", "Standard error");
  participants().setValue(24);
  EXPECT_EQ(view_.studies(), 0);
  EXPECT_EQ(value_of("order", "Power"), "") << "figures of other inputs";
  ASSERT_TRUE(has_studies(50));
  EXPECT_NE(value_of("order", "Standard error"), before);

  type(kOrderSd, "x");
  EXPECT_EQ(source_of(kOrderSd), "must be 0 or more");
  EXPECT_TRUE(state().contains("Correct these values: comparisons, rougher: order, SD"))
      << state().toStdString();
  EXPECT_EQ(view_.studies(), 0);
  child<QLineEdit>(view_, kOrderSd).clear();
  type(kOrderSd, "0.1");
  EXPECT_TRUE(has_studies());
}

TEST_F(PrecisionOfAProtocol, BeginsAgainWithAnotherTextAndKeepsWhatWasStated) {
  show_jnd();
  ASSERT_TRUE(has_studies());
  view_.hold_for_new_text();
  EXPECT_TRUE(is_still());
  const std::int64_t before = view_.studies();
  show("amplitude_jnd");
  EXPECT_EQ(view_.studies(), before) << "the text is the same";
  ASSERT_TRUE(has_studies(before + 1));

  nlohmann::json changed = test::library_file("amplitude_jnd");
  changed["title"] = "Another title";
  show("amplitude_jnd", changed.dump());
  EXPECT_EQ(view_.studies(), 0);
  ASSERT_TRUE(has_studies());
  EXPECT_EQ(participants().value(), 12);
  show("spacing_jnd");
  ASSERT_TRUE(eventually([this] { return state().contains("State these values"); }))
      << "what was stated of another file";
  show("amplitude_jnd", changed.dump());
  EXPECT_TRUE(has_studies());
}

TEST_F(PrecisionOfAProtocol, ComputesNothingWhileTheDeviceIsInUseOrWhileItIsHidden) {
  show_jnd();
  ASSERT_TRUE(has_studies());
  StimulusExaminer::Hold hold = study_.examiner().hold();
  EXPECT_TRUE(state().contains("while the device is in use")) << state().toStdString();
  EXPECT_TRUE(is_still());
  const std::int64_t before = view_.studies();
  hold.reset();
  ASSERT_TRUE(has_studies(before + 1));
  view_.hide();
  EXPECT_TRUE(is_still());
  const std::int64_t at_hiding = view_.studies();
  view_.show();
  EXPECT_TRUE(has_studies(at_hiding + 1));
}

TEST_F(PrecisionOfAProtocol, StatesWhyThereIsNoFigure) {
  nlohmann::json file = test::library_file("roughness_force");
  file["estimation"] = {{"factor", "texture"}, {"condition", "force"}, {"predictor", "force_N"}};
  file["analysis"]["family"] = {"exponent"};
  show("roughness_force", file.dump());
  ASSERT_TRUE(eventually([this] { return state().contains("Studies cannot be simulated here"); }))
      << state().toStdString();
  EXPECT_TRUE(state().contains("--physics")) << state().toStdString();
  show("amplitude_same_different");
  ASSERT_TRUE(eventually([this] { return state().contains("has no family of tests"); }))
      << state().toStdString();
}

TEST_F(PrecisionOfAProtocol, ShowsTheCommandThatSimulatesTheSameStudies) {
  show_jnd();
  QTest::mouseClick(&child<QPushButton>(view_, "show_commands"), Qt::LeftButton);
  const PowerLine expected{.protocol = home() / "amplitude_jnd.json",
                           .participants = 12,
                           .seed = PrecisionView::kSeed,
                           .runs = PrecisionView::kStudies,
                           .effects = {{kOrder, 0.4}},
                           .assumed = {{kOrderSd, 0.3}}};
  EXPECT_EQ(child<QLineEdit>(view_, "command_1").text().toStdString(), power_line(expected, {}));
}

TEST_F(PrecisionOfAProtocol, HasNamesAndTheOrderOfReading) {
  show_jnd();
  ASSERT_TRUE(has_studies());
  EXPECT_EQ(nameless_controls(view_), QStringList{});
  EXPECT_EQ(steps_against_reading(view_), QStringList{});
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, choice);
    take_screenshot(view_, choice == ThemeChoice::light ? "precision" : "precision-dark",
                    {480, 600});
  }
  apply_theme(*qApp, ThemeChoice::light);
}

TEST_F(PrecisionOfAProtocol, IsATabOfTheEditor) {
  const std::filesystem::path file = study_.folder() / "protocols" / "amplitude_jnd.json";
  write_file(file, test::library_text("amplitude_jnd"), Overwrite::allow);
  ProtocolEditorPage page(study_);
  page.resize(1264, 672);
  page.show();
  page.open(file);
  ASSERT_TRUE(eventually([&page] { return page.is_checked() && page.result() != nullptr; }));
  auto& precision = *page.findChild<PrecisionView*>();
  EXPECT_FALSE(precision.isVisible());
  QTest::mouseClick(&child<QPushButton>(page, "editor_show_precision"), Qt::LeftButton);
  EXPECT_TRUE(precision.isVisible());
  ASSERT_TRUE(eventually([&page] {
    return child<QLabel>(page, "precision_state").text().contains("State these values");
  }));
  EXPECT_EQ(nameless_controls(page), QStringList{});
  EXPECT_EQ(steps_against_reading(page), QStringList{});
  EXPECT_LE(page.minimumSizeHint().width(), 740) << "a window of 910 points with its navigation";
  take_screenshot(page, "editor-precision");
  QTest::mouseClick(&child<QPushButton>(page, "editor_side_plan"), Qt::LeftButton);
  take_screenshot(page, "editor-precision-small", {910, 512});
}

}  // namespace
}  // namespace asperity

// The protocol editor as an author meets it: typing, problems, the plan, saving, conflicts.

#include "app/gui/editor/protocol_editor_page.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <QtCore/QRegularExpression>
#include <QtGui/QTextBlock>
#include <QtGui/QTextLayout>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QCompleter>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QStyle>
#include <QtWidgets/QStyleOption>

#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/editor/find_bar.h"
#include "app/gui/editor/form/protocol_form.h"
#include "app/gui/editor/json_colors.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/editor/question_bar.h"
#include "app/gui/look/fitted_label.h"
#include "app/gui/participant/participant_view.h"
#include "app/gui/plan/plan_preview.h"
#include "protocols/file/library_protocols.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/gui/editor/library_text.h"
#include "tests/gui/study/lively_study.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/gated_examination.h"
#include "tests/gui/support/screenshot.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

class ProtocolEditor : public QuietHome {
 protected:
  ProtocolEditor() {
    folder_ = small_demo_study();
    file_ = folder_ / "protocols" / "improved_recognition.json";
    write_file(file_, library_text("improved_recognition"), Overwrite::refuse);
  }

  void open(const std::shared_ptr<GatedExamination>& gate = nullptr) {
    study_ = std::make_unique<OpenStudy>(folder_);
    if (gate != nullptr) study_->examiner().set_examine(examine_through(gate));
    page_ = std::make_unique<ProtocolEditorPage>(*study_);
    page_->resize(1366, 768);
    page_->show();
    page_->open(file_);
    click("editor_to_text");
    ASSERT_TRUE(checked());
  }
  bool checked() {
    return eventually([&] { return page_->is_checked(); });
  }
  ProtocolTextEdit& edit() { return child<ProtocolTextEdit>(*page_, "editor_text"); }
  /// Puts the cursor before, or behind, the first place where these words stand.
  void go_before(const QString& words) {
    edit().go_to(static_cast<int>(edit().text().indexOf(words)));
  }
  void go_behind(const QString& words) {
    edit().go_to(static_cast<int>(edit().text().indexOf(words) + words.size()));
  }
  void type(const QString& keys) { QTest::keyClicks(&edit(), keys); }
  void click(const char* button) {
    QTest::mouseClick(&child<QPushButton>(*page_, button), Qt::LeftButton);
  }
  void find_in_form(const QString& words) {
    page_->resize(910, 512);
    click("editor_find");
    auto& line = child<QLineEdit>(*page_, "find_words");
    line.setText(words);
    QTest::keyClick(&line, Qt::Key_Return);
    QApplication::processEvents();
  }
  QString label(const char* name) { return child<QLabel>(*page_, name).text(); }
  bool asks() { return child<QuestionBar>(*page_, "editor_question").isVisible(); }
  bool saved() {
    return eventually([&] { return !page_->has_unsaved_changes(); });
  }
  QStringList underlined() {
    QStringList words{};
    for (const QTextEdit::ExtraSelection& underline : edit().underlined()) {
      words.append(underline.cursor.selectedText());
    }
    return words;
  }

  std::filesystem::path folder_{};
  std::filesystem::path file_{};
  std::unique_ptr<OpenStudy> study_{};
  std::unique_ptr<ProtocolEditorPage> page_{};
};

TEST_F(ProtocolEditor, ShowsAValidProtocolAsValid) {
  open();
  EXPECT_TRUE(label("editor_state").contains("✓"));
  EXPECT_TRUE(label("editor_state").contains("valid"));
  EXPECT_TRUE(underlined().isEmpty());
  EXPECT_FALSE(page_->has_unsaved_changes());
  EXPECT_EQ(page_->content(), library_text("improved_recognition"));
}

TEST_F(ProtocolEditor, UnderlinesAndListsWarnings) {
  open();
  QString text = edit().text();
  const QString explorations = R"("explorations": {)";
  text.insert(text.indexOf(explorations) + explorations.size(),
              R"("unused": {"minimum_contact_s": 1},)");
  edit().replace_text(text);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(label("editor_state").contains("▲"));
  EXPECT_TRUE(label("editor_state").contains("valid, 1 warning"));
  EXPECT_EQ(underlined(), QStringList{"\"unused\""});
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_TRUE(problems.text_at(0, 1).startsWith("Warning: no block uses the exploration"))
      << problems.text_at(0, 1).toStdString();
}

TEST_F(ProtocolEditor, ChecksNoTextWhileTheDeviceIsInUse) {
  open();
  StimulusExaminer::Hold hold = study_->examiner().hold();
  go_behind("\"planned\": 2");
  type("x");
  EXPECT_TRUE(label("editor_state").contains("when the device is free again"));
  constexpr int kMoment_ms = 50;
  QTest::qWait(kMoment_ms);
  EXPECT_FALSE(page_->is_checked());
  EXPECT_TRUE(underlined().isEmpty());
  hold.reset();
  EXPECT_TRUE(label("editor_state").contains("checking"));
  ASSERT_TRUE(checked());
  EXPECT_FALSE(underlined().isEmpty());
}

TEST_F(ProtocolEditor, ShowsNothingOfTheFileBeforeWhileTheTextOfAnotherIsNotChecked) {
  const std::filesystem::path invalid = folder_ / "protocols" / "amplitude_jnd.json";
  std::string text = library_text("amplitude_jnd");
  const std::string version = R"("version": ")";
  write_file(invalid, text.insert(text.find(version) + version.size(), "x"), Overwrite::refuse);
  open();
  const auto& side = child<QStackedWidget>(*page_, "editor_plan_side");
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  const auto of_form = [this] {
    return std::ranges::count_if(page_->findChildren<QLabel*>("form_problem"),
                                 [](const QLabel* label) { return label->isVisible(); });
  };
  const auto expect_nothing = [&] {
    EXPECT_EQ(side.currentWidget(), page_->findChild<QLabel*>("editor_why_no_plan"));
    EXPECT_EQ(label("editor_why_no_plan"), "The text is checked when the device is free again.");
    EXPECT_EQ(problems.shown_rows(), 0);
    EXPECT_TRUE(underlined().isEmpty());
    EXPECT_EQ(of_form(), 0);
    EXPECT_EQ(page_->result(), nullptr);
    EXPECT_EQ(child<StudyTable>(*page_, "plan_table").shown_rows(), 0);
    for (const char* const words : {"plan_words", "screen_words"}) {
      EXPECT_EQ(label(words), "The plan is being made…");
    }
    EXPECT_TRUE(label("plan_detail").isEmpty());
  };
  StimulusExaminer::Hold hold = study_->examiner().hold();
  EXPECT_EQ(side.currentIndex(), 0) << "the plan";
  EXPECT_TRUE(eventually([&] { return !label("plan_detail").isEmpty(); }));
  page_->open(invalid);
  expect_nothing();
  hold.reset();
  ASSERT_TRUE(checked());
  EXPECT_EQ(problems.shown_rows(), 1);
  EXPECT_EQ(of_form(), 1);
  hold = study_->examiner().hold();
  page_->open(file_);
  expect_nothing();
  hold.reset();
  ASSERT_TRUE(checked());
  EXPECT_EQ(side.currentIndex(), 0);
}

// The relief of 500 N/m exerts at most 1.5 N, which `check` finds by rendering it.
TEST_F(ProtocolEditor, ShowsTheWarningsThatNeedTheStimuliOnceTheTextIsStill) {
  open();
  const QString before = edit().text();
  QString text = before;
  const QString target = R"("minimum": 0.3, "target": 1,)";
  ASSERT_TRUE(text.contains(target));
  text.replace(target, R"("minimum": 0.3, "target": 2,)");
  edit().replace_text(text);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(underlined().isEmpty()) << "the text is valid, and not still yet";
  ASSERT_TRUE(eventually([&] { return label("editor_state").endsWith("valid, 1 warning"); }))
      << label("editor_state").toStdString();
  EXPECT_EQ(underlined().size(), 1);
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_TRUE(problems.text_at(0, 1).startsWith("Warning: the stimulus \"rendered_"))
      << problems.text_at(0, 1).toStdString();
  EXPECT_TRUE(problems.text_at(0, 1).contains("exerts at most 1.50 N"));
  EXPECT_EQ(problems.text_at(0, 2), "Surfaces › Stimuli › rendered");
  edit().replace_text(before);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(underlined().isEmpty()) << "it is of another text";
}

TEST_F(ProtocolEditor, LooksUpTheFilesAgainWhenItIsShown) {
  open();
  const std::filesystem::path relief = folder_ / "stimuli" / "metal.png";
  const std::string content = read_file(relief);
  for (const bool is_there : {false, true}) {
    page_->hide();
    if (is_there) {
      write_file(relief, content, Overwrite::refuse);
    } else {
      std::filesystem::remove(relief);
    }
    page_->show();
    ASSERT_TRUE(checked());
    EXPECT_EQ(page_->result()->is_valid(), is_there) << label("editor_state").toStdString();
  }
}

TEST_F(ProtocolEditor, AbandonsAnExaminationWhenTheTextChangesOrIsNotShown) {
  const auto gate = std::make_shared<GatedExamination>();
  open(gate);
  ASSERT_TRUE(eventually([&] { return gate->has_begun(1); }));
  EXPECT_TRUE(label("editor_state").endsWith("valid (the stimuli are being examined…)"))
      << label("editor_state").toStdString();
  go_behind("\"title\": \"");
  type("N");
  EXPECT_TRUE(eventually([&] { return gate->has_stopped(1); }));
  ASSERT_TRUE(eventually([&] { return gate->has_begun(2); }));
  page_->hide();
  EXPECT_TRUE(eventually([&] { return gate->has_stopped(2); }));
  page_->show();
  ASSERT_TRUE(eventually([&] { return gate->has_begun(3); }));
  gate->is_open = true;
  EXPECT_TRUE(eventually([&] { return label("editor_state").endsWith("valid, 1 warning"); }))
      << label("editor_state").toStdString();
}

TEST_F(ProtocolEditor, WarnsOfSessionsWithAnotherTextOfTheVersionWhileItIsTyped) {
  fill_with_participants(folder_);
  file_ = folder_ / "protocols" / "chapter_recognition.json";
  open();
  EXPECT_TRUE(underlined().isEmpty());
  go_behind("\"title\": \"");
  type("New ");
  ASSERT_TRUE(checked());
  EXPECT_EQ(underlined(), QStringList{"\"version\""});
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  const QString warning = problems.text_at(0, 1);
  EXPECT_TRUE(warning.contains("sessions of chapter_recognition 1.1.0 with another text"))
      << warning.toStdString();
  EXPECT_TRUE(warning.endsWith("give the changed protocol a new version")) << warning.toStdString();
  EXPECT_EQ(problems.text_at(0, 2), "Question › Version");
  go_behind("\"version\": \"1.1.");
  QTest::keyClick(&edit(), Qt::Key_Delete);
  type("1");
  ASSERT_TRUE(checked());
  EXPECT_TRUE(underlined().isEmpty());
}

TEST_F(ProtocolEditor, UnderlinesWhatIsTypedWrongInItsPlace) {
  open();
  go_behind("hand_oc");
  type("x");
  ASSERT_TRUE(checked());
  EXPECT_EQ(underlined(), QStringList{"\"hand_ocxcluded\""});
  EXPECT_TRUE(label("editor_state").contains("✕"));
  EXPECT_TRUE(label("editor_state").contains("1 problem"));
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_EQ(problems.text_at(0, 0), "20");
  EXPECT_EQ(problems.text_at(0, 2), "Participant › Environment › Vision");
  const int place = edit().underlined()[0].cursor.selectionStart();
  EXPECT_EQ(edit().problems_at(place), problems.text_at(0, 1));
  EXPECT_TRUE(edit().problems_at(place - 1).isEmpty());
  EXPECT_EQ(edit().underlined()[0].format.underlineStyle(), QTextCharFormat::WaveUnderline);

  QTest::keyClick(&edit(), Qt::Key_Backspace);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(underlined().isEmpty());
  EXPECT_EQ(problems.shown_rows(), 0);
}

TEST_F(ProtocolEditor, ColoursKeysTextsAndNumbersAlsoOfWhatIsTyped) {
  open();
  const auto color_at = [this](const QString& words) {
    const int place = static_cast<int>(edit().text().indexOf(words));
    const QTextBlock line = edit().document()->findBlock(place);
    for (const QTextLayout::FormatRange& range : line.layout()->formats()) {
      const int in_line = place - line.position();
      if (range.start <= in_line && in_line < range.start + range.length) {
        return range.format.foreground().color();
      }
    }
    return QColor();
  };
  using Kind = JsonToken::Kind;
  EXPECT_EQ(color_at("\"vision\""), json_color(Kind::key, theme()));
  EXPECT_EQ(color_at("\"hand_occluded\""), json_color(Kind::string, theme()));
  go_before("\"vision\"");
  type("\"typed");
  edit().insertPlainText("\": 12.5, ");
  EXPECT_EQ(color_at("12.5"), json_color(Kind::number, theme()));
  EXPECT_NE(json_color(Kind::number, theme()), json_color(Kind::string, theme()));
}

TEST_F(ProtocolEditor, UnderlinesTheRightCharactersBehindAMicroSignAndAnEmoji) {
  open();
  go_before("\"vision\": \"hand_occluded\"");
  edit().insertPlainText(QString::fromUtf8("\"$comment\": \"µm 😀😀\", "));
  go_behind("\"vision\": \"hand_");
  type("x");
  ASSERT_TRUE(checked());
  EXPECT_EQ(underlined(), QStringList{"\"hand_xoccluded\""});
}

TEST_F(ProtocolEditor, FindsWhatCheckFindsInADozenBrokenProtocols) {
  open();
  const QString good = QString::fromStdString(library_text("improved_recognition"));
  const std::array<std::pair<const char*, const char*>, 14> mutations{{
      {"\"kind\": \"recognition\"", "\"kind\": \"recogniton\""},
      {"\"version\": \"1.1.0\"", "\"version\": \"1.0\""},
      {"\"level_dBA\": 65", "\"level_dBA\": 650"},
      {"\"force_limit_N\": 5,", "\"force_limit_N\": 0,"},
      {"\"picture\": \"stimuli/metal_photo.png\"", "\"picture\": \"stimuli/no_such.png\""},
      {"\"factor\": \"texture\"", "\"factor\": \"textur\""},
      {"\"model\": \"height_map\"", "\"model\": \"heigth_map\""},
      {"\"exploration\": \"stroking\"", "\"exploration\": \"strokin\""},
      {"{\"run\": \"familiarisation\"},", ""},
      {"\"maximum_contact_s\": 15", "\"maximum_contact_s\": 1"},
      {"\"correct\": 6,", "\"correct\": 9,"},
      {"\"license\": \"CC0-1.0\",", "\"license\": \"CC0-1.0\" \"\","},
      {"\"sessions\": 1,", "\"sessions\": 1, \"sessions\": 2,"},
      {"\"every_tick\": true}\n}", "\"every_tick\": true}\n"},
  }};
  const std::filesystem::path other = home() / "other.json";
  for (const auto& [right, wrong] : mutations) {
    QString text = good;
    ASSERT_TRUE(text.contains(right)) << right;
    text.replace(text.indexOf(right), QString(right).size(), wrong);
    edit().replace_text(text);
    ASSERT_TRUE(checked());
    write_file(other, text.toStdString(), Overwrite::allow);
    const auto expected =
        check_protocol(other, study_->models(), folder_, std::nullopt).diagnostics;
    ASSERT_FALSE(expected.empty()) << wrong;
    const auto& found = page_->result()->diagnostics;
    const auto& problems = child<StudyTable>(*page_, "editor_problems");
    ASSERT_EQ(found.size(), expected.size()) << wrong;
    ASSERT_EQ(problems.shown_rows(), static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].line, expected[i].line) << wrong;
      EXPECT_EQ(found[i].column, expected[i].column) << wrong;
      EXPECT_EQ(found[i].pointer, expected[i].pointer) << wrong;
      EXPECT_EQ(found[i].message, expected[i].message) << wrong;
      EXPECT_FALSE(underlined()[static_cast<qsizetype>(i)].isEmpty()) << wrong;
    }
  }
}

TEST_F(ProtocolEditor, ShowsEachProblemAsAWhole) {
  open();
  page_->resize(1280, 720);
  go_behind("hand_oc");
  type("x");
  go_behind("\"level_dBA\": 6");
  type("5");
  go_behind("\"tiling\": \"");
  type("x");
  ASSERT_TRUE(checked());
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 3) << "with a scroll bar, which takes of the width";
  EXPECT_TRUE(problems.text_at(0, 1).contains("did you mean"));
  EXPECT_TRUE(eventually([&] { return cut_cells(problems).isEmpty(); }))
      << cut_cells(problems).join(" | ").toStdString();
}

TEST_F(ProtocolEditor, NamesWhatIsWrongInTheWordsOfTheView) {
  open();
  QString text = edit().text();
  text.replace("\"break_every_trials\": 16", "\"break_every_trials\": 500");
  edit().replace_text(text);
  ASSERT_TRUE(checked());
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_FALSE(problems.isColumnHidden(0)) << "the lines of the text";
  EXPECT_TRUE(problems.text_at(0, 1).endsWith("or remove the key"));
  click("editor_to_form");
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_TRUE(problems.isColumnHidden(0));
  EXPECT_TRUE(problems.text_at(0, 1).endsWith("or remove the setting"));

  static const QRegularExpression level(",\\s*\"level_dBA\": \\d+");
  text.remove(level);
  edit().replace_text(text);
  ASSERT_TRUE(checked());
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_TRUE(problems.text_at(0, 1).endsWith("add the setting “Sound level”"))
      << problems.text_at(0, 1).toStdString();
  EXPECT_TRUE(
      label("editor_why_no_plan").endsWith("the first is at " + problems.text_at(0, 2) + "."));
  bool is_next_to_it = false;
  child<ProtocolForm>(*page_, "editor_form").go_to("/environment/masking_noise");
  QApplication::processEvents();
  for (const QLabel* const shown : page_->findChildren<QLabel*>("form_problem")) {
    is_next_to_it |= shown->isVisible() && shown->text().contains("add the setting “Sound level”");
  }
  EXPECT_TRUE(is_next_to_it);

  text.replace("\"masking_noise\": {", "\"masking_noise\": {\"level\": 3, ");
  edit().replace_text(text);
  ASSERT_TRUE(checked());
  EXPECT_TRUE(problems.text_at(0, 1).startsWith("there is no key \"level\" here"))
      << "which only the text has: " << problems.text_at(0, 1).toStdString();
}

TEST_F(ProtocolEditor, JumpsToTheProblemThatIsClicked) {
  open();
  go_behind("\"rate_Hz\": ");
  type("9");
  ASSERT_TRUE(checked());
  edit().go_to(0);
  auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  QTest::mouseClick(problems.viewport(), Qt::LeftButton, {},
                    problems.visualRect(problems.model()->index(0, 1)).center());
  EXPECT_EQ(edit().textCursor().position(), edit().text().indexOf("91000"));
  EXPECT_TRUE(edit().hasFocus());
}

TEST_F(ProtocolEditor, ListsWhatIsTypedInTheFormInPlaceOfANumberAndLeadsBackToIt) {
  open();
  click("editor_to_form");
  auto& form = child<ProtocolForm>(*page_, "editor_form");
  const auto friction = [&] {
    form.go_to("/material/friction");
    QApplication::processEvents();
    return qobject_cast<QLineEdit*>(QApplication::focusWidget());
  };
  ASSERT_NE(friction(), nullptr);
  friction()->selectAll();
  QTest::keyClicks(friction(), "abc");
  ASSERT_TRUE(checked());
  EXPECT_TRUE(page_->has_unsaved_changes());
  form.show_page("question");
  QApplication::processEvents();
  auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_TRUE(problems.text_at(0, 1).contains("\"abc\"")) << problems.text_at(0, 1).toStdString();
  EXPECT_EQ(problems.text_at(0, 2), "Surfaces › Material › Friction");
  QTest::mouseClick(problems.viewport(), Qt::LeftButton, {},
                    problems.visualRect(problems.model()->index(0, 1)).center());
  QApplication::processEvents();
  const auto* line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->text(), "abc");
}

QStringList surfaces_of_table(const StudyTable& table) {
  QStringList words{};
  for (int row = 0; row < table.shown_rows(); ++row) {
    if (!table.text_at(row, 1).isEmpty()) words.append(table.text_at(row, 3));
  }
  return words;
}

QStringList surfaces_of_plan(const Plan& plan) {
  QStringList words{};
  for (const PlanStep& step : plan.steps) {
    const auto* trial = std::get_if<TrialStep>(&step);
    if (trial == nullptr) continue;
    QStringList surfaces{};
    for (const PlannedPresentation& surface : plan.trials[trial->trial].presentations) {
      surfaces.append(QString::fromStdString(surface.code + ' ' + surface.item));
    }
    words.append(surfaces.join(", "));
  }
  return words;
}

TEST_F(ProtocolEditor, LaysOutThePlanThatMakePlanMakes) {
  open();
  const Protocol& protocol = *page_->result()->protocol;
  const auto& table = child<StudyTable>(*page_, "plan_table");
  const auto shows = [&](const Plan& plan) {
    return table.shown_rows() == static_cast<int>(plan.steps.size()) &&
           surfaces_of_table(table) == surfaces_of_plan(plan);
  };
  EXPECT_TRUE(eventually([&] { return shows(make_plan(protocol, {1, 0})); }));
  click("plan_another");
  EXPECT_TRUE(eventually([&] { return shows(make_plan(protocol, {2, 0})); }));
  EXPECT_FALSE(shows(make_plan(protocol, {1, 0})));
  child<QSpinBox>(*page_, "plan_seed").setValue(77);
  const Plan plan = make_plan(protocol, {77, 0});
  ASSERT_TRUE(eventually([&] { return shows(plan); }));

  const PlanCost cost = cost_of(protocol, plan);
  EXPECT_TRUE(label("plan_words")
                  .startsWith(QString("at most %1 trials · %2 contacts · about")
                                  .arg(cost.trials)
                                  .arg(cost.contacts)))
      << label("plan_words").toStdString();
  const QString detail = label("plan_detail");
  EXPECT_TRUE(detail.contains("Trial 1, familiarisation")) << detail.toStdString();
  for (const Option& option : plan.trials[0].questions.front().options) {
    EXPECT_TRUE(detail.contains(QString::fromStdString(option.value)));
  }
}

TEST_F(ProtocolEditor, LaysOutThePlanOfTheChosenGroup) {
  open();
  EXPECT_FALSE(child<QComboBox>(*page_, "plan_group").isVisible());
  QString text = edit().text();
  text.replace("\"factors\": {",
               "\"groups\": {\"factor\": \"ground\"}, "
               "\"factors\": {\"ground\": {\"levels\": [\"dawn\", \"dusk\"]}, ");
  edit().replace_text(text);
  ASSERT_TRUE(checked());
  ASSERT_TRUE(page_->result()->diagnostics.empty())
      << page_->result()->diagnostics[0].message.english();
  auto& group = child<QComboBox>(*page_, "plan_group");
  EXPECT_TRUE(group.isVisible());
  EXPECT_EQ(group.currentText(), "dawn");
  EXPECT_TRUE(eventually([&] { return label("plan_detail").contains("dawn"); }));
  group.setCurrentIndex(1);
  EXPECT_TRUE(eventually([&] { return label("plan_detail").contains("dusk"); }));
  click("editor_show_screen");
  auto& on_screen = child<QComboBox>(*page_, "screen_group");
  EXPECT_TRUE(on_screen.isVisible());
  EXPECT_EQ(on_screen.currentText(), "dusk");
  on_screen.setCurrentIndex(0);
  emit on_screen.activated(0);
  EXPECT_EQ(group.currentText(), "dawn");
  group.setCurrentIndex(1);
  EXPECT_EQ(on_screen.currentText(), "dusk");

  edit().replace_text(text.replace("dusk", "evening"));
  ASSERT_TRUE(checked());
  EXPECT_EQ(group.currentText(), "evening") << "the same group under another name";
  click("editor_show_plan");
  page_->resize(1040, 512);
  edit().replace_text(text.replace("dawn", "with a long practice"));
  ASSERT_TRUE(checked());
  group.setCurrentIndex(0);
  const auto is_whole = [&group] {
    QStyleOptionComboBox option{};
    option.initFrom(&group);
    const QRect room = group.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                     QStyle::SC_ComboBoxEditField, &group);
    return room.width() > group.fontMetrics().horizontalAdvance("with a long practice");
  };
  EXPECT_TRUE(eventually(is_whole)) << "the name is cut at " << group.width();
  const auto& side = child<QStackedWidget>(*page_, "editor_plan_side");
  EXPECT_TRUE(side.rect().contains(QRect(group.mapTo(&side, QPoint()), group.size())));
  take_screenshot(*page_, "editor-plan-group", {1040, 512});
}

TEST_F(ProtocolEditor, LaysOutTheChosenRowOfTheCounterbalancing) {
  open();
  EXPECT_FALSE(child<QSpinBox>(*page_, "plan_row").isVisible());
  QString text = edit().text();
  text.replace("\"factors\": {",
               "\"factors\": {\"ground\": {\"levels\": [\"dawn\", \"noon\", \"dusk\"]}, ");
  text.replace("\"flow\": [", "\"counterbalance\": \"williams\", \"flow\": [");
  text.replace("\"run\": \"main\",", "\"run\": \"main\", \"for_each\": \"ground\",");
  edit().replace_text(text);
  ASSERT_TRUE(checked());
  ASSERT_TRUE(page_->result()->diagnostics.empty())
      << page_->result()->diagnostics[0].message.english();
  auto& row = child<QSpinBox>(*page_, "plan_row");
  EXPECT_TRUE(row.isVisible());
  EXPECT_EQ(row.maximum(), 6);  // a Williams square of three
  auto& table = child<StudyTable>(*page_, "plan_table");
  const Protocol& protocol = *page_->result()->protocol;
  for (const int chosen : {1, 4, 6}) {
    row.setValue(chosen);
    const Plan plan = make_plan(protocol, {1, chosen - 1});
    const auto first = std::find_if(plan.steps.begin(), plan.steps.end(), [&](const auto& step) {
      const auto* trial = std::get_if<TrialStep>(&step);
      return trial != nullptr && plan.trials[trial->trial].block == "main";
    });
    ASSERT_NE(first, plan.steps.end());
    table.select(QString::number(first - plan.steps.begin()));
    const std::string ground =
        "ground: " + text_of(plan.trials[std::get<TrialStep>(*first).trial].factors.at("ground"));
    EXPECT_TRUE(eventually([&] {
      return label("plan_detail").contains(QString::fromStdString(ground));
    })) << ground
        << label("plan_detail").toStdString();
  }
}

TEST_F(ProtocolEditor, ShowsTheScreenOfTheParticipantAtEveryStep) {
  open();
  ASSERT_TRUE(
      eventually([&] { return child<StudyTable>(*page_, "plan_table").shown_rows() > 10; }));
  click("editor_show_screen");
  auto& table = child<StudyTable>(*page_, "plan_table");
  const int steps = table.shown_rows();
  auto& next = child<QPushButton>(*page_, "screen_next");
  auto& back = child<QPushButton>(*page_, "screen_back");
  table.select("0");
  ASSERT_TRUE(
      eventually([&] { return label("screen_words") == QString("Step 1 of %1").arg(steps); }));
  const auto& view = child<ParticipantView>(*page_, "screen_view");
  EXPECT_TRUE(eventually([&] { return view.drawn_texts().join(" ").contains("Welcome"); }));
  EXPECT_FALSE(back.isEnabled());
  int screens = 1;
  for (; next.isEnabled(); ++screens) next.click();
  EXPECT_TRUE(label("screen_words").startsWith(QString("Step %1 of %1").arg(steps)));
  EXPECT_GT(screens, steps);  // a trial has several
  int back_again = 1;
  for (; back.isEnabled(); ++back_again) back.click();
  EXPECT_EQ(back_again, screens);
}

TEST_F(ProtocolEditor, SaysWhyThereIsNoPlan) {
  open();
  auto& side = child<QStackedWidget>(*page_, "editor_plan_side");
  EXPECT_EQ(side.currentIndex(), 0);
  go_behind("\"rate_Hz\": ");
  type("9");
  ASSERT_TRUE(checked());
  EXPECT_EQ(side.currentWidget(), page_->findChild<QLabel*>("editor_why_no_plan"));
  EXPECT_EQ(label("editor_why_no_plan"),
            "The plan appears here once the text is valid. At present it has 1 problem; the first "
            "is on line 21.");
}

TEST_F(ProtocolEditor, SaysWhatTheKeyUnderTheCursorMeans) {
  open();
  go_behind("\"level_d");
  EXPECT_TRUE(label("editor_help").contains("Level at the ear."));
  EXPECT_TRUE(label("editor_help").contains("from 0 to 85"));
}

TEST_F(ProtocolEditor, IndentsByTwoSpacesAndUndoes) {
  open();
  const QString before = edit().text();
  go_before("  \"kind\"");
  QTest::keyClick(&edit(), Qt::Key_Tab);
  EXPECT_TRUE(edit().text().contains("\n    \"kind\""));
  QTest::keyClick(&edit(), Qt::Key_Backtab);
  EXPECT_EQ(edit().text(), before);
  QTest::keyClick(&edit(), Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&edit(), Qt::Key_Tab);
  EXPECT_TRUE(edit().text().startsWith("  {\n    \"format\""));
  QTest::keyClick(&edit(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(edit().text(), before);
  go_behind("\"consent\": {");
  QTest::keyClick(&edit(), Qt::Key_Return);
  EXPECT_TRUE(edit().text().contains("\"consent\": {\n    \n"));
}

TEST_F(ProtocolEditor, FindsWords) {
  open();
  edit().go_to(0);
  QTest::keyClick(&edit(), Qt::Key_F, Qt::ControlModifier);
  auto& words = child<QLineEdit>(*page_, "find_words");
  ASSERT_TRUE(words.hasFocus());
  QTest::keyClicks(&words, "masking");
  EXPECT_EQ(edit().textCursor().selectedText(), "masking");
  EXPECT_EQ(label("find_count"), "1 match");
  words.clear();
  QTest::keyClicks(&words, "\"phase\"");
  EXPECT_EQ(label("find_count"), "3 matches");
  const int first = edit().textCursor().selectionStart();
  QTest::keyClick(&words, Qt::Key_Return);
  EXPECT_GT(edit().textCursor().selectionStart(), first);
  QTest::keyClick(&words, Qt::Key_Return, Qt::ShiftModifier);
  EXPECT_EQ(edit().textCursor().selectionStart(), first);
  QTest::keyClick(&words, Qt::Key_Return, Qt::ShiftModifier);  // around
  EXPECT_GT(edit().textCursor().selectionStart(), first);
  QTest::keyClick(&words, Qt::Key_Escape);
  EXPECT_TRUE(edit().hasFocus());
}

TEST_F(ProtocolEditor, SavesByCtrlS) {
  open();
  QSignalSpy saved_file(page_.get(), &ProtocolEditorPage::saved);
  EXPECT_FALSE(child<QPushButton>(*page_, "editor_save").isEnabled());
  go_behind("\"planned\": 2");
  type("1");
  EXPECT_TRUE(page_->has_unsaved_changes());
  QTest::keyClick(&edit(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(saved());
  EXPECT_EQ(saved_file.count(), 1);
  EXPECT_NE(read_file(file_).find("\"planned\": 210,"), std::string::npos);
  EXPECT_EQ(read_file(file_), page_->content());
  EXPECT_FALSE(asks());
}

TEST_F(ProtocolEditor, TakesBackAChangeWhereverTheFocusIs) {
  open();
  const std::string before = page_->content();
  go_behind("\"planned\": 2");
  type("1");
  ASSERT_NE(page_->content(), before);
  auto& button = child<QPushButton>(*page_, "editor_methods");
  button.setFocus();
  QTest::keyClick(&button, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(page_->content(), before);
}

TEST_F(ProtocolEditor, ReturnsTheFocusToTheFieldAfterAClickOnSave) {
  open();
  click("editor_to_form");
  auto& form = child<ProtocolForm>(*page_, "editor_form");
  form.go_to("/title");
  QApplication::processEvents();
  QWidget* const field = QApplication::focusWidget();
  ASSERT_TRUE(form.isAncestorOf(field));
  QTest::keyClicks(field, "x");
  auto& save = child<QPushButton>(*page_, "editor_save");
  save.setFocus();
  save.click();
  ASSERT_TRUE(saved());
  EXPECT_EQ(QApplication::focusWidget(), field);
}

TEST_F(ProtocolEditor, OffersTheFilesOfTheStudyWhereOneIsNamed) {
  open();
  click("editor_to_form");
  auto& form = child<ProtocolForm>(*page_, "editor_form");
  form.go_to("/textures/brick/height_field");
  QApplication::processEvents();
  const auto* const line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(line, nullptr);
  ASSERT_NE(line->completer(), nullptr);
  QStringList offered{};
  const QAbstractItemModel& model = *line->completer()->model();
  for (int row = 0; row < model.rowCount(); ++row) {
    offered.append(model.index(row, 0).data().toString());
  }
  EXPECT_TRUE(offered.contains("stimuli/brick.png")) << offered.join(", ").toStdString();
  EXPECT_FALSE(offered.contains("stimuli/brick.png.json"));
}

TEST_F(ProtocolEditor, CallsTheFileAfterTheNameThatItIsSavedUnder) {
  open();
  ASSERT_EQ(file_.filename(), "improved_recognition.json");
  QSignalSpy saved_file(page_.get(), &ProtocolEditorPage::saved);
  go_behind("\"name\": \"improved_recog");
  type("x");
  click("editor_save");
  ASSERT_TRUE(saved());
  const std::filesystem::path renamed = file_.parent_path() / "improved_recogxnition.json";
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_EQ(read_file(renamed), page_->content());
  ASSERT_EQ(saved_file.count(), 1);
  EXPECT_EQ(saved_file.first().first().toString().toStdString(), renamed.string());
  go_behind("improved_recogx");
  type("y");
  click("editor_save");
  ASSERT_TRUE(saved());
  EXPECT_FALSE(std::filesystem::exists(renamed));
}

TEST_F(ProtocolEditor, StatesThatASavedFileWithProblemsCannotBeRun) {
  open();
  const auto banner = [&]() -> QString {
    for (const Banner* each : page_->findChildren<Banner*>()) {
      if (each->isVisible()) return each->text();
    }
    return {};
  };
  go_behind("\"planned\": 2");
  type("x");
  click("editor_save");  // before the text has been checked
  ASSERT_TRUE(saved());
  ASSERT_TRUE(checked());
  EXPECT_EQ(banner(), "The file is saved, but no session can be run with it: it has 1 problem.");
  take_screenshot(*page_, "editor-saved-with-problems");
  edit().undo();
  EXPECT_EQ(banner(), "");
  ASSERT_TRUE(checked());
  click("editor_save");
  ASSERT_TRUE(saved());
  EXPECT_EQ(banner(), "");

  go_behind("\"name\": \"improved_recog");
  type("x");
  edit().replace_text(edit().text().replace("\"planned\": 20", "\"planned\": -1"));
  ASSERT_TRUE(checked());
  click("editor_save");
  ASSERT_TRUE(saved());
  EXPECT_EQ(
      banner(),
      "Saved as improved_recogxnition.json: the file is named after the protocol. The file is "
      "saved, but no session can be run with it: it has 1 problem.");
}

TEST_F(ProtocolEditor, KeepsTheTextWhenItCannotBeSaved) {
  open();
  go_behind("\"planned\": 2");
  type("1");
  std::filesystem::rename(folder_ / "protocols", folder_ / "elsewhere");
  click("editor_save");
  ASSERT_TRUE(eventually([&] {
    for (const Banner* banner : page_->findChildren<Banner*>()) {
      if (banner->text().startsWith("The protocol could not be saved")) return true;
    }
    return false;
  }));
  EXPECT_TRUE(page_->has_unsaved_changes());
  std::filesystem::rename(folder_ / "elsewhere", folder_ / "protocols");
  click("editor_save");
  EXPECT_TRUE(saved());
}

TEST_F(ProtocolEditor, AsksBeforeItWritesOverWhatSomebodyElseHasWritten) {
  open();
  go_behind("\"planned\": 2");
  type("1");
  const std::string mine = page_->content();
  write_file(file_, "theirs", Overwrite::allow);
  click("editor_save");
  ASSERT_TRUE(eventually(
      [&] { return asks() && !page_->findChildren<QPushButton*>("editor_keep_mine").isEmpty(); }));
  EXPECT_EQ(read_file(file_), "theirs");
  EXPECT_EQ(page_->content(), mine);
  click("editor_keep_mine");
  if (page_->has_unsaved_changes()) click("editor_save");  // the news came before the saving
  ASSERT_TRUE(saved());
  EXPECT_EQ(read_file(file_), mine);
}

TEST_F(ProtocolEditor, TakesTheirsWhenToldToAndKeepsMineInTheUndo) {
  open();
  go_behind("\"planned\": 2");
  type("1");
  const std::string mine = page_->content();
  write_file(file_, "{\"theirs\": true}\n", Overwrite::allow);
  ASSERT_TRUE(eventually([&] { return asks(); }));
  click("editor_take_theirs");
  EXPECT_EQ(page_->content(), "{\"theirs\": true}\n");
  EXPECT_FALSE(page_->has_unsaved_changes());
  QTest::keyClick(&edit(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(page_->content(), mine);
  EXPECT_TRUE(page_->has_unsaved_changes());
}

TEST_F(ProtocolEditor, FollowsTheFileWhileNothingIsUnsaved) {
  open();
  write_file(file_, "{\"theirs\": true}\n", Overwrite::allow);
  EXPECT_TRUE(eventually([&] { return page_->content() == "{\"theirs\": true}\n"; }));
  EXPECT_FALSE(page_->has_unsaved_changes());
  EXPECT_FALSE(asks());
}

TEST_F(ProtocolEditor, DoesNotLeaveUnsavedChangesWithoutAsking) {
  open();
  QSignalSpy back(page_.get(), &ProtocolEditorPage::back_wanted);
  EXPECT_TRUE(page_->may_leave());
  go_behind("\"planned\": 2");
  type("1");
  click("editor_back");
  EXPECT_TRUE(asks());
  EXPECT_EQ(back.count(), 0);
  click("editor_leave_stay");
  QTest::qWait(0);
  EXPECT_EQ(back.count(), 0);
  EXPECT_TRUE(page_->has_unsaved_changes());

  click("editor_back");
  click("editor_leave_save");
  ASSERT_TRUE(eventually([&] { return back.count() == 1; }));
  EXPECT_NE(read_file(file_).find("\"planned\": 210,"), std::string::npos);

  go_behind("\"planned\": 2");
  type("2");
  const std::filesystem::path another = folder_ / "protocols" / "chapter_matching.json";
  page_->open(another);
  EXPECT_EQ(page_->file(), file_);
  click("editor_leave_discard");
  ASSERT_TRUE(eventually([&] { return page_->file() == another; }));
  EXPECT_EQ(page_->content(), library_text("chapter_matching"));
  EXPECT_NE(read_file(file_).find("\"planned\": 210,"), std::string::npos);
}

// Analyses pool simulated sessions of both texts as they pool those of people.
TEST_F(ProtocolEditor, AsksForANewVersionOnceSessionsWereSimulatedWithTheOldOne) {
  fill_with_participants(folder_);
  file_ = folder_ / "protocols" / "chapter_matching.json";
  {
    Study study = Study::open(folder_, Access::read_write);
    ProtocolRow protocol{};
    protocol.name = "chapter_matching";
    protocol.version = "1.1.0";
    protocol.kind = "matching";
    protocol.design = "chapter";
    protocol.source = read_file(file_);
    ASSERT_NE(protocol.source.find(R"("version": "1.1.0")"), std::string::npos);
    SessionRow session{};
    for (const SessionRow& each : study.sessions()) {
      if (each.mode == SessionMode::simulate) session = each;
    }
    session.protocol_id = study.add_protocol(protocol);
    session.session = 0;  // the next one
    session.state = SessionState::open;
    session.ended_utc.reset();
    PlannedTrialRow trial{};
    trial.trial = 1;
    trial.block = "main";
    trial.block_ordinal = 1;
    trial.phase = "main";
    trial.factors_json = "{}";
    study.end_session(study.add_session(session, {trial}), SessionState::completed,
                      "2026-03-02T10:00:00Z");
  }
  open();
  go_behind("\"title\": \"");
  type("New ");
  click("editor_save");
  ASSERT_TRUE(eventually([&] { return asks(); }));
  EXPECT_TRUE(child<QuestionBar>(*page_, "editor_question")
                  .question()
                  .startsWith("Sessions simulated with another text of version 1.1.0: 1."))
      << child<QuestionBar>(*page_, "editor_question").question().toStdString();
  EXPECT_EQ(read_file(file_), library_text("chapter_matching"));
}

TEST_F(ProtocolEditor, AsksForANewVersionOnceSessionsWereRunWithTheOldOne) {
  fill_with_participants(folder_);
  file_ = folder_ / "protocols" / "chapter_recognition.json";
  open();
  go_behind("\"title\": \"");
  type("New ");
  click("editor_save");
  ASSERT_TRUE(eventually([&] { return asks(); }));
  EXPECT_TRUE(child<QuestionBar>(*page_, "editor_question")
                  .question()
                  .contains("sessions were run with another text of version 1.1.0"));
  EXPECT_EQ(read_file(file_), library_text("chapter_recognition"));
  click("editor_raise_version");
  ASSERT_TRUE(saved());
  EXPECT_NE(read_file(file_).find("\"version\": \"1.1.1\""), std::string::npos);
  EXPECT_EQ(read_file(file_), page_->content());

  go_behind("\"version\": \"1.1.");
  QTest::keyClick(&edit(), Qt::Key_Delete);
  type("0");
  click("editor_save");
  ASSERT_TRUE(eventually([&] { return asks(); }));
  click("editor_save_anyway");
  ASSERT_TRUE(saved());
  EXPECT_NE(read_file(file_).find("\"version\": \"1.1.0\""), std::string::npos);
}

TEST_F(ProtocolEditor, GivesBackEveryByteThatItWasGiven) {
  for (const std::string& bytes :
       {std::string("{\r\n  \"a\": 1\r\n}\r\n"),
        std::string("{\"a\": \"\xC2\xA0 \xF0\x9F\x98\x80\"}"), std::string("")}) {
    write_file(file_, bytes, Overwrite::allow);
    open();
    EXPECT_EQ(page_->content(), bytes);
    EXPECT_FALSE(page_->has_unsaved_changes());
    EXPECT_FALSE(edit().isReadOnly());
  }
}

TEST_F(ProtocolEditor, DoesNotChangeAFileThatItCannotShowByteForByte) {
  for (const std::string& bytes : {std::string("{\"a\": \"\xFF\"}"), std::string("{\r\n\n}"),
                                   std::string("{\"\xE2\x80\xA9\"}")}) {
    write_file(file_, bytes, Overwrite::allow);
    open();
    EXPECT_TRUE(edit().isReadOnly()) << bytes;
    EXPECT_FALSE(child<QPushButton>(*page_, "editor_save").isEnabled());
    const auto expected = check_protocol(file_, study_->models(), folder_, std::nullopt);
    ASSERT_FALSE(page_->result()->diagnostics.empty());
    EXPECT_EQ(page_->result()->diagnostics[0].message.english(),
              expected.diagnostics[0].message.english());
    EXPECT_EQ(read_file(file_), bytes);
  }
}

TEST_F(ProtocolEditor, ShowsTheParametersOfSurfacesInTheirUnits) {
  open();
  edit().replace_text(QString::fromStdString(library_text("amplitude_jnd")));
  ASSERT_TRUE(checked());
  EXPECT_TRUE(eventually([&] { return label("plan_detail").contains("wavelength 2.5 mm"); }))
      << label("plan_detail").toStdString();
  EXPECT_TRUE(label("plan_detail").contains("amplitude 50 µm"));
  EXPECT_FALSE(label("plan_detail").contains("_m "));
}

TEST_F(ProtocolEditor, ShowsOneOfItsSidesWhereTheyHaveNoRoomTogether) {
  open();
  auto& plan = child<QWidget>(*page_, "editor_plan_side");
  EXPECT_TRUE(plan.isVisible());
  EXPECT_TRUE(edit().isVisible());
  EXPECT_LE(page_->minimumSizeHint().width(), 740) << "a window of 910 points with its navigation";
  page_->resize(740, 460);
  EXPECT_TRUE(eventually([&] { return !plan.isVisible(); }));
  EXPECT_TRUE(edit().isVisible());
  click("editor_side_plan");
  EXPECT_TRUE(plan.isVisible());
  EXPECT_FALSE(edit().isVisible());
  page_->resize(1366, 768);
  EXPECT_TRUE(eventually([&] { return plan.isVisible() && edit().isVisible(); }));
}

TEST_F(ProtocolEditor, KeepsTheFieldInUseInItsPlaceWhenNewsAndQuestionsAppear) {
  open();
  click("editor_to_form");
  page_->resize(1050, 696);
  auto& form = child<ProtocolForm>(*page_, "editor_form");
  form.go_to("/blocks/main/question/prompt");
  QApplication::processEvents();
  const QPointer<QWidget> field = QApplication::focusWidget();
  ASSERT_TRUE(form.isAncestorOf(field));
  QScrollBar& bar = *child<QScrollArea>(form, "form_area").verticalScrollBar();
  bar.setValue(bar.value() + 80);  // away from the lower end, which news below covers
  constexpr int kMoment_ms = 100;
  QTest::qWait(kMoment_ms);
  const QPoint before = field->mapTo(page_.get(), QPoint());
  emit form.edit_refused("this name is taken");
  QTest::qWait(kMoment_ms);
  EXPECT_EQ(field->mapTo(page_.get(), QPoint()), before);
  EXPECT_FALSE(field->visibleRegion().isEmpty());
  QTest::keyClicks(field, "x");
  page_->may_leave();
  QTest::qWait(kMoment_ms);
  EXPECT_TRUE(asks());
  EXPECT_EQ(field->mapTo(page_.get(), QPoint()), before);
}

// The widths with which the form is tested.
TEST_F(ProtocolEditor, LeavesTheFormItsWidthNextToThePlan) {
  for (const char* const language : {"de", "en"}) {
    apply_language(language);
    open();
    click("editor_to_form");
    auto& form = child<ProtocolForm>(*page_, "editor_form");
    const auto& name = child<FittedLabel>(*page_, "editor_name");
    page_->resize(1136, 784);
    EXPECT_TRUE(eventually([&] { return form.width() >= 650; })) << form.width();
    page_->resize(1050, 696);
    EXPECT_TRUE(eventually([&] { return form.width() >= 590; })) << form.width();
    EXPECT_FALSE(name.is_cut());
    page_->resize(740, 460);
    EXPECT_TRUE(eventually([&] { return form.width() >= 590; })) << form.width();
    EXPECT_FALSE(name.is_cut()) << name.width();
    take_screenshot(*page_, QString("editor-head-%1").arg(language), {740, 460});
    for (const char* const place : {"/blocks/main/question/form", "/blocks/main/order", "/factors",
                                    "/stimuli/rendered/model"}) {
      form.go_to(place);
      const QString picture =
          QString("editor-%1-%2").arg(language, QString(place).section('/', -1));
      take_screenshot(*page_, picture + "-1366", {1136, 870});
      take_screenshot(*page_, picture + "-1280", {1050, 690});
    }
  }
  apply_language("en");
}

TEST_F(ProtocolEditor, HasRoomForItsWordsInAGermanWindowOf1280Points) {
  std::string text = library_text("improved_recognition");
  text = replaced(text, "\"factors\": {",
                  "\"groups\": {\"factor\": \"ground\"}, "
                  "\"factors\": {\"ground\": {\"levels\": [\"dawn\", \"dusk\"]}, ");
  text = replaced(text, "\"break_every_trials\": 16", "\"break_every_trials\": 500");
  write_file(file_, text, Overwrite::allow);
  apply_language("de");
  open();
  click("editor_to_form");
  page_->resize(1050, 696);  // next to the names of the pages
  child<ProtocolForm>(*page_, "editor_form").show_page("order");
  const auto& problems = child<StudyTable>(*page_, "editor_problems");
  ASSERT_EQ(problems.shown_rows(), 1);
  EXPECT_TRUE(eventually([&] { return cut_cells(problems).isEmpty(); }));
  EXPECT_GE(problems.columnWidth(1), problems.columnWidth(2));
  EXPECT_LE(problems.rowHeight(0), problems.viewport()->height()) << "a problem is read as a whole";
  const auto& group = child<QComboBox>(*page_, "plan_group");
  QStyleOptionComboBox option{};
  option.initFrom(&group);
  const QRect room = group.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                   QStyle::SC_ComboBoxEditField, &group);
  EXPECT_GT(room.width(), group.fontMetrics().horizontalAdvance("dawn") + 4);
  constexpr int kLettersOfStep = 16;
  for (const QLabel* const summary : page_->findChildren<FittedLabel*>("summary")) {
    if (!summary->isVisible()) continue;
    EXPECT_GE(summary->width(), kLettersOfStep * summary->fontMetrics().averageCharWidth());
  }
  apply_language("en");
}

TEST_F(ProtocolEditor, Pictures) {
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, choice);
    const QString end = choice == ThemeChoice::light ? "" : "-dark";
    write_file(file_, library_text("improved_recognition"), Overwrite::allow);
    open();
    ASSERT_TRUE(
        eventually([&] { return child<StudyTable>(*page_, "plan_table").shown_rows() > 10; }));
    go_behind("\"level_d");
    take_screenshot(*page_, "editor-valid" + end);
    click("editor_to_form");
    click("editor_show_screen");
    child<QPushButton>(*page_, "screen_next").click();
    auto& form = child<ProtocolForm>(*page_, "editor_form");
    form.go_to("/blocks/main/question/prompt");
    ASSERT_TRUE(eventually([&] { return !label("screen_words").isEmpty(); }));
    take_screenshot(*page_, "editor-form" + end);
    take_screenshot(*page_, "editor-form-small" + end, {910, 512});
    find_in_form("deadline");
    take_screenshot(*page_, "editor-form-find" + end, {910, 512});
    QTest::keyClick(&child<QLineEdit>(*page_, "find_words"), Qt::Key_Escape);
    page_->resize(1366, 768);
    click("editor_show_plan");
    click("editor_to_text");
    go_behind("hand_oc");
    type("x");
    go_behind("\"level_dBA\": 6");
    type("5");
    go_behind("\"tiling\": \"");
    type("x");
    ASSERT_TRUE(checked());
    go_before("hand_ocx");
    take_screenshot(*page_, "editor-problems" + end);
    while (underlined().size() > 0) {
      QTest::keyClick(&edit(), Qt::Key_Z, Qt::ControlModifier);
      ASSERT_TRUE(checked());
    }
    edit().go_to(0);
    type(" ");
    QTest::keyClick(&edit(), Qt::Key_F, Qt::ControlModifier);
    child<QLineEdit>(*page_, "find_words").setText("stimuli/");
    page_->may_leave();
    take_screenshot(*page_, "editor-leaving" + end);
  }
  apply_theme(*qApp, ThemeChoice::light);
  apply_language("de");
  open();
  click("editor_to_form");
  find_in_form("Frage");
  take_screenshot(*page_, "german-editor-form-find", {910, 512});
  apply_language("en");
}

}  // namespace
}  // namespace asperity

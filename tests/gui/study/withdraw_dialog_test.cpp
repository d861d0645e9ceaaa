// Withdrawing a participant from the window: what is asked, what is said afterwards, and what the pages count then.

#include "app/gui/study/withdraw_dialog.h"

#include <string>

#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>

#include "app/gui/base/open_study.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/window/study_window.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

class Withdrawing : public QuietHome {
 protected:
  void SetUp() override {
    window_.resize(1280, 720);
    window_.show();
    folder_ = lively_study();
    Study study = Study::open(folder_, Access::read_write);
    study.end_output(study.begin_output(
        {.kind = OutputKind::public_export, .path = "/data/rough-surfaces-public"}));
    ASSERT_TRUE(window_.open_study(folder_));
  }

  StudyTable& table(const char* page, const char* name) {
    window_.show_page(page);
    return child<StudyTable>(window_, name);
  }

  /// The dialog about P001.
  WithdrawDialog& ask() {
    StudyTable& people = table("participants", "participants_table");
    EXPECT_TRUE(eventually([&] { return people.shown_rows() == 12; }));
    people.select("P001");
    QTest::mouseClick(&child<QPushButton>(window_, "participants_withdraw"), Qt::LeftButton);
    return child<WithdrawDialog>(window_, "withdraw_dialog");
  }

  static void do_it(WithdrawDialog& dialog) {
    auto& button = child<QPushButton>(dialog, "withdraw_do");
    ASSERT_TRUE(button.isEnabled());
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_TRUE(eventually([&] {
      return child<StateLabel>(dialog, "withdraw_state").state() == State::fine;
    })) << child<StateLabel>(dialog, "withdraw_state").text().toStdString();
  }

  std::filesystem::path folder_{};
  StudyWindow window_{};
};

TEST_F(Withdrawing, KeepsTheDataAndCountsTheParticipantNoMore) {
  WithdrawDialog& dialog = ask();
  EXPECT_FALSE(child<QPushButton>(dialog, "withdraw_do").isEnabled());
  QTest::keyClicks(&child<QLineEdit>(dialog, "withdraw_by"), "R. Keeper");
  EXPECT_EQ(child<QPushButton>(dialog, "withdraw_do").property("role"), "primary");
  take_screenshot(dialog, "withdraw-keep", dialog.size());
  do_it(dialog);
  EXPECT_TRUE(child<StateLabel>(dialog, "withdraw_state").text().contains("excluded"));
  StudyTable& people = table("participants", "participants_table");
  EXPECT_TRUE(eventually([&] { return people.text_at(0, 0) == "P001 (withdrawn)"; }));
  EXPECT_EQ(people.text_at(0, 4), "0");
  StudyTable& protocols = table("protocols", "protocols_table");
  EXPECT_TRUE(eventually([&] {
    for (int row = 0; row < protocols.shown_rows(); ++row) {
      if (protocols.text_at(row, 4) == "9 of 20") return true;
    }
    return false;
  }));
}

TEST_F(Withdrawing, DeletesOnceTheLabelIsTyped) {
  WithdrawDialog& dialog = ask();
  QTest::keyClicks(&child<QLineEdit>(dialog, "withdraw_by"), "R. Keeper");
  child<QRadioButton>(dialog, "withdraw_delete").click();
  EXPECT_FALSE(child<QPushButton>(dialog, "withdraw_do").isEnabled());
  QTest::keyClicks(&child<QLineEdit>(dialog, "withdraw_label"), "P00");
  EXPECT_FALSE(child<QPushButton>(dialog, "withdraw_do").isEnabled());
  QTest::keyClicks(&child<QLineEdit>(dialog, "withdraw_label"), "1");
  EXPECT_EQ(child<QPushButton>(dialog, "withdraw_do").property("role"), "danger")
      << "what cannot be restored";
  take_screenshot(dialog, "withdraw-delete", dialog.size());
  EXPECT_TRUE(child<QPlainTextEdit>(dialog, "withdraw_outputs")
                  .toPlainText()
                  .contains("/data/rough-surfaces-public"));
  do_it(dialog);
  take_screenshot(dialog, "withdraw-done", dialog.size());
  const Study study = Study::open(folder_, Access::read_only);
  EXPECT_FALSE(study.participant("P001"));
  ASSERT_EQ(study.withdrawals().size(), 1U);
  EXPECT_EQ(study.withdrawals()[0].decided_by, "R. Keeper");
  const StudyTable& people = table("participants", "participants_table");
  EXPECT_TRUE(eventually([&] { return people.shown_rows() == 11; }));
}

}  // namespace
}  // namespace asperity

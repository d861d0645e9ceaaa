// report: from a simulated study to a file that a person reads, without a screen.

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

class Report : public testing::Test {
 protected:
  /// Simulated once; each test has a copy.
  static const SmallStudy& simulated() {
    static const SmallStudy made = simulated_study(2, 3);
    return made;
  }
  Outcome report(const fs::path& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"report", small_.study(), "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return asperity(arguments);
  }
  fs::path file(const std::string& name) const { return small_.place() / name; }

  SmallStudy small_{simulated()};
};

TEST_F(Report, IsAFileThatSaysWhatIsInTheStudy) {
  const std::map<std::string, std::string> before = contents_of(small_.study());
  const Outcome html = report(file("report.html"));
  ASSERT_EQ(html.status, 0) << html.err;
  EXPECT_EQ(html.out, "");
  EXPECT_NE(html.err.find("100 %"), std::string::npos) << "how far it is";
  EXPECT_EQ(html.err.find("XDG_RUNTIME_DIR"), std::string::npos) << html.err;
  const std::string text = text_of(file("report.html"));
  for (const char* words :
       {"small_selection 1.0.0: virtual participants", "SIMULATED: no human participant",
        "Two virtual participants were simulated by a virtual hand", "small_recognition",
        "Further tests and numbers"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
  ASSERT_EQ(report(file("again.html")).status, 0);
  EXPECT_TRUE(text_of(file("again.html")) == text) << "the same study, the same bytes";
  const Outcome pdf = report(file("report.pdf"), {"--protocol", "small_selection"});
  ASSERT_EQ(pdf.status, 0) << pdf.err;
  EXPECT_EQ(text_of(file("report.pdf")).substr(0, 5), "%PDF-");
  // It lists its reports, and nothing else of it has changed.
  std::map<std::string, std::string> after = contents_of(small_.study());
  EXPECT_EQ(after.size(), before.size());
  for (const auto& [name, content] : before) {
    if (name.starts_with("study.sqlite")) continue;
    EXPECT_TRUE(after[name] == content) << name;
  }
  ASSERT_EQ(report(file("last.html")).status, 0);
  EXPECT_TRUE(text_of(file("last.html")) == text) << "the same study after it was written to";
}

// Outside a desktop session Qt warns of a folder that no file needs.
TEST_F(Report, IsWrittenWhereWarningsOfQtEndPrograms) {
  const Outcome outcome =
      run({.arguments = {"report", small_.study(), "--out", file("report.html")},
           .environment = {{"QT_FATAL_WARNINGS", "1"}, {"XDG_RUNTIME_DIR", ""}}});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(Report, IsNotWrittenWhereSomethingStandsInItsWay) {
  write_text(file("mine.pdf"), "precious");
  const Outcome there = report(file("mine.pdf"));
  EXPECT_EQ(there.status, 1);
  EXPECT_NE(there.err.find("already exists"), std::string::npos) << there.err;
  EXPECT_EQ(text_of(file("mine.pdf")), "precious");
  EXPECT_EQ(report(file("mine.pdf"), {"--force"}).status, 0);
  EXPECT_EQ(text_of(file("mine.pdf")).substr(0, 5), "%PDF-");

  EXPECT_EQ(report(file("report.docx")).status, 2);
  const Outcome nowhere = report(file("nowhere") / "report.pdf");
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_NE(nowhere.err.find("there is no folder"), std::string::npos) << nowhere.err;
  EXPECT_EQ(nowhere.err.find('%'), std::string::npos) << "before the work: " << nowhere.err;
  EXPECT_EQ(report(file("report.pdf"), {"--protocol", "another"}).status, 1);
  EXPECT_EQ(asperity({"report", file("no-study"), "--out", file("report.pdf")}).status, 1);
  EXPECT_EQ(asperity({"report", small_.study()}).status, 2);
  EXPECT_FALSE(fs::exists(file("report.pdf")));
  EXPECT_FALSE(fs::exists(file("report.docx")));
}

}  // namespace
}  // namespace asperity::test

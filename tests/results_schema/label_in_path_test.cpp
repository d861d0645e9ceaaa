// Which paths of outputs a withdrawal blanks: no more and no less than those that name the participant.

#include "results_schema/deletion/label_in_path.h"

#include <string>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(LabelInPath, IsTheNameOfAFolderInAnyLetterCase) {
  for (const char* path : {"/P013/tables", "/out/p013/tables/a.html", "/out/P013", "/out/p013/",
                           "P013/report.html", "/out//P013//tables"}) {
    EXPECT_TRUE(names_label(path, "P013")) << path;
  }
}

TEST(LabelInPath, StandsBetweenOtherCharactersInTheNameOfAFile) {
  for (const char* path :
       {"/out/P013.html", "/out/p013.html", "/out/report-P013.pdf", "/out/report_p013_final.pdf",
        "/out/export 2026 (P013)", "/out/P0135-P013.html", "P013"}) {
    EXPECT_TRUE(names_label(path, "P013")) << path;
  }
}

TEST(LabelInPath, IsNoPartOfALongerWordOrNumber) {
  for (const char* path : {"/out/P0135.html", "/out/P0135/tables", "/out/LP013.html",
                           "/out/reportP013.html", "/out/P013a", "/out/P01", "/out/tables", "", "/",
                           "/out/\u00fcP013.html", "/out/P013\u00fc.html"}) {
    EXPECT_FALSE(names_label(path, "P013")) << path;
  }
}

// The folders above an output are those of the computer.
TEST(LabelInPath, IsNoPartOfTheNameOfAFolder) {
  EXPECT_FALSE(names_label("/home/lab 1/study-1/tables", "1"));
  EXPECT_TRUE(names_label("/home/lab 1/1/tables", "1"));
  EXPECT_TRUE(names_label("/home/lab 1/tables-1", "1"));
}

}  // namespace
}  // namespace asperity

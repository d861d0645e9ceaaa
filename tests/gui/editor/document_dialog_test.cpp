// The documents in a window: from the table of methods to another page and back.

#include <QtGui/QTextBlock>
#include <QtTest/QTest>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>

#include "app/gui/base/documents.h"
#include "tests/gui/study/lively_study.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

class DocumentWindow : public QuietHome {
 protected:
  DocumentDialog& open(const QString& page) {
    auto* dialog = new DocumentDialog(page);
    dialog->setAttribute(Qt::WA_DeleteOnClose, false);
    dialog_.reset(dialog);
    dialog->show();
    return *dialog;
  }
  DocumentBrowser& text() { return child<DocumentBrowser>(*dialog_, "document_text"); }
  QString page() { return text().source().fileName(); }
  void follow(const QString& link) { text().setSource(text().source().resolved(QUrl(link))); }

 private:
  std::unique_ptr<DocumentDialog> dialog_{};
};

TEST_F(DocumentWindow, ShowsTheMethodsAndFollowsTheirLinks) {
  DocumentDialog& dialog = open("methods.md");
  EXPECT_EQ(page(), "methods.md");
  EXPECT_TRUE(text().toPlainText().contains("amplitude_jnd"));
  EXPECT_FALSE(text().toPlainText().contains("| ---")) << "the tables are shown as tables";
  auto& back = child<QPushButton>(dialog, "document_back");
  EXPECT_FALSE(back.isEnabled());
  take_screenshot(dialog, "methods");

  follow("procedures.md");
  EXPECT_EQ(page(), "procedures.md");
  back.click();
  EXPECT_EQ(page(), "methods.md");

  child<QPushButton>(dialog, "document_all").click();
  EXPECT_EQ(page(), "README.md");
  follow("formats/");
  EXPECT_EQ(page(), "README.md") << "a folder without a page is not followed";
}

TEST_F(DocumentWindow, ShowsTheHeadingThatALinkNames) {
  open("methods.md");
  const int top = text().verticalScrollBar()->value();
  follow("methods.md#identification");
  EXPECT_GT(text().verticalScrollBar()->value(), top);
  EXPECT_EQ(text().textCursor().block().text(), "Identification");
}

TEST_F(DocumentWindow, DoesNotFollowALinkToAFileThatIsNoDocument) {
  open("methods.md");
  follow("../CMakeLists.txt");
  EXPECT_EQ(page(), "methods.md");
}

}  // namespace
}  // namespace asperity

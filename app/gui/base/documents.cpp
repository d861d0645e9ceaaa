// Renders the Markdown files of the program in a QTextBrowser, whose headings are made into anchors of links.

#include "app/gui/base/documents.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QRegularExpression>
#include <QtGui/QDesktopServices>
#include <QtGui/QTextBlock>
#include <QtGui/QTextTable>
#include <QtWidgets/QBoxLayout>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"

namespace asperity {

namespace {

/// As in links to a heading: "Which question, which method" → "which-question-which-method".
QString anchor_of(const QString& heading) {
  static const QRegularExpression kLeftOut(QStringLiteral("[^\\w\\- ]"),
                                           QRegularExpression::UseUnicodePropertiesOption);
  return heading.trimmed().toLower().remove(kLeftOut).replace(' ', '-');
}

}  // namespace

QString documents_folder() {
  // Beside an installed program, or in the source tree that a build lies in.
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* place : {"../share/doc/asperity", "../docs", "../../docs", "../../../docs"}) {
    const QString folder = QDir::cleanPath(program.absoluteFilePath(place));
    if (QDir(folder).exists("command-line.md")) return folder;
  }
  return {};
}

DocumentBrowser::DocumentBrowser(QWidget* parent) : QTextBrowser(parent) {
  setFont(text_font(TextSize::small));  // so that the widest tables fit
  document()->setDocumentMargin(kMargin);
  connect(this, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
    show_lines_of_tables();
    show_heading(url.fragment());
  });
}

void DocumentBrowser::doSetSource(const QUrl& url, QTextDocument::ResourceType /*type*/) {
  if (!url.isLocalFile()) {
    QDesktopServices::openUrl(url);
    return;
  }
  QUrl page = url;
  if (QFileInfo(url.toLocalFile()).isDir()) {
    page.setPath(QDir::cleanPath(url.path() + "/README.md"));
  }
  // The documents name files of the source, too, which an installed program does not have.
  if (!page.path().endsWith(".md") || !QFileInfo::exists(page.toLocalFile())) return;
  QTextBrowser::doSetSource(page, QTextDocument::MarkdownResource);
}

void DocumentBrowser::show_lines_of_tables() {
  for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setBorderCollapse(true);
    format.setBorder(1);
    format.setBorderBrush(theme().line);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setCellPadding(kGrid / 2.0);
    format.setTopMargin(kGrid);
    format.setBottomMargin(kGrid);
    table->setFormat(format);
  }
}

void DocumentBrowser::show_heading(const QString& anchor) {
  if (anchor.isEmpty()) return;
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || anchor_of(block.text()) != anchor) continue;
    QTextCursor cursor(block);
    moveCursor(QTextCursor::End);  // so that the heading comes to the top
    setTextCursor(cursor);
    return;
  }
}

DocumentDialog::DocumentDialog(const QString& page, QWidget* parent) : QDialog(parent) {
  setObjectName("document_dialog");
  setWindowTitle(tr("Documents"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(1120, 640);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  browser_ = new DocumentBrowser(this);
  browser_->setObjectName("document_text");
  browser_->setAccessibleName(tr("Text of the document"));

  auto* row = new QHBoxLayout();
  QPushButton* back = make_button(tr("← Back"), ButtonRole::plain, this);
  back->setObjectName("document_back");
  back->setEnabled(false);
  connect(back, &QPushButton::clicked, browser_, &QTextBrowser::backward);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  QPushButton* all = make_button(tr("All documents"), ButtonRole::plain, this);
  all->setObjectName("document_all");
  QPushButton* close = make_button(tr("Close"), ButtonRole::plain, this);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  row->addWidget(back);
  row->addWidget(all);
  row->addStretch(1);
  row->addWidget(close);
  layout->addWidget(browser_, 1);
  layout->addLayout(row);

  const QString folder = documents_folder();
  all->setEnabled(!folder.isEmpty());
  if (folder.isEmpty()) {
    browser_->setPlainText(
        tr("The documents are not installed on this computer. They are in the folder “docs” of the "
           "source, and in the Debian package."));
    return;
  }
  const auto show_page = [this, folder](const QString& name) {
    browser_->setSource(QUrl::fromLocalFile(folder + '/' + name));
  };
  connect(all, &QPushButton::clicked, this, [show_page] { show_page("README.md"); });
  show_page(page);
}

}  // namespace asperity

#include "moc_documents.cpp"

// Shows the documents of the program in a window of their own.

#pragma once

#include <QtCore/QUrl>
#include <QtWidgets/QDialog>
#include <QtWidgets/QTextBrowser>

namespace asperity {

/// Where the documents of this program lie on this machine; empty when they were not installed.
QString documents_folder();

/// Reads Markdown: tables have lines, and a link to a heading ("#thresholds") shows it.
class DocumentBrowser final : public QTextBrowser {
  Q_OBJECT
 public:
  explicit DocumentBrowser(QWidget* parent = nullptr);

 protected:
  /// A page of the documents is shown here, an address on the web in the web browser. A folder is its README.md.
  void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;

 private:
  void show_lines_of_tables();
  void show_heading(const QString& anchor);
};

/// Not modal: an author reads it beside the protocol.
class DocumentDialog final : public QDialog {
  Q_OBJECT
 public:
  /// `page` is relative to documents_folder(): "methods.md". Where the documents are not installed the window states so.
  explicit DocumentDialog(const QString& page, QWidget* parent = nullptr);

 private:
  DocumentBrowser* browser_ = nullptr;
};

}  // namespace asperity

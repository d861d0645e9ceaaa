// Asks for a file, writes the figure as SVG, PDF or PNG by its ending, and copies figures.

#include "app/gui/data/figure_saver.h"

#include <QtCore/QMimeData>
#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtGui/QImage>
#include <QtWidgets/QFileDialog>

#include "app/figures/figure_files.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

struct CopiedFigure {
  QImage picture{};
  QByteArray svg{};
};

QByteArray bytes_of(const std::string& text) {
  return QByteArray(text.data(), static_cast<qsizetype>(text.size()));
}

/// "svg" of "SVG, … (*.svg)".
QString ending_in(const QString& filter) { return filter.section("(*.", 1).section(')', 0, 0); }

}  // namespace

FigureSaver::FigureSaver(Banner& banner, QWidget& page)
    : QObject(&page), banner_(banner), page_(page) {}

void FigureSaver::ask_where_to_save(const Figure& figure, double width_mm,
                                    const std::string& name) {
  auto* dialog = new QFileDialog(&page_, tr("File for the figure"));
  dialog->setObjectName("figure_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->setOption(QFileDialog::DontConfirmOverwrite);  // the banner asks
  dialog->setNameFilters({tr("SVG, for the web and for drawing programs (*.svg)"),
                          tr("PDF, for print and LaTeX (*.pdf)"),
                          tr("PNG, for slides and office programs (*.png)")});
  dialog->setDefaultSuffix("svg");
  dialog->selectFile(QString::fromStdString(name + ".svg"));
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    const QString ending = ending_in(filter);
    dialog->setDefaultSuffix(ending);
    const QStringList files = dialog->selectedFiles();
    if (files.isEmpty()) return;
    const QString file = files.front();
    for (const char* other : {".svg", ".pdf", ".png"}) {
      if (file.endsWith(other)) dialog->selectFile(file.chopped(4) + "." + ending);
    }
  });
  connect(dialog, &QFileDialog::fileSelected, this, [this, figure, width_mm](const QString& file) {
    save(figure, width_mm, file.toStdString(), Overwrite::refuse);
  });
  dialog->open();
}

void FigureSaver::save(const Figure& figure, double width_mm, const std::filesystem::path& file,
                       Overwrite overwrite) {
  const QString shown = QString::fromStdString(file.string());
  if (saving_.is_running()) {
    banner_.show_news(State::look, tr("Another figure is being saved; save this one afterwards."));
    return;
  }
  std::error_code error{};
  if (overwrite == Overwrite::refuse && std::filesystem::exists(file, error)) {
    banner_.show_news(
        State::look,
        tr("The file %1 already exists. Replace it, or save the figure under another name.")
            .arg(shown),
        tr("Replace “%1”").arg(QString::fromStdString(file.filename().string())),
        [this, figure, width_mm, file] { save(figure, width_mm, file, Overwrite::allow); });
    return;
  }
  saving_.run<bool>(
      [figure, width_mm, file, overwrite, look_up = language_of_windows()](
          const std::stop_token&, const BackgroundTask::Progress&) {
        write_figure(file, figure, {.width_mm = width_mm, .look_up = look_up}, overwrite);
        return true;
      },
      [this, shown](bool) {
        banner_.show_news(State::fine, tr("The figure is in %1.").arg(shown));
      },
      [this](const QString& what) {
        banner_.show_news(State::stop, tr("The figure was not saved: %1").arg(what));
      });
}

void FigureSaver::copy(const Figure& figure) {
  copying_.run<CopiedFigure>(
      [figure, look_up = language_of_windows()](const std::stop_token&,
                                                const BackgroundTask::Progress&) {
        const FigurePrint print{.look_up = look_up};
        return CopiedFigure{.picture = QImage::fromData(bytes_of(png_of(figure, print)), "PNG"),
                            .svg = bytes_of(svg_of(figure, print))};
      },
      [this](const CopiedFigure& copied_figure) {
        auto* content = new QMimeData();  // the clipboard's from here on
        content->setImageData(copied_figure.picture);
        content->setData("image/svg+xml", copied_figure.svg);
        QGuiApplication::clipboard()->setMimeData(content);
        banner_.show_news(State::fine,
                          tr("The figure is on the clipboard, as a picture and as SVG."));
        emit copied();
      },
      [this](const QString& what) {
        banner_.show_news(State::stop, tr("The figure was not copied: %1").arg(what));
      });
}

}  // namespace asperity

#include "moc_figure_saver.cpp"

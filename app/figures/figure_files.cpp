// Lays a figure out in hundredths of a millimetre and draws it into each format.

#include "app/figures/figure_files.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <QtCore/QBuffer>
#include <QtCore/QByteArray>
#include <QtCore/QUuid>
#include <QtCore/qlogging.h>
#include <QtGui/QFontDatabase>
#include <QtGui/QGuiApplication>
#include <QtGui/QImage>
#include <QtGui/QPageSize>
#include <QtGui/QPainter>
#include <QtGui/QPdfWriter>
#include <QtSvg/QSvgGenerator>

#include "app/figures/draw_figure.h"
#include "app/figures/figure_layout.h"

namespace asperity {

namespace {

// Files are laid out in hundredths of a millimetre, so that font and page sizes are integers.
constexpr double kUnitsPerMillimetre = 100.0;
constexpr double kMillimetresPerInch = 25.4;
constexpr int kUnitsPerInch = 2540;
constexpr double kLetters_pt = 8.0;
constexpr double kPointsPerInch = 72.0;
constexpr double kPngDotsPerInch = 300.0;

struct Sheet {
  FigureLook look{};
  double width = 0.0;  ///< in units
  double height = 0.0;

  double width_mm() const { return width / kUnitsPerMillimetre; }
  double height_mm() const { return height / kUnitsPerMillimetre; }
};

Sheet sheet_of(const Figure& figure, const FigurePrint& print) {
  Sheet sheet{};
  sheet.look.letters = kLetters_pt / kPointsPerInch * kUnitsPerInch;
  sheet.look.look_up = print.look_up;
  sheet.width = std::round(print.width_mm * kUnitsPerMillimetre);
  sheet.height = std::ceil(figure_height(figure, sheet.width, sheet.look));
  return sheet;
}

QString words_of(const Phrase& phrase, const FigurePrint& print) {
  return QString::fromStdString(print.look_up ? phrase.translated(print.look_up)
                                              : phrase.english());
}

std::string text_of_bytes(const QByteArray& bytes) {
  return std::string(bytes.constData(), static_cast<std::size_t>(bytes.size()));
}

/// Programs without the font family that Qt found use another sans-serif font.
void name_any_sans(QByteArray& svg, const FigureLayout& layout) {
  const QByteArray family = layout.font().family().toUtf8();
  svg.replace("font-family=\"" + family + '"', "font-family=\"" + family + ", sans-serif\"");
}

/// Replaces the time stamps, in the document's entries and in its metadata (XMP), by as many blanks: the offsets of a PDF's
/// objects are counted in bytes.
void take_out_the_dates(QByteArray& pdf) {
  const std::pair<QByteArray, char> stamps[]{{"/CreationDate (", ')'},
                                             {"/ModDate (", ')'},
                                             {"xmp:CreateDate=\"", '"'},
                                             {"xmp:ModifyDate=\"", '"'},
                                             {"xmp:MetadataDate=\"", '"'}};
  for (const auto& [key, closing] : stamps) {
    const auto begin = pdf.indexOf(key);
    if (begin < 0) continue;
    const auto end = pdf.indexOf(closing, begin + key.size());
    for (auto i = begin; i <= end; ++i) pdf[i] = ' ';
  }
}

}  // namespace

std::string svg_of(const Figure& figure, const FigurePrint& print) {
  const Sheet sheet = sheet_of(figure, print);
  QByteArray bytes{};
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator svg{};
  svg.setOutputDevice(&buffer);
  svg.setResolution(kUnitsPerInch);
  svg.setSize({static_cast<int>(sheet.width), static_cast<int>(sheet.height)});
  svg.setViewBox(QRectF(0.0, 0.0, sheet.width, sheet.height));
  svg.setTitle(words_of(figure.title, print));
  svg.setDescription(words_of(figure.note, print));
  QPainter painter(&svg);
  // A viewer with a dark background would show dark text on it.
  painter.fillRect(QRectF(0.0, 0.0, sheet.width, sheet.height), sheet.look.colors.ground);
  draw_figure(figure, painter, QRectF(0.0, 0.0, sheet.width, sheet.height), sheet.look);
  painter.end();
  name_any_sans(bytes, FigureLayout(figure, sheet.width, sheet.look));
  return text_of_bytes(bytes);
}

std::string png_of(const Figure& figure, const FigurePrint& print) {
  const Sheet sheet = sheet_of(figure, print);
  const double dots = kPngDotsPerInch / kUnitsPerInch;
  QImage image(static_cast<int>(std::lround(sheet.width * dots)),
               static_cast<int>(std::ceil(sheet.height * dots)), QImage::Format_RGB32);
  image.fill(sheet.look.colors.ground);
  const int per_metre = static_cast<int>(std::lround(kPngDotsPerInch / kMillimetresPerInch * 1e3));
  image.setDotsPerMeterX(per_metre);
  image.setDotsPerMeterY(per_metre);
  QPainter painter(&image);
  painter.scale(dots, dots);
  draw_figure(figure, painter, QRectF(0.0, 0.0, sheet.width, sheet.height), sheet.look);
  painter.end();
  QByteArray bytes{};
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return text_of_bytes(bytes);
}

std::string pdf_of(const Figure& figure, const FigurePrint& print) {
  const Sheet sheet = sheet_of(figure, print);
  QByteArray bytes{};
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter pdf(&buffer);
  pdf.setResolution(kUnitsPerInch);
  pdf.setPageSize(QPageSize(QSizeF(sheet.width_mm(), sheet.height_mm()), QPageSize::Millimeter, {},
                            QPageSize::ExactMatch));
  pdf.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
  pdf.setTitle(words_of(figure.title, print));
#if QT_VERSION >= QT_VERSION_CHECK(6, 8, 0)
  // Otherwise it is drawn at random. That of the figure's contents is the same whenever it is written.
  pdf.setDocumentId(QUuid::createUuidV5(QUuid(), QByteArray::fromStdString(svg_of(figure, print))));
#endif
  QPainter painter(&pdf);
  draw_figure(figure, painter, QRectF(0.0, 0.0, sheet.width, sheet.height), sheet.look);
  painter.end();
  take_out_the_dates(bytes);
  return text_of_bytes(bytes);
}

namespace {

using BytesOfFigure = std::string (*)(const Figure&, const FigurePrint&);

/// Null for an extension that is not supported.
BytesOfFigure bytes_by_ending(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".svg") return svg_of;
  if (ending == ".png") return png_of;
  if (ending == ".pdf") return pdf_of;
  return nullptr;
}

}  // namespace

void require_figure_ending(const std::filesystem::path& path) {
  if (bytes_by_ending(path) != nullptr) return;
  throw std::invalid_argument("the figure \"" + path.filename().string() +
                              "\" cannot be written; its name must end in .svg, .png or .pdf");
}

std::string figure_bytes(const std::filesystem::path& path, const Figure& figure,
                         const FigurePrint& print) {
  require_figure_ending(path);
  return bytes_by_ending(path)(figure, print);
}

void write_figure(const std::filesystem::path& path, const Figure& figure, const FigurePrint& print,
                  Overwrite overwrite) {
  write_file(path, figure_bytes(path, figure, print), overwrite);
}

namespace {

/// Suppresses a warning of Qt: a terminal outside a desktop session has no folder for sockets,
/// which is not required here.
class QuietStart final {
 public:
  QuietStart() : before_(qInstallMessageHandler(hear)) {}
  ~QuietStart() { qInstallMessageHandler(before_); }
  QuietStart(const QuietStart&) = delete;
  QuietStart& operator=(const QuietStart&) = delete;

 private:
  static void hear(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (message.contains("XDG_RUNTIME_DIR not set")) return;
    std::fprintf(stderr, "%s\n", qPrintable(qFormatLogMessage(type, context, message)));
  }

  QtMessageHandler before_ = nullptr;
};

}  // namespace

struct LettersWithoutWindows::Application {
  int count = 1;
  char name[9] = "asperity";
  char* arguments[2] = {name, nullptr};
  std::optional<QuietStart> quiet{std::in_place};
  QGuiApplication application;

  Application() : application(count, arguments) { quiet.reset(); }
};

LettersWithoutWindows::LettersWithoutWindows() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // A request to end at the first warning of Qt is about windows: that of QuietStart would end the program.
  qunsetenv("QT_FATAL_WARNINGS");
  application_ = std::make_unique<Application>();
}

LettersWithoutWindows::~LettersWithoutWindows() = default;

}  // namespace asperity

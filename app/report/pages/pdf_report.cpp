// Draws the pages of the layout with a PDF writer of Qt.

#include "app/report/pages/pdf_report.h"

#include <stdexcept>

#include <QtCore/QBuffer>
#include <QtGui/QPageLayout>
#include <QtGui/QPageSize>
#include <QtGui/QPainter>
#include <QtGui/QPdfWriter>

#include "app/report/pages/report_pages.h"

namespace asperity {

std::string pdf_of(const Report& report, const std::stop_token& stop,
                   const std::function<void(double)>& progress) {
  constexpr double kLayoutShare = 0.5;
  const ReportPages pages(report, stop, [&progress](double fraction) {
    if (progress) progress(kLayoutShare * fraction);
  });
  QByteArray bytes{};
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kReportUnitsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({}, QPageLayout::Point);
    writer.setTitle(QString::fromStdString(report.title));
    writer.setCreator(QString::fromStdString(report.program));
    QPainter painter(&writer);
    for (std::size_t page = 0; page < pages.count(); ++page) {
      if (stop.stop_requested()) break;
      if (page > 0 && !writer.newPage())
        throw std::runtime_error(
            "a further page of the PDF cannot be created; write the report as .html");
      pages.draw(page, painter);
      if (progress) {
        progress(kLayoutShare + (1.0 - kLayoutShare) * static_cast<double>(page + 1) /
                                    static_cast<double>(pages.count()));
      }
    }
  }
  return bytes.toStdString();
}

}  // namespace asperity

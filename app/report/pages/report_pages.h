// Lays a report out on A4 pages: the positions of all lines, rules and figures.

#pragma once

#include <functional>
#include <stop_token>
#include <variant>
#include <vector>

#include <QtCore/QPointF>
#include <QtCore/QRectF>
#include <QtCore/QSizeF>
#include <QtCore/QString>
#include <QtGui/QColor>
#include <QtGui/QFont>

#include "app/report/text/report.h"

class QPainter;

namespace asperity {

/// All lengths are in twentieths of a point (1/1440 inch): fine enough for the position of letters
/// in print.
inline constexpr int kReportUnitsPerInch = 1440;

struct PageText {
  QPointF baseline{};
  QString text{};
  QFont font{};
  QColor color{};
  double width = 0.0;
};
struct PageBox {
  QRectF place{};
  QColor color{};
};
struct PageFigure {
  QRectF place{};
  const Figure* figure = nullptr;  ///< of the report
};
using PageMark = std::variant<PageText, PageBox, PageFigure>;

/// Pages with a heading that names their chapter and the origin of its data, and with a page
/// number. A heading stays with what follows it; a table that fits on a page is not split where
/// only a small part would remain, and a longer one continues under repeated headings; no line of a
/// paragraph is left alone.
///
/// Requires a Qt application. After a stop request, contains the pages that are finished.
class ReportPages final {
 public:
  /// `report` outlives it.
  explicit ReportPages(const Report& report, const std::stop_token& stop = {},
                       const std::function<void(double)>& progress = {});

  std::size_t count() const noexcept { return pages_.size(); }
  const std::vector<PageMark>& marks(std::size_t page) const { return pages_.at(page); }
  /// The size of an A4 page.
  static QSizeF size();
  /// The area of everything except heading and page number.
  static QRectF text_area();
  /// The painter's units are those of the layout. Its state is restored.
  void draw(std::size_t page, QPainter& painter) const;

 private:
  std::vector<std::vector<PageMark>> pages_{};
};

}  // namespace asperity

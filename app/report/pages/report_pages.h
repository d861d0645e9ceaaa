// A report laid out on pages of A4: where every line, rule and figure stands.

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

/// All lengths are twentieths of a point (1/1440 inch): fine enough that letters stand where they
/// would on paper.
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

/// Pages with a heading that says which chapter they belong to and whose data they show, and with
/// their number. A heading stays with what follows it; a table that fits on a page is not cut where
/// little of it would stay, and a longer one goes on under its headings; no line of a paragraph
/// stands alone.
///
/// Needs an application of Qt. When asked to stop, the pages there are by then.
class ReportPages final {
 public:
  /// `report` outlives it.
  explicit ReportPages(const Report& report, const std::stop_token& stop = {},
                       const std::function<void(double)>& progress = {});

  std::size_t count() const noexcept { return pages_.size(); }
  const std::vector<PageMark>& marks(std::size_t page) const { return pages_.at(page); }
  /// Of a page of A4.
  static QSizeF size();
  /// Where all but heading and number stands.
  static QRectF text_area();
  /// The painter's units are those of the layout. Its state is left as it was.
  void draw(std::size_t page, QPainter& painter) const;

 private:
  std::vector<std::vector<PageMark>> pages_{};
};

}  // namespace asperity

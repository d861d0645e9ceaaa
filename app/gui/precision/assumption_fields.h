// The assumptions of a power analysis as fields: what simulated responses depend on, to be read and stated.

#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/power/assumption.h"
#include "protocols/shapes/shape.h"

class QGridLayout;
class QLabel;
class QLineEdit;

namespace asperity {

/// A field for each assumption, with its unit and source; the meaning is the tooltip. A field without a value is empty. An emptied
/// field has the usual value of the program again, if there is one.
///
/// The object names of the fields are the names of the assumptions. Values are in SI; small lengths are shown in µm or mm.
class AssumptionFields final : public QWidget {
  Q_OBJECT
 public:
  using Stated = std::map<std::string, double>;  ///< by the names of the assumptions

  explicit AssumptionFields(QWidget* parent = nullptr);

  /// `usual`: the assumptions of the protocol. Does not signal.
  void show_assumptions(const std::vector<Assumption>& usual, const Stated& stated);
  const Stated& stated() const noexcept { return stated_; }
  /// The captions of the fields in which something is typed that is not a value, with a comma between them; or empty.
  QString invalid_fields() const;
  /// In the order of the layout.
  const std::vector<QLineEdit*>& fields() const noexcept { return fields_; }

 signals:
  void edited();  ///< something was typed

 private:
  void add_row(std::size_t index, QGridLayout& grid, int line);
  void take(std::size_t index, const QString& typed);
  void show_value(std::size_t index);
  void show_source(std::size_t index);

  std::vector<Assumption> usual_{};
  Stated stated_{};
  std::set<std::size_t> invalid_{};
  QWidget* rows_ = nullptr;  ///< made again for other assumptions
  std::vector<QLineEdit*> fields_{};
  std::vector<QLabel*> sources_{};
};

/// "comparisons, rougher: order, SD" for "comparisons.rougher.order_sd".
QString assumption_caption(const std::string& name);
/// The unit for display, with a power of ten that suits the usual value; without a unit empty.
QString unit_text(const Assumption& usual);
NumberShape shape_of(const Assumption& usual);
/// A number in SI as it is shown: in the unit of the shape, with 3 significant digits.
QString rounded_in_unit(double value, const NumberShape& shape);

}  // namespace asperity

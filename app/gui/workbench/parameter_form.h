// A form for declared parameters: of a force model, or of anything else that declares some.

#pragma once

#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "stimuli/properties/parameter.h"

class QGridLayout;

namespace asperity {

enum class FormStyle {
  fields,   ///< a field for each number
  sliders,  ///< a slider under it as well, its default marked
};

/// The form follows from the declarations alone: a field with its unit and range for a number, a
/// list for a choice, the meaning as tool tip, and "default" or a button that resets beside each.
///
/// Values are SI, as everywhere; on the screen metres become µm or mm, m/s becomes mm/s and radians
/// degrees. A value that nobody edits comes back exactly as it was set. What is typed is converted
/// as a decimal number, so that 0.1 mm is 1e-4 m to the last bit.
///
/// The object names of the controls are those of the parameters, "reset_NAME" of the buttons and
/// "slider_NAME" of the sliders.
class ParameterForm final : public QWidget {
  Q_OBJECT
 public:
  explicit ParameterForm(std::vector<Parameter> parameters, FormStyle style = FormStyle::fields,
                         QWidget* parent = nullptr);
  ~ParameterForm() override;

  const std::vector<Parameter>& parameters() const noexcept { return parameters_; }
  /// Of all parameters.
  ParameterValues values() const;
  /// Of those alone that differ from their default.
  ParameterValues given() const;
  /// Errors: std::invalid_argument, with nothing changed, as `complete_values`. Does not signal.
  void set_values(const ParameterValues& values);
  /// Other defaults than the declared ones (a sample's suggestion); what stood at its default
  /// follows. Errors and signals: as set_values.
  void set_defaults(const ParameterValues& defaults);
  void reset();

  /// A slider is held.
  bool is_dragging() const noexcept { return dragging_; }

 signals:
  void edited();    ///< by a person, or by `reset`
  void released();  ///< of a slider

 private:
  struct Row;
  void add_row(std::size_t index, QGridLayout* grid, int& line, FormStyle style);
  void add_number(std::size_t index, QGridLayout* grid, int& line, FormStyle style);
  void edit(std::size_t index, const ParameterValue& value);
  void show_row(std::size_t index);

  std::vector<Parameter> parameters_{};
  std::vector<Row> rows_;
  bool dragging_ = false;
};

/// With its unit as on the screen: "0.5 mm".
QString text_of(const Parameter& parameter, const ParameterValue& value);

}  // namespace asperity

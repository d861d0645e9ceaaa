// Makes a slider, field or list for each parameter, and shows few digits without losing any.

#include "app/gui/workbench/parameter_form.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtGui/QPainter>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QSlider>
#include <QtWidgets/QStyleOptionSlider>

#include "analysis/numbers/number_text.h"
#include "app/gui/base/parameter_unit.h"
#include "app/gui/base/parameter_words.h"
#include "app/gui/base/question_form.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/decimal_field.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr int kSliderSteps = 1000;
constexpr int kParameterFieldWidth = 128;
constexpr int kResetWidth = 64;

struct FormWords {
  Q_DECLARE_TR_FUNCTIONS(FormWords)
};

/// value · 10^exponent by moving the decimal point, not by a product that rounds.
double decimal_shifted(double value, int exponent) {
  const std::string text = shifted_decimal(number_text(value), exponent).value_or("");
  double shifted = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), shifted);
  return shifted;
}

/// A unit on the screen: shown = SI · 10^exponent, or SI / factor.
struct ShownUnit {
  QString name{};
  int exponent = 0;
  double factor = 1.0;

  double shown(double si) const {
    return factor == 1.0 ? decimal_shifted(si, exponent) : si / factor;
  }
  double si(double shown) const {
    return factor == 1.0 ? decimal_shifted(shown, -exponent) : shown * factor;
  }
};

ShownUnit shown_unit(const Parameter& parameter) {
  const DisplayUnit display = display_unit_of(parameter);
  const std::string_view own = parameter.unit == "1" ? std::string_view() : parameter.unit;
  const std::string name(display.unit.empty() ? own : display.unit);
  return {QString::fromStdString(name), -display.power, display.factor};
}

/// Four significant digits without exponent or trailing zeros, with a point.
QString short_number(double value) {
  if (value == 0.0) return "0";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  QString text = QString::number(value, 'f', std::clamp(3 - magnitude, 0, 9));
  if (text.contains('.')) {
    while (text.endsWith('0')) text.chop(1);
    if (text.endsWith('.')) text.chop(1);
  }
  return text;
}

/// Shows few digits and keeps all of them until somebody types.
class NumberField final : public DecimalField {
 public:
  explicit NumberField(QWidget* parent) : DecimalField(parent) {
    setDecimals(12);
    setStepType(AdaptiveDecimalStepType);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
    setButtonSymbols(NoButtons);  // arrow keys and the slider step as well
    setFocusPolicy(Qt::StrongFocus);
  }
  QString textFromValue(double value) const override {
    return short_number(value).replace('.', locale().decimalPoint());
  }
  double valueFromText(const QString& text) const override {
    const QString number = QString(text).remove(suffix()).trimmed();
    return number == textFromValue(value()) ? value() : DecimalField::valueFromText(text);
  }

 protected:
  // A panel that is scrolled with the wheel must not change what lies under the pointer.
  void wheelEvent(QWheelEvent* event) override {
    hasFocus() ? DecimalField::wheelEvent(event) : event->ignore();
  }
};

class MarkedSlider final : public QSlider {
 public:
  explicit MarkedSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setRange(0, kSliderSteps);
    setPageStep(kSliderSteps / 20);
  }
  void set_mark(int step) {
    mark_ = step;
    update();
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QStyleOptionSlider option{};
    initStyleOption(&option);
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
    const int x =
        handle / 2 + QStyle::sliderPositionFromValue(0, kSliderSteps, mark_, width() - handle);
    {
      QPainter painter(this);
      painter.fillRect(QRect(x - 1, height() / 2 - 8, 2, 16), theme().muted);
    }
    QSlider::paintEvent(event);
  }
  void wheelEvent(QWheelEvent* event) override {
    hasFocus() ? QSlider::wheelEvent(event) : event->ignore();
  }

 private:
  int mark_ = 0;
};

/// A range over more than a factor of 50 is walked in proportions.
bool is_logarithmic(const Parameter& parameter) {
  return parameter.minimum > 0.0 && parameter.maximum / parameter.minimum >= 50.0;
}

int step_of(const Parameter& parameter, double value) {
  double share = (value - parameter.minimum) / (parameter.maximum - parameter.minimum);
  if (is_logarithmic(parameter)) {
    share = std::log(value / parameter.minimum) / std::log(parameter.maximum / parameter.minimum);
  }
  return static_cast<int>(std::lround(kSliderSteps * std::clamp(share, 0.0, 1.0)));
}

double value_at(const Parameter& parameter, int step) {
  if (step <= 0) return parameter.minimum;
  if (step >= kSliderSteps) return parameter.maximum;
  const double share = static_cast<double>(step) / kSliderSteps;
  const double value =
      is_logarithmic(parameter)
          ? parameter.minimum * std::pow(parameter.maximum / parameter.minimum, share)
          : parameter.minimum + share * (parameter.maximum - parameter.minimum);
  if (value == 0.0) return value;
  // Three digits: nobody means more with a slider.
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double rounded =
      decimal_shifted(std::round(decimal_shifted(value, 2 - magnitude)), magnitude - 2);
  return std::clamp(parameter.kind == ParameterKind::integer ? std::round(value) : rounded,
                    parameter.minimum, parameter.maximum);
}

QString tip_of(const Parameter& parameter) {
  const QString meaning = words_of(parameter.meaning).toHtmlEscaped();
  const QString name = QString::fromStdString(parameter.name);
  if (parameter.kind == ParameterKind::choice) {
    return FormWords::tr("<p>%1.</p><p>In files: %2</p>").arg(meaning, name);
  }
  return FormWords::tr("<p>%1.</p><p>From %2 to %3. In files: %4</p>")
      .arg(meaning, text_of(parameter, parameter.minimum), text_of(parameter, parameter.maximum),
           name);
}

}  // namespace

QString text_of(const Parameter& parameter, const ParameterValue& value) {
  if (const auto* choice = std::get_if<std::string>(&value)) {
    return choice_name(parameter, *choice);
  }
  const ShownUnit unit = shown_unit(parameter);
  const QString number = short_number(unit.shown(std::get<double>(value)));
  return unit.name.isEmpty() ? number : FormWords::tr("%1 %2").arg(number, unit.name);
}

struct ParameterForm::Row {
  ParameterValue value{};
  ParameterValue usual{};  // the default that counts
  NumberField* field = nullptr;
  MarkedSlider* slider = nullptr;
  ChoiceBox* list = nullptr;
  QPushButton* reset = nullptr;
};

ParameterForm::ParameterForm(std::vector<Parameter> parameters, FormStyle style, QWidget* parent)
    : QWidget(parent), parameters_(std::move(parameters)), rows_(parameters_.size()) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(style == FormStyle::sliders ? 0 : kGrid / 2);
  grid->setColumnStretch(0, 1);
  int line = 0;
  for (std::size_t i = 0; i < parameters_.size(); ++i) add_row(i, grid, line, style);
}

ParameterForm::~ParameterForm() = default;

void ParameterForm::add_row(std::size_t index, QGridLayout* grid, int& line, FormStyle style) {
  const Parameter& parameter = parameters_[index];
  Row& row = rows_[index];
  row.value = row.usual = parameter.default_value;
  const QString name = QString::fromStdString(parameter.name);
  QLabel* caption = make_text(caption_of(parameter), this);
  caption->setFont(text_font(TextSize::small));
  caption->setToolTip(tip_of(parameter));
  grid->addWidget(caption, line, 0);
  row.reset = make_button({}, ButtonRole::link, this);
  row.reset->setObjectName("reset_" + name);
  row.reset->setFont(text_font(TextSize::small));
  row.reset->setStyleSheet("padding: 0 2px;");
  row.reset->setFixedWidth(kResetWidth);
  connect(row.reset, &QPushButton::clicked, this,
          [this, index] { edit(index, rows_[index].usual); });
  grid->addWidget(row.reset, line, 2);
  if (parameter.kind == ParameterKind::choice) {
    row.list = new ChoiceBox(this);
    ignore_wheel(*row.list);
    row.list->setObjectName(name);
    row.list->setToolTip(tip_of(parameter));
    row.list->setAccessibleName(caption_of(parameter));
    row.list->setFixedWidth(kParameterFieldWidth);
    for (const std::string& choice : parameter.choices) {
      row.list->addItem(choice_with_word(parameter, choice));
      row.list->setItemData(row.list->count() - 1, choice_name(parameter, choice),
                            ChoiceBox::kValueRole);
    }
    connect(row.list, &QComboBox::activated, this, [this, index](int chosen) {
      edit(index, parameters_[index].choices[static_cast<std::size_t>(chosen)]);
    });
    caption->setBuddy(row.list);
    grid->addWidget(row.list, line++, 1);
    if (style == FormStyle::sliders) grid->setRowMinimumHeight(line++, kGrid / 2);
  } else {
    add_number(index, grid, line, style);
    caption->setBuddy(row.field);
  }
  QWidget* const field = row.list != nullptr ? static_cast<QWidget*>(row.list) : row.field;
  setTabOrder(field, row.reset);
  show_row(index);
}

void ParameterForm::add_number(std::size_t index, QGridLayout* grid, int& line, FormStyle style) {
  const Parameter& parameter = parameters_[index];
  Row& row = rows_[index];
  const QString name = QString::fromStdString(parameter.name);
  const ShownUnit unit = shown_unit(parameter);
  row.field = new NumberField(this);
  row.field->setObjectName(name);
  row.field->setToolTip(tip_of(parameter));
  row.field->setAccessibleName(caption_of(parameter));
  row.field->setRange(unit.shown(parameter.minimum), unit.shown(parameter.maximum));
  if (!unit.name.isEmpty()) row.field->setSuffix(" " + unit.name);
  row.field->setFixedWidth(kParameterFieldWidth);
  connect(row.field, &QDoubleSpinBox::valueChanged, this, [this, index](double shown) {
    const Parameter& declared = parameters_[index];
    double value = shown_unit(declared).si(shown);
    if (declared.kind == ParameterKind::integer) value = std::round(value);
    // The borders as shown may be a rounding away from the declared ones.
    edit(index, std::clamp(value, declared.minimum, declared.maximum));
  });
  grid->addWidget(row.field, line, 1);
  ++line;
  if (style == FormStyle::fields) return;
  row.slider = new MarkedSlider(this);
  row.slider->setObjectName("slider_" + name);
  row.slider->setToolTip(tip_of(parameter));
  row.slider->setAccessibleName(caption_of(parameter));
  connect(row.slider, &QSlider::sliderPressed, this, [this] { dragging_ = true; });
  connect(row.slider, &QSlider::valueChanged, this,
          [this, index](int step) { edit(index, value_at(parameters_[index], step)); });
  connect(row.slider, &QSlider::sliderReleased, this, [this] {
    dragging_ = false;
    emit released();
  });
  grid->addWidget(row.slider, line, 0, 1, 3);
  ++line;
  if (index + 1 < parameters_.size()) grid->setRowMinimumHeight(line++, kGrid);
}

void ParameterForm::edit(std::size_t index, const ParameterValue& value) {
  if (rows_[index].value == value) return;
  rows_[index].value = value;
  show_row(index);
  emit edited();
}

void ParameterForm::show_row(std::size_t index) {
  const Parameter& parameter = parameters_[index];
  Row& row = rows_[index];
  if (row.list != nullptr) {
    const auto chosen = std::find(parameter.choices.begin(), parameter.choices.end(),
                                  std::get<std::string>(row.value));
    row.list->setCurrentIndex(static_cast<int>(chosen - parameter.choices.begin()));
  } else {
    const double number = std::get<double>(row.value);
    const QSignalBlocker quiet_field(row.field);
    row.field->setValue(shown_unit(parameter).shown(number));
    if (row.slider != nullptr) {
      const QSignalBlocker quiet_slider(row.slider);
      if (!row.slider->isSliderDown()) row.slider->setValue(step_of(parameter, number));
      row.slider->set_mark(step_of(parameter, std::get<double>(row.usual)));
    }
  }
  const bool at_default = row.value == row.usual;
  // Beside a value that stands at its default the word says why there is nothing to reset.
  row.reset->setText(at_default ? tr("default") : tr("↺ Reset"));
  row.reset->setEnabled(!at_default);
  row.reset->setToolTip(tr("The default is %1.").arg(text_of(parameter, row.usual)));
}

ParameterValues ParameterForm::values() const {
  ParameterValues values{};
  for (std::size_t i = 0; i < rows_.size(); ++i)
    values.emplace(parameters_[i].name, rows_[i].value);
  return values;
}

ParameterValues ParameterForm::given() const {
  ParameterValues values{};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].value != rows_[i].usual) values.emplace(parameters_[i].name, rows_[i].value);
  }
  return values;
}

void ParameterForm::set_values(const ParameterValues& values) {
  ParameterValues merged = this->values();
  for (const auto& [name, value] : values) merged[name] = value;
  const ParameterValues complete = complete_values("the form", parameters_, merged);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].value = complete.at(parameters_[i].name);
    show_row(i);
  }
}

void ParameterForm::set_defaults(const ParameterValues& defaults) {
  const ParameterValues complete = complete_values("the form", parameters_, defaults);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    const ParameterValue& usual = complete.at(parameters_[i].name);
    if (row.value == row.usual) row.value = usual;
    row.usual = usual;
    show_row(i);
  }
}

void ParameterForm::reset() {
  if (given().empty()) return;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].value = rows_[i].usual;
    show_row(i);
  }
  emit edited();
}

}  // namespace asperity

#include "moc_parameter_form.cpp"

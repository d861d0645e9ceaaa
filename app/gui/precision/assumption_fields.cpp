// Makes a row for each assumption, and reads what is typed as a decimal number in the unit of display.

#include "app/gui/precision/assumption_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"
#include "app/gui/base/parameter_unit.h"
#include "app/gui/base/typed_number.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr int kAssumptionFieldWidth = 88;
constexpr int kLeastFieldWidth = 64;
constexpr int kShownDigits = 3;

/// The words of "BLOCK.QUESTION.PARAMETER".
struct AssumptionParts {
  QString question{};   ///< "comparisons, rougher"
  QString parameter{};  ///< "order, SD"
};

/// Of what a parameter is, and of the condition of a magnitude estimation.
QString shown_part(const QString& part) {
  const std::map<QString, QString> names{
      {"bias", AssumptionFields::tr("bias")},
      {"condition", AssumptionFields::tr("condition")},
      {"correct", AssumptionFields::tr("correct")},
      {"criterion", AssumptionFields::tr("criterion")},
      {"curvature", AssumptionFields::tr("curvature")},
      {"difference", AssumptionFields::tr("difference")},
      {"exponent", AssumptionFields::tr("exponent")},
      {"identical", AssumptionFields::tr("identical")},
      {"lapse", AssumptionFields::tr("lapse")},
      {"level", AssumptionFields::tr("level")},
      {"noise", AssumptionFields::tr("noise")},
      {"order", AssumptionFields::tr("order")},
      {"peak", AssumptionFields::tr("peak")},
      {"peak_ratio", AssumptionFields::tr("peak ratio")},
      {"ratio", AssumptionFields::tr("ratio")},
      {"sensitivity", AssumptionFields::tr("sensitivity")},
      {"shift", AssumptionFields::tr("shift")},
      {"slope", AssumptionFields::tr("slope")},
      {"structure", AssumptionFields::tr("structure")},
      {"target", AssumptionFields::tr("target")},
      {"texture", AssumptionFields::tr("texture")},
      {"threshold", AssumptionFields::tr("threshold")},
      {"tie_within", AssumptionFields::tr("tie within")},
      {"unsure_within", AssumptionFields::tr("unsure within")},
  };
  const auto found = names.find(part);
  return found == names.end() ? QString(part).replace('_', ' ') : found->second;
}

AssumptionParts parts_of_name(const std::string& name) {
  AssumptionParts parts{.question = text(name).section('.', 0, 1).replace('.', ", ")};
  QString parameter = text(name).section('.', 2);
  const bool is_deviation = parameter.endsWith("_sd");
  if (is_deviation) parameter.chop(3);
  const QString of = parameter.section('.', 0, -2);  // a factor, whose name is the protocol's
  parts.parameter = shown_part(parameter.section('.', -1));
  if (!of.isEmpty()) {
    parts.parameter = AssumptionFields::tr("%1 (%2)").arg(parts.parameter,
                                                          of == "condition" ? shown_part(of) : of);
  }
  if (is_deviation) parts.parameter = AssumptionFields::tr("%1, SD").arg(parts.parameter);
  return parts;
}

std::optional<double> value_typed(const QString& typed, const NumberShape& shape) {
  const std::optional<std::string> in_file = number_typed(shape, typed);
  if (!in_file) return {};
  const std::optional<double> value = number_in(*in_file);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

QString range_text(ParameterRange range) {
  switch (range) {
    case ParameterRange::any:
      break;
    case ParameterRange::not_negative:
      return AssumptionFields::tr("must be 0 or more");
    case ParameterRange::positive:
      return AssumptionFields::tr("must be above 0");
    case ParameterRange::proportion:
      return AssumptionFields::tr("must be from 0 to 1");
  }
  return AssumptionFields::tr("must be a number");
}

bool are_equal(const std::vector<Assumption>& one, const std::vector<Assumption>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const Assumption& a, const Assumption& b) {
                      return a.name == b.name && a.value == b.value && a.unit == b.unit &&
                             a.meaning == b.meaning && a.part == b.part;
                    });
}

}  // namespace

QString assumption_caption(const std::string& name) {
  const AssumptionParts parts = parts_of_name(name);
  return AssumptionFields::tr("%1: %2").arg(parts.question, parts.parameter);
}

NumberShape shape_of(const Assumption& usual) {
  constexpr double kRoom =
      10.0;  // a value may be stated that is so much greater than the usual one
  const Parameter parameter{.unit = usual.unit, .maximum = kRoom * usual.value.value_or(0.0)};
  return {.display = display_unit_of(parameter)};
}

QString unit_text(const Assumption& usual) {
  const std::string_view shown = shape_of(usual).display.unit;
  if (!shown.empty()) return text(std::string(shown));
  const std::map<std::string_view, QString> words{
      {"1", QString()},
      {"log-odds", AssumptionFields::tr("log-odds")},
      {"ratio", AssumptionFields::tr("ratio")},
      {"scale units", AssumptionFields::tr("scale units")},
  };
  const auto found = words.find(usual.unit);
  return found == words.end() ? text(usual.unit) : found->second;
}

QString rounded_in_unit(double value, const NumberShape& shape) {
  return shown_in_unit(shape, number_text(with_digits(value, kShownDigits)));
}

AssumptionFields::AssumptionFields(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, kGrid, 0);
}

void AssumptionFields::show_assumptions(const std::vector<Assumption>& usual,
                                        const Stated& stated) {
  if (rows_ != nullptr && are_equal(usual, usual_) && stated == stated_) return;
  usual_ = usual;
  stated_ = stated;
  invalid_.clear();
  fields_.clear();
  sources_.clear();
  delete rows_;
  rows_ = new QWidget(this);
  auto* grid = new QGridLayout(rows_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(kGrid / 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(3, 1);
  int line = 0;
  QString question{};
  for (std::size_t i = 0; i < usual_.size(); ++i) {
    const QString own = parts_of_name(usual_[i].name).question;
    if (own != question) {
      QLabel* heading = make_text(own, rows_, true);
      heading->setFont(text_font(TextSize::small));
      grid->addWidget(heading, line++, 0, 1, 4);
      question = own;
    }
    add_row(i, *grid, line++);
  }
  grid->setRowStretch(line, 1);
  layout()->addWidget(rows_);
}

void AssumptionFields::add_row(std::size_t index, QGridLayout& grid, int line) {
  const Assumption& assumption = usual_[index];
  const QString tip = QString("<p>%1.</p><p>%2</p>")
                          .arg(words_of(assumption.meaning).toHtmlEscaped(), text(assumption.name));
  auto* field = new QLineEdit(rows_);
  QLabel* caption = make_text(parts_of_name(assumption.name).parameter, rows_);
  QLabel* unit = make_text(unit_text(assumption), rows_, true);
  QLabel* source = make_text({}, rows_, true);
  for (QLabel* label : {caption, unit, source}) label->setFont(text_font(TextSize::small));
  field->setObjectName(text(assumption.name));
  field->setAccessibleName(assumption_caption(assumption.name));
  field->setAccessibleDescription(words_of(assumption.meaning));
  field->setMinimumWidth(kLeastFieldWidth);
  field->setMaximumWidth(kAssumptionFieldWidth);
  field->setAlignment(Qt::AlignRight);
  caption->setBuddy(field);
  caption->setToolTip(tip);
  field->setToolTip(tip);
  source->setObjectName("source_" + text(assumption.name));
  grid.addWidget(caption, line, 0);
  grid.addWidget(field, line, 1);
  grid.addWidget(unit, line, 2);
  grid.addWidget(source, line, 3);
  fields_.push_back(field);
  sources_.push_back(source);
  connect(field, &QLineEdit::textEdited, this,
          [this, index](const QString& typed) { take(index, typed); });
  connect(field, &QLineEdit::editingFinished, this, [this, index] { show_value(index); });
  show_value(index);
  show_source(index);
}

void AssumptionFields::take(std::size_t index, const QString& typed) {
  const Assumption& assumption = usual_[index];
  stated_.erase(assumption.name);
  invalid_.erase(index);
  if (!typed.trimmed().isEmpty()) {
    const std::optional<double> value = value_typed(typed, shape_of(assumption));
    if (value && is_in_range(assumption.range, *value)) {
      stated_[assumption.name] = *value;
    } else {
      invalid_.insert(index);
    }
  }
  show_source(index);
  emit edited();
}

/// What is typed and not a value stays.
void AssumptionFields::show_value(std::size_t index) {
  if (invalid_.contains(index)) return;
  const Assumption& assumption = usual_[index];
  const auto found = stated_.find(assumption.name);
  QLineEdit& field = *fields_[index];
  if (found != stated_.end()) {
    if (field.text().trimmed().isEmpty()) {
      field.setText(shown_in_unit(shape_of(assumption), number_text(found->second)));
    }
    return;
  }
  field.setText(assumption.value ? rounded_in_unit(*assumption.value, shape_of(assumption))
                                 : QString());
}

void AssumptionFields::show_source(std::size_t index) {
  const Assumption& assumption = usual_[index];
  QString words = tr("not stated");
  if (invalid_.contains(index)) {
    words = range_text(assumption.range);
  } else if (stated_.contains(assumption.name)) {
    words = tr("stated");
  } else if (assumption.value) {
    words = tr("assumed");
  }
  sources_[index]->setText(words);
}

QString AssumptionFields::invalid_fields() const {
  QStringList captions{};
  for (const std::size_t index : invalid_) captions.append(assumption_caption(usual_[index].name));
  return captions.join(", ");
}

}  // namespace asperity

#include "moc_assumption_fields.cpp"

// Implements what the parts of a form share.

#include "app/gui/editor/form/form_part.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QtWidgets/QToolButton>

#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr int kToolWidth = 24;
constexpr int kLabelWidth = 144;
constexpr int kLeastLabelWidth = 72;

class FieldLabel final : public QLabel {
 public:
  using QLabel::QLabel;

  QSize sizeHint() const override { return of_width(std::max(column_, longest_word())); }
  void set_column(int width) { column_ = width; }
  QSize minimumSizeHint() const override {
    return {std::max(kLeastLabelWidth, longest_word()), fontMetrics().height()};
  }

 private:
  QSize of_width(int width) const { return {width, heightForWidth(width)}; }
  int longest_word() const { return qRound(width_of_longest_word(text(), fontMetrics())) + 1; }

  int column_ = kLabelWidth;
};

}  // namespace

FormPart::FormPart(FormContext& context, std::string pointer, QWidget* parent)
    : QWidget(parent), context_(context), pointer_(std::move(pointer)) {
  setObjectName(text(pointer_));
}

void FormPart::set_name(const QString& name) {
  if (focusProxy() != nullptr) focusProxy()->setAccessibleName(name);
}

void FormPart::write(const std::string& json) const {
  context_.edit([&](const JsonDocument& text) { return with_value(text, pointer_, json); }, {});
}

void FormPart::write_typed(const std::string& json) const {
  context_.edit([&](const JsonDocument& text) { return with_value(text, pointer_, json); },
                pointer_);
}

void FormPart::remove(const std::string& pointer, const std::string& step) const {
  if (source().find(pointer) == nullptr) return;
  context_.edit([&](const JsonDocument& text) { return without(text, std::array{pointer}); }, step);
}

std::vector<Remark> problems_at(const FormContext& context, const std::string& pointer,
                                Problems which) {
  std::vector<Remark> found{};
  for (const auto& [place, remarks] : context.problems) {
    const bool is_within = which == Problems::within && place.starts_with(pointer + "/");
    if (place == pointer || is_within) found.insert(found.end(), remarks.begin(), remarks.end());
  }
  return found;
}

QLabel* make_problem_label(QWidget* parent) {
  QLabel* label = make_text({}, parent);
  label->setObjectName("form_problem");
  label->hide();
  return label;
}

void show_problems(QLabel& label, const std::vector<Remark>& remarks) {
  QStringList lines{};
  State worst = State::look;
  for (const Remark& remark : remarks) {
    if (remark.state == State::stop) worst = State::stop;
    lines.append(shape_of(remark.state) + " " + remark.sentence);
  }
  const QString style = "color: " + color_of(worst).name();
  if (!lines.isEmpty() && label.styleSheet() != style) label.setStyleSheet(style);
  label.setText(lines.join("\n"));
  label.setVisible(!lines.isEmpty());
}

void show_problem(QLabel& label, const QString& sentence) {
  show_problems(label, sentence.isEmpty() ? std::vector<Remark>{}
                                          : std::vector<Remark>{{State::stop, sentence}});
}

QToolButton* make_tool(const QString& sign, const QString& name, QWidget* parent) {
  auto* tool = new QToolButton(parent);
  tool->setText(sign);
  tool->setToolTip(name);
  tool->setAccessibleName(name);
  tool->setAutoRaise(true);
  tool->setFixedWidth(kToolWidth);
  return tool;
}

QLabel* make_field_label(const QString& words, QWidget* parent) {
  auto* label = new FieldLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  // Names can be continued in the next line after an underscore.
  label->setText(QString(words).replace('_', QStringLiteral("_\u200B")));
  QSizePolicy policy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  label->setSizePolicy(policy);
  return label;
}

void align_field_labels(const std::vector<QLabel*>& labels) {
  int widest = 0;
  for (const QLabel* const label : labels) widest = std::max(widest, label->sizeHint().width());
  for (QLabel* const label : labels) static_cast<FieldLabel&>(*label).set_column(widest);
}

}  // namespace asperity

#include "moc_form_part.cpp"

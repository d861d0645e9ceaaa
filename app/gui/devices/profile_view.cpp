// Builds rows of title, number, limit and result in groups, followed by the plot of the response.

#include "app/gui/devices/profile_view.h"

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QGridLayout>

#include "app/gui/devices/profile_words.h"
#include "app/gui/devices/response_plot.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/profiles/profile_verdict.h"

namespace asperity {

namespace {

constexpr int kResultWidth = 112;
constexpr int kNumberWidth = 88;

/// "x 0.18 N, y 0.17 N, z 0.11 N"
QString axes_in_words(const DeviceItem& item) {
  QStringList parts{};
  const char* const axes = "xyz";
  for (std::size_t i = 0; i < item.by_axis.size() && i < 3; ++i) {
    parts << QString("%1 %2").arg(QChar(axes[i]), value_in_words(item.name, item.by_axis[i]));
  }
  // A number and its unit stay on one line.
  return parts.join(",\n").replace(' ', QChar::Nbsp).replace('\n', ' ');
}

QLabel* number_label(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(number_font(TextSize::body));
  label->setAlignment(Qt::AlignRight | Qt::AlignTop);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

ProfileView::ProfileView(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid);
  heading_ = make_heading({}, this);
  heading_->setObjectName("profile_heading");
  rows->addWidget(heading_);
  summary_ = new StateLabel(this);
  summary_->setObjectName("profile_summary");
  rows->addWidget(summary_);
  how_ = make_text({}, this, true);
  rows->addWidget(how_);
  known_ = make_text({}, this, true);
  known_->setObjectName("profile_known");
  rows->addWidget(known_);
  rows->addSpacing(kGrid);
  response_ = new ResponsePlot(this);
  rows->addWidget(response_);
  rows->addSpacing(kGrid);
  items_ = new QWidget(this);
  rows->addWidget(items_);
}

void ProfileView::show_profile(const DeviceProfile& profile) {
  heading_->setText(tr("Measured on %1").arg(date_in_words(profile.measured_utc)));
  const ItemResult summary = verdict_of(profile);
  summary_->set_state(summary.state, summary.words);
  QString how = tr("%1 at %2 Hz, force at most %3 N.")
                    .arg(text(profile.model))
                    .arg(shown_number(profile.rate_Hz, 'f', 0))
                    .arg(shown_number(profile.force_N, 'f', 1));
  if (profile.is_simulated) {
    how += ' ' + tr("Simulated device: its timing is reported, not evaluated.");
  }
  how_->setText(how);
  const Phrase known = what_is_known(profile);
  known_->setText(words_of(known));
  known_->setVisible(!known.empty());
  response_->show_profile(profile);
  fill(profile);
}

void ProfileView::fill(const DeviceProfile& profile) {
  auto* anew = new QWidget(this);
  delete layout()->replaceWidget(items_, anew);
  delete items_;
  items_ = anew;
  grid_ = new QGridLayout(items_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(kMargin);
  grid_->setVerticalSpacing(kGrid);
  grid_->setColumnStretch(0, 1);
  grid_->setColumnMinimumWidth(1, kResultWidth);
  grid_->setColumnMinimumWidth(2, kNumberWidth);
  grid_->setColumnMinimumWidth(3, kNumberWidth);
  for (const ItemGroup& group : groups_of(profile)) {
    if (group.items.empty()) continue;
    const int row = grid_->rowCount();
    auto* name = new QLabel(group.name, items_);
    name->setFont(text_font(TextSize::body, true));
    grid_->addWidget(name, row, 0);
    const auto add_head = [&](int column, const QString& text, Qt::Alignment side) {
      QLabel* label = make_text(text, items_, true);
      label->setFont(text_font(TextSize::small));
      label->setWordWrap(false);
      label->setAlignment(side | Qt::AlignBottom);
      grid_->addWidget(label, row, column);
    };
    add_head(1, tr("result"), Qt::AlignLeft);
    add_head(2, tr("measured"), Qt::AlignRight);
    add_head(3, tr("limit"), Qt::AlignRight);
    auto* line = new QFrame(items_);
    line->setFixedHeight(1);
    line->setStyleSheet("background: " + theme().line.name());
    grid_->addWidget(line, row + 1, 0, 1, 4);
    for (const DeviceItem* item : group.items) add_item(*item);
    grid_->setRowMinimumHeight(grid_->rowCount(), kGrid);
  }
}

void ProfileView::add_item(const DeviceItem& item) {
  const int row = grid_->rowCount();
  const QString name = text(item.name);
  auto* what = new QVBoxLayout();
  what->setSpacing(0);
  QLabel* title = make_text(title_of_item(item.name), items_);
  title->setObjectName("item_" + name);
  title->setToolTip(name);
  what->addWidget(title);
  QString remark = words_of(item.text);
  if (const QString axes = axes_in_words(item); !axes.isEmpty()) {
    remark += (remark.isEmpty() ? "" : " ") + tr("Along %1.").arg(axes);
  }
  QLabel* said = make_text(remark, items_, true);
  said->setFont(text_font(TextSize::small));
  what->addWidget(said);
  grid_->addLayout(what, row, 0);
  auto* result = new StateLabel(items_);
  result->setObjectName("result_" + name);
  const ItemResult found = result_of(item);
  result->set_state(found.state, found.words);
  result->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  grid_->addWidget(result, row, 1);
  QLabel* value =
      number_label(item.value ? value_in_words(item.name, *item.value) : QString("–"), items_);
  value->setObjectName("value_" + name);
  grid_->addWidget(value, row, 2);
  const QString limit = limit_in_words(item);
  QLabel* bound = number_label(limit.isEmpty() ? QString("–") : limit, items_);
  bound->setObjectName("limit_" + name);
  grid_->addWidget(bound, row, 3);
}

}  // namespace asperity

#include "moc_profile_view.cpp"

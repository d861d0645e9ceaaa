// Makes labels, buttons, cards, state labels and banners with the sizes and colours of the theme.

#include "app/gui/look/controls.h"

#include <algorithm>
#include <utility>

#include <QtGui/QClipboard>
#include <QtGui/QFontMetrics>
#include <QtGui/QKeyEvent>
#include <QtGui/QScreen>
#include <QtGui/QShortcut>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QStyle>
#include <QtWidgets/QStyleOption>
#include <QtWidgets/QTableView>

#include "app/gui/look/focus_order.h"
#include "app/gui/look/wrapping_row.h"

namespace asperity {

namespace {

const char* role_name(ButtonRole role) {
  switch (role) {
    case ButtonRole::primary:
      return "primary";
    case ButtonRole::danger:
      return "danger";
    case ButtonRole::link:
      return "link";
    case ButtonRole::selector:
      return "switch";
    case ButtonRole::plain:
      break;
  }
  return "plain";
}

QLabel* make_label(const QString& text, QWidget* parent, TextSize size, bool bold) {
  auto* label = new QLabel(text, parent);
  label->setFont(text_font(size, bold));
  label->setWordWrap(true);
  return label;
}

void copy_selection(const QTableView& table) {
  QModelIndexList cells = table.selectionModel()->selectedIndexes();
  std::sort(cells.begin(), cells.end());
  QString text{};
  int row = -1;
  for (const QModelIndex& cell : std::as_const(cells)) {
    if (row >= 0) text += cell.row() == row ? '\t' : '\n';
    row = cell.row();
    text += cell.data().toString();
  }
  if (!text.isEmpty()) QApplication::clipboard()->setText(text);
}

/// Return and Enter press it while it has the focus, as Space does: outside dialogs Qt leaves that out.
class Button final : public QPushButton {
 public:
  using QPushButton::QPushButton;

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    const bool presses = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!presses || event->isAutoRepeat()) return QPushButton::keyPressEvent(event);
    if (menu() != nullptr) return showMenu();
    click();
  }
};

}  // namespace

QPushButton* make_button(const QString& verb, ButtonRole role, QWidget* parent) {
  auto* button = new Button(verb, parent);
  button->setProperty("role", role_name(role));
  button->setCheckable(role == ButtonRole::selector);
  if (role == ButtonRole::selector) {
    // Bold while it is chosen: neither clipped then, nor do its neighbours move.
    constexpr int kPadding = 32;
    const QFontMetrics letters(text_font(TextSize::body, true));
    button->setMinimumWidth(letters.horizontalAdvance(verb) + kPadding);
  }
  button->setAutoDefault(false);
  button->setCursor(Qt::PointingHandCursor);
  return button;
}

void set_role(QPushButton& button, ButtonRole role) {
  button.setProperty("role", role_name(role));
  button.style()->unpolish(&button);
  button.style()->polish(&button);
}

void ChoiceBox::initStyleOption(QStyleOptionComboBox* option) const {
  QComboBox::initStyleOption(option);
  const int room = room_in(*option);
  const QString value = currentData(kValueRole).toString();
  if (!value.isEmpty() && option->fontMetrics.horizontalAdvance(option->currentText) >= room) {
    option->currentText = value;
  }
  option->currentText = option->fontMetrics.elidedText(option->currentText, Qt::ElideMiddle, room);
}

QString ChoiceBox::shown_text() const {
  QStyleOptionComboBox option{};
  initStyleOption(&option);
  return option.currentText;
}

/// For the text.
int ChoiceBox::room_in(const QStyleOptionComboBox& option) const {
  constexpr int kTextMargin = 4;  // both sides
  const QRect field =
      style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
  return field.width() - kTextMargin;
}

/// Qt's size leaves the padding of the style sheet out.
QSize ChoiceBox::with_room(QSize size) const {
  if (sizeAdjustPolicy() != AdjustToContents) return size;
  for (int i = 0; i < count(); ++i) size.setWidth(std::max(size.width(), width_for(itemText(i))));
  return size;
}

int ChoiceBox::width_for(const QString& text) const {
  QStyleOptionComboBox option{};
  QComboBox::initStyleOption(&option);
  // One more: with no point to spare the text is elided.
  return option.rect.width() - room_in(option) + option.fontMetrics.horizontalAdvance(text) + 1;
}

void ChoiceBox::showPopup() {
  constexpr int kAroundText = 48;  // padding, and a scroll bar
  const int wanted = view()->sizeHintForColumn(modelColumn()) + kAroundText;
  view()->setMinimumWidth(std::min(wanted, screen()->availableGeometry().width()));
  QComboBox::showPopup();
}

QLabel* make_title(const QString& text, QWidget* parent) {
  return make_label(text, parent, TextSize::title, true);
}

QLabel* make_heading(const QString& text, QWidget* parent) {
  return make_label(text, parent, TextSize::heading, true);
}

QLabel* make_text(const QString& text, QWidget* parent, bool muted) {
  QLabel* label = make_label(text, parent, TextSize::body, false);
  if (muted) label->setProperty("role", "muted");
  return label;
}

QFrame* make_card(QWidget* parent, QVBoxLayout*& layout) {
  auto* card = new QFrame(parent);
  card->setProperty("role", "card");
  layout = new QVBoxLayout(card);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kGrid);
  return card;
}

void clear_layout(QLayout& layout) {
  while (QLayoutItem* const item = layout.takeAt(0)) {
    if (item->layout() != nullptr) clear_layout(*item->layout());
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
}

QSplitter* make_splitter(Qt::Orientation orientation, QWidget* parent, int gap) {
  auto* splitter = new QSplitter(orientation, parent);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(gap);
  splitter->setStyleSheet("QSplitter::handle { background: transparent; }");
  return splitter;
}

QString shape_of(State state) {
  switch (state) {
    case State::fine:
      return "✓";
    case State::look:
      return "▲";
    case State::stop:
      return "✕";
    case State::unknown:
      break;
  }
  return "·";
}

QColor color_of(State state) {
  switch (state) {
    case State::fine:
      return theme().fine;
    case State::look:
      return theme().look;
    case State::stop:
      return theme().stop;
    case State::unknown:
      break;
  }
  return theme().muted;
}

StateLabel::StateLabel(QWidget* parent) : QLabel(parent) { setWordWrap(true); }

void StateLabel::set_state(State state, const QString& text) {
  state_ = state;
  words_ = text;
  write();
}

void StateLabel::write() {
  setTextFormat(Qt::RichText);
  setText(QString("<span style='color:%1'><b>%2</b></span>&nbsp; %3")
              .arg(color_of(state_).name(), shape_of(state_), words_.toHtmlEscaped()));
}

void StateLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !text().isEmpty()) write();
}

Banner::Banner(QWidget* parent) : QFrame(parent) {
  constexpr int kLeastText = 280;  // next to the buttons; otherwise they are below it
  shape_ = new QLabel(this);
  shape_->setFont(text_font(TextSize::heading, true));
  text_ = make_text({}, this);
  text_->setMinimumWidth(kLeastText);
  action_ = make_button({}, ButtonRole::plain, this);
  action_->setObjectName("banner_action");
  away_ = make_button(tr("Dismiss"), ButtonRole::link, this);
  away_->setObjectName("banner_dismiss");
  auto* row = new WrappingRow(this, kGrid / 2);
  row->setContentsMargins(kMargin, kGrid, kGrid, kGrid);
  auto* news = new QHBoxLayout();
  auto* buttons = new QHBoxLayout();
  for (QHBoxLayout* const part : {news, buttons}) part->setSpacing(kMargin);
  news->addWidget(shape_);
  news->addWidget(text_, 1);
  buttons->setContentsMargins(kMargin - row->spacing(), 0, 0, 0);
  buttons->addWidget(action_);
  buttons->addWidget(away_);
  row->add_layout(news);
  row->add_layout(buttons, Qt::AlignRight);
  connect(action_, &QPushButton::clicked, this, [this] {
    const auto act = on_action_;  // may show other news
    hide();
    if (act) act();
  });
  connect(away_, &QPushButton::clicked, this, &QWidget::hide);
  hide();
}

void Banner::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  place_in_focus_order(*this);
}

void Banner::show_news(State state, const QString& text, const QString& action,
                       std::function<void()> on_action) {
  state_ = state;
  restyle();
  shape_->setText(shape_of(state));
  text_->setText(text);
  action_->setText(action);
  action_->setVisible(!action.isEmpty());
  on_action_ = std::move(on_action);
  show();
}

void Banner::restyle() {
  const QString color = color_of(state_).name();
  const QString style = QString(
                            "asperity--Banner { background: %1; border: 1px solid %2; "
                            "border-left: 6px solid %2; border-radius: 4px; }")
                            .arg(theme().panel.name(), color);
  if (style == styleSheet()) return;  // a style sheet may change the palette in its turn
  setStyleSheet(style);
  shape_->setStyleSheet("color: " + color);
}

void Banner::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && shape_ != nullptr) restyle();
}

QString Banner::text() const { return text_->text(); }

ModeBand::ModeBand(QWidget* parent) : QLabel(parent) {
  setAlignment(Qt::AlignCenter);
  setFont(text_font(TextSize::body, true));
  setFixedHeight(kControlHeight);
  hide();
}

void ModeBand::set_mode(SessionMode mode) {
  setVisible(mode != SessionMode::run);
  const bool pilot = mode == SessionMode::pilot;
  setText(pilot ? tr("PILOT: not study data") : tr("SIMULATED: no human participant"));
  setStyleSheet(
      QString("background: %1; color: %2")
          .arg((pilot ? theme().pilot : theme().simulated).name(), theme().on_band.name()));
}

EmptyState::EmptyState(const QString& title, const QString& text, QWidget* parent)
    : QWidget(parent) {
  auto* outer = new QHBoxLayout(this);
  outer->addStretch(1);
  layout_ = new QVBoxLayout();
  layout_->setSpacing(kMargin);
  layout_->addStretch(1);
  layout_->addWidget(make_heading(title, this));
  QLabel* words = make_text(text, this, true);
  words->setMinimumWidth(420);
  layout_->addWidget(words);
  layout_->addStretch(2);
  outer->addLayout(layout_, 2);
  outer->addStretch(1);
}

QPushButton* EmptyState::add_action(const QString& verb, ButtonRole role,
                                    std::function<void()> on_click) {
  QPushButton* button = make_button(verb, role, this);
  connect(button, &QPushButton::clicked, this, [act = std::move(on_click)] { act(); });
  layout_->insertWidget(layout_->count() - 1, button, 0, Qt::AlignLeft);
  return button;
}

void style_table(QTableView& table) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::ExtendedSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setSortingEnabled(true);
  table.setShowGrid(false);
  table.setAlternatingRowColors(false);
  table.setWordWrap(false);
  table.setTabKeyNavigation(false);  // by Tab one comes past it, by arrows through it
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(kControlHeight);
  table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table.horizontalHeader()->setStretchLastSection(true);
  table.horizontalHeader()->setHighlightSections(false);
  auto* copy = new QShortcut(QKeySequence::Copy, &table);
  copy->setContext(Qt::WidgetShortcut);
  QObject::connect(copy, &QShortcut::activated, &table, [&table] { copy_selection(table); });
}

}  // namespace asperity

#include "moc_controls.cpp"

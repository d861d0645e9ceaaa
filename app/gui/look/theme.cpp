// Holds the light and the dark theme, and composes palette and style sheet of the application from one.

#include "app/gui/look/theme.h"

#include <array>

#include <QtGui/QFontDatabase>
#include <QtGui/QPalette>
#include <QtWidgets/QApplication>
#include <QtWidgets/QStyleFactory>
#include <qcustomplot.h>

// Those of a static library are not found by themselves; the macro does not work in a namespace.
static void load_icons() { Q_INIT_RESOURCE(look); }

namespace asperity {

namespace {

Theme light_theme() {
  Theme light{};
  light.ground = QColor("#F4F5F7");
  light.panel = QColor("#FFFFFF");
  light.raised = QColor("#E9ECF0");
  light.line = QColor("#CBD0D7");
  light.text = QColor("#1B1F24");
  light.muted = QColor("#57606A");
  light.press = QColor("#0A58CA");
  light.on_press = QColor("#FFFFFF");
  light.fine = QColor("#1A7F37");
  light.look = QColor("#8A5300");
  light.stop = QColor("#C01C28");
  light.on_stop = QColor("#FFFFFF");
  light.pilot = QColor("#FFC107");
  light.simulated = QColor("#C9B3F5");
  light.on_band = QColor("#1B1F24");
  return light;
}

Theme dark_theme() {
  Theme dark{};
  dark.dark = true;
  dark.ground = QColor("#16191D");
  dark.panel = QColor("#1F2328");
  dark.raised = QColor("#2D333B");
  dark.line = QColor("#444C56");
  dark.text = QColor("#E6EDF3");
  dark.muted = QColor("#A4AEB9");
  dark.press = QColor("#4C9BFF");
  dark.on_press = QColor("#0B1320");
  dark.fine = QColor("#56D364");
  dark.look = QColor("#F0B94A");
  dark.stop = QColor("#FF7B72");
  dark.on_stop = QColor("#1B0B0B");
  dark.pilot = QColor("#FFC107");
  dark.simulated = QColor("#C9B3F5");
  dark.on_band = QColor("#1B1F24");
  return dark;
}

Theme& current_theme() {
  static Theme theme = light_theme();
  return theme;
}

QPalette palette_of(const Theme& look) {
  QPalette palette{};
  palette.setColor(QPalette::Window, look.ground);
  palette.setColor(QPalette::WindowText, look.text);
  palette.setColor(QPalette::Base, look.panel);
  palette.setColor(QPalette::AlternateBase, look.ground);
  palette.setColor(QPalette::Text, look.text);
  palette.setColor(QPalette::PlaceholderText, look.muted);
  palette.setColor(QPalette::Button, look.raised);
  palette.setColor(QPalette::ButtonText, look.text);
  palette.setColor(QPalette::Highlight, look.press);
  palette.setColor(QPalette::HighlightedText, look.on_press);
  palette.setColor(QPalette::ToolTipBase, look.panel);
  palette.setColor(QPalette::ToolTipText, look.text);
  palette.setColor(QPalette::Link, look.press);
  palette.setColor(QPalette::Mid, look.line);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, look.muted);
  }
  return palette;
}

QString style_sheet_of(const Theme& look) {
  // Roles are set by the functions of controls.h. The style keeps the width of the sort arrow free at the
  // right of every header, though the arrow stands above it: 1 + 10 px are the 11 of the cells.
  return QString(R"css(
    QWidget { color: %text; }
    QToolTip { background: %panel; color: %text; border: 1px solid %line; padding: 4px; }
    QPushButton { min-height: 30px; padding: 0 14px; border: 1px solid %line; border-radius: 4px;
                  background: %raised; color: %text; }
    QPushButton:hover { border-color: %press; }
    QPushButton:focus { border: 2px solid %press; }
    QPushButton:disabled { color: %muted; background: %ground; border-color: %line; }
    QPushButton::menu-indicator { image: url(:/look/down-%mode.svg); width: 12px; height: 12px;
      subcontrol-origin: border; subcontrol-position: center right; right: 8px; }
    QPushButton[role="primary"] { background: %press; color: %on_press; border-color: %press; font-weight: bold; }
    QPushButton[role="primary"]::menu-indicator { image: url(:/look/down-%other.svg); }
    QPushButton[role="primary"]:disabled { background: %raised; color: %muted; border-color: %line; }
    QPushButton[role="primary"]:focus { border: 2px solid %text; }
    QPushButton[role="danger"] { background: %stop; color: %on_stop; border-color: %stop; font-weight: bold; }
    QPushButton[role="danger"]:disabled { background: %raised; color: %muted; border-color: %line; }
    QPushButton[role="danger"]:focus { border: 2px solid %text; }
    QPushButton[role="link"] { border: none; background: transparent; color: %press; padding: 0 8px; text-align: left; }
    QPushButton[role="link"]:disabled { color: %muted; }
    QPushButton[role="link"]:focus { border: 2px solid %press; padding: 0 6px; }
    QPushButton[role="switch"]:checked { background: %press; color: %on_press; border-color: %press; font-weight: bold; }
    QPushButton[role="switch"]:checked:focus { border: 2px solid %text; }
    QLineEdit, QPlainTextEdit, QTextEdit, QSpinBox, QDoubleSpinBox, QComboBox {
      min-height: 30px; padding: 0 8px; border: 1px solid %line; border-radius: 4px; background: %panel; color: %text;
      selection-background-color: %press; selection-color: %on_press; }
    QPlainTextEdit, QTextEdit { padding: 4px 8px; }
    QLineEdit:focus, QPlainTextEdit:focus, QTextEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus, QComboBox:focus {
      border: 2px solid %press; }
    QLineEdit:disabled, QPlainTextEdit:disabled, QTextEdit:disabled, QComboBox:disabled, QSpinBox:disabled,
    QDoubleSpinBox:disabled, QLineEdit[waits="true"], QPlainTextEdit[waits="true"], QTextEdit[waits="true"],
    QComboBox[waits="true"], QSpinBox[waits="true"], QDoubleSpinBox[waits="true"] { background: %ground; color: %muted; }
    QComboBox::drop-down { border: none; width: 28px; }
    QComboBox::down-arrow { image: url(:/look/down-%mode.svg); width: 12px; height: 12px; }
    QSpinBox::up-button, QSpinBox::down-button, QDoubleSpinBox::up-button, QDoubleSpinBox::down-button {
      border: none; width: 24px; }
    QSpinBox::up-arrow, QDoubleSpinBox::up-arrow { image: url(:/look/up-%mode.svg); width: 12px; height: 12px; }
    QSpinBox::down-arrow, QDoubleSpinBox::down-arrow { image: url(:/look/down-%mode.svg); width: 12px; height: 12px; }
    QScrollBar:vertical { width: 12px; background: transparent; }
    QScrollBar:horizontal { height: 12px; background: transparent; }
    QScrollBar::handle { background: %line; border-radius: 4px; margin: 2px; }
    QScrollBar::handle:hover { background: %muted; }
    QScrollBar::handle:vertical { min-height: 32px; }
    QScrollBar::handle:horizontal { min-width: 32px; }
    QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
    QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
    QCheckBox { spacing: 8px; }
    QCheckBox::indicator, QTableView::indicator, QListView::indicator {
      width: 16px; height: 16px; border: 1px solid %muted; border-radius: 3px; background: %panel; }
    QCheckBox::indicator:checked, QTableView::indicator:checked, QListView::indicator:checked {
      border-color: %press; background: %press; image: url(:/look/check-%mode.svg); }
    QCheckBox::indicator:focus { border: 2px solid %press; }
    QCheckBox::indicator:disabled, QTableView::indicator:disabled, QListView::indicator:disabled {
      border-color: %line; background: %ground; }
    QRadioButton { spacing: 8px; }
    QRadioButton::indicator {
      width: 16px; height: 16px; border: 1px solid %muted; border-radius: 9px; background: %panel; }
    QRadioButton::indicator:checked {
      width: 8px; height: 8px; border: 5px solid %press; background: %on_press; }
    QRadioButton::indicator:unchecked:focus { width: 14px; height: 14px; border: 2px solid %press; }
    QRadioButton::indicator:checked:focus { border-color: %text; }
    QRadioButton::indicator:disabled { border-color: %line; background: %ground; }
    QTableView, QTreeView, QListView { background: %panel; border: 1px solid %line; border-radius: 4px;
      gridline-color: transparent; selection-background-color: %press; selection-color: %on_press; }
    QTableView:focus, QTreeView:focus, QListView:focus { border-color: %press; }
    QTableView::item, QTreeView::item, QListView::item { border: 0px; padding: 4px 8px; }
    QTableView::item:selected, QTreeView::item:selected, QListView::item:selected { background: %press; color: %on_press; }
    QHeaderView { background: %raised; }
    QHeaderView::section { background: %raised; color: %muted; border: none; border-bottom: 1px solid %line;
      padding: 6px 1px 6px 11px; }
    QHeaderView::up-arrow, QHeaderView::down-arrow { subcontrol-origin: border; subcontrol-position: top center;
      width: 10px; height: 8px; }
    QHeaderView::up-arrow { image: url(:/look/up-%mode.svg); }
    QHeaderView::down-arrow { image: url(:/look/down-%mode.svg); }
    QProgressBar { border: none; border-radius: 4px; background: %raised; max-height: 8px; min-height: 8px; }
    QProgressBar::chunk { border-radius: 4px; background: %press; }
    QWidget[marked="true"] { border: 2px dashed %press; border-radius: 4px; }
    QFrame[role="card"] { background: %panel; border: 1px solid %line; border-radius: 6px; }
    QLabel[role="muted"] { color: %muted; }
    QSplitter::handle { background: %line; }
    QScrollArea { border: none; background: transparent; }
    QTabBar::tab { padding: 8px 16px; border: none; border-bottom: 2px solid transparent; }
    QTabBar::tab:selected { border-bottom: 2px solid %press; font-weight: bold; }
    QTabBar::tab:focus { background: %raised; }
    QTabWidget::pane { border: none; border-top: 1px solid %line; }
    QMenu { background: %panel; border: 1px solid %line; }
    QMenu::item { padding: 6px 24px; }
    QMenu::item:selected { background: %press; color: %on_press; }
  )css")
      .replace("%mode", look.dark ? "dark" : "light")
      .replace("%other", look.dark ? "light" : "dark")
      .replace("%on_press", look.on_press.name())
      .replace("%on_stop", look.on_stop.name())
      .replace("%ground", look.ground.name())
      .replace("%panel", look.panel.name())
      .replace("%raised", look.raised.name())
      .replace("%line", look.line.name())
      .replace("%text", look.text.name())
      .replace("%muted", look.muted.name())
      .replace("%press", look.press.name())
      .replace("%stop", look.stop.name());
}

}  // namespace

const Theme& theme() { return current_theme(); }

void apply_theme(QApplication& application, ThemeChoice choice) {
  load_icons();
  // As it was before the first theme: from then on the application's palette is ours.
  static const bool system_is_dark =
      QApplication::palette().color(QPalette::Window).lightnessF() <
      QApplication::palette().color(QPalette::WindowText).lightnessF();
  const bool dark =
      choice == ThemeChoice::dark || (choice == ThemeChoice::system && system_is_dark);
  current_theme() = dark ? dark_theme() : light_theme();
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(palette_of(theme()));
  QApplication::setFont(text_font(TextSize::body));
  application.setStyleSheet(style_sheet_of(theme()));
}

QColor series_color(int index) {
  static const std::array<QColor, 6> kOkabeIto = {QColor("#0072B2"), QColor("#E69F00"),
                                                  QColor("#009E73"), QColor("#CC79A7"),
                                                  QColor("#56B4E9"), QColor("#D55E00")};
  return kOkabeIto[static_cast<std::size_t>(index) % kOkabeIto.size()];
}

QFont text_font(TextSize size, bool bold) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPointSize(static_cast<int>(size));
  font.setBold(bold);
  return font;
}

QFont number_font(TextSize size) {
  // The digits of the general font are of equal width in nearly every family; a fixed font is the
  // only promise.
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setPointSize(static_cast<int>(size));
  return font;
}

void style_plot(QCustomPlot& plot) {
  const Theme& look = theme();
  plot.setBackground(QBrush(look.panel));
  for (QCPAxisRect* rect : plot.axisRects()) {
    for (QCPAxis* axis : rect->axes()) {
      axis->setBasePen(QPen(look.line));
      axis->setTickPen(QPen(look.line));
      axis->setSubTickPen(Qt::NoPen);
      axis->setTickLabelColor(look.muted);
      axis->setTickLabelFont(text_font(TextSize::small));
      axis->setLabelColor(look.text);
      axis->setLabelFont(text_font(TextSize::small));
      axis->grid()->setPen(QPen(look.line, 0, Qt::DotLine));
      axis->grid()->setZeroLinePen(QPen(look.line));
      axis->ticker()->setTickCount(4);
    }
  }
}

}  // namespace asperity

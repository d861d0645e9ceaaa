// Places the popup below the button, within the screen.

#include "app/gui/base/commands_button.h"

#include <algorithm>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QFrame>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

constexpr int kWidth = 720;

class CommandWords final {
  Q_DECLARE_TR_FUNCTIONS(CommandWords)
};

void add_line(QVBoxLayout& layout, const ShownCommand& command, int number, QFrame& popup) {
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  auto* line = new QLineEdit(QString::fromStdString(command.line), &popup);
  line->setObjectName(QString("command_%1").arg(number));
  line->setAccessibleName(command.action);
  line->setReadOnly(true);
  line->setFont(number_font(TextSize::body));
  line->setCursorPosition(0);
  QPushButton* copy = make_button(CommandWords::tr("Copy"), ButtonRole::plain, &popup);
  copy->setObjectName(QString("copy_%1").arg(number));
  QObject::connect(copy, &QPushButton::clicked, &popup, [&popup, text = line->text()] {
    QGuiApplication::clipboard()->setText(text);
    popup.close();
  });
  row->addWidget(line, 1);
  row->addWidget(copy);
  layout.addLayout(row);
}

void show_commands(const std::vector<ShownCommand>& commands, QPushButton& button) {
  auto* popup = new QFrame(&button, Qt::Popup);
  popup->setObjectName("commands");
  popup->setAttribute(Qt::WA_DeleteOnClose);
  auto* layout = new QVBoxLayout(popup);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kGrid);
  int number = 0;
  for (const ShownCommand& command : commands) {
    layout->addWidget(make_heading(command.action, popup));
    if (!command.line.empty()) add_line(*layout, command, ++number, *popup);
    if (!command.remark.isEmpty()) layout->addWidget(make_text(command.remark, popup, true));
  }
  const QRect room = button.screen()->availableGeometry();
  popup->setFixedWidth(std::min(kWidth, room.width()));
  popup->adjustSize();
  const QPoint below = button.mapToGlobal(QPoint(0, button.height()));
  popup->move(
      std::clamp(below.x(), room.left(), room.left() + room.width() - popup->width()),
      std::max(room.top(), std::min(below.y(), room.top() + room.height() - popup->height())));
  popup->show();
}

}  // namespace

QPushButton* make_commands_button(std::function<std::vector<ShownCommand>()> commands,
                                  QWidget* parent) {
  QPushButton* button = make_button(CommandWords::tr("Command…"), ButtonRole::link, parent);
  button->setObjectName("show_commands");
  button->setToolTip(CommandWords::tr("The same on the command line"));
  QObject::connect(button, &QPushButton::clicked, button, [button, commands = std::move(commands)] {
    show_commands(commands(), *button);
  });
  return button;
}

}  // namespace asperity

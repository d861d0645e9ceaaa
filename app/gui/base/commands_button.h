// The button with which a page shows the command lines of its actions.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QtCore/QString>

class QPushButton;
class QWidget;

namespace asperity {

struct ShownCommand {
  QString action{};    ///< as the page names it
  std::string line{};  ///< empty: a terminal cannot do it, as the remark states
  QString remark{};    ///< a sentence; may be empty
};

/// Shows the commands of now in a popup, each with a button that copies it to the clipboard.
///
/// The names of the parts: "show_commands"; "commands", "command_1", "copy_1", and so on.
QPushButton* make_commands_button(std::function<std::vector<ShownCommand>()> commands,
                                  QWidget* parent);

}  // namespace asperity

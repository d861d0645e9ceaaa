// The last row of a dialog: what accepts it, and "Cancel".

#pragma once

#include <initializer_list>

class QBoxLayout;
class QDialog;
class QPushButton;
class QWidget;

namespace asperity {

/// Adds a row with the widgets `left` at its left end, and at its right end "Cancel", which rejects the dialog, and `accept`.
/// Returns "Cancel".
QPushButton* add_dialog_buttons(QDialog& dialog, QBoxLayout& layout, QPushButton* accept,
                                std::initializer_list<QWidget*> left = {});

}  // namespace asperity

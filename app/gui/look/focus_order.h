// The order in which Tab visits the controls of a page.

#pragma once

class QWidget;

namespace asperity {

/// Lets Tab visit the controls of `strip`, an item of its parent's layout, after those of the items before it, which may have
/// been made later. Without controls before it, the order stays.
void place_in_focus_order(QWidget& strip);

}  // namespace asperity

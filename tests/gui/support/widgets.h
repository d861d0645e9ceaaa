// Finding a window's widgets, and waiting for what they will show.

#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

#include "tests/support/patience.h"

class QTableView;

namespace asperity {

/// The child of that object name; fails the test where there is none.
template <class Widget>
Widget& child(const QWidget& parent, const char* name) {
  auto* found = parent.findChild<Widget*>(name);
  if (found == nullptr) throw std::runtime_error(std::string("no widget ") + name);
  return *found;
}

/// Waits, with events going on, until it holds; false where it did not within `kPatience`.
bool eventually(const std::function<bool()>& condition);

/// The same; fails the test with "no `what`" where it never holds.
void require(const std::function<bool()>& condition, const std::string& what);

/// Names of columns and texts of cells that have less room than they need, of a table whose texts are
/// wrapped.
QStringList cut_cells(const QTableView& table);

}  // namespace asperity

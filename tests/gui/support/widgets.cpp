#include "tests/gui/support/widgets.h"

#include <QtTest/QTest>

namespace asperity {

bool eventually(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, 20000);
}

void require(const std::function<bool()>& condition, const std::string& what) {
  if (!QTest::qWaitFor(condition, 60000)) throw std::runtime_error("no " + what);
}

}  // namespace asperity

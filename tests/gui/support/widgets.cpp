#include "tests/gui/support/widgets.h"

#include <QtTest/QTest>

namespace asperity {

bool eventually(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, kPatience_ms);
}

void require(const std::function<bool()>& condition, const std::string& what) {
  if (!eventually(condition)) throw std::runtime_error("no " + what);
}

}  // namespace asperity

// Starts a check after a pause in typing, and discards the result of an older text.

#include "app/gui/editor/live_check.h"

#include <utility>

namespace asperity {

namespace {

constexpr int kPause_ms = 250;  // longer than between two keys, shorter than a person waits for

}  // namespace

LiveCheck::LiveCheck(Text text, Check check, QObject* parent)
    : QObject(parent), text_(std::move(text)), check_(std::move(check)) {
  pause_.setSingleShot(true);
  pause_.setInterval(kPause_ms);
  connect(&pause_, &QTimer::timeout, this, &LiveCheck::begin);
}

void LiveCheck::want() {
  ++wanted_;
  settled_ = false;
  pause_.start();
}

void LiveCheck::want_now() {
  want();
  pause_.stop();
  begin();
}

void LiveCheck::begin() {
  work_.ask(
      [this, number = wanted_, text = text_(), check = check_]() -> NewestWork::Delivery {
        auto result = std::make_shared<const ProtocolCheck>(check(text));
        return [this, number, result] {
          if (number != wanted_) return;
          settled_ = true;
          emit checked(result);
        };
      },
      [this, number = wanted_](const QString& what) {
        if (number != wanted_) return;
        settled_ = true;
        emit failed(what);
      });
}

}  // namespace asperity

#include "moc_live_check.cpp"

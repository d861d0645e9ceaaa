// Checks one text at a time, and begins again with the newest one where it has changed meanwhile.

#include "app/gui/editor/live_check.h"

#include <utility>

namespace asperity {

namespace {

constexpr int kOneAction_ms = 10;  // an action that changes the text several times is checked once

}  // namespace

LiveCheck::LiveCheck(Text text, Check check, QObject* parent)
    : QObject(parent), text_(std::move(text)), check_(std::move(check)) {
  soon_.setSingleShot(true);
  soon_.setInterval(kOneAction_ms);
  connect(&soon_, &QTimer::timeout, this, &LiveCheck::begin);
}

void LiveCheck::want() {
  ++wanted_;
  settled_ = false;
  if (!is_held_ && !is_checking_ && !soon_.isActive()) soon_.start();
}

void LiveCheck::set_held(bool held) {
  is_held_ = held;
  if (held) {
    soon_.stop();
  } else if (!settled_ && !is_checking_) {
    soon_.start();
  }
}

void LiveCheck::begin() {
  is_checking_ = true;
  work_.ask(
      [this, number = wanted_, text = text_(), check = check_]() -> NewestWork::Delivery {
        const auto result = std::make_shared<const ProtocolCheck>(check(text));
        return [this, number, result] {
          if (ends_newest(number)) emit checked(result);
        };
      },
      [this, number = wanted_](const QString& what) {
        if (ends_newest(number)) emit failed(what);
      });
}

bool LiveCheck::ends_newest(std::uint64_t number) {
  is_checking_ = false;
  settled_ = number == wanted_;
  if (!settled_ && !is_held_) begin();
  return settled_;
}

}  // namespace asperity

#include "moc_live_check.cpp"

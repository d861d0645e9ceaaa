// The checks of a text that is being typed: off the GUI thread, and only the newest text counts.

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "app/gui/look/newest_work.h"
#include "app/tasks/check_protocol.h"

namespace asperity {

/// Has the text checked as soon as it has changed. While a check runs, further changes wait for its end: then the newest text
/// is checked, and what was found in the older one is dropped. While it is held, no check begins; the newest text is checked
/// afterwards. Belongs to the GUI thread.
class LiveCheck final : public QObject {
  Q_OBJECT
 public:
  using Text = std::function<std::string()>;                       ///< on the GUI thread
  using Check = std::function<ProtocolCheck(const std::string&)>;  ///< on the worker
  using Result = std::shared_ptr<const ProtocolCheck>;

  LiveCheck(Text text, Check check, QObject* parent = nullptr);

  /// The text has changed: what is known of it no longer holds.
  void want();
  void set_held(bool held);
  /// Neither waiting nor checking: what `checked` delivered last holds.
  bool is_settled() const noexcept { return settled_; }

 signals:
  void checked(const asperity::LiveCheck::Result& result);
  void failed(const QString& what);

 private:
  void begin();
  /// The check of the text with this number has ended. Returns whether it is the newest one, which is checked otherwise.
  bool ends_newest(std::uint64_t number);

  Text text_{};
  Check check_{};
  QTimer soon_{};
  std::uint64_t wanted_ = 0;
  bool is_checking_ = false;
  bool is_held_ = false;
  bool settled_ = true;
  NewestWork work_{};
};

}  // namespace asperity

// Work away from the GUI thread of which only the newest request matters.

#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include <QtCore/QObject>
#include <QtCore/QString>

namespace asperity {

/// One worker with one waiting place: a request that waits is replaced by a newer one and never
/// begun. A request that has begun is finished and delivered, so that a preview keeps moving under
/// a control that is dragged without end.
///
/// Belongs to the GUI thread. When it is destroyed it waits for the work in hand; nothing is
/// delivered any more.
class NewestWork final : public QObject {
  Q_OBJECT
 public:
  using Delivery = std::function<void()>;  ///< runs on the GUI thread
  using Work = std::function<Delivery()>;  ///< runs on the worker

  explicit NewestWork(QObject* parent = nullptr);
  ~NewestWork() override;

  /// `failed` gets what an exception says, unless a newer request was made meanwhile.
  void ask(Work work, std::function<void(QString)> failed);
  /// Something waits, runs or is about to be delivered.
  bool is_busy() const noexcept { return delivered_ < asked_; }

 signals:
  void settled();  ///< the newest request has been delivered

 private:
  struct Request {
    std::uint64_t number = 0;
    Work work{};
    std::function<void(QString)> failed{};
  };
  void run(const std::stop_token& stop);
  void deliver(std::uint64_t number, const Delivery& delivery);

  std::uint64_t asked_ = 0;  // of the GUI thread
  std::uint64_t delivered_ = 0;
  std::mutex mutex_{};
  std::condition_variable_any wake_{};
  std::optional<Request> waiting_{};
  std::jthread worker_{};
};

}  // namespace asperity

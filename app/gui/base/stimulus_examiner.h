// Examines the stimuli of protocols for the pages of a study, away from the GUI thread.

#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <QtCore/QObject>

#include "app/gui/look/background_task.h"
#include "app/tasks/warnings/stimulus_examination.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// One worker for all pages: one protocol at a time, in the order of the requests.
///
/// A result is kept for the text of a protocol and the contents of the files that it names (`content_key`): the list of
/// protocols, the editor and the start page share one examination. What was stopped is not kept.
///
/// A page requests while it is shown, withdraws when it is hidden and need not withdraw when it is destroyed. While a
/// session or a device test runs, the servo loop needs the processor: its owner has a hold. What runs then is
/// stopped, and begun again afterwards. Everything else that a page computes about a protocol follows
/// `held_changed` in the same way.
///
/// A stop takes effect at the next stimulus. Belongs to the GUI thread. When it is destroyed, it waits for the
/// worker; nothing is delivered any more.
class StimulusExaminer final : public QObject {
  Q_OBJECT
 public:
  using Result = std::shared_ptr<const StimulusExamination>;  ///< its diagnostics name no file
  using Done = std::function<void(const Protocol& protocol, const Result& result)>;
  using Examine = std::function<StimulusExamination(const Protocol&, const std::stop_token&)>;

  /// The models outlive it.
  StimulusExaminer(std::filesystem::path study, const ModelRegistry& models);

  /// Replaces the requests of the page by these protocols, which have been checked with the study. An examination that
  /// runs for the page goes on if its protocol is among them. `done` is called for each, in this order.
  void request(const QObject* page, std::vector<std::shared_ptr<const Protocol>> protocols,
               Done done);
  void withdraw(const QObject* page);

  /// Nothing is examined until every hold is gone: a session can begin before a device test that was stopped has ended.
  using Hold = std::shared_ptr<const void>;
  [[nodiscard]] Hold hold();
  bool is_held() const noexcept { return !hold_.expired(); }

  /// In place of `examine_stimuli`, for tests.
  void set_examine(Examine examine) { examine_ = std::move(examine); }

 signals:
  void held_changed();

 private:
  struct Request {
    const QObject* page = nullptr;
    std::shared_ptr<const Protocol> protocol{};
    Done done{};
  };
  struct Found {
    std::string key{};  ///< empty: not to be kept
    Result result{};
    bool is_outdated = false;  ///< a file was replaced meanwhile
  };
  using Known = std::map<std::string, Result>;  ///< by content_key

  static Found found_in(const Protocol& protocol, const std::filesystem::path& study,
                        const Known& known, const Examine& examine, const std::stop_token& stop);
  void begin_next();
  void end_hold();
  void stop();
  void deliver(const Found& found);

  std::filesystem::path study_{};
  Examine examine_{};
  Known known_{};
  std::deque<Request> waiting_{};
  std::optional<Request> current_{};  ///< absent while a worker that was stopped ends
  std::weak_ptr<const void> hold_{};
  BackgroundTask task_{};
};

}  // namespace asperity

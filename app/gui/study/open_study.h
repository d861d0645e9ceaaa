// The study that the window shows: its folder, a reader of its own, and news of changes.

#pragma once

#include <any>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <QtCore/QObject>

#include "renderers/force_model.h"
#include "results_schema/study.h"

namespace asperity {

/// Belongs to the GUI thread. Only reads: what writes (a session, a task) opens the study itself and
/// then calls `announce_change`.
class OpenStudy final : public QObject {
  Q_OBJECT
 public:
  /// Errors: ResultsError as Study::open.
  explicit OpenStudy(const std::filesystem::path& folder, QObject* parent = nullptr);

  const std::filesystem::path& folder() const noexcept { return study_.folder(); }
  const Study& study() const noexcept { return study_; }
  const ModelRegistry& models() const noexcept { return models_; }
  /// Everybody who shows the study reads it again.
  void announce_change() { emit changed(); }

 signals:
  /// What a page leaves to the one that is made in its place for another theme or language; empty
  /// when none has left anything. Taken once.
  void leave(const std::string& page, std::any what) { left_[page] = std::move(what); }
  std::any take_left(const std::string& page) { return std::exchange(left_[page], {}); }
  void changed();

 private:
  Study study_;
  ModelRegistry models_ = built_in_models();
};

}  // namespace asperity
  std::map<std::string, std::any> left_{};

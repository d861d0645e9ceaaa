// The examination of the stimuli of a text that is being typed: once the text has been still for a while.

#pragma once

#include <memory>

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include "app/gui/base/stimulus_examiner.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Belongs to the GUI thread.
class LiveExamination final : public QObject {
  Q_OBJECT
 public:
  /// The examiner outlives it.
  explicit LiveExamination(StimulusExaminer& examiner, QObject* parent = nullptr);

  /// The text is this protocol: it is examined unless `abandon` is called before.
  void want(std::shared_ptr<const Protocol> protocol);
  /// The text has changed, or is no longer shown: nothing is known of its stimuli, and an examination stops.
  void abandon();

  /// Null while there is none.
  const StimulusExaminer::Result& result() const noexcept { return result_; }
  /// It has begun, or waits for the examiner.
  bool is_under_way() const noexcept { return is_under_way_; }

 signals:
  /// An examination has begun, is held or released, or has a result.
  void changed();

 private:
  void begin();

  StimulusExaminer& examiner_;
  std::shared_ptr<const Protocol> protocol_{};
  StimulusExaminer::Result result_{};
  bool is_under_way_ = false;
  QTimer pause_{};
};

}  // namespace asperity

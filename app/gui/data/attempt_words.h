// How an attempt and what was decided about it are said in words.

#pragma once

#include <QtCore/QAbstractItemModel>
#include <QtCore/QCoreApplication>
#include <QtCore/QString>

#include "app/gui/look/controls.h"
#include "app/records/attempt_detail.h"

namespace asperity {

class AttemptWords final {
  Q_DECLARE_TR_FUNCTIONS(AttemptWords)
 public:
  static QString of_verdict(Verdict verdict);
  /// "Trial 3, attempt 1 · P001"
  static QString title(const AttemptDetail& detail);
  /// Session, protocol, block, outcome, answer, times.
  static QString summary(const AttemptDetail& detail);
  /// Whether it counts, and if not, why.
  static QString standing(const AttemptDetail& detail);
  static State state(const AttemptDetail& detail);
  /// "2 · brick, height_map": a presentation by its names.
  static QString of_surface(const PresentationRow& surface);
  /// How columns of the times of an answer are called; `explain_times` gives their headers tool tips
  /// that say what is counted from.
  static QString after_contact();
  static QString after_cue();
  static void explain_times(QAbstractItemModel& table, int contact_column, int cue_column);
  /// "3.21 s"; "–" where there is none.
  static QString of_seconds(const std::optional<double>& time_s);
};

}  // namespace asperity

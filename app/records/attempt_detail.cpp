// Reads the rows of the attempt and of its session, and its recording on request.

#include "app/records/attempt_detail.h"

#include <algorithm>

#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"

namespace asperity {

bool AttemptDetail::is_excluded_itself() const noexcept {
  bool excluded = false;
  for (const DecisionRow& decision : decisions) {
    if (!decision.trial) continue;
    if (decision.verdict == Verdict::exclude) excluded = true;
    if (decision.verdict == Verdict::include) excluded = false;
  }
  return excluded;
}

AttemptDetail attempt_detail(const Study& study, std::int64_t attempt_id) {
  AttemptDetail detail{};
  detail.session = study.session(study.session_of(attempt_id));
  const ProtocolRow protocol = study.protocol(detail.session.protocol_id);
  detail.protocol_name = protocol.name;
  detail.protocol_version = protocol.version;
  const std::vector<AttemptRow> attempts = study.attempts(detail.session.id);
  const auto here =
      std::find_if(attempts.begin(), attempts.end(),
                   [attempt_id](const AttemptRow& attempt) { return attempt.id == attempt_id; });
  detail.attempt = *here;
  detail.ordinal = static_cast<int>(here - attempts.begin()) + 1;
  detail.count = static_cast<int>(attempts.size());
  if (here != attempts.begin()) detail.previous_id = std::prev(here)->id;
  if (std::next(here) != attempts.end()) detail.next_id = std::next(here)->id;
  for (const PlannedTrialRow& planned : study.plan(detail.session.id)) {
    if (planned.trial == detail.attempt.trial) detail.planned = planned;
  }
  for (DecisionRow& decision : study.decisions(detail.session.id)) {
    const bool about_this =
        decision.trial == detail.attempt.trial && decision.attempt == detail.attempt.attempt;
    if (!decision.trial || about_this) detail.decisions.push_back(std::move(decision));
  }
  return detail;
}

Recording recording_of(const std::filesystem::path& study, const RecordingRow& row) {
  const std::filesystem::path file = study / row.path;
  Recording recording = read_recording(file);
  if (sha256_of(read_file(file)) != row.sha256) {
    throw ResultsError("the recording " + file.string() +
                           " differs from the one that was stored with the attempt (its SHA-256 "
                           "differs); restore it from a copy of the study",
                       file);
  }
  return recording;
}

Table table_of(const Recording& recording) {
  Table table{};
  table.columns.push_back("time_ns");
  for (const RecordingColumn& column : recording.header.columns) {
    table.columns.push_back(column.name);
  }
  table.rows.reserve(recording.time_ns.size());
  for (std::size_t tick = 0; tick < recording.time_ns.size(); ++tick) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.reserve(table.columns.size());
    row.emplace_back(recording.time_ns[tick]);
    for (const std::vector<float>& column : recording.columns) {
      row.emplace_back(static_cast<double>(column[tick]));
    }
  }
  return table;
}

}  // namespace asperity

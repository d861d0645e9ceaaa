// Copies table by table in the order of their references, with new keys for each session.

#include "results_schema/merge/merged_rows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "results_schema/merge/merged_table.h"

namespace asperity {
namespace {

/// A table whose rows belong to a session, and the order in which they are copied: that in which they were written where
/// they have an id.
struct TableOfSession {
  const char* name;
  const char* order;
};
/// With the column session_id: before the attempts, and after them.
constexpr TableOfSession kPlanTables[] = {
    {"session_file", "path"}, {"segment", "segment"}, {"trial", "trial"}};
constexpr TableOfSession kLaterTables[] = {{"session_answer", "id"}, {"event", "id"}};
/// With the column attempt_id, each after those to which its rows refer.
constexpr TableOfSession kAttemptTables[] = {{"presentation", "attempt_id, position"},
                                             {"presentation_asset", "attempt_id, position, role"},
                                             {"model_limit", "attempt_id, position, kind"},
                                             {"visit", "attempt_id, position, visit"},
                                             {"instability", "attempt_id, position"},
                                             {"response", "id"},
                                             {"servo_quality", "attempt_id"},
                                             {"compliance", "id"},
                                             {"recording", "attempt_id"}};

/// The keys that rows of one session have in the merged study.
struct SessionKeys {
  std::int64_t session = 0;
  std::map<std::int64_t, std::int64_t> attempts{};  ///< by those of the source
};

/// The text of an event in which the path of a log has the label as a folder.
std::string relabelled_log(std::string data_json, const std::string& prefix) {
  const std::string start = "\"log\":\"logs/";
  const std::size_t at = data_json.find(start);
  if (at != std::string::npos) data_json.insert(at + start.size(), prefix);
  return data_json;
}

class MergedRows final {
 public:
  MergedRows(Database& merged, OpenSources sources) : merged_(merged), sources_(sources) {}

  void copy() {
    number_sources();
    copy_protocols();
    copy_solutions();
    // One at a time: a statement that stayed open would keep the log from being emptied into the file.
    std::string last;
    while (copy_participant_after(last)) {
    }
    copy_withdrawals();  // which refer to participants whose data were kept
  }

 private:
  MergedTable& table(const std::string& name) {
    std::unique_ptr<MergedTable>& entry = tables_[name];
    if (!entry) entry = std::make_unique<MergedTable>(merged_, name);
    return *entry;
  }

  /// From 1, in the order of their first labels, so that the numbers do not depend on the order in which they were named.
  void number_sources() {
    numbers_.assign(sources_.size(), 0);
    Statement source(merged_,
                     "SELECT source FROM merged_participant GROUP BY source ORDER BY min(label)");
    std::int64_t number = 0;
    while (source.step()) numbers_[static_cast<std::size_t>(source.integer_at(0))] = ++number;
  }

  /// Each content once. What a study states of it apart from its text follows from the text.
  void copy_protocols() {
    struct Known {
      ProtocolRow row{};
      const OpenSource* source = nullptr;
    };
    std::map<std::string, Known> by_content;
    for (const OpenSource& source : sources_) {
      for (const ProtocolRow& row : source.study.protocols()) {
        const auto [known, is_new] = by_content.try_emplace(row.source_sha256, row, &source);
        const ProtocolRow& other = known->second.row;
        if (!is_new && std::tie(row.name, row.version, row.kind, row.design) !=
                           std::tie(other.name, other.version, other.kind, other.design)) {
          refuse_pair(known->second.source->source, source.source,
                      "they state different things of the protocol file with the SHA-256 " +
                          row.source_sha256 + ": " + other.name + ' ' + other.version + " (" +
                          other.kind + ", " + other.design + ") and " + row.name + ' ' +
                          row.version + " (" + row.kind + ", " + row.design +
                          "). One of the studies was changed by another program; restore it from "
                          "a copy");
        }
      }
    }
    std::map<std::tuple<std::string, std::string, std::string>, const ProtocolRow*> ordered;
    for (const auto& [sha256, known] : by_content) {
      ordered[{known.row.name, known.row.version, sha256}] = &known.row;
    }
    Transaction transaction(merged_);
    Statement insertion(merged_,
                        "INSERT INTO protocol (name, version, kind, design, source_sha256, source) "
                        "VALUES (?, ?, ?, ?, ?, ?)");
    std::map<std::string, std::int64_t> ids_by_content;
    for (const auto& [key, row] : ordered) {
      insertion
          .bind(row->name, row->version, row->kind, row->design, row->source_sha256, row->source)
          .run();
      ids_by_content[row->source_sha256] = merged_.last_row_id();
    }
    transaction.commit();
    for (const OpenSource& source : sources_) {
      std::map<std::int64_t, std::int64_t>& ids = protocol_ids_.emplace_back();
      for (const ProtocolRow& row : source.study.protocols()) {
        ids[row.id] = ids_by_content.at(row.source_sha256);
      }
    }
  }

  /// In the order of withdrawing. Studies that were copied from one have the withdrawals before that in common.
  void copy_withdrawals() {
    const std::vector<std::string> columns = columns_of(merged_, "withdrawal");
    std::string names = "withdrawn_utc";  // decides the order
    std::string marks = "?";
    const std::string key = "participant_id";  // the last one, which is replaced
    for (const std::string& column : columns) {
      if (column == "id" || column == "withdrawn_utc" || column == key) continue;
      names += ", " + column;
      marks += ", ?";
    }
    names += ", " + key;
    marks += ", ?";
    std::set<std::vector<std::optional<std::string>>> rows;
    for (std::size_t number = 0; number < sources_.size(); ++number) {
      Statement statement(sources_[number].database, "SELECT " + names + " FROM withdrawal");
      while (statement.step()) {
        std::vector<std::optional<std::string>> row(columns.size() - 1);
        statement.read_all(row);
        const auto whose = withdrawn_ids_.find({number, row.back().value_or("")});
        if (whose != withdrawn_ids_.end()) row.back() = std::to_string(whose->second);
        rows.insert(std::move(row));
      }
    }
    Transaction transaction(merged_);
    Statement insertion(merged_, "INSERT INTO withdrawal (" + names + ") VALUES (" + marks + ')');
    for (const auto& row : rows) {
      for (const std::optional<std::string>& value : row) insertion.bind(value);
      insertion.run();
    }
    transaction.commit();
  }

  /// The cache of solved matching problems. Where two programs solved a problem differently, the lesser text stays, so that
  /// the order of the studies does not matter; what an attempt used is in its presentation.
  void copy_solutions() {
    merged_.execute(
        "CREATE TEMP TABLE merged_solution (key TEXT PRIMARY KEY, solution_json TEXT NOT NULL) "
        "WITHOUT ROWID");
    Transaction transaction(merged_);
    Statement insertion(merged_,
                        "INSERT INTO merged_solution VALUES (?, ?) ON CONFLICT DO UPDATE "
                        "SET solution_json = min(solution_json, excluded.solution_json)");
    for (const OpenSource& source : sources_) {
      Statement solution(source.database, "SELECT key, solution_json FROM solution ORDER BY key");
      while (solution.step()) {
        insertion.bind_column(solution, 0).bind_column(solution, 1).run();
      }
    }
    merged_.execute("INSERT INTO solution SELECT * FROM merged_solution ORDER BY key");
    transaction.commit();
  }

  /// The participant whose label follows `last`, which becomes it. False: there is none.
  bool copy_participant_after(std::string& last) {
    std::int64_t source = 0;
    std::int64_t id = 0;
    {
      Statement next(merged_,
                     "SELECT label, source, id FROM merged_participant WHERE label > ? "
                     "ORDER BY label LIMIT 1");
      if (!next.bind(last).step()) return false;
      next.read(last, source, id);
    }
    Transaction transaction(merged_);
    copy_participant(static_cast<std::size_t>(source), last, id);
    transaction.commit();
    return true;
  }

  void copy_participant(std::size_t number, const std::string& label, std::int64_t id) {
    Database& source = sources_[number].database;
    MergedTable& participants = table("participant");
    Statement row(source, participants.selection("WHERE id = ?"));
    if (!row.bind(id).step()) return;
    // One who withdrew can have no new session, by the rules: that follows at the end.
    const std::int64_t merged_id =
        participants.add(row, [&label](const std::string& column, Statement&, int) -> MergedValue {
          if (column == "id") return Missing{};
          if (column == "label") return label;
          if (column == "withdrawn") return std::int64_t{0};
          return Unchanged{};
        });
    const bool has_withdrawn = row.integer_at(participants.place_of("withdrawn")) != 0;
    const bool is_virtual = row.integer_at(participants.place_of("is_virtual")) != 0;
    copy_sessions(number, id, merged_id, is_virtual);
    if (has_withdrawn) {
      withdrawn_ids_[{number, std::to_string(id)}] = merged_id;
      Statement(merged_, "UPDATE participant SET withdrawn = 1 WHERE id = ?").bind(merged_id).run();
    }
  }

  void copy_sessions(std::size_t number, std::int64_t participant, std::int64_t merged_id,
                     bool is_virtual) {
    MergedTable& sessions = table("session");
    const std::map<std::int64_t, std::int64_t>& protocols = protocol_ids_[number];
    Statement row(sources_[number].database,
                  sessions.selection("WHERE participant_id = ? ORDER BY session"));
    row.bind(participant);
    while (row.step()) {
      SessionKeys keys{};
      // Rows are added to an open session only: it is closed when it has them.
      keys.session = sessions.add(
          row, [&](const std::string& column, Statement& values, int at) -> MergedValue {
            if (column == "id" || column == "ended_utc") return Missing{};
            if (column == "participant_id") return merged_id;
            if (column == "protocol_id") return protocols.at(values.integer_at(at));
            if (column == "state") return std::string("open");
            return Unchanged{};
          });
      const std::int64_t session = row.integer_at(sessions.place_of("id"));
      copy_session(sources_[number], session, keys);
      // A simulation gives the same sessions, however many studies it is divided into.
      if (!is_virtual) add_origin(number, session, keys.session);
      Statement end(merged_, "UPDATE session SET state = ?, ended_utc = ? WHERE id = ?");
      end.bind_column(row, sessions.place_of("state"))
          .bind_column(row, sessions.place_of("ended_utc"))
          .bind(keys.session)
          .run();
    }
  }

  void copy_session(const OpenSource& source, std::int64_t session, SessionKeys& keys) {
    const MergedValueOf value_of = [&](const std::string& column, Statement& row,
                                       int at) -> MergedValue {
      if (column == "id") return Missing{};
      if (column == "session_id") return keys.session;
      if (column == "attempt_id") {
        const auto merged = keys.attempts.find(row.integer_at(at));
        return merged == keys.attempts.end() ? MergedValue(Unchanged{}) : merged->second;
      }
      return Unchanged{};
    };
    for (const TableOfSession& of_plan : kPlanTables) {
      table(of_plan.name)
          .add_all(source.database, std::string("WHERE session_id = ? ORDER BY ") + of_plan.order,
                   session, value_of);
    }
    copy_attempts(source.database, session, keys, value_of);
    for (const TableOfSession& of_attempts : kAttemptTables) {
      const bool is_recording = std::string(of_attempts.name) == "recording";
      table(of_attempts.name)
          .add_all(source.database,
                   std::string("WHERE attempt_id IN (SELECT id FROM attempt WHERE session_id = ?) "
                               "ORDER BY ") +
                       of_attempts.order,
                   session, [&](const std::string& column, Statement& row, int at) -> MergedValue {
                     if (!is_recording || column != "path") return value_of(column, row, at);
                     return merged_path(source.source, row.text_at(at)).string();
                   });
    }
    for (const TableOfSession& later : kLaterTables) {
      table(later.name)
          .add_all(source.database, std::string("WHERE session_id = ? ORDER BY ") + later.order,
                   session, [&](const std::string& column, Statement& row, int at) -> MergedValue {
                     if (column != "data_json") return value_of(column, row, at);
                     return relabelled_log(row.text_at(at), source.source.prefix);
                   });
    }
  }

  /// The event that states from which study the session is, as the last one of the session. The id there is its place in
  /// the order in which that study assigned groups.
  void add_origin(std::size_t number, std::int64_t session, std::int64_t merged_id) {
    Statement study(sources_[number].database, "SELECT name, created_utc FROM study");
    std::string name;
    std::string created_utc;
    if (study.step()) study.read(name, created_utc);
    const nlohmann::ordered_json data{{"study", name},
                                      {"created_utc", created_utc},
                                      {"source", numbers_[number]},
                                      {"session_id", session}};
    Statement(merged_,
              "INSERT INTO event (session_id, time_ns, kind, text, data_json) VALUES (?1, "
              "(SELECT max(last_ns) FROM ("
              "SELECT clock_zero_ns AS last_ns FROM session WHERE id = ?1 "
              "UNION ALL SELECT max(ended_ns) FROM segment WHERE session_id = ?1 "
              "UNION ALL SELECT max(offset_ns) FROM attempt WHERE session_id = ?1 "
              "UNION ALL SELECT max(time_ns) FROM event WHERE session_id = ?1)), ?2, ?3, ?4)")
        .bind(merged_id, kMergedEvent, name, data.dump())
        .run();
  }

  /// With the decisions on them: an attempt follows a valid one of the same trial only after the decision that set that one
  /// aside. Both keep their own order.
  void copy_attempts(Database& source, std::int64_t session, SessionKeys& keys,
                     const MergedValueOf& value_of) {
    std::int64_t last_decision = 0;
    const auto copy_decisions_until = [&](std::int64_t last) {
      MergedTable& decisions = table("decision");
      Statement row(source,
                    decisions.selection("WHERE session_id = ? AND id > ? AND id <= ? ORDER BY id"));
      row.bind(session, last_decision, last);
      while (row.step()) decisions.add(row, value_of);
      last_decision = std::max(last_decision, last);
    };
    MergedTable& attempts = table("attempt");
    Statement row(source, attempts.selection("WHERE session_id = ? ORDER BY id"));
    row.bind(session);
    Statement set_aside(source,
                        "SELECT coalesce(max(id), 0) FROM decision WHERE session_id = ? "
                        "AND trial = ? AND attempt < ? AND verdict = 'set_aside'");
    while (row.step()) {
      set_aside.bind(session, row.integer_at(attempts.place_of("trial")),
                     row.integer_at(attempts.place_of("attempt")));
      if (set_aside.step()) {
        const std::int64_t decision = set_aside.integer_at(0);
        if (decision > last_decision) copy_decisions_until(decision);
      }
      set_aside.run();
      keys.attempts[row.integer_at(attempts.place_of("id"))] = attempts.add(row, value_of);
    }
    copy_decisions_until(std::numeric_limits<std::int64_t>::max());
  }

  Database& merged_;
  OpenSources sources_;
  std::map<std::string, std::unique_ptr<MergedTable>> tables_{};
  /// Of each source: the ids in the merged study, by those of the source.
  std::vector<std::map<std::int64_t, std::int64_t>> protocol_ids_{};
  /// Of participants whose data are kept: the id in the merged study, by the source and the id there.
  std::map<std::pair<std::size_t, std::string>, std::int64_t> withdrawn_ids_{};
  std::vector<std::int64_t> numbers_{};  ///< of the sources, from 1
};

}  // namespace

std::filesystem::path merged_path(const MergeSource& source, const std::filesystem::path& path) {
  if (source.prefix.empty() || path.empty()) return path;
  const std::string first = path.begin()->string();
  constexpr const char* kSheet = "sheet-";
  if (first.starts_with(kSheet)) {
    return kSheet + source.prefix + path.string().substr(std::string(kSheet).size());
  }
  if (first != "recordings" && first != "logs") return path;
  std::filesystem::path merged = first;
  std::string prefix = source.prefix;
  for (auto name = std::next(path.begin()); name != path.end(); ++name) {
    merged /= prefix + name->string();
    prefix.clear();
  }
  return merged;
}

void copy_merged_rows(Database& merged, OpenSources sources) { MergedRows(merged, sources).copy(); }

}  // namespace asperity

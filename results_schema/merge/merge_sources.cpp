// Compares identities of participants and sessions of all studies in tables on disk.

#include "results_schema/merge/merge_sources.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/merge/merged_table.h"
#include "results_schema/study_store.h"
#include "results_schema/tables/name_forms.h"

namespace asperity {
namespace {

/// A text that two rows share only if all their values are equal.
std::string identity_of(const std::vector<std::optional<std::string>>& values) {
  std::string text;
  for (const std::optional<std::string>& value : values) {
    text += value ? std::to_string(value->size()) + ':' + *value : std::string("-");
  }
  return sha256_of(text);
}

/// What never changes of a session, with the text of its protocol: two copies of a session are equal in it for ever. The
/// name of the participant is no part of it: a merge can have prefixed it.
std::string select_session_identities(Database& database, std::size_t& columns) {
  static const std::set<std::string> kMutableOrKey{"id", "participant_id", "protocol_id", "state",
                                                   "ended_utc"};
  std::string select = "SELECT label || '/' || session.session, source_sha256";
  columns = 2;
  for (const std::string& column : columns_of(database, "session")) {
    if (kMutableOrKey.contains(column)) continue;
    select += ", session." + column;
    ++columns;
  }
  return select +
         " FROM session JOIN participant ON participant.id = participant_id "
         "JOIN protocol ON protocol.id = protocol_id ORDER BY label, session.session";
}

/// Of a person: the moment at which they were added, and what they answered. Virtual participants and sessions that are
/// faster than real time have the dates of a simulated calendar, which begins anew in each study: they are known by their
/// sessions.
constexpr const char* kPersonIdentities =
    "SELECT label, created_utc, age_years, sex, handedness, answers_json FROM participant "
    "WHERE is_virtual = 0 AND NOT EXISTS (SELECT 1 FROM session "
    "WHERE participant_id = participant.id AND pacing = 'stepped') ORDER BY label";
constexpr std::size_t kPersonColumns = 6;

/// Remembers which study has a row of which identity, on disk: a study can have more rows than fit into memory.
class Identities final {
 public:
  Identities(Database& merged, OpenSources sources)
      : sources_(sources),
        known_(merged, "SELECT source, name FROM merged_identity WHERE identity = ?"),
        insertion_(merged, "INSERT INTO merged_identity VALUES (?, ?, ?) ON CONFLICT DO NOTHING") {}

  /// `thing` is "session" or "participant".
  void add(std::size_t source, const std::string& thing, const std::string& name,
           const std::string& identity) {
    if (known_.bind(identity).step()) {
      std::int64_t other = 0;
      std::string other_name;
      known_.read(other, other_name);
      if (static_cast<std::size_t>(other) != source) {
        refuse_pair(sources_[static_cast<std::size_t>(other)].source, sources_[source].source,
                    "both contain the same " + thing + ", " + other_name +
                        (name == other_name ? "" : " and " + name) +
                        ". They are copies of one study, or were merged from a common one, and a "
                        "withdrawal from one of them would be undone by the other. Name only "
                        "studies without common data");
      }
    }
    known_.run();
    insertion_.bind(identity, static_cast<std::int64_t>(source), name).run();
  }

 private:
  OpenSources sources_;
  Statement known_;
  Statement insertion_;
};

/// `rows` select a name, then the columns of which the identity consists.
void add_identities(Identities& identities, std::size_t source, Database& database,
                    const std::string& rows, std::size_t columns, const std::string& thing) {
  std::vector<std::optional<std::string>> values(columns);
  Statement row(database, rows);
  while (row.step()) {
    const std::string name = row.text_at(0);
    row.read_all(values);
    values.front().reset();
    identities.add(source, thing, name, identity_of(values));
  }
}

void add_participants(Database& merged, std::size_t number, const OpenSource& source) {
  Statement insertion(merged, "INSERT INTO merged_participant VALUES (?, ?, ?, ?)");
  Statement participant(source.database, "SELECT id, label FROM participant ORDER BY label");
  while (participant.step()) {
    std::int64_t id = 0;
    std::string label;
    participant.read(id, label);
    const std::string merged_label = source.source.prefix + label;
    if (!is_participant_label(merged_label)) {
      refuse_source(source.source, "the label " + merged_label +
                                       " would be too long: a label has at most 32 letters and "
                                       "digits. Choose a shorter prefix than \"" +
                                       source.source.prefix + "\"");
    }
    insertion.bind(merged_label, static_cast<std::int64_t>(number), id, label_form(merged_label))
        .run();
  }
}

std::string added_utc(const OpenSource& source, std::int64_t id) {
  Statement statement(source.database, "SELECT created_utc FROM participant WHERE id = ?");
  std::string utc;
  if (statement.bind(id).step()) statement.read(utc);
  return utc;
}

/// Labels of one form in two studies: of two participants, or of one who went to both.
void refuse_similar_labels(Database& merged, OpenSources sources) {
  Statement similar(merged,
                    "SELECT first.label, first.source, first.id, "
                    "second.label, second.source, second.id, "
                    "(SELECT count(*) FROM (SELECT 1 FROM merged_participant GROUP BY form "
                    "HAVING count(DISTINCT source) > 1)) "
                    "FROM merged_participant AS first JOIN merged_participant AS second "
                    "ON second.form = first.form AND second.source > first.source "
                    "ORDER BY first.label, first.source, second.source, second.label LIMIT 1");
  if (!similar.step()) return;
  std::string label;
  std::int64_t first = 0;
  std::int64_t first_id = 0;
  std::string second_label;
  std::int64_t second = 0;
  std::int64_t second_id = 0;
  std::int64_t labels = 0;
  similar.read(label, first, first_id, second_label, second, second_id, labels);
  const OpenSource& one = sources[static_cast<std::size_t>(first)];
  const OpenSource& other = sources[static_cast<std::size_t>(second)];
  const std::string who = label == second_label
                              ? "both have a participant " + label
                              : "they have the participants " + label + " and " + second_label +
                                    ", whose labels differ only in letter case or leading zeros";
  refuse_pair(one.source, other.source,
              who + ", added to " + one.source.folder.string() + " at " + added_utc(one, first_id) +
                  " and to " + other.source.folder.string() + " at " + added_utc(other, second_id) +
                  (labels == 1 ? "" : " (and " + std::to_string(labels - 1) + " further labels)") +
                  ". Distinguish the labels by a prefix, for example --prefix " +
                  other.source.folder.string() + "=B");
}

/// A row of `withdrawal` without its id.
using WithdrawalValues = std::vector<std::optional<std::string>>;

std::set<WithdrawalValues> deletions_of(Database& database) {
  Statement statement(database,
                      "SELECT withdrawn_utc, is_virtual, reason, decided_by, sessions, attempts, "
                      "answers, recordings FROM withdrawal WHERE data = 'deleted'");
  std::set<WithdrawalValues> deletions;
  while (statement.step()) {
    WithdrawalValues values(8);
    statement.read_all(values);
    deletions.insert(std::move(values));
  }
  return deletions;
}

/// `deleted_from` has a deletion that `other`, which was created at the same moment, has not.
void refuse_undone_deletion(const OpenSource& deleted_from, const OpenSource& other) {
  const std::set<WithdrawalValues> done = deletions_of(deleted_from.database);
  const std::set<WithdrawalValues> others = deletions_of(other.database);
  const auto undone = std::find_if(done.begin(), done.end(), [&others](const auto& deletion) {
    return !others.contains(deletion);
  });
  if (undone == done.end()) return;
  refuse_pair(deleted_from.source, other.source,
              "they were copied from one study, and data of a participant were deleted from " +
                  deleted_from.source.folder.string() + " at " + undone->front().value_or("") +
                  ", but not from " + other.source.folder.string() +
                  ", which may still contain them. If it does, delete them there too "
                  "(\"asperity withdraw\"); then merge with --deletions-checked");
}

/// What the studies state of one thing; where `stated` has it, that. `text_of` shows it, empty where nothing is stated.
template <typename Value, typename Text>
Value agreed(OpenSources sources, const std::string& things, const std::string& option,
             const Value& stated, Value StudyMetadata::*member, const Text& text) {
  if (!text(stated).empty()) return stated;
  Value found{};
  const OpenSource* first = nullptr;
  for (const OpenSource& source : sources) {
    Value value = source.study.metadata().*member;
    if (text(value).empty() || value == found) continue;
    if (first != nullptr) {
      refuse_pair(first->source, source.source,
                  "they state different " + things + ", \"" + text(found) + "\" and \"" +
                      text(value) + "\". State what holds for the merged study with " + option);
    }
    found = std::move(value);
    first = &source;
  }
  return found;
}

}  // namespace

void refuse_source(const MergeSource& source, const std::string& why) {
  throw ResultsError("the study " + source.folder.string() + " cannot be merged: " + why,
                     source.folder);
}

void refuse_pair(const MergeSource& first, const MergeSource& second, const std::string& why) {
  throw ResultsError("the studies " + first.folder.string() + " and " + second.folder.string() +
                         " cannot be merged: " + why,
                     second.folder);
}

std::string creation_of(Database& database) {
  Statement statement(database, "SELECT created_utc FROM study");
  std::string utc;
  if (statement.step()) statement.read(utc);
  return utc;
}

void refuse_unfinished(const OpenSource& source) {
  if (!unfinished_deletions(source.database).empty()) {
    refuse_source(source.source,
                  "the deletion of a participant's data is not complete. Repeat it with \"asperity "
                  "withdraw\" and --delete, then merge again");
  }
  Statement open(source.database,
                 "SELECT label, session FROM session JOIN participant "
                 "ON participant.id = participant_id WHERE state = 'open' ORDER BY label, session");
  while (open.step()) {
    std::string label;
    int session = 0;
    open.read(label, session);
    const auto holder = StudyLock::holder(source.study.folder(), Study::session_lock_name(label));
    if (!holder) continue;
    refuse_source(source.source, "its session " + label + '/' + std::to_string(session) +
                                     " is running (" + holder->description +
                                     "). Wait until it has ended, then merge again");
  }
  for (const ProtocolRow& protocol : source.study.protocols()) {
    if (sha256_of(protocol.source) == protocol.source_sha256) continue;
    refuse_source(source.source, "the text of its protocol " + protocol.name + ' ' +
                                     protocol.version +
                                     " does not have the stored SHA-256; restore the study from a "
                                     "copy, then merge again");
  }
}

void list_participants(Database& merged, OpenSources sources) {
  merged.execute(
      "CREATE TEMP TABLE merged_participant (label TEXT NOT NULL, source INTEGER NOT NULL, "
      "id INTEGER NOT NULL, form TEXT NOT NULL, PRIMARY KEY (label, source)) WITHOUT ROWID;"
      "CREATE INDEX temp.merged_participant_by_form ON merged_participant (form);"
      "CREATE TEMP TABLE merged_identity (identity TEXT PRIMARY KEY, source INTEGER NOT NULL, "
      "name TEXT NOT NULL) WITHOUT ROWID");
  Transaction transaction(merged);
  Identities identities(merged, sources);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    Database& database = sources[i].database;
    std::size_t columns = 0;
    const std::string sessions = select_session_identities(database, columns);
    add_identities(identities, i, database, sessions, columns, "session");
    add_identities(identities, i, database, kPersonIdentities, kPersonColumns, "participant");
    add_participants(merged, i, sources[i]);
  }
  transaction.commit();
  refuse_similar_labels(merged, sources);
}

void refuse_undone_deletions(OpenSources sources) {
  std::map<std::string, std::vector<const OpenSource*>> copies;
  for (const OpenSource& source : sources) copies[creation_of(source.database)].push_back(&source);
  for (const auto& [created_utc, of_one] : copies) {
    for (const OpenSource* one : of_one) {
      for (const OpenSource* other : of_one) {
        if (one != other) refuse_undone_deletion(*one, *other);
      }
    }
  }
}

StudyMetadata merged_metadata(OpenSources sources, const StudyMetadata& stated) {
  const auto text = [](const std::optional<std::string>& value) { return value.value_or(""); };
  const auto list = [](const std::vector<std::string>& names) {
    std::string joined;
    for (const std::string& name : names) joined += (joined.empty() ? "" : "; ") + name;
    return joined;
  };
  return {.authors =
              agreed(sources, "authors", "--author", stated.authors, &StudyMetadata::authors, list),
          .license = agreed(sources, "licences", "--license", stated.license,
                            &StudyMetadata::license, text),
          .ethics_approval = agreed(sources, "ethics approvals", "--ethics", stated.ethics_approval,
                                    &StudyMetadata::ethics_approval, text)};
}

}  // namespace asperity

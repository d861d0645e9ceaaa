// What a study says of itself: who answers for it, and what was made of it.

#include <array>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

constexpr std::array kOutputKinds{OutputKind::export_, OutputKind::public_export,
                                  OutputKind::report, OutputKind::copy, OutputKind::merge};

}  // namespace

StudyMetadata Study::metadata() const {
  return store_->read([](Database& database) {
    StudyMetadata metadata{};
    Statement study(database, "SELECT license, ethics_approval FROM study");
    if (study.step()) study.read(metadata.license, metadata.ethics_approval);
    Statement author(database, "SELECT name FROM author ORDER BY position");
    while (author.step()) author.read(metadata.authors.emplace_back());
    return metadata;
  });
}

void Study::set_metadata(const StudyMetadata& metadata) {
  Database& database = store_->writable();
  Transaction transaction(database);
  Statement(database, "UPDATE study SET license = ?, ethics_approval = ?")
      .bind(metadata.license, metadata.ethics_approval)
      .run();
  database.execute("DELETE FROM author");
  Statement author(database, "INSERT INTO author VALUES (?, ?)");
  int position = 0;
  for (const std::string& name : metadata.authors) author.bind(++position, name).run();
  transaction.commit();
}

std::int64_t Study::begin_output(const OutputRow& output) {
  Statement insertion(store_->writable(),
                      "INSERT INTO output (kind, path, program_version) VALUES (?, ?, ?) "
                      "RETURNING id");
  insertion.bind(text_of(output.kind), output.path, output.program_version);
  std::int64_t id = 0;
  if (insertion.step()) insertion.read(id);
  insertion.run();
  return id;
}

void Study::end_output(std::int64_t id) {
  Statement(store_->writable(),
            "UPDATE output SET made_utc = strftime('%Y-%m-%dT%H:%M:%fZ', 'now') WHERE id = ?")
      .bind(id)
      .run();
}

void Study::remove_output(std::int64_t id) {
  Statement(store_->writable(), "DELETE FROM output WHERE id = ?").bind(id).run();
}

std::vector<OutputRow> Study::outputs() const { return store_->read(outputs_in); }

std::vector<OutputRow> Study::outputs_since_added(const std::string& label) const {
  return store_->read(
      [&label](Database& database) { return outputs_since_added_in(database, label); });
}

std::vector<OutputRow> outputs_in(Database& database) {
  Statement statement(database,
                      "SELECT kind, path, program_version, made_utc FROM output ORDER BY id");
  std::vector<OutputRow> rows;
  while (statement.step()) {
    OutputRow& row = rows.emplace_back();
    std::string kind;
    statement.read(kind, row.path, row.program_version, row.made_utc);
    row.kind = enum_of(kind, kOutputKinds, "output.kind");
  }
  return rows;
}

}  // namespace asperity

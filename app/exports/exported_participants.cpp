// Gives new labels in a relabelled export, and sorts the participants by them.

#include "app/exports/exported_participants.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity {
namespace {

// Of all participants of the study, those who withdrew included: none of their labels is used for another one.
std::vector<std::string> labels_of(const std::vector<ParticipantRow>& participants) {
  std::vector<std::string> labels{};
  for (const ParticipantRow& participant : participants) labels.push_back(participant.label);
  return labels;
}

void relabel(std::vector<ExportedParticipant>& participants, const std::vector<std::string>& taken,
             const RandomBits& bits) {
  if (!bits) throw std::invalid_argument("random_bits is empty; new labels cannot be drawn");
  std::vector<std::string> labels = drawn_labels(participants.size(), taken, bits);
  for (std::size_t i = 0; i < participants.size(); ++i) {
    participants[i].listed.label = std::move(labels[i]);
    for (SessionRow& session : participants[i].sessions) {
      session.participant = participants[i].listed.label;
    }
  }
  std::sort(participants.begin(), participants.end(),
            [](const ExportedParticipant& a, const ExportedParticipant& b) {
              return a.listed.label < b.listed.label;
            });
}

}  // namespace

std::vector<ExportedParticipant> exported_participants(const Study& study,
                                                       const ExportOptions& options) {
  const std::vector<ParticipantRow> rows = study.participants();
  std::map<std::string, std::vector<SessionRow>> sessions{};
  for (SessionRow& session : study.sessions()) {
    sessions[session.participant].push_back(std::move(session));
  }
  std::vector<ExportedParticipant> participants{};
  for (const ParticipantRow& row : rows) {
    if (row.withdrawn && is_public(options.audience)) continue;
    participants.push_back(
        {.stored = row, .listed = row, .sessions = std::move(sessions[row.label])});
  }
  if (options.audience == ExportAudience::relabelled) {
    relabel(participants, labels_of(rows), options.random_bits);
  }
  return participants;
}

std::string versions_text(const std::vector<ExportedParticipant>& participants) {
  std::set<std::string> versions{};
  for (const ExportedParticipant& participant : participants) {
    for (const SessionRow& session : participant.sessions) versions.insert(session.program_version);
  }
  std::string text{};
  for (const std::string& version : versions) text += (text.empty() ? "" : ", ") + version;
  return text.empty() ? text : "The sessions were run with Asperity " + text + ".\n";
}

AgeBands age_bands_of(const std::vector<ExportedParticipant>& participants) {
  std::vector<ParticipantRow> rows{};
  for (const ExportedParticipant& participant : participants) {
    if (!participant.sessions.empty()) rows.push_back(participant.stored);
  }
  return AgeBands(rows);
}

}  // namespace asperity

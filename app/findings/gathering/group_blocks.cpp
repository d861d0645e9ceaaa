// Reads the places of a study once a session needs one, and draws the sequence up to each.

#include "app/findings/gathering/group_blocks.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "app/study_files/group_places.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

std::string name_of_block(const PermutedBlocks& blocks, const std::string& mode,
                          const std::string& sequence, std::size_t before) {
  const std::string number = std::to_string(permuted_place(blocks, mode, before).block + 1);
  return mode + (sequence.empty() ? " " : " " + sequence + ' ') + number;
}

}  // namespace

std::optional<std::string> block_of_simulated(const std::string& label, const Protocol& protocol) {
  const std::size_t digits = label.find_last_not_of("0123456789") + 1;
  std::size_t number = 0;
  const char* const end = label.data() + label.size();
  const std::optional<PermutedBlocks> blocks = permuted_blocks_of(protocol);
  if (!blocks || std::from_chars(label.data() + digits, end, number).ec != std::errc{} ||
      number == 0) {
    return {};
  }
  return name_of_block(*blocks, text_of(SessionMode::simulate), "", number - 1);
}

GroupBlocks::GroupBlocks(const Study& study, const std::vector<SessionRow>& sessions)
    : study_(study), sessions_(sessions) {}

void GroupBlocks::read_places() {
  places_.emplace();
  const std::vector<WithdrawalRow> withdrawals = study_.withdrawals();
  const bool is_any_deleted =
      std::any_of(withdrawals.begin(), withdrawals.end(),
                  [](const WithdrawalRow& row) { return row.data == WithdrawnData::deleted; });
  std::map<std::string, std::size_t> stations{{"", 0}};  // this study first
  for (const GroupPlace& place : group_places(study_, sessions_)) {
    const std::size_t station = stations.try_emplace(place.study, stations.size()).first->second;
    if (place.dealt) {
      (*places_)[place.session->id] = {"dealt", static_cast<std::size_t>(*place.dealt - 1)};
    } else if (!is_any_deleted) {
      (*places_)[place.session->id] = {station == 0 ? "" : "station " + std::to_string(station),
                                       place.before};
    }
  }
}

std::optional<std::string> GroupBlocks::of(const SessionRow& session, const Protocol& protocol) {
  const std::optional<PermutedBlocks> blocks = permuted_blocks_of(protocol);
  if (!blocks || !session.group_level) return {};
  if (session.mode == SessionMode::simulate) {
    return block_of_simulated(session.participant, protocol);
  }
  if (!places_) read_places();
  const auto place = places_->find(session.id);
  if (place == places_->end()) return {};
  return name_of_block(*blocks, text_of(session.mode), place->second.sequence,
                       place->second.before);
}

}  // namespace asperity

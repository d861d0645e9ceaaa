// The blocks in which a protocol with permuted blocks assigned the participants to groups.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// The names of the blocks, which differ between modes and between stations. Labels of groups can be exchanged within a block.
///
/// The place of a participant in the sequence is the number of those assigned before. Participants whose data are deleted can no
/// longer be counted, so that the blocks of a study with such participants are unknown, except for dealt places.
class GroupBlocks final {
 public:
  /// `sessions`: all of the study.
  GroupBlocks(const Study& study, const std::vector<SessionRow>& sessions);

  /// Of the participant of this session; nothing where the blocks are not permuted, or unknown.
  std::optional<std::string> of(const SessionRow& session, const Protocol& protocol);

 private:
  struct Place {
    std::string sequence{};
    std::size_t before = 0;
  };
  void read_places();

  const Study& study_;
  const std::vector<SessionRow>& sessions_;
  std::optional<std::map<std::int64_t, Place>>
      places_{};  ///< by id of the session, once they are needed
};

/// Of a virtual participant of a simulation, whose place is the number at the end of the label.
std::optional<std::string> block_of_simulated(const std::string& label, const Protocol& protocol);

}  // namespace asperity

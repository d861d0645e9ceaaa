// The groups to which a protocol assigns participants, in a sentence.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/outcome/display_number.h"
#include "app/report/text/report_sections.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

/// ", in permuted blocks of 4 or 6 participants (seed 3)"
std::string blocks_text(const PermutedBlocks& blocks) {
  std::string text{};
  for (const int size : std::set<int>(blocks.sizes.begin(), blocks.sizes.end())) {
    text += (text.empty() ? "" : " or ") + std::to_string(size);
  }
  return ", by a random sequence in permuted blocks of " + text + " participants (seed " +
         std::to_string(blocks.seed) + ')';
}

std::string assignment_text(const Protocol& protocol, bool are_virtual) {
  switch (protocol.groups->assigned) {
    case Protocol::Groups::Assignment::balanced:
      return are_virtual ? ", in turn"
                         : ", each to the group with the fewest participants at that time";
    case Protocol::Groups::Assignment::permuted_blocks:
      return blocks_text(permuted_blocks_of(protocol).value());
    case Protocol::Groups::Assignment::by_experimenter:
      return are_virtual ? ", in turn" : ", by the experimenter";
  }
  return {};
}

}  // namespace

std::string groups_text(const ReportFacts& facts) {
  std::map<std::string, std::set<std::string>> members{};
  for (const ReportedSession& session : facts.sessions) {
    if (session.row.group_level) members[*session.row.group_level].insert(session.row.participant);
  }
  if (members.empty()) return {};
  std::vector<std::string> groups{};
  std::string factor{};
  std::string how{};
  if (facts.file.protocol && facts.file.protocol->groups) {
    const Protocol::Groups& declared = *facts.file.protocol->groups;
    groups = groups_of(*facts.file.protocol);
    factor = " of the factor " + declared.factor;
    how = assignment_text(*facts.file.protocol, facts.group == AnswerGroup::virtual_participants);
  } else {
    for (const auto& [group, labels] : members) groups.push_back(group);
  }
  std::string sizes{};
  for (const std::string& group : groups) {
    sizes += (sizes.empty() ? "" : "; ") + group + ", n = " + display_count(members[group].size());
  }
  return "Participants were assigned to " + count_in_words(groups.size()) + " groups" + factor +
         " (" + sizes + ')' + how + '.';
}

}  // namespace asperity

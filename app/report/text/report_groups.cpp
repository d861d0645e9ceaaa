// The groups to which a protocol assigns participants, in a sentence.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/reading_number.h"
#include "app/report/text/report_sections.h"
#include "protocols/plan/groups.h"

namespace asperity {

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
    how = facts.group == AnswerGroup::virtual_participants ? ", in turn"
          : declared.assigned == Protocol::Groups::Assignment::balanced
              ? ", each to the group with the fewest participants at that time"
              : ", by the experimenter";
  } else {
    for (const auto& [group, labels] : members) groups.push_back(group);
  }
  std::string sizes{};
  for (const std::string& group : groups) {
    sizes += (sizes.empty() ? "" : "; ") + group + ", n = " + reading_count(members[group].size());
  }
  return "Participants were assigned to " + count_in_words(groups.size()) + " groups" + factor +
         " (" + sizes + ')' + how + '.';
}

}  // namespace asperity

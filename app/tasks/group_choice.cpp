// Compares the stated group with those of the protocol and with the participant's earlier one.

#include "app/tasks/group_choice.h"

#include <algorithm>
#include <vector>

#include "protocols/design/wording.h"
#include "protocols/plan/groups.h"

namespace asperity {

std::optional<Phrase> complaint_about_group(const Protocol& protocol,
                                            const std::optional<std::string>& before,
                                            const std::optional<std::string>& stated) {
  const std::vector<std::string> groups = groups_of(protocol);
  if (groups.empty()) {
    if (!stated) return {};
    return phrase("GroupChoice", "the protocol \"%1\" has no groups; leave out --group")
        .with(protocol.name);
  }
  if (stated && std::find(groups.begin(), groups.end(), *stated) == groups.end()) {
    return phrase("GroupChoice", "the protocol \"%1\" has no group \"%2\"; use %3")
        .with(protocol.name, *stated, joined_by_or(quoted(groups)));
  }
  if (stated && before && *stated != *before) {
    return phrase("GroupChoice",
                  "the participant is in the group \"%1\" of the protocol \"%2\", and stays in it "
                  "in all sessions; leave out --group")
        .with(*before, protocol.name);
  }
  const bool is_by_program =
      protocol.groups->assigned != Protocol::Groups::Assignment::by_experimenter;
  if (is_by_program && stated) {
    return phrase("GroupChoice",
                  "the program assigns the groups of the protocol \"%1\"; leave out --group")
        .with(protocol.name);
  }
  if (!is_by_program && !stated && !before) {
    return phrase("GroupChoice",
                  "the experimenter assigns the groups of the protocol \"%1\"; state the group of "
                  "the participant with --group: %2")
        .with(protocol.name, joined_by_or(quoted(groups)));
  }
  return {};
}

}  // namespace asperity

// Implements the names that fields offer: those that values declare, and those that follow from the blocks.

#include "protocols/form/offered_names.h"

#include <algorithm>

#include "protocols/file/stored_protocol.h"
#include "protocols/form/new_values.h"
#include "protocols/kinds/analysed_names.h"

namespace asperity {

ProtocolNames names_of_form(const JsonDocument& protocol) {
  ProtocolNames names = names_in(protocol.root());
  const Protocol read = stored_protocol(std::string(protocol.text())).protocol;
  auto& tests = names.offered[kTestNames];
  for (const KindTest* const test : tests_of(read)) {
    auto found = std::ranges::find(tests, test->name, &ProtocolNames::Offered::name);
    if (found == tests.end()) found = tests.insert(tests.end(), {std::string(test->name), {}});
    found->meanings.push_back(test->meaning);
  }
  // Also where there are none, so that other names are not offered in their place.
  auto& items = names.offered[kChosenItems];
  for (const std::string& item : chosen_items(read)) items.push_back({item});
  auto& scales = names.offered[kRatedScales];
  const auto rated = rated_scales(read);
  for (const std::string& name : declared_names(names, kAnswerNames)) {
    if (rated.contains(name)) scales.push_back({name});
  }
  return names;
}

const std::vector<ProtocolNames::Offered>* offered_in(const ProtocolNames& names,
                                                      const NameShape& shape) {
  const auto found = names.offered.find(shape.among.empty() ? shape.registry : shape.among);
  return found == names.offered.end() ? nullptr : &found->second;
}

std::vector<std::string> offered_names(const ProtocolNames& names, const NameShape& shape) {
  const auto* const offered = offered_in(names, shape);
  if (offered == nullptr) return declared_names(names, shape.registry);
  std::vector<std::string> offered_here{};
  for (const ProtocolNames::Offered& one : *offered) offered_here.push_back(one.name);
  return offered_here;
}

}  // namespace asperity

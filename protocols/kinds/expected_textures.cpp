// Looks textures up among the expectations, and leaves out those that are not known.

#include "protocols/kinds/expected_textures.h"

namespace asperity {

std::vector<ForceFeatures> expected_of(const Expectations& expectations,
                                       const std::vector<std::string>& textures) {
  std::vector<ForceFeatures> expected{};
  for (const std::string& texture : textures) {
    const auto found = expectations.find(texture);
    if (found != expectations.end()) expected.push_back(found->second);
  }
  return expected;
}

std::vector<std::size_t> options_with_textures(const Protocol& protocol, const Question& question) {
  std::vector<std::size_t> options{};
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    if (protocol.textures.contains(question.options[i].value)) options.push_back(i);
  }
  return options;
}

std::vector<std::string> textures_of(const Question& question,
                                     const std::vector<std::size_t>& options) {
  std::vector<std::string> textures{};
  for (const std::size_t option : options) textures.push_back(question.options.at(option).value);
  return textures;
}

}  // namespace asperity

#include "app/cli/usage_errors.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <CLI/CLI.hpp>

#include "results_schema/table.h"

namespace asperity {

namespace {

/// What a number is of, by the end of the option's name, with one that can be written.
struct OptionUnit {
  std::string_view ending{};
  std::string_view words{};
  std::string_view example{};
};

// A longer ending stands before a shorter one that it contains.
constexpr std::array kOptionUnits{
    OptionUnit{"-m-per-s", "metres per second", "0.1"},
    OptionUnit{"-n-per-m", "newtons per metre", "1000"},
    OptionUnit{"-hz", "hertz", "1000"},
    OptionUnit{"-n", "newtons", "0.5"},
    OptionUnit{"-m", "metres", "0.1"},
};

bool is_whole_number(std::string_view text, bool may_be_negative) {
  if (may_be_negative && text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](char letter) { return letter >= '0' && letter <= '9'; });
}

/// What the option takes instead of `text`; nothing where it takes this.
std::optional<std::string> expected_instead(const CLI::Option& option, const std::string& text) {
  const std::string type = option.get_type_name();
  if (type.find('{') != std::string::npos) return {};  // one of a few, which the option names
  if (type.starts_with("UINT") || type.starts_with("INT")) {
    if (is_whole_number(text, type.starts_with("INT"))) return {};
    return "a whole number, such as 10";
  }
  if (!type.starts_with("FLOAT") || number_in(text)) return {};
  const std::string name = option.get_name();
  for (const OptionUnit& unit : kOptionUnits) {
    if (!name.ends_with(unit.ending)) continue;
    return "a number of " + std::string(unit.words) + ", such as " + std::string(unit.example);
  }
  return "a number, such as 0.5";
}

}  // namespace

std::optional<std::string> unknown_option(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  if (chosen.empty()) return {};
  const CLI::App& command = *chosen.front();
  for (const std::string& word : program.remaining(true)) {
    const std::string name = word.substr(0, word.find('='));
    if (name.size() < 3 || !name.starts_with("--")) continue;
    std::string sentence = "asperity: " + command.get_name() + " has no option " + name + "; ";
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& there : option->get_lnames()) {
        if (there.starts_with(name.substr(2))) return sentence + "there is --" + there;
      }
    }
    return sentence + "see asperity " + command.get_name() + " --help";
  }
  return {};
}

std::optional<std::string> unreadable_number(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  if (chosen.empty()) return {};
  for (const CLI::Option* option : chosen.front()->get_options()) {
    for (const std::string& text : option->results()) {
      if (const auto expected = expected_instead(*option, text)) {
        return "asperity: " + option->get_name() + ": \"" + text + "\" is not " + *expected;
      }
    }
  }
  return {};
}

}  // namespace asperity

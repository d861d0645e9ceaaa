// Recognises the parser's messages by the words around a name, and composes sentences from option types.

#include "app/cli/usage_errors.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "protocols/design/wording.h"
#include "results_schema/tables/table.h"

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
    OptionUnit{"-rad", "radians", "0.2"},
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
  if (type.find("WORD") != std::string::npos) return {};  // one of a few, which the option names
  if (type.starts_with("UINT") || type.starts_with("INT")) {
    if (is_whole_number(text, type.starts_with("INT"))) return {};
    return "a whole number; write one, such as 10";
  }
  if (!type.starts_with("FLOAT") || number_in(text)) return {};
  const std::string name = option.get_name();
  for (const OptionUnit& unit : kOptionUnits) {
    if (!name.ends_with(unit.ending)) continue;
    return "a number; write one in " + std::string(unit.words) + ", such as " +
           std::string(unit.example);
  }
  return "a number; write one, such as 0.5";
}

/// Where more is to be read.
std::string help_of(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return "see asperity " + (chosen.empty() ? "" : chosen.front()->get_name() + ' ') + "--help";
}

/// The subcommand, or the program where none was given.
std::string named(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? "asperity" : chosen.front()->get_name();
}

const CLI::App& chosen_app(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program : *chosen.front();
}

std::string unknown_option(const CLI::App& program, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const std::string sentence = named(program) + " has no option " + name + "; ";
  std::vector<std::string> names{};
  for (const CLI::Option* option : chosen_app(program).get_options()) {
    for (const std::string& there : option->get_lnames()) {
      if (name.size() > 2 && there.starts_with(name.substr(2)))
        return sentence + "did you mean --" + there + "?";
      names.push_back("--" + there);
    }
  }
  const auto nearest = nearest_name(name, names);
  return sentence + (nearest ? "did you mean " + *nearest + "?" : help_of(program));
}

/// Of the words that nothing takes, the first option.
std::optional<std::string> first_unknown_option(const CLI::App& program) {
  for (const std::string& word : program.remaining(true)) {
    if (word.size() > 1 && word.starts_with('-')) return unknown_option(program, word);
  }
  return {};
}

/// Of the words that nothing takes, the first option, or else the first word.
std::string unexpected_word(const CLI::App& program) {
  if (const auto option = first_unknown_option(program)) return *option;
  const std::vector<std::string> words = program.remaining(true);
#ifdef ASPERITY_WITH_WINDOWS
  // A word that is no subcommand was taken for the folder of a study.
  if (program.get_subcommands().empty()) {
    const std::string first = program.get_option("STUDY")->as<std::string>();
    if (!std::filesystem::is_directory(first)) return unknown_subcommand(program, first);
  }
#else
  if (program.get_subcommands().empty()) return unknown_subcommand(program, words.front());
#endif
  return '"' + words.front() + "\" is an unexpected argument; remove it, or " + help_of(program);
}

/// What stands in a message of the parser around a word of its own.
struct Around {
  std::string before{};
  std::string after{};
};

std::optional<Around> around(const std::string& message, std::string_view word) {
  const std::size_t at = message.find(word);
  if (at == std::string::npos) return {};
  return Around{message.substr(0, at), message.substr(at + word.size())};
}

std::string wrong_count(const CLI::App& program, const std::string& message) {
  const std::string name = message.substr(0, message.find(':'));
  const CLI::Option* option = chosen_app(program).get_option_no_throw(name);
  const std::size_t given = option == nullptr ? 0 : option->results().size();
  if (given > 1) return name + " is given " + std::to_string(given) + " times; give it once";
  return name + ": its value is missing; " + help_of(program);
}

std::string without_name_of_program(const CLI::App& program, const CLI::ParseError& error) {
  const std::string message = error.what();
  const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (kind == CLI::ExitCodes::ExtrasError) return unexpected_word(program);
  if (kind == CLI::ExitCodes::ArgumentMismatch) return wrong_count(program, message);
  if (kind == CLI::ExitCodes::RequiredError) {
    // It may be the missing one, misspelt.
    if (const auto option = first_unknown_option(program)) return *option;
    if (const auto missing = around(message, " is required")) {
      return named(program) + " needs " +
             (missing->before == "A subcommand" ? "a subcommand" : missing->before) + "; " +
             help_of(program);
    }
  }
  if (kind == CLI::ExitCodes::RequiresError) {
    if (const auto two = around(message, " requires ")) {
      return two->before + " needs " + two->after + "; add it, or leave out " + two->before;
    }
  }
  if (kind == CLI::ExitCodes::ExcludesError) {
    if (const auto two = around(message, " excludes ")) {
      return two->before + " and " + two->after + " exclude each other; leave one out";
    }
  }
  return message;
}

}  // namespace

std::string usage_error(const CLI::App& program, const CLI::ParseError& error) {
  if (const auto sentence = unreadable_number(program)) return *sentence;
  return "asperity: " + without_name_of_program(program, error);
}

std::string unknown_subcommand(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names{};
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  const auto nearest = nearest_name(word, names);
  const std::string folder = nearest ? "" : " and no folder";
  return "there is no subcommand" + folder + " \"" + word + "\"; " +
         (nearest ? "did you mean " + *nearest + "?" : "see asperity --help");
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

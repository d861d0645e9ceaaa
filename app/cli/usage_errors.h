// What is wrong with a command line, in sentences that name the option, its text and what is expected.

#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace asperity {

/// The sentence for a command line that could not be parsed: "asperity: --width-m: "10cm" is not a number of metres,
/// such as 0.1". It names a subcommand or an option that is close to one that does not exist.
std::string usage_error(const CLI::App& program, const CLI::ParseError& error);

/// The same for a word that is neither a subcommand nor the folder of a study.
std::string unknown_subcommand(const CLI::App& program, const std::string& word);

/// The same for the first option whose text is not the number that it takes; nothing where all are. Parsing takes a
/// negative number as a large one where the option has no sign. The unit is the end of the option's name.
std::optional<std::string> unreadable_number(const CLI::App& program);

}  // namespace asperity

// What is wrong with a command line, in sentences that name the option, its text and what is expected.

#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace asperity {

/// What is wrong with an option that does not exist, with the one that may be meant; nothing if it is
/// something else that was not expected.
std::optional<std::string> unknown_option(const CLI::App& program);

/// "--width-m: \"10cm\" is not a number of metres, such as 0.1", of the first option whose text is not the number that
/// it takes; nothing where all are. The unit is the end of the option's name.
std::optional<std::string> unreadable_number(const CLI::App& program);

}  // namespace asperity

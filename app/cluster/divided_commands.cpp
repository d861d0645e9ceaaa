// Holds the table of commands, and finds the declaration and the result of one by its words.

#include "app/cluster/divided_commands.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "app/words/text_parts.h"

namespace asperity {

namespace {

constexpr std::array kDividedCommands{
    DividedCommand{.name = "sweep", .whole_option = "--out", .joined_by = "gather"},
    DividedCommand{.name = "simulate",
                   .whole_option = "--study",
                   .joined_by = "merge",
                   .result_ending = ".merged"},
    DividedCommand{.name = "power",
                   .whole_option = "--out",
                   .whole_file = "studies.tsv",
                   .joined_by = "gather"},
};

/// "--out", "--out=FILE"
bool is_option(const std::string& word, std::string_view option) {
  return word.starts_with(option) && (word.size() == option.size() || word[option.size()] == '=');
}

[[noreturn]] void refuse(const DividedCommand& command, const std::string& what) {
  throw std::invalid_argument(std::string(command.name) + ": " + what);
}

}  // namespace

std::span<const DividedCommand> divided_commands() { return kDividedCommands; }

const DividedCommand& declaration_of(const std::vector<std::string>& words) {
  const std::string name = words.empty() ? "" : words.front();
  const auto found = std::find_if(kDividedCommands.begin(), kDividedCommands.end(),
                                  [&](const DividedCommand& each) { return each.name == name; });
  if (found != kDividedCommands.end()) return *found;
  std::vector<std::string> names{};
  for (const DividedCommand& each : kDividedCommands) names.emplace_back(each.name);
  throw std::invalid_argument(
      "the command \"" + name + "\" cannot be divided into shards; those that can are " +
      listed(names) + ", written after -- and without the name of the program");
}

std::filesystem::path whole_of(const std::vector<std::string>& words) {
  const DividedCommand& command = declaration_of(words);
  std::optional<std::string> whole{};
  for (std::size_t at = 1; at < words.size(); ++at) {
    const std::string& word = words[at];
    for (const auto& [option, instead] :
         {std::pair{kShardOption, "--shards N"}, std::pair{kJobsOption, "--cpus N"}}) {
      if (!is_option(word, option)) continue;
      refuse(command, "the batch script gives " + std::string(option) +
                          " to each task; leave it out, and write " + instead + " before --");
    }
    if (!is_option(word, command.whole_option)) continue;
    if (whole) refuse(command, std::string(command.whole_option) + " is given twice; give it once");
    const bool is_one_word = word.size() > command.whole_option.size();
    if (is_one_word) whole = word.substr(command.whole_option.size() + 1);
    if (!is_one_word) whole = at + 1 < words.size() ? words[at + 1] : "";
  }
  while (whole && whole->size() > 1 && whole->ends_with('/')) whole->pop_back();
  if (!whole || whole->empty()) {
    refuse(command, "the option " + std::string(command.whole_option) +
                        ", which names the shards, is missing; add it to the command");
  }
  if (!command.whole_file.empty()) return std::filesystem::path(*whole) / command.whole_file;
  if (const auto name = std::filesystem::path(*whole).filename(); name == "." || name == "..") {
    refuse(command,
           std::string(command.whole_option) + " \"" + *whole +
               "\" has no name, from which those of the shards are made; write the name of "
               "the folder, from the folder that contains it");
  }
  return *whole;
}

}  // namespace asperity

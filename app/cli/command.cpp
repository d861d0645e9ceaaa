#include "app/cli/command.h"

#include <exception>
#include <iostream>
#include <string>
#include <utility>

#include "app/cli/output/terminal.h"
#include "app/plugins/plugin_process.h"
#include "protocols/file/diagnostic.h"
#include "results_schema/error_text.h"

namespace asperity {

namespace {

constexpr int kNotAcceptable = 1;

int status_of_unwritten_output(const std::string& remedy) {
  say("asperity: the output is incomplete: standard output cannot be written to (it was closed, or "
      "its disk is full); " +
      remedy);
  return kNotAcceptable;
}

}  // namespace

int status_of(const Job& job) {
  constexpr int kWrongUsage = 2;
  try {
    const int status = job();
    if (std::cout.flush()) return status;
    return status_of_unwritten_output("repeat the command with its output in another file");
  } catch (const WrongUsage& error) {
    say(std::string("asperity: ") + error.what());
    return kWrongUsage;
  } catch (const ProtocolError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) say(text_of(diagnostic));
    return kNotAcceptable;
  } catch (const std::exception& error) {
    say(std::string("asperity: ") + message_of(error));
    return kNotAcceptable;
  }
}

Job with_lasting_effect(Job job, std::string printed_again) {
  return [job = std::move(job), printed_again = std::move(printed_again)] {
    const int status = job();
    if (std::cout.flush()) return status;
    std::cout.clear();  // it is reported here
    return status_of_unwritten_output(
        "what the command stores is complete, and the command need not be repeated" +
        (printed_again.empty() ? "" : "; " + printed_again));
  };
}

Job watched_with(const std::vector<std::filesystem::path>& plugins, Job job) {
  if (plugins.empty()) return job;
  return [plugins, job = std::move(job)] {
    return in_plugin_process(
        {.plugins = plugins, .work = [&job] { return status_of(job); }, .report = say});
  };
}

}  // namespace asperity

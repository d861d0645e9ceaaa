// The program: one binary, one subcommand per job.

#include <exception>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/terminal.h"
#include "app/program.h"
#include "protocols/diagnostic.h"

namespace {

constexpr int kNotAcceptable = 1;
constexpr int kWrongUsage = 2;

}  // namespace

int main(int argc, char** argv) {
  using namespace asperity;
  CLI::App program{"Asperity: psychophysics experiments on haptic texture.", "asperity"};
  program.set_version_flag("--version", version_line());
  program.require_subcommand(1);
  Job job{};
  add_new(program, job);
  add_check(program, job);
  add_run(program, job);
  add_simulate(program, job);
  add_analyze(program, job);
  add_export(program, job);
  add_models(program, job);
  add_render(program, job);
  add_texture(program, job);
  add_synth(program, job);
  add_verify(program, job);
  add_replay(program, job);
  add_copy(program, job);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : kWrongUsage;
  }
  try {
    return job();
  } catch (const WrongUsage& error) {
    say(std::string("asperity: ") + error.what());
    return kWrongUsage;
  } catch (const ProtocolError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) say(text_of(diagnostic));
    return kNotAcceptable;
  } catch (const std::exception& error) {
    say(std::string("asperity: ") + error.what());
    return kNotAcceptable;
  }
}

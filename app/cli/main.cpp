// The program: one binary, one subcommand per job.

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  CLI::App program{"Asperity: psychophysics experiments on haptic texture", "asperity"};
  program.set_version_flag("--version", "asperity " ASPERITY_VERSION);
  program.require_subcommand(0);
  CLI11_PARSE(program, argc, argv);
  return 0;
}

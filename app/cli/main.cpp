// The program: one binary, one subcommand per job; without one, the window.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/cli/usage_errors.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/gui/window/program_window.h"
#endif
#include "app/study_files/program.h"
#include "device/units_in_use.h"
#include "renderers/servo/servo_thread.h"

namespace {

constexpr int kWrongUsage = 2;

#ifdef ASPERITY_WITH_WINDOWS
/// No subcommand, and perhaps the folder of a study: the window.
void add_windows(CLI::App& program, asperity::Job& job, int& argc, char** argv) {
  auto study = std::make_shared<std::optional<std::filesystem::path>>();
  const CLI::Option* const window =
      program.add_flag("--window")->description("Open the window, as without a subcommand");
  program.require_subcommand(0, 1);
  program.add_option("STUDY", *study,
                     "Without a subcommand: folder of the study to show in the window");
  program.callback([&program, &job, &argc, argv, study, window] {
    if (!program.get_subcommands().empty()) {
      if (window->count() > 0) {
        throw CLI::ValidationError("--window and the subcommand " +
                                   program.get_subcommands().front()->get_name() +
                                   " exclude each other; leave one out");
      }
      if (*study) {
        throw CLI::ValidationError(
            "\"" + (*study)->string() + "\" before the subcommand " +
            program.get_subcommands().front()->get_name() +
            " has no meaning; leave it out, or write it after the subcommand");
      }
      return;
    }
    if (*study && !std::filesystem::is_directory(**study)) {
      throw CLI::ValidationError(asperity::unknown_subcommand(program, (*study)->string()));
    }
    job = [&argc, argv, study] { return asperity::run_windows(argc, argv, *study); };
  });
}
#endif

/// Threads that were left behind in a driver use what the end of a program destroys, and the end of a manufacturer's library
/// may wait for them. Everything else is closed by now.
int end_with(int status) {
  if (!asperity::ServoThread::end_all_forces() && !asperity::UnitInUse::is_any()) return status;
  std::fflush(nullptr);
  std::_Exit(status);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace asperity;
  handle_signals();
  const ShownOutput shown(std::cout);
  const ShownOutput shown_errors(std::cerr);
  CLI::App program{"Asperity: psychophysics experiments on haptic texture.", "asperity"};
  program.set_version_flag("--version", version_line());
  Job job{};
#ifdef ASPERITY_WITH_WINDOWS
  add_windows(program, job, argc, argv);
#else
  program.require_subcommand(1);
#endif
  add_new(program, job);
  add_check(program, job);
  add_run(program, job);
  add_simulate(program, job);
  add_power(program, job);
  add_analyze(program, job);
#ifdef ASPERITY_WITH_WINDOWS
  add_report(program, job);
#endif
  add_export(program, job);
  add_metadata(program, job);
  add_devices(program, job);
  add_device_test(program, job);
  add_models(program, job);
  add_render(program, job);
  add_texture(program, job);
  add_synth(program, job);
  add_texture_recording(program, job);
  add_fit_model(program, job);
  add_bake(program, job);
  add_stimulus(program, job);
  add_verify(program, job);
  add_replay(program, job);
  add_sweep(program, job);
  add_gather(program, job);
  add_clean_stiffness(program, job);
  add_submit(program, job);
  add_bench(program, job);
  add_copy(program, job);
  add_merge(program, job);
  add_withdraw(program, job);
  add_close_device(program, job);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0)
      return status_of([&] { return program.exit(error); });  // --help, --version
    say(usage_error(program, error));
    return kWrongUsage;
  }
  if (const auto sentence = unreadable_number(program)) {
    say(*sentence);
    return kWrongUsage;
  }
  return end_with(status_of(job));
}

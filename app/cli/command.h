// The subcommands of the program: each adds itself and leaves a job to do.

#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace asperity {

/// What the parsed command line asks for. Returns the exit status; throws what it cannot do.
using Job = std::function<int()>;

/// Does the job. What it throws is stated on standard error; the status is 1 then, or 2 for WrongUsage. Where the reader of
/// standard output has closed it, the status is that of a program that SIGPIPE has ended.
int status_of(const Job& job);

/// The job of a command that changes a study or makes a file: repeated for what it printed, it would change the study again, or
/// fail. It prints at its end; where standard output cannot be written to, it does so on standard error, with the status 1.
Job with_lasting_effect(Job job);

/// The job, in a separate process where it loads plug-ins (app/plugins/plugin_process.h): a plug-in that ends its process or does
/// not return is named. Not for a job in real time, whose process holds the device.
Job watched_with(const std::vector<std::filesystem::path>& plugins, Job job);

void add_analyze(CLI::App& program, Job& job);
void add_bake(CLI::App& program, Job& job);
void add_bench(CLI::App& program, Job& job);
void add_check(CLI::App& program, Job& job);
void add_clean_stiffness(CLI::App& program, Job& job);
/// Hidden: ClosingProcess starts it.
void add_close_device(CLI::App& program, Job& job);
void add_copy(CLI::App& program, Job& job);
void add_devices(CLI::App& program, Job& job);
void add_device_test(CLI::App& program, Job& job);
void add_export(CLI::App& program, Job& job);
void add_fit_model(CLI::App& program, Job& job);
void add_merge(CLI::App& program, Job& job);
void add_gather(CLI::App& program, Job& job);
void add_metadata(CLI::App& program, Job& job);
void add_models(CLI::App& program, Job& job);
void add_new(CLI::App& program, Job& job);
void add_power(CLI::App& program, Job& job);
void add_render(CLI::App& program, Job& job);
void add_replay(CLI::App& program, Job& job);
/// Absent without Qt.
void add_report(CLI::App& program, Job& job);
void add_run(CLI::App& program, Job& job);
void add_simulate(CLI::App& program, Job& job);
void add_stimulus(CLI::App& program, Job& job);
void add_submit(CLI::App& program, Job& job);
void add_sweep(CLI::App& program, Job& job);
void add_synth(CLI::App& program, Job& job);
void add_texture(CLI::App& program, Job& job);
void add_texture_recording(CLI::App& program, Job& job);
void add_verify(CLI::App& program, Job& job);
void add_withdraw(CLI::App& program, Job& job);

/// A wrong use of the command line that parsing cannot see: exit status 2, the sentence on standard
/// error.
class WrongUsage final : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace asperity

// asperity verify: does a study hold what it says?

#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/plugins/plugin_files.h"
#include "app/tasks/verify/verify_study.h"

namespace asperity {

namespace {

/// The remedy of damaged data. A copy that is older than a deletion contains the deleted data.
std::string remedy_of(const Study& study) {
  std::string deleted_utc{};
  try {
    for (const WithdrawalRow& row : study.withdrawals()) {
      if (row.data == WithdrawnData::deleted) {
        deleted_utc = std::max(deleted_utc, row.withdrawn_utc);
      }
    }
  } catch (const std::exception&) {
    // Too damaged to be read: its deletions, if any, are not known.
    return "Restore damaged data from the latest copy of the study, unless the problem states "
           "another remedy; an earlier copy can contain data that participants have had deleted";
  }
  if (deleted_utc.empty()) {
    return "Restore damaged data from a copy of the study, unless the problem states another "
           "remedy";
  }
  return "Restore damaged data from a copy of the study that was made after " +
         local_time_text(deleted_utc) +
         ", unless the problem states another remedy; earlier copies contain data that "
         "participants have had deleted. Without a later copy, withdraw these participants again "
         "from the restored study";
}

}  // namespace

void add_verify(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    bool replay = false;
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "verify", "Check a study: every hash and constraint, and the plans against their seeds.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command->add_flag(
      "--replay", options->replay,
      "Also replay every recorded hand movement through its force models, and compare the "
      "stored detectors of perceived instability and numbers of gaps in contact");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] {
      const InterruptWatch interrupt("stopping; the study is not verified");
      Study study = Study::open(options->study, Access::read_only);
      const ModelBuilds builds = models_with_builds(options->plugins);
      VerifyResult result{};
      {
        Progress progress("verifying");
        result = verify_study(study, builds, options->replay, interrupt.token(),
                              [&progress](double fraction) { progress.show(fraction); });
      }
      if (interrupt.token().stop_requested()) {
        say("asperity: the verification was stopped before it was complete; repeat the command to "
            "verify the whole study");
        return 1;
      }
      for (const std::string& problem : result.problems) say("asperity: " + problem);
      for (const std::string& remark : result.remarks) std::cout << "remark: " << remark << '\n';
      for (const std::string& rule : result.rules) std::cout << rule << '\n';
      if (options->replay) {
        std::cout << counted(static_cast<std::size_t>(result.recordings_replayed), "recording")
                  << " replayed";
        if (result.attempts_without_recording > 0) {
          std::cout << "; attempts without a recording, which cannot be replayed: "
                    << result.attempts_without_recording
                    << " (simulate keeps the recordings of the first participant unless "
                       "--recordings states otherwise)";
        }
        std::cout << '\n';
      }
      std::cout << (result.problems.empty()
                        ? std::string("no problems found")
                        : std::to_string(result.problems.size()) +
                              (result.problems.size() == 1 ? " problem" : " problems") + " found")
                << '\n';
      if (result.problems.size() > result.plugin_problems) {
        std::cout << remedy_of(study) << '\n';
      }
      return result.problems.empty() ? 0 : 1;
    });
  });
}

}  // namespace asperity

// asperity withdraw: a participant withdraws from a study.

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <pwd.h>

#include "app/cli/command.h"
#include "app/cli/options/text_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/study_files/study_outputs.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

std::string name_of_user() {
  const passwd* const entry = ::getpwuid(::geteuid());
  return entry == nullptr ? std::to_string(::geteuid()) : entry->pw_name;
}

std::string held(const WithdrawalRow& counts) {
  const auto of = [](int count, const char* thing) {
    return counted(static_cast<std::size_t>(count), thing);
  };
  return of(counts.sessions, "session") + ", " + of(counts.attempts, "attempt") + ", " +
         of(counts.answers, "response") + ", " + of(counts.recordings, "recording");
}

/// A mistyped label would delete the data of another participant: it is given twice, by --confirm or at a terminal.
/// Errors: WrongUsage where it was not given again and nobody can be asked, or as another one.
bool is_confirmed(const std::string& label, const std::string& confirmed,
                  const WithdrawalRow& counts) {
  if (!confirmed.empty()) {
    if (confirmed == label) return true;
    throw WrongUsage("--confirm is " + confirmed + ", and the participant is " + label +
                     "; nothing was deleted. Give the same label twice");
  }
  if (::isatty(STDIN_FILENO) == 0) {
    throw WrongUsage(
        "withdraw --delete needs a terminal for the confirmation, and there is none; repeat the "
        "label with " +
        ("--confirm " + label) + " to delete " + held(counts) +
        " permanently. Nothing was deleted");
  }
  std::cerr << label << ": " << held(counts)
            << ". They cannot be restored. Type the label again to delete them: " << std::flush;
  std::string typed{};
  return std::getline(std::cin, typed) && typed == label;
}

void name_outputs(const std::vector<OutputRow>& outputs) {
  if (outputs.empty()) return;
  std::cout
      << "outputs of the study that may contain data of the participant; they were not changed. "
         "Delete those that contain such data, and repeat the export or the report if needed:\n";
  for (const OutputRow& output : outputs) {
    const bool is_complete = !output.made_utc.empty();
    std::cout << "  " << (is_complete ? local_time_text(output.made_utc) : "(not complete)  ")
              << "  " << kind_words(output.kind).english() << "  "
              << (output.path.empty()
                      ? "(its path contained the label of another participant, and was removed)"
                      : output.path)
              << '\n';
  }
}

}  // namespace

void add_withdraw(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::string label{};
    bool deletes = false;
    std::optional<WithdrawalReason> reason{};
    std::string by{};
    std::string confirmed{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "withdraw", "Withdraw a participant: the data are excluded from every analysis, or deleted.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command->add_option("LABEL", options->label, "Label of the participant")->required();
  auto* deletes =
      command->add_flag("--delete", options->deletes,
                        "Delete every trace of the participant from the folder of the study. "
                        "Without this option the data are kept and excluded from every analysis");
  command
      ->add_option("--confirm", options->confirmed,
                   "With --delete: LABEL again, as confirmation. If this option is absent, the "
                   "label is requested on the terminal; without a terminal the option is required")
      ->needs(deletes);
  const std::map<std::string, WithdrawalReason> reasons{
      {text_of(WithdrawalReason::consent_withdrawn), WithdrawalReason::consent_withdrawn},
      {text_of(WithdrawalReason::not_eligible), WithdrawalReason::not_eligible},
      {text_of(WithdrawalReason::other), WithdrawalReason::other}};
  command
      ->add_option(
          "--reason", options->reason,
          "Reason of the withdrawal (default: that of an earlier withdrawal of the participant, "
          "which kept the data, otherwise consent_withdrawn)")
      ->transform(word_of(reasons))
      ->option_text("consent_withdrawn|not_eligible|other");
  command
      ->add_option(
          "--by", options->by,
          "Name of the person who decided on the withdrawal (default: the user of this computer)")
      ->transform(not_blank("the name of the person who decided on the withdrawal"));
  command->callback([options, &job] {
    job = [options] {
      Study study = Study::open(options->study, Access::read_write);
      const WithdrawalRow counts = study.counts_of_participant(options->label);
      // An interrupted deletion, of which no participant is left, was confirmed before.
      const bool is_interrupted = !study.participant(options->label);
      if (options->deletes && !is_interrupted &&
          !is_confirmed(options->label, options->confirmed, counts)) {
        say("asperity: the label was not repeated, and nothing was deleted; to delete the data, "
            "repeat the command and type the label");
        return 1;
      }
      const InterruptWatch interrupt("stopping if another program keeps the study open");
      const Withdrawal done = study.withdraw(
          options->label,
          {.data = options->deletes ? WithdrawnData::deleted : WithdrawnData::kept,
           .reason = options->reason.value_or(counts.reason),
           .decided_by = options->by.empty() ? name_of_user() : options->by},
          [] {
            say("asperity: another program is reading the study, and the deletion waits for it, up "
                "to 30 s; close the study there");
          },
          interrupt.token());
      std::cout << options->label << " has withdrawn: " << held(done.row)
                << (options->deletes ? " deleted" : " kept and excluded from every analysis")
                << '\n';
      name_outputs(outputs_of_withdrawal(done, options->label));
      return 0;
    };
    job = with_lasting_effect(job);
  });
}

}  // namespace asperity

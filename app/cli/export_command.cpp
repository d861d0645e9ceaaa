// asperity export: a study as tidy tables.

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/exports/export_study.h"
#include "app/exports/publication.h"
#include "app/study_files/study_metadata.h"
#include "app/study_files/study_outputs.h"
#include "app/words/text_parts.h"
#include "renderers/built_in_models.h"

namespace asperity {

namespace {

/// "wide,sav" and so on; "none" is only the tables, "all" is everything. The movements in recordings can identify a
/// participant: in a public export they are written only if they are named.
std::set<ExportFormat> formats_in(const std::vector<std::string>& names, ExportAudience audience) {
  if (names.empty()) return usual_export_formats();
  std::set<ExportFormat> formats{};
  for (const std::string& name : names) {
    if (name == "none") continue;
    for (const ExportFormat format :
         {ExportFormat::wide, ExportFormat::sav, ExportFormat::bids, ExportFormat::psychds,
          ExportFormat::physio, ExportFormat::stimuli, ExportFormat::fit}) {
      const bool is_in_all = format != ExportFormat::physio || !is_public(audience);
      if ((name == "all" && is_in_all) || name == name_of(format)) formats.insert(format);
    }
  }
  return formats;
}

/// Of the files of a dataset, which has one for each session, only how many there are.
void say_what_was_written(const std::string& out, const std::vector<ExportedFile>& files) {
  std::map<std::string, std::size_t> of_dataset{};
  for (const ExportedFile& file : files) {
    const auto at = std::min(file.name.find("bids/"), file.name.find("psychds/"));
    if (at != std::string::npos) {
      ++of_dataset[file.name.substr(0, file.name.find('/', at) + 1)];
    } else {
      say(out + "/" + file.name + (file.rows ? ": " + counted(*file.rows, "row") : ""));
    }
    const auto remark = [&file](std::size_t cells, const char* what) {
      if (cells > 0) say(file.name + ": in " + counted(cells, "cell") + ' ' + what);
    };
    remark(file.spaced_cells,
           "tabs or line breaks, which TSV cannot contain, were replaced by spaces");
    remark(file.marked_cells,
           "an apostrophe prevents a text from being read as a formula (README.txt)");
    remark(file.cut_cells,
           "a text was truncated: SPSS allows 32 000 bytes for a text and 120 bytes for the label "
           "of an option");
  }
  for (const auto& [name, count] : of_dataset) {
    say(out + "/" + name + ": " + counted(count, "file"));
  }
}

}  // namespace

void add_export(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::string out{};
    bool published = false;
    bool relabel = false;
    bool age_bands = false;
    bool force = false;
    std::vector<std::string> questions{};
    std::vector<std::string> formats{};

    ExportAudience audience() const {
      if (relabel) return ExportAudience::relabelled;
      return published ? ExportAudience::published : ExportAudience::own;
    }
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "export",
      "Export a study as tables (TSV) with a codebook, and in the formats of other programs.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command->add_option("--out", options->out, "New folder for the tables")->required();
  auto* published = command->add_flag(
      "--public", options->published,
      "Leave out dates, free text, answers to questionnaires, recordings and participants who "
      "withdrew; the columns, and what can still identify a participant, are listed below");
  command
      ->add_option(
          "--with-questions", options->questions,
          "Questions of questionnaires whose answers are to be published, separated by commas")
      ->delimiter(',')
      ->needs(published);
  command
      ->add_flag("--relabel", options->relabel,
                 "Give the participants new labels, drawn at random in every export, and leave out "
                 "what shows when, or in which order, sessions were run. The assignment is not "
                 "stored")
      ->needs(published);
  command
      ->add_flag("--age-bands", options->age_bands,
                 "Replace ages by bands of at least five participants")
      ->needs(published);
  command->add_flag("--force", options->force, "Replace an earlier export");
  command
      ->add_option("--formats", options->formats,
                   "Formats in addition to the tables, separated by commas: wide (CSV, one row per "
                   "participant), sav (SPSS, JASP), fit (counts at the levels of a numeric "
                   "factor), bids, psychds, stimuli (the height fields), physio (the recordings, "
                   "in the BIDS dataset); all (with --public, without physio); none. Default: all "
                   "but physio")
      ->delimiter(',')
      ->check(
          word_among({"wide", "sav", "bids", "psychds", "physio", "stimuli", "fit", "all", "none"}))
      ->option_text("NAME,…");
  constexpr std::size_t kColumns = 80;
  command->footer("--public:\n" + wrapped_text(publication_text_of_any_study(), kColumns, "  "));
  command->callback([options, &job] {
    job = [options] {
      Study::read_beside_writers();  // ListedOutput is one, in this process
      const Study study = Study::open(options->study, Access::read_only);
      const InterruptWatch interrupt("stopping; no export is written");
      const ModelRegistry models = built_in_models();
      ExportOptions wanted{};
      wanted.audience = options->audience();
      wanted.random_bits = random_bits_of_this_machine();
      wanted.has_age_bands = options->age_bands;
      wanted.overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      wanted.formats = formats_in(options->formats, wanted.audience);
      wanted.questions_for_public = {options->questions.begin(), options->questions.end()};
      refuse_export(study, options->out, wanted);  // before it is listed
      ListedOutput listed(study,
                          options->published ? OutputKind::public_export : OutputKind::export_,
                          options->out);
      ExportOutcome outcome{};
      {
        Progress progress("exporting");
        outcome = export_study(study, models, options->out, wanted, interrupt.token(),
                               [&progress](double fraction) { progress.show(fraction); });
      }
      if (outcome.files.empty()) {
        say("asperity: the export was stopped, and the incomplete export was removed; repeat the "
            "command to export the study");
        return 1;
      }
      say_what_was_written(options->out, outcome.files);
      say_condition(study);
      if (!options->formats.empty()) {
        for (const Phrase& why : outcome.not_written) say("asperity: " + why.english());
      }
      for (const Phrase& warning : outcome.warnings) {
        say("asperity: warning: " + warning.english());
      }
      const StudyMetadata metadata = study.metadata();
      if (const auto missing = missing_metadata(metadata)) {
        // Only what is missing: the options replace what is there.
        say("asperity: warning: " + missing->english() +
            " Enter the metadata with: asperity metadata " + options->study +
            (metadata.authors.empty() ? " --author \"Family, Given\"" : "") +
            (metadata.license ? "" : " --license CC-BY-4.0"));
      }
      say_unrecorded(listed.complete());
      const auto has = [&](ExportFormat format) { return wanted.formats.contains(format); };
      if (has(ExportFormat::bids) && !has(ExportFormat::physio)) {
        say(std::string("the recordings were left out; --formats ") +
            (options->published ? "all,physio" : "all") + " adds them");
      }
      return 0;
    };
  });
}

}  // namespace asperity

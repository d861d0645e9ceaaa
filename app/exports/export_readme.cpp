// Composes the text from the options, the warnings and the description of a public export.

#include "app/exports/export_readme.h"

namespace asperity {

std::string export_readme(const ExportOptions& options, const std::optional<Phrase>& remark,
                          const std::vector<Phrase>& warnings, const std::string& publication) {
  std::string text = "A study, exported by Asperity for use in other programs.\n\n";
  if (remark) text += "BEFORE USE: " + remark->english() + "\n\n";
  for (const Phrase& warning : warnings) text += "INCOMPLETE: " + warning.english() + "\n\n";
  text +=
      "codebook.tsv describes every column of every file; MANIFEST.tsv contains the SHA-256 of "
      "every file; events.json describes each kind of event.\nimport.R and import.py load all "
      "tables with the correct types.\n\n";
  if (is_public(options.audience)) {
    std::string named{};
    for (const std::string& question : options.questions_for_public) {
      named += (named.empty() ? ", except for " : ", ") + question;
    }
    text += "This is a public export: without dates, free text and answers to questionnaires" +
            named + ". Participants who withdrew are not included.\n" + publication + "\n";
  }
  return text +
         "The .tsv files of this folder contain all data, including attempts that do not count, "
         "excluded ones, pilots and virtual\nparticipants; the columns virtual, mode, phase, "
         "valid, excluded and flagged identify them, and counts_in_analyses\nof attempts.tsv "
         "states which attempts analyses include. All other files of this\nfolder contain only "
         "sessions of human participants. Pilots are in pilot/, virtual participants in virtual/. "
         "Rows that do not\ncount are marked there too, except in wide.csv and wide.sav, which "
         "include only "
         "responses that count.\n\nSpreadsheets: a text that begins with = + - @, a tab or a line "
         "break would be read as a formula. In every .tsv and .csv file such a\ntext is preceded "
         "by an apostrophe; the same applies to a text that begins with an apostrophe or is "
         "exactly "
         "n/a.\nRemove one apostrophe from every text that begins with one to restore the original "
         "texts; import.R and\nimport.py do this. Numbers are never changed. The .sav files "
         "contain the original texts.\nTabs and line breaks within a text are spaces in a .tsv "
         "file; the number of such cells was reported at the export.\n\nMissing values are n/a in "
         ".tsv files and empty in .csv files. Times in seconds are relative to the beginning of "
         "the session. Labels of\nparticipants and seeds are texts, even if they look like "
         "numbers.\n";
}

}  // namespace asperity

// Declares the columns of participants.tsv; a public export has bands in place of ages.

#include <utility>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

ExportColumn age_column(const StudyVocabulary& vocabulary) {
  if (!vocabulary.age_bands) {
    return missing("not reported",
                   at_least(0, column("age_years", "number", "year", "age", [](const Place& at) {
                              return optional_cell(at.participant->age_years);
                            })));
  }
  return missing(
      "not reported, or fewer than five ages are in the export",
      with_levels(column("age_band", "text", "",
                         "band of the age in years, with at least five participants of the export",
                         [bands = *vocabulary.age_bands](const Place& at) {
                           return optional_cell(bands.of(*at.participant));
                         }),
                  vocabulary.age_bands->names()));
}

}  // namespace

Columns participant_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::participant);
  columns.back().levels.push_back("mixed");
  columns.back().description = "mode of the participant's sessions";
  columns.back().missing = "no session yet";
  const auto participant = [](auto member) {
    return [member](const Place& at) { return optional_cell(at.participant->*member); };
  };
  columns.push_back(age_column(vocabulary));
  columns.push_back(missing(
      "not reported",
      with_levels(column("sex", "text", "",
                         "reported sex: F female, M male, X neither (O in BIDS, which has no X)",
                         participant(&ParticipantRow::sex)),
                  {"F", "M", "X"})));
  columns.push_back(missing("not reported",
                            with_levels(column("handedness", "text", "", "reported preferred hand",
                                               participant(&ParticipantRow::handedness)),
                                        {"left", "right", "ambidextrous"})));
  if (!vocabulary.groups.empty()) {
    // Of two protocols with groups a participant has two, which are no level.
    columns.push_back(missing("no session of a protocol with groups",
                              column("group", "text", "",
                                     "group of the participant, in all sessions of a protocol; the "
                                     "groups of several protocols are separated by \"; \"",
                                     [](const Place& at) { return *at.participant_groups; })));
  }
  if (vocabulary.known_languages.size() > 1) {
    // The same in all sessions of a protocol; of several protocols they can be two, which are no level.
    columns.push_back(missing("no session yet",
                              column("language", "text", "",
                                     "language of the texts in the participant's sessions, a BCP "
                                     "47 tag; several languages are separated by \"; \"",
                                     [](const Place& at) { return *at.participant_languages; })));
  }
  columns.push_back(dropped(column("created_utc", "utc_time", "", "when the participant was added",
                                   [](const Place& at) { return at.participant->created_utc; })));
  columns.push_back(column("withdrawn", "boolean", "",
                           "1: the participant withdrew; the data are excluded from every analysis",
                           [](const Place& at) { return boolean(at.participant->withdrawn); }));
  for (const std::string& name : vocabulary.participant_answers) {
    const auto question = vocabulary.questions.find(name);
    const bool known = question != vocabulary.questions.end();
    ExportColumn answer =
        missing("not asked or not answered",
                column("answer_" + name, "text", "",
                       "answer to: " + (known ? question->second.prompt : "\"" + name + "\""),
                       [name](const Place& at) { return member_of(at.answers, name); }));
    answer.publication = vocabulary.is_published(name)          ? Publication::kept
                         : !known || question->second.free_text ? Publication::dropped
                                                                : Publication::dropped_unless_named;
    if (known) {
      answer.levels = question->second.options;
      answer.level_meanings = question->second.option_meanings;
      answer.minimum = question->second.minimum;
      answer.maximum = question->second.maximum;
      answer.source = question->second.source;
    }
    columns.push_back(std::move(answer));
  }
  return columns;
}

}  // namespace asperity::export_columns

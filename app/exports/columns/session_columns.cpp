// Declares the columns of sessions.tsv, with the protocol's statements about the participant's senses.

#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

// What the protocol states of the participant's senses; what was measured in the session is in the columns of attempts.
void add_senses(const StudyVocabulary& vocabulary, Columns& columns) {
  const auto add = [&](ExportColumn made, auto member) {
    made.source = "protocol";
    made.cell = [senses = vocabulary.senses, member](const Place& at) -> Cell {
      const auto found = senses.find(at.protocol->source_sha256);
      if (found == senses.end()) return {};
      return member(found->second);
    };
    columns.push_back(std::move(made));
  };
  using Senses = StoredProtocol::Senses;
  constexpr const char* kUnreadable = "the stored protocol cannot be read";
  ExportColumn vision =
      missing(kUnreadable, with_levels(column("vision", "text", "",
                                              "what the participant was to see, as the protocol "
                                              "requests",
                                              {}),
                                       {"free", "hand_occluded", "blindfold"}));
  vision.level_meanings = {
      {"free", {"hand, device and screen", ""}},
      {"hand_occluded", {"the screen but not the hand; compliance is not recorded", ""}},
      {"blindfold",
       {"nothing while surfaces are felt; eye_mask_confirmed of attempts states whether the eye "
        "mask was on",
        ""}}};
  add(std::move(vision), [](const Senses& senses) -> Cell {
    return senses.vision ? Cell{text_of(*senses.vision)} : Cell{};
  });
  add(missing(kUnreadable, with_levels(column("masking_noise", "text", "",
                                              "noise that masks the sound of the device, as the "
                                              "protocol requests; masking_noise_source of attempts "
                                              "states which noise there was",
                                              {}),
                                       {"none", "white", "pink"})),
      [](const Senses& senses) -> Cell {
        return senses.noise ? Cell{text_of(senses.noise->kind)} : Cell{};
      });
  add(missing("the protocol requests no masking noise, or does not state its level",
              column("masking_noise_level_dBA", "number", "dB(A)",
                     "level of this noise at the ear, as the protocol requests and not as measured",
                     {})),
      [](const Senses& senses) {
        return senses.noise ? optional_cell(senses.noise->level_dBA) : Cell{};
      });
}

}  // namespace

Columns session_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::session);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  const auto text = [&add](const char* name, const char* description, auto member) {
    add(missing("unknown", column(name, "text", "", description,
                                  [member](const Place& at) { return at.session->*member; })));
  };
  const auto dating_text = [&](const char* name, const char* description, auto member) {
    text(name, description, member);
    columns.back().publication = Publication::dropped_with_new_labels;
  };
  const auto of_protocol = [&add](const char* name, const char* description, auto member) {
    add(column(name, "text", "", description,
               [member](const Place& at) { return at.protocol->*member; }));
  };
  of_protocol("protocol", "name of the protocol", &ProtocolRow::name);
  of_protocol("protocol_version", "version of the protocol", &ProtocolRow::version);
  of_protocol("kind", "kind of the protocol", &ProtocolRow::kind);
  for (const ExperimentKind* const kind : experiment_kinds()) {
    columns.back().levels.emplace_back(kind->id);
  }
  of_protocol("design", "as published or improved", &ProtocolRow::design);
  columns.back().levels = {"chapter", "improved"};
  of_protocol("protocol_sha256", "SHA-256 of the protocol file, byte for byte",
              &ProtocolRow::source_sha256);
  columns.back().publication =
      Publication::dropped_with_new_labels;  // a file that changes during a study dates
  add(with_levels(column("state", "text", "", "state of the session",
                         [](const Place& at) { return text_of(at.session->state); }),
                  {"open", "completed", "stopped", "crashed"}));
  // Seeds are often counted up, and rows of the counterbalancing are assigned in the order of participants.
  dating_text("seed", "seed of all random numbers of the session, a 64-bit integer",
              &SessionRow::seed);
  dating_text("generator", "name and version of the random number generator",
              &SessionRow::generator);
  add(dropped_with_new_labels(at_least(
      0, column("counterbalance_row", "integer", "", "row of the counterbalancing square, from 0",
                [](const Place& at) { return integer(at.session->counterbalance_row); }))));
  if (!vocabulary.groups.empty()) {
    add(with_levels(
        missing("the protocol has no groups",
                column("group", "text", "",
                       "group of the participant: the level of the protocol's factor between "
                       "participants",
                       [](const Place& at) { return optional_cell(at.session->group_level); })),
        {vocabulary.groups.begin(), vocabulary.groups.end()}));
  }
  if (vocabulary.known_languages.size() > 1) {
    add(with_levels(
        column("language", "text", "", "language of the texts for the participant, a BCP 47 tag",
               [languages = vocabulary.languages](const Place& at) {
                 return Cell{languages.at(at.protocol->source_sha256)};
               }),
        vocabulary.known_languages));
  }
  add_senses(vocabulary, columns);
  add(column("mirrored", "boolean", "", "1: the workspace was laid out for a left hand",
             [](const Place& at) { return boolean(at.session->mirrored); }));
  dating_text("program_version", "version of the program", &SessionRow::program_version);
  dating_text("program_commit", "commit from which the program was built",
              &SessionRow::program_commit);
  dating_text("program_build", "how the program was built", &SessionRow::program_build);
  dating_text("program_sha256", "SHA-256 of the program file", &SessionRow::program_sha256);
  dating_text("instruction_set", "instruction set of the numerical code",
              &SessionRow::instruction_set);
  text("os", "operating system, with the release of its kernel", &SessionRow::os);
  columns.back().publication = Publication::dropped;  // its name can be an institution's own
  text("device", "driver and model of the haptic device", &SessionRow::device);
  text("pacing", "real_time, or stepped on a simulated clock", &SessionRow::pacing);
  columns.back().levels = {"stepped", "real_time"};
  text("scheduling", "scheduling of the servo thread", &SessionRow::scheduling);
  columns.back().missing = "there is no servo thread";
  add(at_least(0, column("rate_Hz", "number", "Hz", "rate of the servo loop",
                         [](const Place& at) { return at.session->rate_Hz; })));
  add(at_least(0, column("stimulus_files", "integer", "1", "files that the session used",
                         [](const Place& at) {
                           return integer(static_cast<std::int64_t>(at.session->files.size()));
                         })));
  add(dropped_with_new_labels(missing(
      "no files", column("stimulus_files_json", "json", "",
                         "SHA-256 of each file that the session used, by path within the study",
                         [](const Place& at) -> Cell {
                           nlohmann::json files = nlohmann::json::object();
                           for (const StimulusFileRow& file : at.session->files) {
                             files[file.path] = file.sha256;
                           }
                           return files.empty() ? Cell{} : Cell{files.dump()};
                         }))));
  add(missing("a human participant",
              column("observer_json", "json", "", "how the virtual participant judged, as declared",
                     [](const Place& at) -> Cell {
                       const std::string& json = at.session->observer_json;
                       return json == "null" ? Cell{} : Cell{json};
                     })));
  add(dropped_with_new_labels(
      missing("the protocol requires no consent",
              column("consent_version", "text", "", "version of the consent text agreed to",
                     [](const Place& at) { return optional_cell(at.session->consent_version); }))));
  add(dropped(
      missing("the protocol requires no consent",
              column("consent_utc", "utc_time", "", "when consent was given",
                     [](const Place& at) { return optional_cell(at.session->consent_utc); }))));
  add(dropped(column("started_utc", "utc_time", "",
                     "when the session began; all times in seconds are relative to it",
                     [](const Place& at) { return at.session->started_utc; })));
  add(dropped(
      missing("the session has not ended",
              column("ended_utc", "utc_time", "", "when the session ended",
                     [](const Place& at) { return optional_cell(at.session->ended_utc); }))));
  return columns;
}

}  // namespace asperity::export_columns

// Table by table: what an exported column is called, what it means and where it comes from.

#include "app/exports/columns.h"

#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/column_making.h"
#include "app/exports/event_columns.h"
#include "app/words/coded_phrases.h"
#include "protocols/kinds/experiment_kind.h"
#include "results_schema/analysis_use.h"

namespace asperity {

using namespace export_columns;

namespace {

using Place = ExportPlace;

constexpr const char* kMissedInContact =
    "ticks that missed their deadline while a surface was touched; only these affect whether an "
    "attempt counts";
constexpr const char* kNotCountedApart =
    "the attempt was made by version 0.1, which did not count them separately";

/// The words of the program as they were stored, in English, or somebody's own.
Cell text_cell_of(const std::optional<StoredWords>& words) {
  return words ? Cell{words->text} : Cell{};
}

/// Why, by codes. The public is told the program's reasons, and of the experimenter's that there was one.
ExportColumn codes_column(const char* name, const char* when_missing, const char* description,
                          std::optional<StoredWords> AttemptRow::*reason) {
  const auto cell = [reason](std::string (*codes)(const StoredWords&)) {
    return [reason, codes](const Place& at) {
      const std::optional<StoredWords>& words = at.attempt->*reason;
      return words ? Cell{codes(*words)} : Cell{};
    };
  };
  ExportColumn made = missing(when_missing, column(name, "text", "", description, cell(codes_of)));
  made.publication = Publication::without_free_text;
  made.published_cell = cell(published_codes_of);
  return made;
}

Columns participant_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::participant);
  columns.back().levels.push_back("mixed");
  columns.back().description = "mode of the participant's sessions";
  columns.back().missing = "no session yet";
  const auto participant = [](auto member) {
    return [member](const Place& at) { return optional_cell(at.participant->*member); };
  };
  columns.push_back(
      missing("not reported", at_least(0, column("age_years", "number", "year", "age",
                                                 participant(&ParticipantRow::age_years)))));
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
  columns.push_back(dropped(column("created_utc", "utc_time", "", "when the participant was added",
                                   [](const Place& at) { return at.participant->created_utc; })));
  columns.push_back(column("withdrawn", "boolean", "",
                           "1: the participant withdrew; the data were kept but are never used",
                           [](const Place& at) { return boolean(at.participant->withdrawn); }));
  for (const std::string& name : vocabulary.participant_answers) {
    const auto question = vocabulary.questions.find(name);
    const bool known = question != vocabulary.questions.end();
    ExportColumn answer =
        missing("not asked or not answered",
                column("answer_" + name, "text", "",
                       "answer to: " + (known ? question->second.prompt : "\"" + name + "\""),
                       [name](const Place& at) { return member_of(at.answers, name); }));
    answer.publication = vocabulary.goes_to_public(name)        ? Publication::kept
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

Columns session_columns() {
  Columns columns = keys_to(Key::session);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  const auto text = [&add](const char* name, const char* description, auto member) {
    add(missing("unknown", column(name, "text", "", description,
                                  [member](const Place& at) { return at.session->*member; })));
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
  add(with_levels(column("state", "text", "", "state of the session",
                         [](const Place& at) { return text_of(at.session->state); }),
                  {"open", "completed", "stopped", "crashed"}));
  text("seed", "seed of all random numbers of the session, a 64-bit integer", &SessionRow::seed);
  text("generator", "name and version of the random number generator", &SessionRow::generator);
  add(at_least(
      0, column("counterbalance_row", "integer", "", "row of the counterbalancing square, from 0",
                [](const Place& at) { return integer(at.session->counterbalance_row); })));
  add(column("mirrored", "boolean", "", "1: the workspace was laid out for a left hand",
             [](const Place& at) { return boolean(at.session->mirrored); }));
  text("program_version", "version of the program", &SessionRow::program_version);
  text("program_commit", "commit the program was built from", &SessionRow::program_commit);
  text("program_build", "how the program was built", &SessionRow::program_build);
  text("program_sha256", "SHA-256 of the program file", &SessionRow::program_sha256);
  text("instruction_set", "instruction set of the numerical code", &SessionRow::instruction_set);
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
  add(missing("no files",
              column("stimulus_files_json", "json", "",
                     "SHA-256 of each file that the session used, by path within the study",
                     [](const Place& at) -> Cell {
                       nlohmann::json files = nlohmann::json::object();
                       for (const StimulusFileRow& file : at.session->files) {
                         files[file.path] = file.sha256;
                       }
                       return files.empty() ? Cell{} : Cell{files.dump()};
                     })));
  add(missing("a human participant",
              column("observer_json", "json", "", "how the virtual participant judged, as declared",
                     [](const Place& at) -> Cell {
                       const std::string& json = at.session->observer_json;
                       return json == "null" ? Cell{} : Cell{json};
                     })));
  add(missing("the protocol requires no consent",
              column("consent_version", "text", "", "version of the consent text agreed to",
                     [](const Place& at) { return optional_cell(at.session->consent_version); })));
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

/// Factors name textures; what roughness is drawn over is the distance of their elements.
ExportColumn texture_spacing(const StudyVocabulary& vocabulary) {
  ExportColumn made = missing(
      "the protocol requests no magnitudes, or specifies no spacing of the trial's texture",
      column("texture_spacing_m", "number", "m", "spacing of the elements of the texture",
             [estimations = vocabulary.estimations](const Place& at) -> Cell {
               const auto estimation = estimations.find(at.protocol->source_sha256);
               if (estimation == estimations.end()) return {};
               const auto level = at.factors->find(estimation->second.spacing);
               if (level == at.factors->end()) return {};
               if (level->is_number()) return level->get<double>();
               const auto& spacing_m = estimation->second.spacing_m;
               const auto spacing =
                   level->is_string() ? spacing_m.find(level->get<std::string>()) : spacing_m.end();
               return spacing == spacing_m.end() ? Cell{} : Cell{spacing->second};
             }));
  made.source = "protocol";
  return made;
}

Columns trial_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::trial);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(column("protocol", "text", "", "name of the protocol",
             [](const Place& at) { return at.protocol->name; }));
  add(column("block", "text", "", "block of the protocol",
             [](const Place& at) { return at.trial->block; }));
  add(at_least(
      1, column("block_ordinal", "integer", "",
                "number of the block within the session; each run of a block has its own number",
                [](const Place& at) { return integer(at.trial->block_ordinal); })));
  add(with_levels(column("phase", "text", "", "only the main phase is analysed",
                         [](const Place& at) { return at.trial->phase; }),
                  {"familiarisation", "practice", "main"}));
  add(at_least(
      0, column("repetition", "integer", "", "repetition of the same conditions; 0 for an anchor",
                [](const Place& at) { return integer(at.trial->repetition); })));
  for (const auto& [name, factor] : vocabulary.factors) {
    ExportColumn made = missing(
        "the trial does not have this factor",
        column("factor_" + name, factor.numeric ? "number" : "text",
               factor.unit.empty() && factor.numeric ? unit_at_end_of(name).value_or("1")
                                                     : factor.unit,
               factor.meaning.empty() ? "level of the factor \"" + name + "\"" : factor.meaning,
               [name = name](const Place& at) { return member_of(at.factors, name); }));
    made.levels = factor.levels;
    made.level_meanings = factor.level_meanings;
    made.source = factor.source;
    if (factor.numeric && !factor.levels.empty()) {
      made.minimum = number_in(factor.levels.front());
      made.maximum = number_in(factor.levels.back());
    }
    columns.push_back(std::move(made));
  }
  if (!vocabulary.estimations.empty()) add(texture_spacing(vocabulary));
  return columns;
}

Columns attempt_columns() {
  Columns columns = keys_to(Key::attempt);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(at_least(1, column("segment", "integer", "",
                         "number of the segment of the session between interruptions",
                         [](const Place& at) { return integer(at.attempt->segment); })));
  add(with_levels(column("outcome", "text", "", "how the attempt ended",
                         [](const Place& at) { return text_of(at.attempt->outcome); }),
                  {"answered", "timed_out", "not_compliant", "aborted", "device_fault",
                   "emergency_stop", "skipped"}));
  add(column("valid", "boolean", "", "1: the valid attempt of its trial; there is at most one",
             [](const Place& at) { return boolean(at.attempt->valid); }));
  add(dropped(
      missing("the attempt is valid",
              column("invalid_reason", "text", "",
                     "why the attempt does not count; may be in the experimenter's words",
                     [](const Place& at) { return text_cell_of(at.attempt->invalid_reason); }))));
  add(codes_column(
      "invalid_code", "the attempt is valid",
      "the reasons as codes, separated by semicolons; \"typed\" where the experimenter typed one",
      &AttemptRow::invalid_reason));
  add(column("excluded", "boolean", "",
             "1: the attempt or its session was excluded; the attempt does not count",
             [](const Place& at) { return boolean(at.attempt->excluded.has_value()); }));
  add(dropped(missing("not excluded",
                      column("exclusion_reason", "text", "", "reason, as entered",
                             [](const Place& at) { return text_cell_of(at.attempt->excluded); }))));
  add(codes_column("exclusion_code", "not excluded", "the reasons as codes, as in invalid_code",
                   &AttemptRow::excluded));
  add(column("counts_in_analyses", "boolean", "",
             "1: the attempt counts in analyses: the trial belongs to the main phase and is not an "
             "anchor, and the attempt is answered, valid and not excluded",
             [](const Place& at) {
               return boolean(use_in_analyses(*at.trial, *at.attempt) == AnalysisUse::counted);
             }));
  add(column("flagged", "boolean", "", "1: the attempt should be inspected; it counts nevertheless",
             [](const Place& at) { return boolean(at.attempt->flagged); }));
  add(dropped(
      missing("not flagged",
              column("flag_reason", "text", "",
                     "what to inspect, in the words of the program or of the experimenter",
                     [](const Place& at) { return text_cell_of(at.attempt->flag_reason); }))));
  add(codes_column("flag_code", "not flagged", "the reasons as codes, as in invalid_code",
                   &AttemptRow::flag_reason));
  add(column("onset_s", "number", "s", "beginning, since the session began",
             [](const Place& at) { return seconds_in_session(at, at.attempt->onset_ns); }));
  add(column("offset_s", "number", "s", "end, since the session began",
             [](const Place& at) { return seconds_in_session(at, at.attempt->offset_ns); }));
  const auto of_recording = [](auto member) {
    return [member](const Place& at) -> Cell {
      return at.attempt->recording ? Cell{(*at.attempt->recording).*member} : Cell{};
    };
  };
  const auto recording = [&](const char* name, const char* type, const char* unit,
                             const char* description, auto member) {
    add(missing("the attempt was not recorded",
                column(name, type, unit, description, of_recording(member))));
  };
  recording("recording_path", "text", "", "file of the tick records, within the study",
            &RecordingRow::path);
  recording("recording_format", "text", "", "format of that file", &RecordingRow::format);
  recording("recording_sha256", "text", "", "SHA-256 of that file", &RecordingRow::sha256);
  recording("recording_records", "integer", "1", "tick records in that file",
            &RecordingRow::records);
  return columns;
}

Columns presentation_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::attempt);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  const auto text = [&add](const char* name, const char* description, auto member) {
    add(column(name, "text", "", description,
               [member](const Place& at) { return at.presentation->*member; }));
  };
  add(at_least(1, column("position", "integer", "", "place in the order of the trial's surfaces",
                         [](const Place& at) { return integer(at.presentation->position); })));
  text("role", "role of the surface in the trial", &PresentationRow::role);
  columns.back().levels = {"alternative", "target", "anchor"};
  text("item", "name of the surface in the responses", &PresentationRow::item);
  text("stimulus", "stimulus of the protocol", &PresentationRow::stimulus);
  text("model", "force model", &PresentationRow::model);
  text("model_version", "version of the force model", &PresentationRow::model_version);
  add(missing("no texture is involved",
              column("texture", "text", "", "texture of the protocol", [](const Place& at) -> Cell {
                const std::string& texture = at.presentation->texture;
                return texture.empty() ? Cell{} : Cell{texture};
              })));
  add(missing(
      "no height field is involved",
      column("height_field_sha256", "text", "",
             "SHA-256 of the height field's sidecar, which contains that of its picture",
             [](const Place& at) { return optional_cell(at.presentation->height_field_sha256); })));
  const auto sha256 = [&add](const char* name, const char* description, auto member) {
    add(missing("the tool of the model is a point",
                column(name, "text", "", description, [member](const Place& at) {
                  return optional_cell(at.presentation->*member);
                })));
  };
  sha256("surface_sha256", "SHA-256 of the body that was touched (docs/formats/study.md)",
         &PresentationRow::surface_sha256);
  sha256("tool_sha256", "SHA-256 of the body that was held (docs/formats/study.md)",
         &PresentationRow::tool_sha256);
  text("seed", "seed of the renderer, a 64-bit integer", &PresentationRow::seed);
  const auto time = [&add](const char* name, const char* description, const char* when,
                           auto member) {
    add(missing(when, column(name, "number", "s", description, [member](const Place& at) {
                  return seconds_in_session(at, at.presentation->*member);
                })));
  };
  time("onset_s", "first tick with the surface present, since the session began",
       "the surface was not presented", &PresentationRow::onset_ns);
  time("contact_onset_s", "first tick with the probe in the surface, since the session began",
       "the surface was not touched", &PresentationRow::contact_ns);
  time("offset_s", "last tick with the surface present, since the session began",
       "the surface was not presented", &PresentationRow::offset_ns);
  add(at_least(0, column("contact_s", "number", "s", "time in contact",
                         [](const Place& at) { return at.presentation->contact_s; })));
  add(missing("no equal force was requested",
              at_least(0, column("matched_texture_force_N", "number", "N",
                                 "intended RMS of the texture force on the prescribed path",
                                 [](const Place& at) {
                                   return optional_cell(at.presentation->matched_texture_force_N);
                                 }))));
  add(missing("too short in contact",
              at_least(0, column("achieved_texture_force_N", "number", "N",
                                 "RMS of the texture force along the participant's own path",
                                 [](const Place& at) {
                                   return optional_cell(at.presentation->achieved_texture_force_N);
                                 }))));
  const auto listed = [](const std::set<std::string>& models) {
    std::string of{};
    for (const std::string& model : models) of += (of.empty() ? "" : ", ") + model;
    return of;
  };
  for (const auto& [kind, models] : vocabulary.limits) {
    add(missing("the model does not monitor this limit",
                at_least(0, column("limit_" + kind + "_ticks", "integer", "1",
                                   "ticks in which the force model exceeded this limit of valid "
                                   "rendering (docs/models.md); models: " +
                                       listed(models),
                                   [kind = kind](const Place& at) -> Cell {
                                     for (const ModelLimitRow& limit : at.presentation->limits) {
                                       if (limit.kind == kind) return limit.ticks;
                                     }
                                     return {};
                                   }))));
  }
  for (const auto& [name, parameter] : vocabulary.parameters) {
    const std::string of = listed(parameter.models);
    const bool numeric = parameter.levels.empty();
    std::string meaning{};
    for (const std::string& each : parameter.meanings) meaning += each + "; ";
    ExportColumn made =
        missing("the model does not have this parameter",
                column("parameter_" + name, numeric ? "number" : "text",
                       numeric ? parameter.unit.value_or(unit_at_end_of(name).value_or("1")) : "",
                       meaning + "parameter of the force model as rendered; models: " + of,
                       [name = name](const Place& at) { return member_of(at.parameters, name); }));
    made.source = parameter.meanings.empty() ? "what was rendered" : "force model";
    made.minimum = parameter.minimum;
    made.maximum = parameter.maximum;
    made.levels.assign(parameter.levels.begin(), parameter.levels.end());
    columns.push_back(std::move(made));
  }
  return columns;
}

Columns response_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::attempt);
  for (ExportColumn& made : columns) {
    if (made.name == "trial" || made.name == "attempt") {
      made.missing = "the question belongs to the session, not to a trial";
    }
  }
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(column("question", "text", "", "name of the question",
             [](const Place& at) { return at.response->question; }));
  add(at_least(1,
               column("item", "integer", "",
                      "1 for a choice or a number; the position of the surface for an assignment",
                      [](const Place& at) { return integer(at.response->item); })));
  std::string questions{};
  for (const auto& [name, question] : vocabulary.questions) {
    questions += (questions.empty() ? "; " : " · ") + name + ": " + question.prompt;
    std::string options{};
    for (const std::string& option : question.options) {
      options += (options.empty() ? " (" : " | ") + option;
    }
    if (!options.empty()) questions += options + ")";
  }
  add(column("answer", "text", "", "the response, by its name in the protocol" + questions,
             [](const Place& at) { return at.response->answer; }));
  columns.back().publication = Publication::without_questionnaires;
  columns.back().missing = "never, except for answers to questionnaires in a public export";
  add(missing(
      "the response is not a number, or is an answer to a questionnaire in a public export",
      column("answer_number", "number", "", "the response as a number: the estimate of a magnitude",
             [](const Place& at) { return optional_cell(at.response->answer_number); })));
  columns.back().publication = Publication::without_questionnaires;
  add(missing("no response is correct or incorrect",
              column("correct", "boolean", "", "1: correct response",
                     [](const Place& at) { return optional_boolean(at.response->correct); })));
  add(column("options_json", "json", "", "the options in the order in which they were shown",
             [](const Place& at) { return at.response->options_json; }));
  add(column("time_s", "number", "s", "time of the response, since the session began",
             [](const Place& at) { return seconds_in_session(at, at.response->time_ns); }));
  add(missing("there was no contact before",
              at_least(0, column("from_contact_s", "number", "s",
                                 "time from the first contact of the attempt to the response",
                                 [](const Place& at) {
                                   return optional_cell(at.response->from_contact_s);
                                 }))));
  add(missing(
      "not measured",
      at_least(0, column("from_cue_s", "number", "s",
                         "time from the cue, when the question was first asked, to the response",
                         [](const Place& at) { return optional_cell(at.response->from_cue_s); }))));
  add(column("source", "text", "",
             "how the response was given: keyboard; virtual, by a virtual participant; "
             "virtual_guess, by one that ignores the surface or has no expectation",
             [](const Place& at) { return at.response->source; }));
  add(missing("the estimate was not re-elicited",
              column("doubted_estimate", "number", "",
                     "the first estimate, where the magnitude was re-elicited because the estimate "
                     "was at least ten times, or at most a tenth of, an earlier one for the same "
                     "stimulus; the response is the second estimate",
                     [](const Place& at) { return optional_cell(at.doubted_estimate); })));
  add(missing(
      "the response is not an estimate of a magnitude, or the participant has none in some cell",
      column("normalised_estimate", "number", "",
             "the estimate of a magnitude with the participant's own scale removed: multiplied by "
             "the geometric mean of all participants and divided by that of the participant; both "
             "of this protocol, version and kind of session, over valid attempts of the main "
             "phase, without excluded attempts and anchors",
             [](const Place& at) -> Cell {
               if (!at.own_scale || !at.response->answer_number) return {};
               return *at.own_scale * *at.response->answer_number;
             })));
  return columns;
}

Columns servo_columns() {
  Columns columns = keys_to(Key::attempt);
  const auto number = [&columns](const char* name, const char* unit, const char* description,
                                 double ServoQualityRow::*member) {
    columns.push_back(at_least(0, column(name, "number", unit, description,
                                         [member](const Place& at) { return at.servo->*member; })));
  };
  const auto count = [&columns](const char* name, const char* description,
                                std::int64_t ServoQualityRow::*member) {
    columns.push_back(
        at_least(0, column(name, "integer", "1", description,
                           [member](const Place& at) { return integer(at.servo->*member); })));
  };
  using Row = ServoQualityRow;
  number("rate_Hz", "Hz", "requested rate", &Row::rate_Hz);
  count("ticks", "ticks of the servo loop", &Row::ticks);
  number("period_mean_s", "s", "mean time between ticks", &Row::period_mean_s);
  number("period_sd_s", "s", "standard deviation of the time between ticks", &Row::period_sd_s);
  number("period_p50_s", "s", "median time between ticks", &Row::period_p50_s);
  number("period_p99_s", "s", "99th percentile of the time between ticks", &Row::period_p99_s);
  number("period_p99_9_s", "s", "99.9th percentile of the time between ticks",
         &Row::period_p99_9_s);
  number("period_maximum_s", "s", "longest time between ticks", &Row::period_maximum_s);
  number("lateness_p50_s", "s", "median delay of the start of a tick after its deadline",
         &Row::lateness_p50_s);
  number("lateness_p99_s", "s", "99th percentile of the delay of the start after the deadline",
         &Row::lateness_p99_s);
  number("lateness_maximum_s", "s", "longest delay of a start after its deadline",
         &Row::lateness_maximum_s);
  number("execution_p99_s", "s", "99th percentile of the duration of a tick; 0 when simulated",
         &Row::execution_p99_s);
  number("execution_maximum_s", "s", "longest duration of a tick; 0 when simulated",
         &Row::execution_maximum_s);
  count("missed_deadlines", "ticks that missed their deadline", &Row::missed_deadlines);
  columns.push_back(missing(
      kNotCountedApart, at_least(0, column("missed_in_contact", "integer", "1", kMissedInContact,
                                           [](const Place& at) {
                                             return optional_cell(at.servo->missed_in_contact);
                                           }))));
  count("saturated_ticks", "ticks with the force reduced to the limit", &Row::saturated_ticks);
  count("slew_limited_ticks", "ticks with the rate of change of the force limited",
        &Row::slew_limited_ticks);
  count("not_finite_ticks", "ticks with a force that was not a number", &Row::not_finite_ticks);
  count("lost_records", "tick records that were lost", &Row::lost_records);
  columns.push_back(column("fault", "text", "", "fault that stopped the forces, or none",
                           [](const Place& at) { return at.servo->fault; }));
  return columns;
}

Columns compliance_columns() {
  Columns columns = keys_to(Key::attempt);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  using Row = ComplianceRow;
  add(at_least(0, column("position", "integer", "", "place in the order of the trial's surfaces",
                         [](const Place& at) { return integer(at.compliance->position); })));
  add(with_levels(column("quantity", "text", "", "what was measured; the name ends with the unit",
                         [](const Place& at) { return at.compliance->quantity; }),
                  {"normal_force_N", "speed_m_per_s", "contact_s", "strokes", "stroke_length_m"}));
  const auto bound = [&add](const char* name, const char* description,
                            std::optional<double> Row::*member) {
    add(missing("the protocol declares none",
                column(name, "number", "as quantity", description, [member](const Place& at) {
                  return optional_cell(at.compliance->*member);
                })));
  };
  const auto value = [&add](const char* name, const char* description, double Row::*member) {
    add(column(name, "number", "as quantity", description,
               [member](const Place& at) { return at.compliance->*member; }));
  };
  bound("minimum", "lower end of the band that the protocol requires", &Row::minimum);
  bound("maximum", "upper end of the band that the protocol requires", &Row::maximum);
  value("mean", "mean achieved", &Row::mean);
  value("sd", "standard deviation", &Row::sd);
  value("p05", "5th percentile", &Row::p05);
  value("p50", "median", &Row::p50);
  value("p95", "95th percentile", &Row::p95);
  add(missing(
      "the protocol declares no band",
      fraction(
          column("fraction_in_band", "number", "1",
                 "fraction inside the band: of the contact time, of the strokes for the speed",
                 [](const Place& at) { return optional_cell(at.compliance->fraction_in_band); }))));
  add(missing("the protocol declares no requirement",
              column("passed", "boolean", "", "1: explored as the protocol requires",
                     [](const Place& at) { return optional_boolean(at.compliance->passed); })));
  return columns;
}

const char* publication_text(Publication publication) {
  switch (publication) {
    case Publication::kept:
      return "kept";
    case Publication::without_questionnaires:
      return "without answers to questionnaires";
    case Publication::without_free_text:
      return "without free text";
    case Publication::dropped_unless_named:
      return "omitted unless named";
    case Publication::dropped:
      return "dropped";
  }
  return "";
}

}  // namespace

std::optional<std::string> unit_at_end_of(std::string_view name) {
  // A longer ending stands before a shorter one that it contains.
  static constexpr std::array<std::pair<std::string_view, const char*>, 14> kUnits{
      {{"_N_s_per_m", "N s/m"},
       {"_N_per_m", "N/m"},
       {"_N_m", "N m"},
       {"_m_per_s2", "m/s2"},
       {"_m_per_s", "m/s"},
       {"_rad_per_s", "rad/s"},
       {"_per_m", "1/m"},
       {"_per_s", "1/s"},
       {"_rad", "rad"},
       {"_kg", "kg"},
       {"_Hz", "Hz"},
       {"_N", "N"},
       {"_m", "m"},
       {"_s", "s"}}};
  for (const auto& [ending, unit] : kUnits) {
    if (name.ends_with(ending)) return unit;
  }
  return std::nullopt;
}

std::vector<std::string> column_names(const Columns& columns) {
  std::vector<std::string> names{};
  for (const ExportColumn& column : columns) names.push_back(column.name);
  return names;
}

std::vector<ExportFile> export_files(const StudyVocabulary& vocabulary) {
  return {{"participants", participant_columns(vocabulary)},
          {"sessions", session_columns()},
          {"trials", trial_columns(vocabulary)},
          {"attempts", attempt_columns()},
          {"presentations", presentation_columns(vocabulary)},
          {"responses", response_columns(vocabulary)},
          {"servo_quality", servo_columns()},
          {"compliance", compliance_columns()},
          {"events", event_columns()}};
}

Columns answered_trial_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::attempt);
  const std::size_t keys_of_attempt = columns.size();
  const auto append = [&columns](Columns more, std::size_t from) {
    std::move(more.begin() + static_cast<std::ptrdiff_t>(from), more.end(),
              std::back_inserter(columns));
  };
  append(trial_columns(vocabulary), keys_of_attempt - 1);  // without the key "attempt"
  append(attempt_columns(), keys_of_attempt);
  columns.push_back(column("surfaces_json", "json", "",
                           "the surfaces presented, in order: position, role, item, stimulus, "
                           "model and texture of each surface",
                           [](const Place& at) -> Cell {
                             nlohmann::json surfaces = nlohmann::json::array();
                             for (const PresentationRow& row : at.attempt->presentations) {
                               surfaces.push_back({{"position", row.position},
                                                   {"role", row.role},
                                                   {"item", row.item},
                                                   {"stimulus", row.stimulus},
                                                   {"model", row.model},
                                                   {"texture", row.texture}});
                             }
                             return surfaces.dump();
                           }));
  const auto servo = [&columns](const char* name, const char* description,
                                std::int64_t ServoQualityRow::*member) {
    columns.push_back(missing(
        "the attempt has no servo quality",
        at_least(0, column(name, "integer", "1", description, [member](const Place& at) -> Cell {
                   if (!at.attempt->servo) return {};
                   return integer((*at.attempt->servo).*member);
                 }))));
  };
  servo("missed_deadlines", "ticks that missed their deadline", &ServoQualityRow::missed_deadlines);
  columns.push_back(missing(std::string("the attempt has no servo quality, or ") + kNotCountedApart,
                            at_least(0, column("missed_in_contact", "integer", "1",
                                               kMissedInContact, [](const Place& at) -> Cell {
                                                 if (!at.attempt->servo) return {};
                                                 return optional_cell(
                                                     at.attempt->servo->missed_in_contact);
                                               }))));
  servo("saturated_ticks", "ticks with the force reduced to the limit",
        &ServoQualityRow::saturated_ticks);
  servo("lost_records", "tick records that were lost", &ServoQualityRow::lost_records);
  Columns answers = response_columns(vocabulary);
  for (std::size_t i = keys_of_attempt; i < answers.size(); ++i) {
    ExportColumn& made = answers[i];
    made.missing = made.missing == "never" ? "the attempt has no response"
                                           : "the attempt has no response, or " + made.missing;
    made.cell = [of_answer = std::move(made.cell)](const Place& at) {
      return at.response == nullptr ? Cell{} : of_answer(at);
    };
    columns.push_back(std::move(made));
  }
  return columns;
}

bool StudyVocabulary::goes_to_public(const std::string& question) const {
  const auto known = questions.find(question);
  return known != questions.end() && !known->second.free_text && for_public.contains(question);
}

std::string left_out_answers_to(const std::string& question) { return "answer(" + question + ")"; }

Cell cell_for(ExportAudience audience, const ExportColumn& column, const ExportPlace& at) {
  const bool hidden = audience == ExportAudience::published && at.response_is_withheld &&
                      column.publication == Publication::without_questionnaires;
  const bool is_published = audience == ExportAudience::published && column.published_cell;
  Cell cell = hidden ? Cell{} : is_published ? column.published_cell(at) : column.cell(at);
  const auto* text = std::get_if<std::string>(&cell);
  return text != nullptr && text->empty() ? Cell{} : cell;
}

Columns columns_for(ExportAudience audience, Columns columns, std::vector<std::string>& left_out) {
  if (audience == ExportAudience::own) return columns;
  Columns kept{};
  for (ExportColumn& column : columns) {
    if (column.publication == Publication::dropped ||
        column.publication == Publication::dropped_unless_named) {
      left_out.push_back(column.name);
    } else {
      kept.push_back(std::move(column));
    }
  }
  return kept;
}

const std::vector<std::string>& codebook_columns() {
  static const std::vector<std::string> kColumns{"file",    "column",      "description", "type",
                                                 "unit",    "levels",      "minimum",     "maximum",
                                                 "missing", "publication", "source"};
  return kColumns;
}

std::vector<Cell> codebook_row(const std::string& file, const ExportColumn& column) {
  std::string levels{};
  for (const std::string& level : column.levels) levels += (levels.empty() ? "" : " | ") + level;
  return {file,
          column.name,
          column.description,
          column.type,
          column.unit.empty() ? Cell{} : Cell{column.unit},
          levels.empty() ? Cell{} : Cell{levels},
          optional_cell(column.minimum),
          optional_cell(column.maximum),
          column.missing,
          std::string(publication_text(column.publication)),
          column.source};
}

}  // namespace asperity

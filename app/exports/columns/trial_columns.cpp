// Declares the columns of trials.tsv, with one column for each factor, spacing and kind of catch trial.

#include <algorithm>
#include <cstdint>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/unit_of_name.h"
#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"
#include "protocols/design/protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/plan.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

// Roughness is a function of the distance of a texture's elements. A factor either is that distance or names a
// texture whose distance the protocol declares.
ExportColumn texture_spacing(const StudyVocabulary& vocabulary) {
  ExportColumn made = missing(
      "the trial does not belong to a magnitude estimation, or the protocol does not specify the "
      "spacing of its texture",
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

ExportColumn catch_type(const StudyVocabulary& vocabulary) {
  ExportColumn made =
      column("catch_type", "text", "", "what the catch trial presents",
             [types = vocabulary.catch_types](const Place& at) -> Cell {
               if (!at.trial->is_catch) return {};
               const auto type = types.find({at.protocol->source_sha256, at.trial->block});
               return type == types.end() ? Cell{} : Cell{type->second};
             });
  std::vector<std::string> levels{};
  for (const auto& [type, meaning] :
       {std::pair{CatchType::easy, "the comparison at an easy level"},
        std::pair{CatchType::no_signal, "only standards, where the comparison has to be found"},
        std::pair{CatchType::identical_pair, "only standards, where two are compared"}}) {
    levels.emplace_back(text_of(type));
    made.level_meanings[levels.back()].description = meaning;
  }
  made = missing("not a catch trial", with_levels(std::move(made), levels));
  made.source = "protocol";
  return made;
}

ExportColumn anchor() {
  ExportColumn made = missing(
      "not an anchor",
      with_levels(
          column("anchor", "text", "",
                 "place of the anchor, a reference trial whose response no analysis "
                 "contains, in the run of its block",
                 [](const Place& at) -> Cell {
                   if (at.trial->repetition != 0 || at.trial->is_catch) return {};
                   return text_of(anchor_place_in(*at.plan));
                 }),
          {text_of(AnchorPlace::start), text_of(AnchorPlace::middle), text_of(AnchorPlace::end)}));
  made.level_meanings = {{text_of(AnchorPlace::start), {"before the other trials", ""}},
                         {text_of(AnchorPlace::middle), {"after half of the other trials", ""}},
                         {text_of(AnchorPlace::end), {"after the other trials", ""}}};
  return made;
}

}  // namespace

Columns trial_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::trial);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(column("protocol", "text", "", "name of the protocol",
             [](const Place& at) { return at.protocol->name; }));
  add(column("block", "text", "", "block of the protocol",
             [](const Place& at) { return at.trial->block; }));
  std::vector<std::string> kinds{};
  for (const ExperimentKind* const kind : experiment_kinds()) kinds.emplace_back(kind->id);
  add(with_levels(
      column(
          "kind", "text", "", "kind of experiment of the block",
          [kinds_of_blocks = vocabulary.kinds_of_blocks](const Place& at) -> Cell {
            const auto found = kinds_of_blocks.find({at.protocol->source_sha256, at.trial->block});
            if (found == kinds_of_blocks.end()) return at.protocol->kind;
            return found->second;
          }),
      kinds));
  add(at_least(
      1, column("block_ordinal", "integer", "",
                "number of the block within the session; each run of a block has its own number",
                [](const Place& at) { return integer(at.trial->block_ordinal); })));
  add(with_levels(column("phase", "text", "", "only the main phase is analysed",
                         [](const Place& at) { return at.trial->phase; }),
                  {"familiarisation", "practice", "main"}));
  add(at_least(0, column("repetition", "integer", "",
                         "repetition of the same conditions; 0 for an anchor or a catch trial",
                         [](const Place& at) { return integer(at.trial->repetition); })));
  const auto of_procedure = [](ExportColumn made) {
    return missing("no procedure chose the level of the trial", at_least(1, std::move(made)));
  };
  add(of_procedure(
      column("track", "integer", "",
             "track of the procedure that chose the level, within the run of the block",
             [](const Place& at) -> Cell {
               if (!at.trial->track) return {};
               return integer(*at.trial->track);
             })));
  add(of_procedure(column("step", "integer", "", "number of the trial within its track",
                          [](const Place& at) -> Cell {
                            if (!at.trial->step) return {};
                            return integer(*at.trial->step);
                          })));
  add(column("catch_trial", "boolean", "",
             "1: a catch trial at a random place among those of a procedure; no threshold is "
             "estimated from it",
             [](const Place& at) { return boolean(at.trial->is_catch); }));
  if (!vocabulary.catch_types.empty()) add(catch_type(vocabulary));
  add(anchor());
  for (const auto& [name, factor] : vocabulary.factors) {
    ExportColumn made = missing(
        "the trial does not have this factor",
        column("factor_" + name, factor.numeric ? "number" : "text",
               factor.unit.empty() && factor.numeric ? unit_in_files(name) : factor.unit,
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
  const bool has_spacings =
      std::any_of(vocabulary.estimations.begin(), vocabulary.estimations.end(),
                  [](const auto& estimation) { return !estimation.second.spacing.empty(); });
  if (has_spacings) add(texture_spacing(vocabulary));
  return columns;
}

ExportColumn attempts_of_trial_column() {
  return at_least(
      0, column("attempts", "integer", "1",
                "number of attempts at the trial; 0: it was planned and never presented, for "
                "example because the practice had reached its criterion or the session ended",
                [](const Place& at) {
                  return integer(static_cast<std::int64_t>(at.attempts_of_trial));
                }));
}

}  // namespace asperity::export_columns

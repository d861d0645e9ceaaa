// asperity sweep: the offline roughness experiment.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/number_text.h"
#include "app/cli/command.h"
#include "app/cli/model_option.h"
#include "app/cli/number_option.h"
#include "app/cli/parameter_option.h"
#include "app/cli/signals.h"
#include "app/cli/terminal.h"
#include "app/cli/word_option.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/textured_mesh_files.h"
#include "app/sweep/sweep.h"
#include "app/words/text_parts.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/figures/figure_files.h"
#include "app/figures/figures_of.h"
#include "app/figures/sweep_figure.h"
#include "app/findings/study/analyze_study.h"
#include "app/sweep/sweep_beside.h"
#include "app/tasks/protocol_files.h"
#include "protocols/file/protocol_reader.h"
#include "results_schema/study.h"
#endif
#include "protocols/kinds/magnitude.h"
#include "renderers/built_in_models.h"
#include "stimuli/heights/synthetic_surface.h"

namespace asperity {

namespace {

struct SweepOptions {
  std::string model{};
  std::vector<std::string> parameters{};
  SweepOrder order{};
  std::string values{};
  std::string spacings = "0.0005:0.008:40";
  std::string texture = "sinusoid,amplitude_m=0.0002";
  std::optional<std::string> tool{};
  std::optional<double> probe_diameter_m{};
  std::optional<double> applied_force_N{};
  std::optional<double> exploratory_speed_m_per_s{};
  std::string hand = "0.05,3,200";
  int jobs = 0;
  std::string out{};
  SweepMeasure measure = SweepMeasure::max_accel;
  std::string plot{};
  std::string beside{};
  std::optional<std::string> protocol{};
  bool force = false;
};

/// `expected`: how it is written right.
std::vector<double> numbers_of(const std::string& option, const std::string& text, char separator,
                               const std::string& expected) {
  std::vector<double> numbers{};
  for (const std::string& piece : parts_of(text, separator)) {
    const std::optional<double> number = number_in(piece);
    if (!number) {
      throw WrongUsage(option + " " + text + ": \"" + piece + "\" is not a number; " + expected);
    }
    numbers.push_back(*number);
  }
  return numbers;
}

/// What a quantity is given in, and more than anybody presses, strokes or holds: a number above it was
/// meant in another unit.
struct Given {
  const char* name = "";
  const char* unit = "";
  double most = 0.0;
  const char* like = "";
};

Given given_of(VariedQuantity quantity) {
  switch (quantity) {
    case VariedQuantity::probe_diameter:
      return {"a probe diameter", "m", 0.1, "2 mm is 0.002"};
    case VariedQuantity::applied_force:
      return {"a force", "N", 100.0, "500 mN is 0.5"};
    case VariedQuantity::exploratory_speed:
      return {"a speed", "m/s", 10.0, "60 mm/s is 0.06"};
  }
  return {};
}

constexpr Given kGivenSpacing{"a spacing", "m", 0.1, "4 mm is 0.004"};

void require_unit(const std::string& option, double number, const Given& given) {
  if (!(number > given.most)) return;
  throw WrongUsage(option + ": " + given.name + " is given in " + given.unit + " and is at most " +
                   number_text(given.most) + ' ' + given.unit + ", not " + number_text(number) +
                   "; " + given.like);
}

std::vector<double> values_of(VariedQuantity varied, const std::string& text) {
  const Given given = given_of(varied);
  std::vector<double> values =
      numbers_of("--values", text, ',',
                 std::string(given.name) + " is given in " + given.unit + ": " + given.like);
  for (const double value : values) require_unit("--values " + text, value, given);
  return values;
}

std::vector<double> spacings_of(const std::string& text) {
  constexpr const char* kExpected = "write FROM:TO:COUNT, in metres, like 0.0005:0.008:40";
  const std::vector<double> numbers = numbers_of("--spacings", text, ':', kExpected);
  if (numbers.size() != 3 || numbers[2] != std::floor(numbers[2]) || numbers[2] > 10000.0) {
    throw WrongUsage("--spacings " + text + ": " + kExpected);
  }
  for (const double spacing_m : {numbers[0], numbers[1]}) {
    require_unit("--spacings " + text, spacing_m, kGivenSpacing);
  }
  try {
    return logarithmic_spacings(numbers[0], numbers[1], static_cast<int>(numbers[2]));
  } catch (const std::invalid_argument& error) {
    throw WrongUsage("--spacings " + text + ": " + error.what());
  }
}

HandModel hand_of(const std::string& text) {
  constexpr const char* kExpected = "write M_kg,B_N_s_per_m,K_N_per_m, like 0.05,3,200";
  const std::vector<double> numbers = numbers_of("--hand", text, ',', kExpected);
  if (numbers.size() != 3) throw WrongUsage("--hand " + text + ": " + kExpected);
  return {.mass_kg = numbers[0], .damping_N_s_per_m = numbers[1], .stiffness_N_per_m = numbers[2]};
}

void take_texture(SweepOrder& order, const std::string& text) {
  std::vector<std::string> pieces = parts_of(text, ',');
  if (std::filesystem::path(text).extension() == ".png") {
    const LoadedHeightField loaded = load_height_field(text);
    order.texture.relief = loaded.field;
    order.relief_sha256 = loaded.sha256;
    return;
  }
  order.texture.kind = pieces.front();
  pieces.erase(pieces.begin());
  for (const std::string& piece : pieces) {
    if (piece.find('=') == std::string::npos) {
      throw WrongUsage("--texture " + text + ": write KIND[,NAME=VALUE…] or FILE.png");
    }
  }
  for (const SurfaceDeclaration& surface : synthetic_surfaces()) {
    if (surface.kind != order.texture.kind) continue;
    order.texture.values = parameters_from(pieces, surface.parameters, surface.kind);
  }
  if (order.texture.values.contains("spacing_m")) {
    throw WrongUsage("--texture " + text +
                     ": the spacing is set by --spacings; leave out spacing_m");
  }
}

void take_tip(SweepOrder& order, const std::string& text) {
  if (!order.stroke.model->declaration.needs_bodies) {
    throw WrongUsage("the force model " + order.stroke.model->declaration.id +
                     " computes the contact at a point, and --tool needs a model with two bodies; "
                     "leave it out, or choose another model");
  }
  const std::map<std::string, TipForm> forms{
      {"point", TipForm::point}, {"sphere", TipForm::sphere}, {"disc", TipForm::disc}};
  const auto form = forms.find(text);
  if (form != forms.end()) {
    order.stroke.tip.form = form->second;
    return;
  }
  if (!std::filesystem::exists(text)) {
    throw std::runtime_error("--tool " + text +
                             ": there is no such file; write sphere, disc, point, or the file of a "
                             "textured mesh");
  }
  const LoadedTexturedMesh loaded = load_textured_mesh(text);
  order.stroke.tool = {loaded.stored, &loaded.stored->mesh};
  order.tool_sha256 = loaded.sha256;
}

/// A level that stays as it is through the whole sweep, which what is varied does not.
void take_level(const SweepOrder& order, VariedQuantity quantity, const char* option,
                std::optional<double> given, double& level) {
  if (!given) return;
  if (order.varied == quantity) {
    throw WrongUsage(std::string(option) +
                     " is the quantity that --vary varies; give its levels with --values");
  }
  require_unit(std::string(option) + ' ' + number_text(*given), *given, given_of(quantity));
  level = *given;
}

/// What the rows come to, a line per level.
Table summary_table(const Sweep& sweep, SweepMeasure measure) {
  const auto count = [&sweep](double value, const char* status) {
    return static_cast<std::int64_t>(std::count_if(
        sweep.rows.begin(), sweep.rows.end(),
        [&](const SweepRow& row) { return row.value == value && row.status == status; }));
  };
  const std::map<VariedQuantity, const char*> units{
      {VariedQuantity::probe_diameter, "_m"},
      {VariedQuantity::applied_force, "_N"},
      {VariedQuantity::exploratory_speed, "_m_per_s"}};
  Table table{.columns = {text_of(sweep.order.varied) + std::string(units.at(sweep.order.varied)),
                          "rows_fitted", "stick_slip", "not_converged", "saturated",
                          "greatest_at_mm", "parabola_peak_mm", "low_mm", "high_mm", "r2"}};
  const auto rounded = [](std::optional<double> number, double unit) {
    return number ? Cell(std::round(*number * unit * 1e3) / 1e3) : Cell();
  };
  for (const SweepCurve& curve : curves_of(sweep, measure)) {
    std::optional<double> peak_m{};
    std::optional<double> low_m{};
    std::optional<double> high_m{};
    std::optional<double> r2{};
    if (curve.fit) {
      if (std::isfinite(curve.fit->r2)) r2 = curve.fit->r2;
      if (curve.fit->peak) peak_m = std::pow(10.0, -curve.fit->peak->x);
      if (curve.fit->peak && curve.fit->fieller) {
        low_m = std::pow(10.0, -curve.fit->fieller->high);
        high_m = std::pow(10.0, -curve.fit->fieller->low);
      }
    }
    table.rows.push_back({curve.value, static_cast<std::int64_t>(curve.fitted.size()),
                          count(curve.value, "stick_slip"), count(curve.value, "not_converged"),
                          count(curve.value, "saturated"), rounded(curve.greatest_at_m, 1e3),
                          rounded(peak_m, 1e3), rounded(low_m, 1e3), rounded(high_m, 1e3),
                          rounded(r2, 1.0)});
  }
  return table;
}

/// "the probe diameter", as what a model may not depend on.
const char* words_of_varied(VariedQuantity varied) {
  switch (varied) {
    case VariedQuantity::probe_diameter:
      return "the probe diameter";
    case VariedQuantity::applied_force:
      return "the applied force";
    case VariedQuantity::exploratory_speed:
      return "the exploratory speed";
  }
  return "";
}

/// The curves of levels that are one and the same stroke.
void say_what_has_no_effect(const Sweep& sweep) {
  const bool is_so = std::any_of(sweep.rows.begin(), sweep.rows.end(), [](const SweepRow& row) {
    return row.status == kNoEffectByConstruction;
  });
  if (!is_so) return;
  say(std::string(kNoEffectByConstruction) + ": " + sweep.order.stroke.model->declaration.id +
      " cannot depend on " + words_of_varied(sweep.order.varied) +
      "; one stroke per spacing represents all values, and their curves are the same");
}

/// Rows without a measure to fit though nothing went wrong with their stroke: nothing moved the tool.
void say_where_nothing_moved(const Sweep& sweep, SweepMeasure measure, std::size_t unmoved) {
  const RoughnessStroke& stroke = sweep.order.stroke;
  std::string why = "the acceleration has no power in that band";
  if (measure == SweepMeasure::max_accel || measure == SweepMeasure::rms_accel) {
    why = "the tool was not accelerated";
    if (stroke.mode == DragMode::constant_height) {
      why +=
          "; at constant height only a force along the stroke accelerates it, and " +
          stroke.model->declaration.id +
          " has none with these parameters: --drag constant_force lets the texture lift the tool";
    }
  }
  say("not fitted: " + counted(unmoved, "row") + " whose stroke was complete and whose " +
      text_of(measure) + " is 0: " + why);
}

/// Why a column of the summary has no number; a sentence for each reason that there is.
void say_why_absent(const Sweep& sweep, SweepMeasure measure) {
  bool is_short = false;
  bool is_at_end = false;
  bool has_no_top = false;
  std::map<double, std::size_t> unmoved{};  // by level
  std::size_t all_unmoved = 0;
  for (const SweepRow& row : sweep.rows) {
    if (!row.roughness || log10_of(row, measure)) continue;
    ++unmoved[row.value];
    ++all_unmoved;
  }
  if (all_unmoved > 0) say_where_nothing_moved(sweep, measure, all_unmoved);
  for (const SweepCurve& curve : curves_of(sweep, measure)) {
    if (!curve.fit) {
      is_short = is_short || !unmoved.contains(curve.value);
      continue;
    }
    is_at_end = is_at_end || !curve.greatest_at_m;
    has_no_top = has_no_top || !curve.fit->peak;
  }
  if (is_short) {
    say("n/a: a maximum within the range and a parabola need at least three fitted spacings "
        "(--spacings FROM:TO:COUNT; see the column status)");
  }
  if (is_at_end) {
    say("greatest_at_mm n/a: the greatest value is at the first or the last spacing and may not be "
        "the maximum");
  }
  if (has_no_top) {
    say("parabola_peak_mm n/a: the parabola has no highest point within the spacings");
  }
}

#ifdef ASPERITY_WITH_WINDOWS
/// What a sweep is drawn beside.
struct StudyBeside {
  Figure estimates{};
  std::vector<std::string> conditions{};  ///< by the levels of the sweep
  AnswerGroup group = AnswerGroup::people;
};

/// What `--protocol` names: every version of a protocol, or one of them.
struct NamedProtocol {
  std::string name{};
  std::optional<std::string> version{};
};

std::optional<NamedProtocol> named_protocol(const std::optional<std::string>& text) {
  if (!text) return {};
  const std::size_t at = text->find('@');
  if (at == std::string::npos) return NamedProtocol{*text, {}};
  return NamedProtocol{text->substr(0, at), text->substr(at + 1)};
}

bool estimates_roughness(const AnalysisOutcome& outcome) {
  return outcome.kind == magnitude_kind().id && outcome.answers > 0;
}

/// Of a study with estimates by several protocols, or by several versions of one, which of them has to be
/// said: a sweep stands beside one experiment.
void require_one_protocol(const std::string& folder, const std::vector<AnalysisOutcome>& outcomes) {
  std::map<std::string, std::set<std::string>> versions{};
  for (const AnalysisOutcome& outcome : outcomes) {
    if (estimates_roughness(outcome)) versions[outcome.protocol].insert(outcome.version);
  }
  std::vector<std::string> choices{};
  for (const auto& [name, of_name] : versions) {
    for (const std::string& version : of_name) {
      choices.push_back(of_name.size() == 1 ? name : name + '@' + version);
    }
  }
  if (choices.size() < 2) return;
  std::string said{};
  for (const std::string& choice : choices) said += (said.empty() ? "" : ", ") + choice;
  throw std::runtime_error("the study " + folder + " has estimates of roughness by " +
                           (versions.size() > 1 ? std::to_string(versions.size()) + " protocols"
                                                : std::to_string(choices.size()) + " versions of " +
                                                      versions.begin()->first) +
                           ": name one with --protocol, " + said);
}

/// The outcomes that `--protocol` leaves.
std::vector<AnalysisOutcome> outcomes_beside(const Study& study, const SweepOptions& options) {
  const std::optional<NamedProtocol> named = named_protocol(options.protocol);
  std::vector<AnalysisOutcome> outcomes =
      analyze_study(study, named ? std::optional(named->name) : std::nullopt);
  if (named && named->version) {
    std::set<std::string> versions{};
    for (const AnalysisOutcome& outcome : outcomes) versions.insert(outcome.version);
    std::erase_if(outcomes, [&named](const AnalysisOutcome& outcome) {
      return outcome.version != *named->version;
    });
    if (outcomes.empty()) {
      std::string said{};
      for (const std::string& version : versions) said += (said.empty() ? "" : ", ") + version;
      throw std::runtime_error("the study " + options.beside + " has no session of " + named->name +
                               " of the version " + *named->version + "; it has " + said);
    }
  }
  require_one_protocol(options.beside, outcomes);
  return outcomes;
}

Protocol protocol_of(const Study& study, const AnalysisOutcome& outcome,
                     const ModelRegistry& models) {
  const ProtocolRow* found = nullptr;
  const std::vector<ProtocolRow> rows = study.protocols();
  std::size_t alike = 0;
  for (const ProtocolRow& row : rows) {
    if (row.name != outcome.protocol || row.version != outcome.version) continue;
    if (found == nullptr) found = &row;
    ++alike;
  }
  if (found == nullptr) {
    throw std::runtime_error("the study does not contain the protocol " + outcome.protocol + ' ' +
                             outcome.version + "; run asperity verify");
  }
  if (alike > 1) {
    say("asperity: warning: " + std::to_string(alike) + " different protocol files are named " +
        outcome.protocol + ' ' + outcome.version +
        ", and their responses are counted together; the sweep is compared with the first of them");
  }
  return read_protocol(found->source, found->name, declarations_of(models));
}

/// The first estimates of roughness in the order of `analyze`: of people before others.
StudyBeside study_beside(const SweepOptions& options, const ModelRegistry& models) {
  const Study study = Study::open(options.beside, Access::read_only);
  for (const AnalysisOutcome& outcome : outcomes_beside(study, options)) {
    for (Figure& figure : figures_of(outcome)) {
      if (figure.name != "roughness") continue;
      if (!figure.is_drawn()) throw std::runtime_error(figure.instead.english());
      const SweepBeside beside =
          sweep_beside(options.order, protocol_of(study, outcome, models), study.folder());
      require_estimates(figure, beside.conditions);
      say("estimates in the figure: " + outcome.protocol + " " + outcome.version + ", " +
          text_of(outcome.group) + ", " + counted(outcome.answers, "answer"));
      for (const std::string& remark : beside.remarks) {
        say("asperity: warning: " + remark);
      }
      return {
          .estimates = std::move(figure), .conditions = beside.conditions, .group = outcome.group};
    }
  }
  throw std::runtime_error(
      "the study " + options.beside +
      " has no estimates of roughness; name another study, or leave out --beside");
}
#endif

int run_sweep(SweepOptions options) {
  const ModelRegistry models = built_in_models();
  const ForceModel& model = model_named(models, options.model);
  SweepOrder& order = options.order;
  order.stroke.model = &model;
  order.stroke.parameters =
      parameters_from(options.parameters, model.declaration.parameters, options.model);
  order.stroke.hand = hand_of(options.hand);
  order.values =
      options.values.empty() ? usual_values(order.varied) : values_of(order.varied, options.values);
  order.spacings_m = spacings_of(options.spacings);
  take_texture(order, options.texture);
  if (options.tool) take_tip(order, *options.tool);
  take_level(order, VariedQuantity::probe_diameter, "--probe-diameter-m", options.probe_diameter_m,
             order.stroke.tip.diameter_m);
  take_level(order, VariedQuantity::applied_force, "--applied-force-n", options.applied_force_N,
             order.stroke.force_N);
  take_level(order, VariedQuantity::exploratory_speed, "--exploratory-speed-m-per-s",
             options.exploratory_speed_m_per_s, order.stroke.speed_m_per_s);
  const SweepFile file{
      .out = options.out,
      .overwrite = options.force ? Overwrite::allow : Overwrite::refuse,
      .jobs = options.jobs > 0
                  ? options.jobs
                  : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))};
#ifdef ASPERITY_WITH_WINDOWS
  const std::filesystem::path plot = options.plot;
  if (!plot.empty()) {
    try {
      require_figure_ending(plot);
    } catch (const std::invalid_argument& error) {
      throw WrongUsage(std::string("--plot: ") + error.what());
    }
    refuse_existing({plot}, file.overwrite);
    if (plot.has_parent_path() && !std::filesystem::is_directory(plot.parent_path())) {
      throw std::runtime_error("--plot " + options.plot + ": there is no folder " +
                               plot.parent_path().string() + "; create it first");
    }
  }
  std::optional<StudyBeside> beside{};
  if (!options.beside.empty()) {
    require_sweep(order);
    beside = study_beside(options, models);
  }
#endif
  Sweep sweep{};
  {
    const InterruptWatch interrupt("stopping; complete rows are kept");
    Progress progress("sweeping");
    sweep = sweep_into_file(order, file, interrupt.token(),
                            [&progress](double fraction) { progress.show(fraction); });
  }
  const std::size_t asked = order.values.size() * order.spacings_m.size();
  if (!sweep.is_complete) {
    say(sweep.rows.empty()
            ? "asperity: stopped before the first row"
            : "asperity: stopped; " + options.out + " holds " + std::to_string(sweep.rows.size()) +
                  " of " + std::to_string(asked) + " rows; repeat the command to continue");
    return 1;
  }
  std::cout << options.out << ": " << counted(sweep.rows.size(), "row") << ", "
            << text_of(order.stroke.mode) << ", " << text_of(options.measure) << '\n'
            << aligned(summary_table(sweep, options.measure));
  say_what_has_no_effect(sweep);
  say_why_absent(sweep, options.measure);
#ifdef ASPERITY_WITH_WINDOWS
  if (!plot.empty()) {
    const LettersWithoutWindows letters;
    const Figure figure =
        beside ? beside_prediction(of_group(std::move(beside->estimates), beside->group), sweep,
                                   beside->conditions, options.measure)
               : sweep_figure(sweep, options.measure);
    write_figure(plot, figure, {}, file.overwrite);
  }
#endif
  return 0;
}

}  // namespace

void add_sweep(CLI::App& program, Job& job) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = program.add_subcommand(
      "sweep",
      "Predict roughness over texture spacing, by probe diameter, applied force or speed.");
  command->add_option("--model", options->model, "A force model; see: asperity models")->required();
  command->add_option("--param", options->parameters, "Parameter of the model, NAME=VALUE");
  const std::map<std::string, VariedQuantity> varied{
      {"probe_diameter", VariedQuantity::probe_diameter},
      {"applied_force", VariedQuantity::applied_force},
      {"exploratory_speed", VariedQuantity::exploratory_speed}};
  command
      ->add_option("--vary", options->order.varied,
                   "Quantity that is varied, with one curve for each value")
      ->required()
      ->transform(word_of(varied))
      ->option_text("probe_diameter|applied_force|exploratory_speed REQUIRED");
  command->add_option(
      "--values", options->values,
      "Values of that quantity, V,V,…, in m, N or m/s (default: three typical values)");
  command
      ->add_option("--spacings", options->spacings,
                   "Spacings of the texture, FROM:TO:COUNT in metres, logarithmically spaced")
      ->capture_default_str();
  command
      ->add_option("--texture", options->texture,
                   "Texture: KIND[,NAME=VALUE…] of asperity synth, or FILE.png, a height field "
                   "that is stretched to each spacing")
      ->capture_default_str();
  command->add_option("--tool", options->tool,
                      "For a model with two bodies: sphere (the default), disc (upright, along the "
                      "stroke), point, or the file of a textured mesh");
  const std::map<std::string, DragMode> modes{{"constant_height", DragMode::constant_height},
                                              {"constant_force", DragMode::constant_force}};
  command
      ->add_option("--drag", options->order.stroke.mode,
                   "constant_height (the default): at the height of the given mean normal force; "
                   "constant_force: pressed with the given force")
      ->transform(word_of(modes))
      ->option_text("constant_height|constant_force");
  command->add_option("--hand", options->hand, "M_kg,B_N_s_per_m,K_N_per_m")->capture_default_str();
  command
      ->add_option("--stiffness-n-per-m", options->order.stroke.material.stiffness_N_per_m,
                   "Stiffness of the surface, N/m")
      ->capture_default_str();
  command
      ->add_option("--friction", options->order.stroke.material.friction,
                   "Coulomb friction coefficient of the surface")
      ->capture_default_str();
  command
      ->add_option("--probe-diameter-m", options->probe_diameter_m,
                   "Probe diameter, unless --vary varies it")
      ->default_str(number_text(options->order.stroke.tip.diameter_m));
  command
      ->add_option("--applied-force-n", options->applied_force_N,
                   "Applied force, unless --vary varies it")
      ->default_str(number_text(options->order.stroke.force_N));
  command
      ->add_option("--exploratory-speed-m-per-s", options->exploratory_speed_m_per_s,
                   "Exploratory speed, unless --vary varies it")
      ->default_str(number_text(options->order.stroke.speed_m_per_s));
  command
      ->add_option("--jobs", options->jobs,
                   "Number of spacings computed in parallel (default: one for each processor); "
                   "does not affect the result")
      ->check(number_within(1, 256));
  command
      ->add_option("--out", options->out,
                   "Table of the results, one row per spacing and level (TSV)")
      ->required();
  std::map<std::string, SweepMeasure> measures{};
  for (const SweepMeasure measure :
       {SweepMeasure::max_accel, SweepMeasure::rms_accel, SweepMeasure::fa1, SweepMeasure::fa2,
        SweepMeasure::pacinian}) {
    measures[text_of(measure)] = measure;
  }
  command
      ->add_option(
          "--measure", options->measure,
          "Measure of the printed peaks and of the figure: the maximum acceleration (the default), "
          "its RMS, the power in a band, or the power above the vibrotactile threshold")
      ->transform(word_of(measures))
      ->option_text("max_accel|rms_accel|fa1|fa2|pacinian");
#ifdef ASPERITY_WITH_WINDOWS
  auto* plot = command->add_option("--plot", options->plot,
                                   "Also write a figure of that measure, .svg, .png or .pdf");
  auto* beside = command
                     ->add_option("--beside", options->beside,
                                  "Also show the estimates of the participants of this study in "
                                  "the figure. The sweep needs one level for each condition of the "
                                  "protocol, and the conditions must differ in the varied quantity")
                     ->needs(plot);
  command
      ->add_option("--protocol", options->protocol,
                   "Protocol of that study, NAME[@VERSION]; required if several protocols, or "
                   "several versions of one, request estimates of roughness")
      ->needs(beside);
#endif
  command->add_flag("--force", options->force, "Replace the rows of another sweep");
  command->callback([options, &job] { job = [options] { return run_sweep(*options); }; });
}

}  // namespace asperity

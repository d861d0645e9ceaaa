// Fills the tables of measures and of history from the stored rows, with quantities in the units of windows.

#include "app/gui/data/attempt_tables.h"

#include <QtWidgets/QHeaderView>

#include "analysis/numbers/number_text.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/data/attempt_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/outcome_words.h"
#include "app/gui/look/words.h"
#include "app/study_files/parameter_json.h"
#include "renderers/force/layers.h"

namespace asperity {

namespace {

using CellAlign = StudyTable::Align;

QStandardItem* decimal_cell(const std::optional<double>& value, int decimals, double scale = 1.0) {
  if (!value) return empty_number_cell();
  return number_cell(shown_number(*value * scale, 'f', decimals), *value);
}

QStandardItem* state_cell(State state, const QString& words) {
  QStandardItem* cell = text_cell(shape_of(state) + ' ' + words, words);
  cell->setForeground(color_of(state));
  return cell;
}

/// How a quantity of the compliance is shown: its words, and what it is multiplied with.
struct CheckedQuantity {
  QString name{};
  double scale = 1.0;
  int decimals = 2;
};

CheckedQuantity quantity_of(const std::string& name) {
  if (name == "normal_force_N") return {MeasureTables::tr("normal force, N"), 1.0, 2};
  if (name == "speed_m_per_s") return {MeasureTables::tr("speed, mm/s"), 1e3, 0};
  if (name == "contact_s") return {MeasureTables::tr("contact, s"), 1.0, 2};
  if (name == "strokes") return {MeasureTables::tr("strokes"), 1.0, 0};
  if (name == "stroke_length_m") return {MeasureTables::tr("stroke length, mm"), 1e3, 1};
  return {text(name), 1.0, 3};
}

QString asked_of(const ComplianceRow& row, const CheckedQuantity& quantity) {
  const auto number = [&quantity](double value) {
    return shown_number(value * quantity.scale, 'g', 4);
  };
  if (row.minimum && row.maximum) {
    return MeasureTables::tr("%1 to %2").arg(number(*row.minimum), number(*row.maximum));
  }
  if (row.minimum) return MeasureTables::tr("%1 or more").arg(number(*row.minimum));
  if (row.maximum) return MeasureTables::tr("%1 or less").arg(number(*row.maximum));
  return MeasureTables::tr("none");
}

QStandardItem* passed_cell(const std::optional<bool>& passed) {
  if (!passed) return state_cell(State::unknown, MeasureTables::tr("not assessed"));
  return *passed ? state_cell(State::fine, MeasureTables::tr("met"))
                 : state_cell(State::stop, MeasureTables::tr("not met"));
}

/// "wood, brick": a list of words, as it is stored.
QString words_of_list(const std::string& json) {
  QString list = text(json);
  for (const char sign : {'[', ']', '"'}) list.remove(sign);
  return list.replace(",", ", ").simplified();
}

/// "amplitude 1.2, …": an object of numbers, as it is stored.
QString words_of_object(const std::string& json) {
  QString list = text(json);
  for (const char sign : {'{', '}', '"'}) list.remove(sign);
  return list.replace(",", ", ").replace(":", " ").simplified();
}

struct LoopRow {
  QString name{};
  QString value{};
  State state = State::unknown;
};

std::vector<LoopRow> loop_rows(const ServoQualityRow& servo) {
  const auto us = [](double time_s) {
    return MeasureTables::tr("%1 µs").arg(shown_number(time_s * 1e6, 'f', 0));
  };
  const auto count = [](std::int64_t ticks) { return QString::number(ticks); };
  const auto none = [](std::int64_t ticks) { return ticks == 0 ? State::fine : State::look; };
  const auto lost = [](std::int64_t records) { return records == 0 ? State::fine : State::stop; };
  return {
      {MeasureTables::tr("ticks, at %1 Hz").arg(shown_number(servo.rate_Hz, 'f', 0)),
       count(servo.ticks)},
      {MeasureTables::tr("period: mean"), us(servo.period_mean_s)},
      {MeasureTables::tr("period: 99th percentile"), us(servo.period_p99_s)},
      {MeasureTables::tr("period: maximum"), us(servo.period_maximum_s)},
      {MeasureTables::tr("lateness: 99th percentile"), us(servo.lateness_p99_s)},
      {MeasureTables::tr("lateness: maximum"), us(servo.lateness_maximum_s)},
      // Judged in contact alone.
      {MeasureTables::tr("missed deadlines"), count(servo.missed_deadlines)},
      {MeasureTables::tr("missed deadlines in contact"), count(servo.missed_in_contact),
       none(servo.missed_in_contact)},
      {MeasureTables::tr("gaps between ticks in contact"), count(servo.gaps_in_contact),
       none(servo.gaps_in_contact)},
      {MeasureTables::tr("readings replaced as implausible"), count(servo.held_readings),
       none(servo.held_readings)},
      {MeasureTables::tr("ticks missing from the recording"), count(servo.lost_records),
       lost(servo.lost_records)},
      {MeasureTables::tr("ticks with the force at its limit"), count(servo.saturated_ticks),
       none(servo.saturated_ticks)},
      {MeasureTables::tr("ticks with the growth of the force limited"),
       count(servo.slew_limited_ticks), none(servo.slew_limited_ticks)},
      {MeasureTables::tr("ticks without a finite force"), count(servo.not_finite_ticks),
       none(servo.not_finite_ticks)},
      {MeasureTables::tr("fault"), OutcomeWords::of_fault(servo.fault),
       servo.fault == "none" ? State::fine : State::stop},
  };
}

/// What a force model counts ("Counted conditions" of its page in docs/models), in words.
QString limit_words(const std::string& kind) {
  if (kind == "contact") return MeasureTables::tr("a surface was touched");
  if (kind == "folded") {
    return MeasureTables::tr(
        "viewed along the contact normal, a surface folded over itself; part of it was omitted");
  }
  if (kind == "window_border") {
    return MeasureTables::tr("the deepest point lay at the border of the region searched");
  }
  if (kind == "fine_detail") {
    return MeasureTables::tr(
        "the shortest wavelength of the texture was shorter than eight samples");
  }
  if (kind == "fast") {
    return MeasureTables::tr(
        "the tool moved by more than half of the shortest wavelength in one tick");
  }
  if (kind == "coarse_window") {
    return MeasureTables::tr("a contact was too wide for the requested step");
  }
  if (kind == "left_out") {
    return MeasureTables::tr("there were more contacts than the model supports; some were omitted");
  }
  if (kind == "kept") return MeasureTables::tr("a contact persisted although nothing intersected");
  if (kind == "wholly_inside") {
    return MeasureTables::tr(
        "the tool lay completely inside the surface, where no force is rendered");
  }
  if (kind == "too_deep") {
    return MeasureTables::tr(
        "a contact was deeper than the bodies are thick, or steeper than 60°, and was limited");
  }
  if (kind == "no_compute") {
    return MeasureTables::tr(
        "the compute device had no answer in time, and the processor evaluated the contacts");
  }
  if (kind == "unfinished") {
    return MeasureTables::tr("the contact changed faster than its computation followed");
  }
  if (kind == "cell_border") {
    return MeasureTables::tr("the contact was wider than the region that is computed");
  }
  if (kind == "large_strain") {
    return MeasureTables::tr("the tip was pressed in too deep for the law of small strains");
  }
  if (kind == "plugin_error") return MeasureTables::tr("the plug-in reported an error");
  if (kind == "plugin_not_valid") {
    return MeasureTables::tr(
        "the plug-in returned a number that is not finite, or a negative force or depth");
  }
  return text(kind).replace('_', ' ');
}

}  // namespace

MeasureTables::MeasureTables(QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QWidget(this);
  auto* rows = new QVBoxLayout(page);
  rows->setContentsMargins(0, kMargin, kMargin, kMargin);
  rows->setSpacing(kGrid);
  const auto add = [&](const QString& heading, const char* name,
                       const std::vector<StudyTable::Column>& columns) {
    QLabel* words = make_heading(heading, page);
    words->setObjectName(QString(name) + "_heading");
    rows->addWidget(words);
    auto* table = new StudyTable(columns, page);
    table->setObjectName(name);
    table->wrap_texts();
    table->grow_with_rows();
    rows->addWidget(table);
    rows->addSpacing(kMargin);
    return table;
  };
  answers_ = add(tr("Responses"), "attempt_answers",
                 {{tr("Item"), 64, CellAlign::number},
                  {tr("Question"), 0, CellAlign::text},
                  {tr("Response"), 0, CellAlign::text},
                  {tr("Correct"), 88, CellAlign::text},
                  {tr("Options"), 0, CellAlign::text},
                  {AttemptWords::after_contact(), 152, CellAlign::number},
                  {AttemptWords::after_cue(), 120, CellAlign::number},
                  {tr("Given by"), 136, CellAlign::text}});
  answers_->model()->setHeaderData(4, Qt::Horizontal,
                                   tr("The options, in the order in which they were shown."),
                                   Qt::ToolTipRole);
  AttemptWords::explain_times(*answers_->model(), 5, 6);
  surfaces_ = add(tr("Surfaces felt"), "attempt_surfaces",
                  {{tr("No."), 64, CellAlign::number},
                   {tr("Role"), 128, CellAlign::text},
                   {tr("Texture"), 112, CellAlign::text},
                   {tr("Model"), 168, CellAlign::text},
                   {tr("Parameters"), 0, CellAlign::text},
                   {tr("Contact, s"), 112, CellAlign::number},
                   {tr("Texture force, N"), 160, CellAlign::number}});
  surfaces_heading_ = page->findChild<QLabel*>("attempt_surfaces_heading");
  compliance_ = add(tr("Exploration: instructed and observed"), "attempt_compliance",
                    {{tr("Surface"), 88, CellAlign::number},
                     {tr("Quantity"), 0, CellAlign::text},
                     {tr("Requested"), 128, CellAlign::text},
                     {tr("Median"), 96, CellAlign::number},
                     {tr("5 %"), 80, CellAlign::number},
                     {tr("95 %"), 80, CellAlign::number},
                     {tr("In band"), 96, CellAlign::number},
                     {tr("Met"), 136, CellAlign::text}});
  instability_ = add(tr("Perceived instability"), "attempt_instability",
                     {{tr("Surface"), 88, CellAlign::number},
                      {tr("Texture"), 0, CellAlign::text},
                      {tr("Vibration"), 128, CellAlign::number},
                      {tr("Force at rest, N"), 160, CellAlign::number},
                      {tr("At crests"), 128, CellAlign::number}});
  const auto explain = [this](int column, const QString& meaning) {
    instability_->model()->setHeaderData(column, Qt::Horizontal, meaning, Qt::ToolTipRole);
  };
  explain(2, tr("Greatest vibration above 150 Hz that the force model does not explain, relative "
                "to the texture force. Values above 0.4 are rare in stable strokes."));
  explain(3, tr("RMS of the force on the resting hand in 2 to 20 Hz."));
  explain(4, tr("Proportion of slow contact near the crests of a grating; 30 % for an even "
                "motion."));
  loop_ = add(tr("Timing of the servo loop"), "attempt_loop",
              {{tr("Measure"), 0, CellAlign::text},
               {tr("Value"), 160, CellAlign::number},
               {tr("Assessment"), 160, CellAlign::text}});
  limits_ = add(tr("Counts of the force model, in ticks"), "attempt_limits",
                {{tr("Surface"), 88, CellAlign::number},
                 {tr("Event"), 0, CellAlign::text},
                 {tr("Ticks"), 160, CellAlign::number},
                 {tr("Assessment"), 160, CellAlign::text}});
  limits_heading_ = page->findChild<QLabel*>("attempt_limits_heading");
  rows->addStretch(1);
  setWidget(page);
}

void MeasureTables::show_attempt(const AttemptDetail& detail) {
  const AttemptRow& attempt = detail.attempt;
  std::vector<StudyTable::Row> rows{};
  const auto add = [&rows](const QList<QStandardItem*>& cells) {
    rows.push_back({QString::number(rows.size()), cells});
  };
  for (const ResponseRow& response : attempt.responses) {
    const QString right = !response.correct ? tr("–") : *response.correct ? tr("yes") : tr("no");
    add({number_cell(response.item), text_cell(text(response.question)),
         text_cell(OutcomeWords::of_response(response.answer)), text_cell(right),
         text_cell(words_of_list(response.options_json)), decimal_cell(response.from_contact_s, 2),
         decimal_cell(response.from_cue_s, 2), text_cell(text(response.source).replace('_', ' '))});
  }
  answers_->fill(rows);
  rows.clear();
  surfaces_heading_->setText(detail.session.state == SessionState::completed
                                 ? tr("Surfaces felt, by name (the session has ended)")
                                 : tr("Surfaces felt, by name"));
  for (const PresentationRow& surface : attempt.presentations) {
    add({number_cell(surface.position), text_cell(text(surface.role)),
         text_cell(text(surface.texture)),
         text_cell(tr("%1 %2").arg(text(surface.model), text(surface.model_version))),
         text_cell(words_of_object(
             json_text_of(without_unused_layers(parameter_values_in(surface.parameters_json))))),
         decimal_cell(surface.contact_s, 2), decimal_cell(surface.achieved_texture_force_N, 4)});
  }
  surfaces_->fill(rows);
  rows.clear();
  for (const ComplianceRow& row : attempt.compliance) {
    const CheckedQuantity quantity = quantity_of(row.quantity);
    add({number_cell(row.position), text_cell(quantity.name), text_cell(asked_of(row, quantity)),
         decimal_cell(row.p50, quantity.decimals, quantity.scale),
         decimal_cell(row.p05, quantity.decimals, quantity.scale),
         decimal_cell(row.p95, quantity.decimals, quantity.scale),
         row.fraction_in_band
             ? number_cell(tr("%1 %").arg(shown_number(100.0 * *row.fraction_in_band, 'f', 0)),
                           *row.fraction_in_band)
             : empty_number_cell(),
         passed_cell(row.passed)});
  }
  compliance_->fill(rows);
  rows.clear();
  for (const PresentationRow& surface : attempt.presentations) {
    if (!surface.instability) continue;
    const InstabilityRow& judged = *surface.instability;
    add({number_cell(surface.position), text_cell(text(surface.texture)),
         decimal_cell(judged.buzz, 2), decimal_cell(judged.alive_force_N, 4),
         judged.crest_share
             ? number_cell(tr("%1 %").arg(shown_number(100.0 * *judged.crest_share, 'f', 0)),
                           *judged.crest_share)
             : empty_number_cell()});
  }
  instability_->fill(rows);
  rows.clear();
  if (attempt.servo) {
    for (const LoopRow& row : loop_rows(*attempt.servo)) {
      // Read from top to bottom: what it was, how regular, what went wrong.
      add({text_cell(row.name, static_cast<int>(rows.size())), number_cell(row.value, 0.0),
           row.state == State::unknown
               ? text_cell({})
               : state_cell(row.state, row.state == State::fine ? tr("fine") : tr("check"))});
    }
  }
  loop_->fill(rows);
  rows.clear();
  for (const PresentationRow& surface : attempt.presentations) {
    for (const ModelLimitRow& limit : surface.limits) {
      // How long there was contact is what the others are a part of.
      const bool is_limit = limit.kind != "contact";
      add({number_cell(surface.position),
           text_cell(limit_words(limit.kind), static_cast<int>(rows.size())),
           number_cell(QString::number(limit.ticks), static_cast<double>(limit.ticks)),
           !is_limit          ? text_cell({})
           : limit.ticks == 0 ? state_cell(State::fine, tr("fine"))
                              : state_cell(State::look, tr("check"))});
    }
  }
  limits_->fill(rows);
  // Most models count nothing.
  limits_->setVisible(!rows.empty());
  limits_heading_->setVisible(!rows.empty());
}

HistoryTables::HistoryTables(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, kMargin, 0, 0);
  rows->setSpacing(kGrid);
  rows->addWidget(make_heading(tr("Decisions about the attempt or its session"), this));
  decisions_ = new StudyTable({{tr("No."), 56, CellAlign::number},
                               {tr("When"), 192, CellAlign::text},
                               {tr("Applies to"), 144, CellAlign::text},
                               {tr("Decision"), 208, CellAlign::text},
                               {tr("Reason"), 0, CellAlign::text},
                               {tr("Decided by"), 160, CellAlign::text}},
                              this);
  decisions_->setObjectName("attempt_decisions");
  rows->addWidget(decisions_, 1);
  rows->addSpacing(kMargin);
  rows->addWidget(make_heading(tr("Events during the attempt"), this));
  events_ = new StudyTable({{tr("Time, s"), 96, CellAlign::number},
                            {tr("Event"), 200, CellAlign::text},
                            {tr("Text"), 0, CellAlign::text}},
                           this);
  events_->setObjectName("attempt_events");
  rows->addWidget(events_, 1);
}

void HistoryTables::show_attempt(const AttemptDetail& detail) {
  std::vector<StudyTable::Row> rows{};
  int number = 0;
  for (const DecisionRow& decision : detail.decisions) {
    ++number;
    rows.push_back({QString::number(number),
                    {number_cell(number),
                     text_cell(text_of_time(decision.decided_utc), text(decision.decided_utc)),
                     text_cell(decision.trial ? tr("this attempt") : tr("the session")),
                     text_cell(AttemptWords::of_verdict(decision.verdict)),
                     text_cell(OutcomeWords::of_reason(decision.reason)),
                     text_cell(text(decision.decided_by))}});
  }
  decisions_->fill(rows);
  rows.clear();
  for (const EventRow& event : detail.attempt.events) {
    const double time_s = static_cast<double>(event.time_ns - detail.attempt.onset_ns) * 1e-9;
    rows.push_back({QString::number(rows.size()),
                    {number_cell(shown_number(time_s, 'f', 2), time_s), text_cell(text(event.kind)),
                     text_cell(OutcomeWords::of_event(event))}});
  }
  events_->fill(rows);
}

}  // namespace asperity

#include "moc_attempt_tables.cpp"

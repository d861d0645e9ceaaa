// What a study with a million attempts is read by: the answers that analyses count, and how far every
// session has come.

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "results_schema/attempt_rows.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

/// Words by their places.
class WordPlaces {
 public:
  explicit WordPlaces(std::vector<std::string>& words) : words_(words) {}
  std::uint32_t place(const std::string& word) {
    const auto [found, is_new] =
        places_.try_emplace(word, static_cast<std::uint32_t>(words_.size()));
    if (is_new) words_.push_back(word);
    return found->second;
  }

 private:
  std::vector<std::string>& words_;
  std::unordered_map<std::string, std::uint32_t> places_{};
};

constexpr const char* kOfSession =
    " WHERE attempt_id IN (SELECT id FROM attempt WHERE session_id = ?1) ";

void read_plan(Database& database, std::int64_t session_id, SessionAnswers& answers,
               WordPlaces& words) {
  // Not those equal to ?: to see where these end SQLite would read every row whole, whose plan is
  // most of a study. The plan is read of anchors only.
  Statement statement(
      database,
      "SELECT session_id, trial, block, phase, factors_json, repetition, "
      "block_ordinal, track, step, is_catch, CASE WHEN repetition = 0 THEN plan_json END "
      "FROM trial WHERE session_id >= ? ORDER BY session_id, trial");
  statement.bind(session_id);
  std::int64_t session = 0;
  std::string block;
  std::string phase;
  std::string factors_json;
  bool is_catch = false;
  std::optional<std::string> plan_json{};
  while (statement.step()) {
    SessionAnswers::Trial trial{};
    statement.read(session, trial.trial, block, phase, factors_json, trial.repetition,
                   trial.block_ordinal, trial.track, trial.step, is_catch, plan_json);
    if (session != session_id) break;
    trial.use = use_in_analyses(phase, trial.repetition, is_catch);
    trial.block = words.place(block);
    trial.factors_json = words.place(factors_json);
    if (plan_json && trial.use == AnalysisUse::anchor) {
      answers.anchor_plans[trial.trial] = std::move(*plan_json);
    }
    answers.trials.push_back(trial);
  }
}

/// A trial that the plan lacks, as in a damaged study, is not analysed.
AnalysisUse use_of_trial(const std::vector<SessionAnswers::Trial>& plan, int trial) {
  const auto found = std::lower_bound(
      plan.begin(), plan.end(), trial,
      [](const SessionAnswers::Trial& planned, int number) { return planned.trial < number; });
  return found == plan.end() || found->trial != trial ? AnalysisUse::practice : found->use;
}

/// Attempts by their ids, and the rows that hang on them as these are read, attempt after attempt.
using Places = std::unordered_map<std::int64_t, SessionAnswers::Attempt*>;

void read_surfaces(Database& database, std::int64_t session_id, SessionAnswers& answers,
                   const Places& attempts, WordPlaces& words) {
  Statement statement(database, std::string("SELECT attempt_id, position, item, model, texture, "
                                            "matched_texture_force_N, achieved_texture_force_N "
                                            "FROM presentation") +
                                    kOfSession + "ORDER BY attempt_id, position");
  statement.bind(session_id);
  std::string item;
  std::string model;
  std::string texture;
  while (statement.step()) {
    std::int64_t id = 0;
    SessionAnswers::Surface surface{};
    statement.read(id, surface.position, item, model, texture, surface.matched_texture_force_N,
                   surface.achieved_texture_force_N);
    surface.item = words.place(item);
    surface.model = words.place(model);
    surface.texture = words.place(texture);
    SessionAnswers::Attempt& attempt = *attempts.at(id);
    if (attempt.surfaces++ == 0) attempt.first_surface = answers.surfaces.size();
    answers.surfaces.push_back(surface);
  }
}

/// Of a row of `compliance`.
struct StoredSummary {
  double mean = 0.0;
  double sd = 0.0;
  double p95 = 0.0;

  /// How a quantity without samples is stored: no hand in contact presses or moves with exactly 0.
  bool has_no_samples() const { return mean == 0.0 && sd == 0.0 && p95 == 0.0; }
};

/// Sets the quantity that the row is about. Contact time and strokes are one number, which is 0 without contact.
void set_quantity(const std::string& quantity, const StoredSummary& summary,
                  SessionAnswers::Exploration& exploration) {
  if (quantity == "contact_s") {
    exploration.contact_s = summary.mean;
  } else if (quantity == "strokes") {
    exploration.strokes = summary.mean;
  } else if (summary.has_no_samples()) {
    return;
  } else if (quantity == "stroke_length_m") {
    exploration.stroke_length_m = summary.mean;
  } else if (quantity == "normal_force_N") {
    exploration.force_N = summary.mean;
    exploration.force_sd_N = summary.sd;
  } else if (quantity == "speed_m_per_s") {
    exploration.speed_m_per_s = summary.mean;
    exploration.speed_sd_m_per_s = summary.sd;
  }
}

/// The exploration of the surface at a position; null for a row without its surface, as in a damaged study.
SessionAnswers::Exploration* exploration_at(SessionAnswers& answers,
                                            const SessionAnswers::Attempt& attempt, int position) {
  for (std::size_t i = 0; i < attempt.surfaces; ++i) {
    const std::size_t place = attempt.first_surface + i;
    if (answers.surfaces[place].position == position) return &answers.explorations[place];
  }
  return nullptr;
}

void read_visits(Database& database, std::int64_t session_id, SessionAnswers& answers,
                 const Places& attempts) {
  Statement statement(database,
                      std::string("SELECT attempt_id, position, count(*), sum(path_m) FROM visit") +
                          kOfSession + "GROUP BY attempt_id, position");
  statement.bind(session_id);
  while (statement.step()) {
    std::int64_t id = 0;
    int position = 0;
    double visits = 0.0;
    double path_m = 0.0;
    statement.read(id, position, visits, path_m);
    const SessionAnswers::Attempt& attempt = *attempts.at(id);
    for (std::size_t i = 0; i < attempt.surfaces; ++i) {
      SessionAnswers::Exploration& one = answers.explorations[attempt.first_surface + i];
      one.visits = one.visits.value_or(0.0);
      one.path_m = one.path_m.value_or(0.0);
    }
    SessionAnswers::Exploration* const visited = exploration_at(answers, attempt, position);
    if (visited == nullptr) continue;
    visited->visits = visits;
    visited->path_m = path_m;
  }
}

/// After `read_surfaces`.
void read_explorations(Database& database, std::int64_t session_id, SessionAnswers& answers,
                       const Places& attempts) {
  answers.explorations.resize(answers.surfaces.size());
  read_visits(database, session_id, answers, attempts);
  Statement statement(
      database,
      std::string("SELECT attempt_id, position, quantity, mean, sd, p95 FROM compliance") +
          kOfSession);
  statement.bind(session_id);
  std::string quantity;
  while (statement.step()) {
    std::int64_t id = 0;
    int position = 0;
    StoredSummary summary{};
    statement.read(id, position, quantity, summary.mean, summary.sd, summary.p95);
    SessionAnswers::Exploration* const explored =
        exploration_at(answers, *attempts.at(id), position);
    if (explored != nullptr) set_quantity(quantity, summary, *explored);
  }
}

void read_replies(Database& database, std::int64_t session_id, SessionAnswers& answers,
                  const Places& attempts, WordPlaces& words) {
  Statement statement(database,
                      std::string("SELECT attempt_id, question, item, answer, correct, "
                                  "answer_number, options_json, from_cue_s, source FROM response") +
                          kOfSession + "ORDER BY attempt_id, question, item");
  statement.bind(session_id);
  std::string question;
  std::string answer;
  std::string options_json;
  std::string source;
  while (statement.step()) {
    std::int64_t id = 0;
    SessionAnswers::Reply reply{};
    statement.read(id, question, reply.item, answer, reply.correct, reply.number, options_json,
                   reply.from_cue_s, source);
    reply.was_asked = source != kNotAsked;
    reply.question = words.place(question);
    reply.answer = words.place(answer);
    reply.options_json = words.place(options_json);
    SessionAnswers::Attempt& attempt = *attempts.at(id);
    if (attempt.replies++ == 0) attempt.first_reply = answers.replies.size();
    answers.replies.push_back(reply);
  }
}

/// What is counted of a session while the attempts of all are read in whatever order.
struct Counting {
  SessionCounts counts{};
  std::vector<bool> done{};  ///< by trial
  struct Stretch {
    std::int64_t first_ns = std::numeric_limits<std::int64_t>::max();
    std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();
  };
  std::map<int, Stretch> stretches{};  ///< by segment
};

using SetAside = std::set<std::tuple<std::int64_t, int, int>>;  // session, trial, attempt

SetAside those_set_aside(Database& database) {
  Statement statement(
      database, "SELECT session_id, trial, attempt FROM decision WHERE verdict = 'set_aside'");
  SetAside set_aside{};
  while (statement.step()) {
    std::int64_t session = 0;
    int trial = 0;
    int attempt = 0;
    statement.read(session, trial, attempt);
    set_aside.emplace(session, trial, attempt);
  }
  return set_aside;
}

/// Of all sessions, or of one.
using Which = std::optional<std::int64_t>;

void count_attempts(Database& database, const Which& which,
                    std::map<std::int64_t, Counting>& sessions) {
  const SetAside set_aside = those_set_aside(database);
  Statement statement(database, std::string("SELECT session_id, trial, attempt, segment, "
                                            "purpose = 'trial' AND (valid OR outcome = 'skipped'), "
                                            "onset_ns, offset_ns "
                                            "FROM attempt") +
                                    (which ? " WHERE session_id = ?" : ""));
  if (which) statement.bind(*which);
  std::int64_t last = 0;
  Counting* counting = nullptr;
  while (statement.step()) {
    std::int64_t session = 0;
    int trial = 0;
    int attempt = 0;
    int segment = 0;
    bool does_its_trial = false;
    std::int64_t onset_ns = 0;
    std::int64_t offset_ns = 0;
    statement.read(session, trial, attempt, segment, does_its_trial, onset_ns, offset_ns);
    if (counting == nullptr || session != last) counting = &sessions[session];
    last = session;
    ++counting->counts.attempts;
    Counting::Stretch& stretch = counting->stretches[segment];
    stretch.first_ns = std::min(stretch.first_ns, onset_ns);
    stretch.last_ns = std::max(stretch.last_ns, offset_ns);
    if (!does_its_trial || set_aside.contains({session, trial, attempt})) continue;
    const auto place = static_cast<std::size_t>(trial);
    if (counting->done.size() <= place) counting->done.resize(place + 1);
    if (!counting->done[place]) ++counting->counts.done_trials;
    counting->done[place] = true;
  }
}

void count_notes(Database& database, const Which& which,
                 std::map<std::int64_t, Counting>& sessions) {
  Statement statement(database, std::string("SELECT session_id FROM event WHERE kind = 'note'") +
                                    (which ? " AND session_id = ?" : ""));
  if (which) statement.bind(*which);
  while (statement.step()) {
    std::int64_t session = 0;
    statement.read(session);
    ++sessions[session].counts.notes;
  }
}

std::map<std::int64_t, SessionCounts> counts_in(Database& database, const Which& which) {
  std::map<std::int64_t, Counting> sessions{};
  // Trials are numbered from 1 without gaps: the last one is found without reading the others.
  Statement statement(
      database, std::string("SELECT id, coalesce((SELECT max(trial) FROM trial WHERE session_id = "
                            "session.id), 0), iif(state = 'completed', NULL, expected_trials) "
                            "FROM session") +
                    (which ? " WHERE id = ?" : ""));
  if (which) statement.bind(*which);
  while (statement.step()) {
    std::int64_t id = 0;
    int trials = 0;
    std::optional<int> expected{};
    statement.read(id, trials, expected);
    sessions[id].counts.planned_trials = std::max(trials, expected.value_or(0));
    sessions[id].counts.planned_is_estimated = expected.has_value();
  }
  count_attempts(database, which, sessions);
  count_notes(database, which, sessions);
  std::map<std::int64_t, SessionCounts> counts{};
  for (auto& [id, counting] : sessions) {
    for (const auto& [segment, stretch] : counting.stretches) {
      counting.counts.running_s += static_cast<double>(stretch.last_ns - stretch.first_ns) * 1e-9;
    }
    counts.emplace(id, counting.counts);
  }
  return counts;
}

}  // namespace

SessionAnswers Study::answers(std::int64_t session_id, AnswerParts parts) const {
  return store_->read([session_id, parts](Database& database) {
    SessionAnswers answers{};
    WordPlaces words(answers.words);
    read_plan(database, session_id, answers, words);
    const Attempts attempts = read_bare_attempts(database, "session_id = ?1", session_id);
    answers.attempts.reserve(attempts.rows().size());
    Places places{};
    for (const AttemptRow& row : attempts.rows()) {
      answers.attempts.push_back({.trial = row.trial,
                                  .outcome = row.outcome,
                                  .valid = row.valid,
                                  .excluded = row.excluded.has_value(),
                                  .flagged = row.flagged});
      places.emplace(row.id, &answers.attempts.back());
    }
    read_surfaces(database, session_id, answers, places, words);
    if (parts == AnswerParts::answers_and_exploration) {
      read_explorations(database, session_id, answers, places);
    }
    read_replies(database, session_id, answers, places, words);
    for (const AttemptRow& row : attempts.rows()) {
      SessionAnswers::Attempt& attempt = *places.at(row.id);
      attempt.use = use_in_analyses(
          use_of_trial(answers.trials, row.trial),
          {.valid = row.valid, .answered = attempt.replies > 0, .excluded = attempt.excluded});
    }
    // Those of a trial stand in the order of their attempts already.
    std::stable_sort(answers.attempts.begin(), answers.attempts.end(),
                     [](const auto& a, const auto& b) { return a.trial < b.trial; });
    return answers;
  });
}

std::map<std::int64_t, SessionCounts> Study::session_counts() const {
  return store_->read([](Database& database) { return counts_in(database, std::nullopt); });
}

SessionCounts Study::session_counts(std::int64_t session_id) const {
  return store_->read(
      [session_id](Database& database) { return counts_in(database, session_id)[session_id]; });
}

}  // namespace asperity

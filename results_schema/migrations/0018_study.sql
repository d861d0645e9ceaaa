-- The schema of a study. Columns are named as in results_schema/rows.h; docs/formats/study.md explains them.
-- The rules are in the file and not in the program, so that they apply to every tool that opens it.

CREATE TABLE study (
  id              INTEGER PRIMARY KEY CHECK (id = 1),
  name            TEXT NOT NULL CHECK (name <> ''),
  created_utc     TEXT NOT NULL CHECK (created_utc GLOB '????-??-??T??:??:??*Z'),
  license         TEXT CHECK (license <> ''),
  ethics_approval TEXT CHECK (ethics_approval <> '')
) STRICT;

CREATE TABLE author (
  position INTEGER PRIMARY KEY CHECK (position >= 1),
  name     TEXT NOT NULL UNIQUE CHECK (name <> '')
) STRICT;

-- withdrawn: the data are kept; nothing more is measured, and nothing is used any more.
CREATE TABLE participant (
  id           INTEGER PRIMARY KEY,
  label        TEXT NOT NULL UNIQUE
               CHECK (length(label) BETWEEN 1 AND 32 AND label NOT GLOB '*[^0-9A-Za-z]*'),
  is_virtual   INTEGER NOT NULL CHECK (is_virtual IN (0, 1)),
  age_years    REAL CHECK (age_years BETWEEN 0 AND 130),
  sex          TEXT CHECK (sex IN ('F', 'M', 'X')),
  handedness   TEXT CHECK (handedness IN ('left', 'right', 'ambidextrous')),
  answers_json TEXT NOT NULL CHECK (json_valid(answers_json)),
  created_utc  TEXT NOT NULL CHECK (created_utc GLOB '????-??-??T??:??:??*Z'),
  withdrawn    INTEGER NOT NULL DEFAULT 0 CHECK (withdrawn IN (0, 1))
) STRICT;

CREATE TABLE protocol (
  id            INTEGER PRIMARY KEY,
  name          TEXT NOT NULL CHECK (name <> ''),
  version       TEXT NOT NULL,
  kind          TEXT NOT NULL,
  design        TEXT NOT NULL,
  source_sha256 TEXT NOT NULL UNIQUE
                CHECK (length(source_sha256) = 64 AND source_sha256 NOT GLOB '*[^0-9a-f]*'),
  source        TEXT NOT NULL
) STRICT;

-- mirrored: the workspace was laid out for the left hand. group_level: the group of the participant, if the protocol has
-- groups: the level of its factor between participants. expected_trials: the estimated length of a plan that grows.
CREATE TABLE session (
  id                 INTEGER PRIMARY KEY,
  participant_id     INTEGER NOT NULL REFERENCES participant,
  session            INTEGER NOT NULL CHECK (session >= 1),
  protocol_id        INTEGER NOT NULL REFERENCES protocol,
  mode               TEXT NOT NULL CHECK (mode IN ('run', 'pilot', 'simulate')),
  state              TEXT NOT NULL CHECK (state IN ('open', 'completed', 'stopped', 'crashed')),
  seed               TEXT NOT NULL CHECK (seed <> '' AND seed NOT GLOB '*[^0-9]*'),
  generator          TEXT NOT NULL,
  counterbalance_row INTEGER NOT NULL CHECK (counterbalance_row >= 0),
  program_version    TEXT NOT NULL,
  program_commit     TEXT NOT NULL,
  program_build      TEXT NOT NULL,
  program_sha256     TEXT NOT NULL
                     CHECK (length(program_sha256) IN (0, 64) AND program_sha256 NOT GLOB '*[^0-9a-f]*'),
  instruction_set    TEXT NOT NULL,
  os                 TEXT NOT NULL,
  device             TEXT NOT NULL,
  device_json        TEXT NOT NULL CHECK (json_valid(device_json)),
  pacing             TEXT NOT NULL CHECK (pacing IN ('stepped', 'real_time')),
  scheduling         TEXT NOT NULL,
  rate_Hz            REAL NOT NULL CHECK (rate_Hz > 0),
  started_utc        TEXT NOT NULL CHECK (started_utc GLOB '????-??-??T??:??:??*Z'),
  clock_zero_ns      INTEGER NOT NULL,
  ended_utc          TEXT CHECK (ended_utc GLOB '????-??-??T??:??:??*Z'),
  consent_version    TEXT,
  consent_utc        TEXT CHECK (consent_utc GLOB '????-??-??T??:??:??*Z'),
  observer_json      TEXT NOT NULL CHECK (json_valid(observer_json)),
  mirrored           INTEGER NOT NULL DEFAULT 0 CHECK (mirrored IN (0, 1)),
  group_level        TEXT CHECK (group_level <> ''),
  expected_trials    INTEGER CHECK (expected_trials >= 1),
  UNIQUE (participant_id, session),
  CHECK ((consent_version IS NULL) = (consent_utc IS NULL)),
  CHECK (state <> 'completed' OR ended_utc IS NOT NULL)
) STRICT;
CREATE INDEX session_protocol ON session (protocol_id);

CREATE TABLE session_file (
  session_id INTEGER NOT NULL REFERENCES session,
  path       TEXT NOT NULL CHECK (path <> ''),
  sha256     TEXT NOT NULL CHECK (length(sha256) = 64 AND sha256 NOT GLOB '*[^0-9a-f]*'),
  bytes      INTEGER NOT NULL CHECK (bytes >= 0),
  PRIMARY KEY (session_id, path)
) STRICT, WITHOUT ROWID;

-- A stretch of uninterrupted running. A program that died leaves ended_ns empty.
CREATE TABLE segment (
  session_id INTEGER NOT NULL REFERENCES session,
  segment    INTEGER NOT NULL CHECK (segment >= 1),
  started_ns INTEGER NOT NULL,
  ended_ns   INTEGER CHECK (ended_ns >= started_ns),
  end_reason TEXT CHECK (end_reason <> ''),
  PRIMARY KEY (session_id, segment),
  CHECK (ended_ns IS NULL OR end_reason IS NOT NULL)
) STRICT, WITHOUT ROWID;

-- What is planned. What happened is in attempt. track and step: the track of a procedure within the run of the block, and
-- the place in it, of a trial whose level a procedure chose from the responses. A catch trial has an easy level at a random
-- place among the trials of a procedure, has repetition 0, and belongs to no track.
CREATE TABLE trial (
  session_id    INTEGER NOT NULL REFERENCES session,
  trial         INTEGER NOT NULL CHECK (trial >= 1),
  block         TEXT NOT NULL,
  block_ordinal INTEGER NOT NULL CHECK (block_ordinal >= 0),
  phase         TEXT NOT NULL,
  repetition    INTEGER NOT NULL CHECK (repetition >= 0),
  factors_json  TEXT NOT NULL CHECK (json_valid(factors_json)),
  plan_json     TEXT NOT NULL CHECK (json_valid(plan_json)),
  track         INTEGER CHECK (track >= 1),
  step          INTEGER CHECK (step >= 1 AND (step IS NULL) = (track IS NULL)),
  is_catch      INTEGER NOT NULL DEFAULT 0,
  PRIMARY KEY (session_id, trial)
) STRICT, WITHOUT ROWID;

-- What happened. A repetition is a new attempt, never an overwritten one. Reasons are codes with arguments in the columns
-- …_json, and the same words in English. Attempts at a practice trial that are made again when an interrupted session is
-- resumed have the purpose 'refresher': they never complete their trial and are never analysed.
CREATE TABLE attempt (
  id                  INTEGER PRIMARY KEY,
  session_id          INTEGER NOT NULL,
  trial               INTEGER NOT NULL,
  attempt             INTEGER NOT NULL CHECK (attempt >= 1),
  segment             INTEGER NOT NULL,
  outcome             TEXT NOT NULL CHECK (outcome IN ('answered', 'timed_out', 'not_compliant', 'aborted',
                                                       'device_fault', 'skipped')),
  valid               INTEGER NOT NULL CHECK (valid IN (0, 1)),
  invalid_reason      TEXT CHECK (invalid_reason <> ''),
  flagged             INTEGER NOT NULL CHECK (flagged IN (0, 1)),
  flag_reason         TEXT CHECK (flag_reason <> ''),
  onset_ns            INTEGER NOT NULL,
  offset_ns           INTEGER NOT NULL CHECK (offset_ns >= onset_ns),
  invalid_reason_json TEXT CHECK (invalid_reason_json IS NULL OR json_valid(invalid_reason_json)),
  flag_reason_json    TEXT CHECK (flag_reason_json IS NULL OR json_valid(flag_reason_json)),
  purpose             TEXT NOT NULL DEFAULT 'trial',
  UNIQUE (session_id, trial, attempt),
  FOREIGN KEY (session_id, trial) REFERENCES trial (session_id, trial),
  FOREIGN KEY (session_id, segment) REFERENCES segment (session_id, segment),
  CHECK ((valid = 1) = (invalid_reason IS NULL)),
  CHECK ((flagged = 0) = (flag_reason IS NULL)),
  CHECK (valid = 0 OR outcome IN ('answered', 'timed_out'))
) STRICT;

-- The material of the surface, and the height of its plane above that of the workspace, can differ between the surfaces of a
-- trial. gaps_in_contact: those of servo_quality before or after which this surface was touched.
CREATE TABLE presentation (
  attempt_id               INTEGER NOT NULL REFERENCES attempt,
  position                 INTEGER NOT NULL CHECK (position >= 1),
  role                     TEXT NOT NULL,
  item                     TEXT NOT NULL,
  stimulus                 TEXT NOT NULL,
  model                    TEXT NOT NULL,
  model_version            TEXT NOT NULL,
  texture                  TEXT NOT NULL,
  parameters_json          TEXT NOT NULL CHECK (json_valid(parameters_json)),
  seed                     TEXT NOT NULL CHECK (seed NOT GLOB '*[^0-9]*'),
  onset_ns                 INTEGER,
  contact_ns               INTEGER CHECK (contact_ns >= onset_ns),
  offset_ns                INTEGER CHECK (offset_ns >= onset_ns),
  contact_s                REAL NOT NULL CHECK (contact_s >= 0),
  matched_texture_force_N  REAL CHECK (matched_texture_force_N >= 0),
  achieved_texture_force_N REAL CHECK (achieved_texture_force_N >= 0),
  stiffness_N_per_m        REAL NOT NULL,
  friction                 REAL NOT NULL,
  raised_m                 REAL NOT NULL,
  gaps_in_contact          INTEGER NOT NULL CHECK (gaps_in_contact >= 0),
  PRIMARY KEY (attempt_id, position)
) STRICT, WITHOUT ROWID;

-- The files from which the stimulus was made, one row each.
CREATE TABLE presentation_asset (
  attempt_id INTEGER NOT NULL,
  position   INTEGER NOT NULL,
  role       TEXT NOT NULL CHECK (role <> '' AND role NOT GLOB '*[^0-9a-z_]*'),
  sha256     TEXT NOT NULL CHECK (length(sha256) = 64 AND sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (attempt_id, position, role),
  FOREIGN KEY (attempt_id, position) REFERENCES presentation (attempt_id, position)
) STRICT, WITHOUT ROWID;

-- One row for each kind of limit that the force model watches, whether or not it was exceeded.
CREATE TABLE model_limit (
  attempt_id INTEGER NOT NULL,
  position   INTEGER NOT NULL,
  kind       TEXT NOT NULL CHECK (kind <> ''),
  ticks      INTEGER NOT NULL CHECK (ticks >= 0),
  PRIMARY KEY (attempt_id, position, kind),
  FOREIGN KEY (attempt_id, position) REFERENCES presentation (attempt_id, position)
) STRICT, WITHOUT ROWID;

-- The visits of the hand to each surface.
CREATE TABLE visit (
  attempt_id           INTEGER NOT NULL,
  position             INTEGER NOT NULL,
  visit                INTEGER NOT NULL CHECK (visit >= 1),
  contact_ns           INTEGER NOT NULL,
  offset_ns            INTEGER NOT NULL CHECK (offset_ns >= contact_ns),
  contact_s            REAL NOT NULL CHECK (contact_s > 0),
  path_m               REAL NOT NULL CHECK (path_m >= 0),
  force_mean_N         REAL,
  force_sd_N           REAL CHECK (force_sd_N >= 0 AND (force_sd_N IS NULL) = (force_mean_N IS NULL)),
  speed_mean_m_per_s   REAL NOT NULL CHECK (speed_mean_m_per_s >= 0),
  speed_sd_m_per_s     REAL NOT NULL CHECK (speed_sd_m_per_s >= 0),
  PRIMARY KEY (attempt_id, position, visit),
  FOREIGN KEY (attempt_id, position) REFERENCES presentation (attempt_id, position)
) STRICT, WITHOUT ROWID;

-- The detectors of perceived instability. A missing row or value is not a value of 0.
CREATE TABLE instability (
  attempt_id           INTEGER NOT NULL,
  position             INTEGER NOT NULL,
  buzz                 REAL CHECK (buzz >= 0),
  buzz_force_N         REAL CHECK (buzz_force_N >= 0 AND (buzz_force_N IS NULL) = (buzz IS NULL)),
  buzz_ns              INTEGER CHECK ((buzz_ns IS NULL) = (buzz IS NULL)),
  no_buzz              TEXT CHECK (no_buzz <> '' AND (no_buzz IS NULL) = (buzz IS NOT NULL)),
  resting_s            REAL CHECK (resting_s > 0),
  alive_force_N        REAL CHECK (alive_force_N >= 0 AND (alive_force_N IS NULL) = (resting_s IS NULL)),
  alive_plate_force_N  REAL CHECK (alive_plate_force_N >= 0 AND (alive_plate_force_N IS NULL) = (resting_s IS NULL)),
  alive_motion_m       REAL CHECK (alive_motion_m >= 0 AND (alive_motion_m IS NULL) = (resting_s IS NULL)),
  alive_work_J         REAL,
  no_aliveness         TEXT CHECK (no_aliveness <> '' AND (no_aliveness IS NULL) = (resting_s IS NOT NULL)),
  crest_share          REAL CHECK (crest_share BETWEEN 0 AND 1),
  slow_s               REAL CHECK (slow_s > 0 AND (slow_s IS NULL) = (crest_share IS NULL)),
  no_crest_share       TEXT CHECK (no_crest_share <> '' AND (no_crest_share IS NULL) = (crest_share IS NOT NULL)),
  PRIMARY KEY (attempt_id, position),
  FOREIGN KEY (attempt_id, position) REFERENCES presentation (attempt_id, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE response (
  id             INTEGER PRIMARY KEY,
  attempt_id     INTEGER NOT NULL REFERENCES attempt,
  question       TEXT NOT NULL CHECK (question <> ''),
  item           INTEGER NOT NULL CHECK (item >= 1),
  answer         TEXT NOT NULL,
  answer_number  REAL,
  correct        INTEGER CHECK (correct IN (0, 1)),
  options_json   TEXT NOT NULL CHECK (json_valid(options_json)),
  time_ns        INTEGER NOT NULL,
  from_contact_s REAL CHECK (from_contact_s >= 0),
  from_cue_s     REAL CHECK (from_cue_s >= 0),
  source         TEXT NOT NULL CHECK (source <> ''),
  UNIQUE (attempt_id, question, item)
) STRICT;

-- missed_in_contact, gaps_in_contact: late ticks, and gaps of more than two periods, while a surface was touched. An
-- attempt is judged by them. held_readings: ticks with an implausible reading of the device, replaced by the last one.
CREATE TABLE servo_quality (
  attempt_id          INTEGER PRIMARY KEY REFERENCES attempt,
  rate_Hz             REAL NOT NULL CHECK (rate_Hz > 0),
  ticks               INTEGER NOT NULL CHECK (ticks >= 0),
  period_mean_s       REAL NOT NULL,
  period_sd_s         REAL NOT NULL CHECK (period_sd_s >= 0),
  period_p50_s        REAL NOT NULL,
  period_p99_s        REAL NOT NULL,
  period_p99_9_s      REAL NOT NULL,
  period_maximum_s    REAL NOT NULL,
  lateness_p50_s      REAL NOT NULL,
  lateness_p99_s      REAL NOT NULL,
  lateness_maximum_s  REAL NOT NULL,
  execution_p99_s     REAL NOT NULL,
  execution_maximum_s REAL NOT NULL,
  missed_deadlines    INTEGER NOT NULL CHECK (missed_deadlines >= 0),
  saturated_ticks     INTEGER NOT NULL CHECK (saturated_ticks >= 0),
  slew_limited_ticks  INTEGER NOT NULL CHECK (slew_limited_ticks >= 0),
  not_finite_ticks    INTEGER NOT NULL CHECK (not_finite_ticks >= 0),
  lost_records        INTEGER NOT NULL CHECK (lost_records >= 0),
  fault               TEXT NOT NULL CHECK (fault <> ''),
  missed_in_contact   INTEGER NOT NULL
                      CHECK (missed_in_contact >= 0 AND missed_in_contact <= missed_deadlines),
  gaps_in_contact     INTEGER NOT NULL CHECK (gaps_in_contact >= 0),
  held_readings       INTEGER NOT NULL CHECK (held_readings >= 0 AND held_readings <= ticks)
) STRICT;

CREATE TABLE compliance (
  id               INTEGER PRIMARY KEY,
  attempt_id       INTEGER NOT NULL REFERENCES attempt,
  position         INTEGER NOT NULL CHECK (position >= 0),
  quantity         TEXT NOT NULL CHECK (quantity IN ('normal_force_N', 'speed_m_per_s', 'contact_s',
                                                     'strokes', 'stroke_length_m')),
  minimum          REAL,
  maximum          REAL CHECK (maximum >= minimum),
  mean             REAL NOT NULL,
  sd               REAL NOT NULL CHECK (sd >= 0),
  p05              REAL NOT NULL,
  p50              REAL NOT NULL,
  p95              REAL NOT NULL,
  fraction_in_band REAL CHECK (fraction_in_band BETWEEN 0 AND 1),
  passed           INTEGER CHECK (passed IN (0, 1)),
  UNIQUE (attempt_id, position, quantity)
) STRICT;

CREATE TABLE recording (
  attempt_id INTEGER PRIMARY KEY REFERENCES attempt,
  path       TEXT NOT NULL UNIQUE CHECK (path <> ''),
  format     TEXT NOT NULL,
  sha256     TEXT NOT NULL CHECK (length(sha256) = 64 AND sha256 NOT GLOB '*[^0-9a-f]*'),
  records    INTEGER NOT NULL CHECK (records >= 0),
  bytes      INTEGER NOT NULL CHECK (bytes > 0)
) STRICT;

CREATE TABLE session_answer (
  id             INTEGER PRIMARY KEY,
  session_id     INTEGER NOT NULL REFERENCES session,
  question       TEXT NOT NULL CHECK (question <> ''),
  item           INTEGER NOT NULL CHECK (item >= 1),
  answer         TEXT NOT NULL,
  answer_number  REAL,
  correct        INTEGER CHECK (correct IN (0, 1)),
  options_json   TEXT NOT NULL CHECK (json_valid(options_json)),
  time_ns        INTEGER NOT NULL,
  from_contact_s REAL CHECK (from_contact_s >= 0),
  from_cue_s     REAL CHECK (from_cue_s >= 0),
  source         TEXT NOT NULL CHECK (source <> ''),
  UNIQUE (session_id, question, item)
) STRICT;

-- attempt_id is empty in what belongs to the session as a whole; text_json if the text is a name or data.
CREATE TABLE event (
  id         INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES session,
  attempt_id INTEGER REFERENCES attempt,
  time_ns    INTEGER NOT NULL,
  kind       TEXT NOT NULL CHECK (kind <> ''),
  text       TEXT NOT NULL,
  data_json  TEXT NOT NULL CHECK (json_valid(data_json)),
  text_json  TEXT CHECK (text_json IS NULL OR json_valid(text_json))
) STRICT;
CREATE INDEX event_session ON event (session_id);
CREATE INDEX event_attempt ON event (attempt_id);

-- Decisions about data that stay unchanged. trial and attempt are both empty in a decision about the whole session.
-- set_aside is final; of exclude and include the latest holds.
CREATE TABLE decision (
  id          INTEGER PRIMARY KEY,
  session_id  INTEGER NOT NULL REFERENCES session,
  trial       INTEGER,
  attempt     INTEGER,
  verdict     TEXT NOT NULL CHECK (verdict IN ('set_aside', 'flag', 'exclude', 'include')),
  reason      TEXT NOT NULL CHECK (reason <> ''),
  decided_by  TEXT NOT NULL,
  decided_utc TEXT NOT NULL CHECK (decided_utc GLOB '????-??-??T??:??:??*Z'),
  reason_json TEXT CHECK (reason_json IS NULL OR json_valid(reason_json)),
  CHECK ((trial IS NULL) = (attempt IS NULL)),
  CHECK (trial IS NOT NULL OR verdict IN ('exclude', 'include'))
) STRICT;
CREATE INDEX decision_attempt ON decision (session_id, trial, attempt);

-- What left the study and may contain data of participants, listed before the first row is read for it. made_utc is empty
-- until it is complete; path is empty where it contained the label of a participant whose data were deleted.
CREATE TABLE output (
  id              INTEGER PRIMARY KEY,
  kind            TEXT NOT NULL CHECK (kind <> '' AND kind NOT GLOB '*[^a-z_]*'),
  path            TEXT NOT NULL,
  program_version TEXT NOT NULL,
  made_utc        TEXT CHECK (made_utc GLOB '????-??-??T??:??:??*Z')
) STRICT;

-- That a participant withdrew, without stating which: of those whose data were deleted nothing else remains. label: of a
-- deletion that is not complete.
CREATE TABLE withdrawal (
  id            INTEGER PRIMARY KEY,
  data          TEXT NOT NULL CHECK (data IN ('kept', 'deleted')),
  is_virtual    INTEGER NOT NULL CHECK (is_virtual IN (0, 1)),
  reason        TEXT NOT NULL CHECK (reason <> '' AND reason NOT GLOB '*[^a-z_]*'),
  decided_by    TEXT NOT NULL CHECK (decided_by <> ''),
  withdrawn_utc TEXT NOT NULL CHECK (withdrawn_utc GLOB '????-??-??T??:??:??*Z'),
  sessions      INTEGER NOT NULL CHECK (sessions >= 0),
  attempts      INTEGER NOT NULL CHECK (attempts >= 0),
  answers       INTEGER NOT NULL CHECK (answers >= 0),
  recordings    INTEGER NOT NULL CHECK (recordings >= 0),
  label         TEXT CHECK (label IS NULL OR (data = 'deleted' AND length(label) BETWEEN 1 AND 32
                                              AND label NOT GLOB '*[^0-9A-Za-z]*')),
  -- Whose data are kept: a later deletion of them deletes this row, so that a participant is counted once.
  participant_id INTEGER UNIQUE REFERENCES participant (id) CHECK ((data = 'kept') = (participant_id IS NOT NULL))
) STRICT;

-- A cache of solved matching problems; what an attempt used is in its presentation.
CREATE TABLE solution (
  key           TEXT PRIMARY KEY,
  solution_json TEXT NOT NULL CHECK (json_valid(solution_json))
) STRICT, WITHOUT ROWID;

-- Append-only. INSERT OR REPLACE deletes without firing DELETE triggers unless recursive_triggers is on, which another tool
-- will not have set: the refusal must also apply to INSERT.

CREATE TRIGGER protocol_no_update BEFORE UPDATE ON protocol
BEGIN SELECT RAISE(ABORT, 'a protocol is append-only'); END;
CREATE TRIGGER protocol_no_delete BEFORE DELETE ON protocol
BEGIN SELECT RAISE(ABORT, 'a protocol is append-only'); END;
CREATE TRIGGER protocol_no_replace BEFORE INSERT ON protocol
WHEN EXISTS (SELECT 1 FROM protocol WHERE id = NEW.id OR source_sha256 = NEW.source_sha256)
BEGIN SELECT RAISE(ABORT, 'a protocol is append-only'); END;

CREATE TRIGGER session_file_no_update BEFORE UPDATE ON session_file
BEGIN SELECT RAISE(ABORT, 'a session_file is append-only'); END;
CREATE TRIGGER session_file_no_delete BEFORE DELETE ON session_file
BEGIN SELECT RAISE(ABORT, 'a session_file is append-only'); END;
CREATE TRIGGER session_file_no_replace BEFORE INSERT ON session_file
WHEN EXISTS (SELECT 1 FROM session_file WHERE session_id = NEW.session_id AND path = NEW.path)
BEGIN SELECT RAISE(ABORT, 'a session_file is append-only'); END;

CREATE TRIGGER trial_no_update BEFORE UPDATE ON trial
BEGIN SELECT RAISE(ABORT, 'a trial is append-only'); END;
CREATE TRIGGER trial_no_delete BEFORE DELETE ON trial
BEGIN SELECT RAISE(ABORT, 'a trial is append-only'); END;
CREATE TRIGGER trial_no_replace BEFORE INSERT ON trial
WHEN EXISTS (SELECT 1 FROM trial WHERE session_id = NEW.session_id AND trial = NEW.trial)
BEGIN SELECT RAISE(ABORT, 'a trial is append-only'); END;

-- A trial has one valid attempt, apart from those that were set aside and from refreshers.
CREATE TRIGGER attempt_no_update BEFORE UPDATE ON attempt
BEGIN SELECT RAISE(ABORT, 'an attempt is append-only'); END;
CREATE TRIGGER attempt_no_delete BEFORE DELETE ON attempt
BEGIN SELECT RAISE(ABORT, 'an attempt is append-only'); END;
CREATE TRIGGER attempt_no_replace BEFORE INSERT ON attempt
WHEN EXISTS (SELECT 1 FROM attempt WHERE id = NEW.id
             OR (session_id = NEW.session_id AND trial = NEW.trial
                 AND (attempt = NEW.attempt
                      OR (NEW.valid = 1 AND valid = 1
                          AND NEW.purpose = 'trial' AND purpose = 'trial' AND NOT EXISTS (
                            SELECT 1 FROM decision WHERE decision.session_id = NEW.session_id
                            AND decision.trial = NEW.trial AND decision.attempt = attempt.attempt
                            AND verdict = 'set_aside')))))
BEGIN SELECT RAISE(ABORT, 'an attempt is append-only, and a trial has one valid attempt'); END;

CREATE TRIGGER presentation_no_update BEFORE UPDATE ON presentation
BEGIN SELECT RAISE(ABORT, 'a presentation is append-only'); END;
CREATE TRIGGER presentation_no_delete BEFORE DELETE ON presentation
BEGIN SELECT RAISE(ABORT, 'a presentation is append-only'); END;
CREATE TRIGGER presentation_no_replace BEFORE INSERT ON presentation
WHEN EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'a presentation is append-only'); END;

CREATE TRIGGER presentation_asset_no_update BEFORE UPDATE ON presentation_asset
BEGIN SELECT RAISE(ABORT, 'a presentation_asset is append-only'); END;
CREATE TRIGGER presentation_asset_no_delete BEFORE DELETE ON presentation_asset
BEGIN SELECT RAISE(ABORT, 'a presentation_asset is append-only'); END;
CREATE TRIGGER presentation_asset_no_replace BEFORE INSERT ON presentation_asset
WHEN EXISTS (SELECT 1 FROM presentation_asset WHERE attempt_id = NEW.attempt_id AND position = NEW.position
                                                AND role = NEW.role)
BEGIN SELECT RAISE(ABORT, 'a presentation_asset is append-only'); END;

CREATE TRIGGER model_limit_no_update BEFORE UPDATE ON model_limit
BEGIN SELECT RAISE(ABORT, 'a model_limit is append-only'); END;
CREATE TRIGGER model_limit_no_delete BEFORE DELETE ON model_limit
BEGIN SELECT RAISE(ABORT, 'a model_limit is append-only'); END;
CREATE TRIGGER model_limit_no_replace BEFORE INSERT ON model_limit
WHEN EXISTS (SELECT 1 FROM model_limit WHERE attempt_id = NEW.attempt_id AND position = NEW.position
                                         AND kind = NEW.kind)
BEGIN SELECT RAISE(ABORT, 'a model_limit is append-only'); END;

CREATE TRIGGER visit_no_update BEFORE UPDATE ON visit
BEGIN SELECT RAISE(ABORT, 'a visit is append-only'); END;
CREATE TRIGGER visit_no_delete BEFORE DELETE ON visit
BEGIN SELECT RAISE(ABORT, 'a visit is append-only'); END;
CREATE TRIGGER visit_no_replace BEFORE INSERT ON visit
WHEN EXISTS (SELECT 1 FROM visit WHERE attempt_id = NEW.attempt_id AND position = NEW.position
                                   AND visit = NEW.visit)
BEGIN SELECT RAISE(ABORT, 'a visit is append-only'); END;

CREATE TRIGGER instability_no_update BEFORE UPDATE ON instability
BEGIN SELECT RAISE(ABORT, 'an instability is append-only'); END;
CREATE TRIGGER instability_no_delete BEFORE DELETE ON instability
BEGIN SELECT RAISE(ABORT, 'an instability is append-only'); END;
CREATE TRIGGER instability_no_replace BEFORE INSERT ON instability
WHEN EXISTS (SELECT 1 FROM instability WHERE attempt_id = NEW.attempt_id AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'an instability is append-only'); END;

CREATE TRIGGER response_no_update BEFORE UPDATE ON response
BEGIN SELECT RAISE(ABORT, 'a response is append-only'); END;
CREATE TRIGGER response_no_delete BEFORE DELETE ON response
BEGIN SELECT RAISE(ABORT, 'a response is append-only'); END;
CREATE TRIGGER response_no_replace BEFORE INSERT ON response
WHEN EXISTS (SELECT 1 FROM response WHERE id = NEW.id
             OR (attempt_id = NEW.attempt_id AND question = NEW.question AND item = NEW.item))
BEGIN SELECT RAISE(ABORT, 'a response is append-only'); END;

CREATE TRIGGER servo_quality_no_update BEFORE UPDATE ON servo_quality
BEGIN SELECT RAISE(ABORT, 'a servo_quality is append-only'); END;
CREATE TRIGGER servo_quality_no_delete BEFORE DELETE ON servo_quality
BEGIN SELECT RAISE(ABORT, 'a servo_quality is append-only'); END;
CREATE TRIGGER servo_quality_no_replace BEFORE INSERT ON servo_quality
WHEN EXISTS (SELECT 1 FROM servo_quality WHERE attempt_id = NEW.attempt_id)
BEGIN SELECT RAISE(ABORT, 'a servo_quality is append-only'); END;

CREATE TRIGGER compliance_no_update BEFORE UPDATE ON compliance
BEGIN SELECT RAISE(ABORT, 'a compliance is append-only'); END;
CREATE TRIGGER compliance_no_delete BEFORE DELETE ON compliance
BEGIN SELECT RAISE(ABORT, 'a compliance is append-only'); END;
CREATE TRIGGER compliance_no_replace BEFORE INSERT ON compliance
WHEN EXISTS (SELECT 1 FROM compliance WHERE id = NEW.id
             OR (attempt_id = NEW.attempt_id AND position = NEW.position AND quantity = NEW.quantity))
BEGIN SELECT RAISE(ABORT, 'a compliance is append-only'); END;

CREATE TRIGGER recording_no_update BEFORE UPDATE ON recording
BEGIN SELECT RAISE(ABORT, 'a recording is append-only'); END;
CREATE TRIGGER recording_no_delete BEFORE DELETE ON recording
BEGIN SELECT RAISE(ABORT, 'a recording is append-only'); END;
CREATE TRIGGER recording_no_replace BEFORE INSERT ON recording
WHEN EXISTS (SELECT 1 FROM recording WHERE attempt_id = NEW.attempt_id OR path = NEW.path)
BEGIN SELECT RAISE(ABORT, 'a recording is append-only'); END;

CREATE TRIGGER session_answer_no_update BEFORE UPDATE ON session_answer
BEGIN SELECT RAISE(ABORT, 'a session_answer is append-only'); END;
CREATE TRIGGER session_answer_no_delete BEFORE DELETE ON session_answer
BEGIN SELECT RAISE(ABORT, 'a session_answer is append-only'); END;
CREATE TRIGGER session_answer_no_replace BEFORE INSERT ON session_answer
WHEN EXISTS (SELECT 1 FROM session_answer WHERE id = NEW.id
             OR (session_id = NEW.session_id AND question = NEW.question AND item = NEW.item))
BEGIN SELECT RAISE(ABORT, 'a session_answer is append-only'); END;

CREATE TRIGGER event_no_update BEFORE UPDATE ON event
BEGIN SELECT RAISE(ABORT, 'an event is append-only'); END;
CREATE TRIGGER event_no_delete BEFORE DELETE ON event
BEGIN SELECT RAISE(ABORT, 'an event is append-only'); END;
CREATE TRIGGER event_no_replace BEFORE INSERT ON event
WHEN EXISTS (SELECT 1 FROM event WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'an event is append-only'); END;

CREATE TRIGGER decision_no_update BEFORE UPDATE ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is append-only'); END;
CREATE TRIGGER decision_no_delete BEFORE DELETE ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is append-only'); END;
CREATE TRIGGER decision_no_replace BEFORE INSERT ON decision
WHEN EXISTS (SELECT 1 FROM decision WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'a decision is append-only'); END;

CREATE TRIGGER output_has_a_path BEFORE INSERT ON output
WHEN NEW.path = ''
BEGIN SELECT RAISE(ABORT, 'an output has a path'); END;
CREATE TRIGGER output_no_update BEFORE UPDATE ON output
WHEN NEW.id IS NOT OLD.id OR NEW.kind IS NOT OLD.kind OR NEW.program_version IS NOT OLD.program_version
  OR (NEW.made_utc IS NOT OLD.made_utc AND OLD.made_utc IS NOT NULL)
  OR (NEW.path IS NOT OLD.path AND NOT (NEW.path = '' AND EXISTS (
        SELECT 1 FROM withdrawal WHERE instr(lower(OLD.path), lower(label)) > 0)))
BEGIN SELECT RAISE(ABORT, 'an output is completed once, and only a withdrawal blanks its path'); END;
CREATE TRIGGER output_no_delete BEFORE DELETE ON output
WHEN OLD.made_utc IS NOT NULL
BEGIN SELECT RAISE(ABORT, 'an output is append-only'); END;
CREATE TRIGGER output_no_replace BEFORE INSERT ON output
WHEN EXISTS (SELECT 1 FROM output WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'an output is append-only'); END;

CREATE TRIGGER withdrawal_no_update BEFORE UPDATE ON withdrawal
WHEN OLD.label IS NULL OR NEW.label IS NOT NULL OR NEW.id IS NOT OLD.id OR NEW.data IS NOT OLD.data
  OR NEW.is_virtual IS NOT OLD.is_virtual OR NEW.reason IS NOT OLD.reason
  OR NEW.decided_by IS NOT OLD.decided_by OR NEW.withdrawn_utc IS NOT OLD.withdrawn_utc
  OR NEW.sessions IS NOT OLD.sessions OR NEW.attempts IS NOT OLD.attempts
  OR NEW.answers IS NOT OLD.answers OR NEW.recordings IS NOT OLD.recordings
  OR NEW.participant_id IS NOT OLD.participant_id
BEGIN SELECT RAISE(ABORT, 'of a withdrawal only the label may be blanked'); END;
CREATE TRIGGER withdrawal_no_delete BEFORE DELETE ON withdrawal
BEGIN SELECT RAISE(ABORT, 'a withdrawal is append-only'); END;
CREATE TRIGGER withdrawal_no_replace BEFORE INSERT ON withdrawal
WHEN EXISTS (SELECT 1 FROM withdrawal WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'a withdrawal is append-only'); END;

-- Of a participant, a session and a segment only the named columns may change later.

CREATE TRIGGER participant_keeps_its_identity BEFORE UPDATE ON participant
WHEN NEW.id IS NOT OLD.id OR NEW.label IS NOT OLD.label OR NEW.is_virtual IS NOT OLD.is_virtual
BEGIN SELECT RAISE(ABORT, 'a participant keeps label and is_virtual for ever'); END;
CREATE TRIGGER participant_stays_withdrawn BEFORE UPDATE ON participant
WHEN OLD.withdrawn = 1 AND NEW.withdrawn = 0
BEGIN SELECT RAISE(ABORT, 'a withdrawal is final'); END;
CREATE TRIGGER participant_no_delete BEFORE DELETE ON participant
WHEN EXISTS (SELECT 1 FROM session WHERE participant_id = OLD.id)
BEGIN SELECT RAISE(ABORT, 'a participant with sessions cannot be removed'); END;
CREATE TRIGGER participant_no_replace BEFORE INSERT ON participant
WHEN EXISTS (SELECT 1 FROM participant WHERE id = NEW.id OR label = NEW.label)
BEGIN SELECT RAISE(ABORT, 'there is a participant of this label'); END;
CREATE TRIGGER participant_is_not_being_deleted BEFORE INSERT ON participant
WHEN EXISTS (SELECT 1 FROM withdrawal WHERE label = NEW.label)
BEGIN SELECT RAISE(ABORT, 'the deletion of the data under this label is not complete'); END;

CREATE TRIGGER session_only_changes_state BEFORE UPDATE ON session
WHEN NEW.id IS NOT OLD.id OR NEW.participant_id IS NOT OLD.participant_id
  OR NEW.session IS NOT OLD.session OR NEW.protocol_id IS NOT OLD.protocol_id
  OR NEW.mode IS NOT OLD.mode OR NEW.seed IS NOT OLD.seed OR NEW.generator IS NOT OLD.generator
  OR NEW.counterbalance_row IS NOT OLD.counterbalance_row
  OR NEW.program_version IS NOT OLD.program_version
  OR NEW.program_commit IS NOT OLD.program_commit OR NEW.program_build IS NOT OLD.program_build
  OR NEW.program_sha256 IS NOT OLD.program_sha256
  OR NEW.instruction_set IS NOT OLD.instruction_set OR NEW.os IS NOT OLD.os
  OR NEW.device IS NOT OLD.device OR NEW.device_json IS NOT OLD.device_json
  OR NEW.pacing IS NOT OLD.pacing OR NEW.scheduling IS NOT OLD.scheduling
  OR NEW.rate_Hz IS NOT OLD.rate_Hz OR NEW.started_utc IS NOT OLD.started_utc
  OR NEW.clock_zero_ns IS NOT OLD.clock_zero_ns OR NEW.observer_json IS NOT OLD.observer_json
  OR NEW.consent_version IS NOT OLD.consent_version OR NEW.consent_utc IS NOT OLD.consent_utc
  OR NEW.mirrored IS NOT OLD.mirrored OR NEW.group_level IS NOT OLD.group_level
  OR NEW.expected_trials IS NOT OLD.expected_trials
BEGIN SELECT RAISE(ABORT, 'of a session only state and ended_utc may change'); END;
CREATE TRIGGER session_completed_stays BEFORE UPDATE ON session
WHEN OLD.state = 'completed'
BEGIN SELECT RAISE(ABORT, 'a completed session does not change'); END;
CREATE TRIGGER session_of_withdrawn_participant_stays_closed BEFORE UPDATE ON session
WHEN NEW.state = 'open' AND OLD.state <> 'open'
  AND EXISTS (SELECT 1 FROM participant WHERE id = NEW.participant_id AND withdrawn = 1)
BEGIN SELECT RAISE(ABORT, 'the participant has withdrawn'); END;
CREATE TRIGGER session_no_delete BEFORE DELETE ON session
BEGIN SELECT RAISE(ABORT, 'a session cannot be removed'); END;
CREATE TRIGGER session_no_replace BEFORE INSERT ON session
WHEN EXISTS (SELECT 1 FROM session WHERE id = NEW.id
             OR (participant_id = NEW.participant_id AND session = NEW.session))
BEGIN SELECT RAISE(ABORT, 'the participant has a session of this number'); END;

CREATE TRIGGER segment_ends_once BEFORE UPDATE ON segment
WHEN OLD.end_reason IS NOT NULL OR NEW.session_id IS NOT OLD.session_id
  OR NEW.segment IS NOT OLD.segment OR NEW.started_ns IS NOT OLD.started_ns
BEGIN SELECT RAISE(ABORT, 'a segment ends once, and nothing else of it changes'); END;
CREATE TRIGGER segment_no_delete BEFORE DELETE ON segment
BEGIN SELECT RAISE(ABORT, 'a segment cannot be removed'); END;
CREATE TRIGGER segment_no_replace BEFORE INSERT ON segment
WHEN EXISTS (SELECT 1 FROM segment WHERE session_id = NEW.session_id AND segment = NEW.segment)
BEGIN SELECT RAISE(ABORT, 'the session has a segment of this number'); END;

-- Every row belongs to others, also where a tool has left foreign_keys off.

CREATE TRIGGER session_has_its_parents BEFORE INSERT ON session
WHEN NOT EXISTS (SELECT 1 FROM participant WHERE id = NEW.participant_id)
  OR NOT EXISTS (SELECT 1 FROM protocol WHERE id = NEW.protocol_id)
BEGIN SELECT RAISE(ABORT, 'a session needs its participant and its protocol'); END;
CREATE TRIGGER session_simulates_virtual_people BEFORE INSERT ON session
WHEN NEW.mode = 'simulate' AND NOT EXISTS (SELECT 1 FROM participant
                                           WHERE id = NEW.participant_id AND is_virtual = 1)
BEGIN SELECT RAISE(ABORT, 'only a virtual participant can be simulated'); END;
CREATE TRIGGER session_of_no_withdrawn_participant BEFORE INSERT ON session
WHEN EXISTS (SELECT 1 FROM participant WHERE id = NEW.participant_id AND withdrawn = 1)
BEGIN SELECT RAISE(ABORT, 'the participant has withdrawn'); END;

-- A participant keeps the group in all sessions of a protocol, whatever its version.
CREATE TRIGGER session_keeps_the_group BEFORE INSERT ON session
WHEN EXISTS (SELECT 1 FROM session AS earlier
             JOIN protocol AS its ON its.id = earlier.protocol_id
             JOIN protocol AS own ON own.id = NEW.protocol_id
             WHERE earlier.participant_id = NEW.participant_id AND earlier.mode = NEW.mode
             AND its.name = own.name AND earlier.group_level <> NEW.group_level)
BEGIN SELECT RAISE(ABORT, 'the participant is in another group of this protocol'); END;

CREATE TRIGGER session_file_has_its_session BEFORE INSERT ON session_file
WHEN NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id)
BEGIN SELECT RAISE(ABORT, 'a session_file needs its session'); END;
CREATE TRIGGER segment_has_its_session BEFORE INSERT ON segment
WHEN NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id AND state = 'open')
BEGIN SELECT RAISE(ABORT, 'a segment needs its session, and that open'); END;
CREATE TRIGGER trial_has_its_session BEFORE INSERT ON trial
WHEN NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id AND state = 'open')
BEGIN SELECT RAISE(ABORT, 'a trial needs its session, and that open'); END;
CREATE TRIGGER trial_is_catch_or_of_a_track BEFORE INSERT ON trial
WHEN NEW.is_catch NOT IN (0, 1)
  OR (NEW.is_catch = 1 AND (NEW.repetition <> 0 OR NEW.track IS NOT NULL))
BEGIN SELECT RAISE(ABORT, 'a catch trial has repetition 0 and no track'); END;
CREATE TRIGGER attempt_has_its_trial BEFORE INSERT ON attempt
WHEN NOT EXISTS (SELECT 1 FROM trial WHERE session_id = NEW.session_id AND trial = NEW.trial)
BEGIN SELECT RAISE(ABORT, 'an attempt needs a planned trial of its session'); END;
CREATE TRIGGER attempt_has_its_segment BEFORE INSERT ON attempt
WHEN NOT EXISTS (SELECT 1 FROM segment WHERE session_id = NEW.session_id AND segment = NEW.segment)
BEGIN SELECT RAISE(ABORT, 'an attempt needs a segment of its session'); END;
CREATE TRIGGER attempt_in_an_open_session BEFORE INSERT ON attempt
WHEN NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id AND state = 'open')
BEGIN SELECT RAISE(ABORT, 'an attempt needs its session to be open'); END;
CREATE TRIGGER attempt_has_a_purpose BEFORE INSERT ON attempt
WHEN NEW.purpose NOT IN ('trial', 'refresher')
BEGIN SELECT RAISE(ABORT, 'the purpose of an attempt is trial or refresher'); END;
CREATE TRIGGER attempt_refreshes_practice BEFORE INSERT ON attempt
WHEN NEW.purpose = 'refresher' AND NOT EXISTS (SELECT 1 FROM trial WHERE session_id = NEW.session_id
                                               AND trial = NEW.trial AND phase = 'practice')
BEGIN SELECT RAISE(ABORT, 'only trials of a practice are repeated as refreshers'); END;
CREATE TRIGGER presentation_has_its_attempt BEFORE INSERT ON presentation
WHEN NOT EXISTS (SELECT 1 FROM attempt WHERE id = NEW.attempt_id)
BEGIN SELECT RAISE(ABORT, 'a presentation needs its attempt'); END;
CREATE TRIGGER presentation_asset_has_its_presentation BEFORE INSERT ON presentation_asset
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'a presentation_asset needs its presentation'); END;
CREATE TRIGGER model_limit_has_its_presentation BEFORE INSERT ON model_limit
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'a model_limit needs its presentation'); END;
CREATE TRIGGER visit_has_its_presentation BEFORE INSERT ON visit
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'a visit needs its presentation'); END;
CREATE TRIGGER instability_has_its_presentation BEFORE INSERT ON instability
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'an instability needs its presentation'); END;
CREATE TRIGGER response_has_its_attempt BEFORE INSERT ON response
WHEN NOT EXISTS (SELECT 1 FROM attempt WHERE id = NEW.attempt_id)
BEGIN SELECT RAISE(ABORT, 'a response needs its attempt'); END;
CREATE TRIGGER servo_quality_has_its_attempt BEFORE INSERT ON servo_quality
WHEN NOT EXISTS (SELECT 1 FROM attempt WHERE id = NEW.attempt_id)
BEGIN SELECT RAISE(ABORT, 'a servo_quality needs its attempt'); END;
CREATE TRIGGER compliance_has_its_attempt BEFORE INSERT ON compliance
WHEN NOT EXISTS (SELECT 1 FROM attempt WHERE id = NEW.attempt_id)
BEGIN SELECT RAISE(ABORT, 'a compliance needs its attempt'); END;
CREATE TRIGGER recording_has_its_attempt BEFORE INSERT ON recording
WHEN NOT EXISTS (SELECT 1 FROM attempt WHERE id = NEW.attempt_id)
BEGIN SELECT RAISE(ABORT, 'a recording needs its attempt'); END;
CREATE TRIGGER session_answer_has_its_session BEFORE INSERT ON session_answer
WHEN NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id)
BEGIN SELECT RAISE(ABORT, 'a session_answer needs its session'); END;
CREATE TRIGGER event_has_its_parents BEFORE INSERT ON event
WHEN NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id)
  OR (NEW.attempt_id IS NOT NULL AND NOT EXISTS (
        SELECT 1 FROM attempt WHERE id = NEW.attempt_id AND session_id = NEW.session_id))
BEGIN SELECT RAISE(ABORT, 'an event needs its session, and its attempt must be of that session'); END;
CREATE TRIGGER decision_has_its_parents BEFORE INSERT ON decision
WHEN NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id)
  OR (NEW.trial IS NOT NULL AND NOT EXISTS (
        SELECT 1 FROM attempt WHERE session_id = NEW.session_id AND trial = NEW.trial
        AND attempt = NEW.attempt))
BEGIN SELECT RAISE(ABORT, 'a decision needs its session, and its attempt must be of that session'); END;
CREATE TRIGGER decision_sets_aside_in_an_open_session BEFORE INSERT ON decision
WHEN NEW.verdict = 'set_aside'
  AND NOT EXISTS (SELECT 1 FROM session WHERE id = NEW.session_id AND state = 'open')
BEGIN SELECT RAISE(ABORT, 'an attempt is set aside to be asked again, while its session is open'); END;
CREATE TRIGGER decision_leaves_withdrawn_data_out BEFORE INSERT ON decision
WHEN NEW.verdict = 'include' AND EXISTS (
       SELECT 1 FROM session JOIN participant ON participant.id = session.participant_id
       WHERE session.id = NEW.session_id AND withdrawn = 1)
BEGIN SELECT RAISE(ABORT, 'the participant has withdrawn: their data stay excluded'); END;

-- How the decisions leave each attempt: analyses include what is valid and not excluded.
CREATE VIEW attempt_standing AS
SELECT attempt.id AS attempt_id,
       attempt.valid = 1 AND NOT EXISTS (
         SELECT 1 FROM decision WHERE decision.session_id = attempt.session_id
         AND decision.trial = attempt.trial AND decision.attempt = attempt.attempt
         AND verdict = 'set_aside') AS valid,
       coalesce((SELECT verdict = 'exclude' FROM decision
                 WHERE decision.session_id = attempt.session_id AND decision.trial = attempt.trial
                 AND decision.attempt = attempt.attempt AND verdict IN ('exclude', 'include')
                 ORDER BY decision.id DESC LIMIT 1), 0)
       OR coalesce((SELECT verdict = 'exclude' FROM decision
                    WHERE decision.session_id = attempt.session_id AND decision.trial IS NULL
                    ORDER BY decision.id DESC LIMIT 1), 0) AS excluded
FROM attempt;

-- For other tools that open the file: natural keys first, one row per thing. An emergency stop is an outcome in the view;
-- the table has it among the faults, which the row of the servo loop distinguishes.
CREATE VIEW tidy_attempt AS
SELECT participant.label AS participant, session.session, attempt.trial, attempt.attempt,
       participant.is_virtual, session.mode, session.state AS session_state,
       protocol.name AS protocol, protocol.version AS protocol_version,
       trial.block, trial.phase, trial.repetition, trial.is_catch, attempt.purpose,
       trial.factors_json,
       CASE WHEN attempt.outcome = 'device_fault'
            AND (SELECT fault FROM servo_quality WHERE attempt_id = attempt.id) = 'emergency_stop'
         THEN 'emergency_stop' ELSE attempt.outcome END AS outcome,
       attempt_standing.valid,
       coalesce(iif(attempt.invalid_reason IS NULL, '', attempt.invalid_reason || '; ') ||
                (SELECT 'set aside: ' || reason FROM decision
                 WHERE decision.session_id = attempt.session_id AND decision.trial = attempt.trial
                 AND decision.attempt = attempt.attempt AND verdict = 'set_aside'
                 ORDER BY decision.id LIMIT 1), attempt.invalid_reason) AS invalid_reason,
       attempt_standing.excluded,
       attempt.flagged OR EXISTS (
         SELECT 1 FROM decision WHERE decision.session_id = attempt.session_id
         AND decision.trial = attempt.trial AND decision.attempt = attempt.attempt
         AND verdict = 'flag') AS flagged,
       nullif(concat_flags.reasons, '') AS flag_reason,
       (attempt.onset_ns - session.clock_zero_ns) / 1e9 AS onset_s,
       (attempt.offset_ns - attempt.onset_ns) / 1e9 AS duration_s,
       recording.path AS recording_path
FROM attempt
JOIN attempt_standing ON attempt_standing.attempt_id = attempt.id
JOIN (SELECT attempt.id AS attempt_id,
             coalesce(attempt.flag_reason, '') || coalesce((
               SELECT iif(attempt.flag_reason IS NULL, '', '; ') || group_concat(reason, '; ')
               FROM decision WHERE decision.session_id = attempt.session_id
               AND decision.trial = attempt.trial AND decision.attempt = attempt.attempt
               AND verdict = 'flag'), '') AS reasons
      FROM attempt) AS concat_flags ON concat_flags.attempt_id = attempt.id
JOIN trial ON trial.session_id = attempt.session_id AND trial.trial = attempt.trial
JOIN session ON session.id = attempt.session_id
JOIN participant ON participant.id = session.participant_id
JOIN protocol ON protocol.id = session.protocol_id
LEFT JOIN recording ON recording.attempt_id = attempt.id
ORDER BY participant.label, session.session, attempt.trial, attempt.attempt;

CREATE VIEW tidy_presentation AS
SELECT participant.label AS participant, session.session, attempt.trial, attempt.attempt,
       presentation.position, participant.is_virtual, session.mode, attempt_standing.valid,
       attempt_standing.excluded,
       presentation.role, presentation.item, presentation.stimulus, presentation.texture,
       presentation.model, presentation.model_version, presentation.parameters_json,
       presentation.contact_s, presentation.matched_texture_force_N,
       presentation.achieved_texture_force_N
FROM presentation
JOIN attempt ON attempt.id = presentation.attempt_id
JOIN attempt_standing ON attempt_standing.attempt_id = attempt.id
JOIN session ON session.id = attempt.session_id
JOIN participant ON participant.id = session.participant_id
ORDER BY participant.label, session.session, attempt.trial, attempt.attempt, presentation.position;

CREATE VIEW tidy_response AS
SELECT participant.label AS participant, session.session, attempt.trial, attempt.attempt,
       response.question, response.item, participant.is_virtual, session.mode,
       protocol.name AS protocol, trial.phase, trial.factors_json, attempt_standing.valid,
       attempt_standing.excluded,
       response.answer, response.answer_number, response.correct, response.options_json,
       response.from_contact_s, response.from_cue_s, response.source
FROM response
JOIN attempt ON attempt.id = response.attempt_id
JOIN attempt_standing ON attempt_standing.attempt_id = attempt.id
JOIN trial ON trial.session_id = attempt.session_id AND trial.trial = attempt.trial
JOIN session ON session.id = attempt.session_id
JOIN participant ON participant.id = session.participant_id
JOIN protocol ON protocol.id = session.protocol_id
ORDER BY participant.label, session.session, attempt.trial, attempt.attempt, response.id;

-- What people decide about data afterwards, without changing them; and for which hand the workspace was
-- laid out.

ALTER TABLE session ADD COLUMN mirrored INTEGER NOT NULL DEFAULT 0 CHECK (mirrored IN (0, 1));

DROP TRIGGER session_only_changes_state;
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
  OR NEW.mirrored IS NOT OLD.mirrored
BEGIN SELECT RAISE(ABORT, 'of a session only state and ended_utc may change'); END;

-- trial and attempt are both empty for a decision about the whole session. set_aside is final; of exclude
-- and include the latest holds.
CREATE TABLE decision (
  id          INTEGER PRIMARY KEY,
  session_id  INTEGER NOT NULL REFERENCES session,
  trial       INTEGER,
  attempt     INTEGER,
  verdict     TEXT NOT NULL CHECK (verdict IN ('set_aside', 'flag', 'exclude', 'include')),
  reason      TEXT NOT NULL CHECK (reason <> ''),
  decided_by  TEXT NOT NULL,
  decided_utc TEXT NOT NULL CHECK (decided_utc GLOB '????-??-??T??:??:??*Z'),
  CHECK ((trial IS NULL) = (attempt IS NULL)),
  CHECK (trial IS NOT NULL OR verdict IN ('exclude', 'include'))
) STRICT;
CREATE INDEX decision_attempt ON decision (session_id, trial, attempt);

CREATE TRIGGER decision_no_update BEFORE UPDATE ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is append-only'); END;
CREATE TRIGGER decision_no_delete BEFORE DELETE ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is append-only'); END;
CREATE TRIGGER decision_no_replace BEFORE INSERT ON decision
WHEN EXISTS (SELECT 1 FROM decision WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'a decision is append-only'); END;
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

-- How the decisions leave each attempt: what analyses count is valid and not excluded.
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

-- One valid attempt per trial, but for those that were set aside.
DROP INDEX attempt_one_valid;
DROP TRIGGER attempt_no_replace;
CREATE TRIGGER attempt_no_replace BEFORE INSERT ON attempt
WHEN EXISTS (SELECT 1 FROM attempt WHERE id = NEW.id
             OR (session_id = NEW.session_id AND trial = NEW.trial
                 AND (attempt = NEW.attempt
                      OR (NEW.valid = 1 AND valid = 1 AND NOT EXISTS (
                            SELECT 1 FROM decision WHERE decision.session_id = NEW.session_id
                            AND decision.trial = NEW.trial AND decision.attempt = attempt.attempt
                            AND verdict = 'set_aside')))))
BEGIN SELECT RAISE(ABORT, 'an attempt is append-only, and a trial has one valid attempt'); END;

DROP VIEW tidy_attempt;
CREATE VIEW tidy_attempt AS
SELECT participant.label AS participant, session.session, attempt.trial, attempt.attempt,
       participant.is_virtual, session.mode, session.state AS session_state,
       protocol.name AS protocol, protocol.version AS protocol_version,
       trial.block, trial.phase, trial.repetition, trial.factors_json,
       attempt.outcome, attempt_standing.valid,
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

DROP VIEW tidy_presentation;
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

DROP VIEW tidy_response;
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

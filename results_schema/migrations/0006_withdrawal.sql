-- Who is responsible for the study, what was made of its data, and who withdrew from it.

ALTER TABLE study ADD COLUMN license TEXT CHECK (license <> '');
ALTER TABLE study ADD COLUMN ethics_approval TEXT CHECK (ethics_approval <> '');
-- What was made before is unknown.
ALTER TABLE study ADD COLUMN outputs_since_utc TEXT CHECK (outputs_since_utc GLOB '????-??-??T??:??:??*Z');
UPDATE study SET outputs_since_utc = strftime('%Y-%m-%dT%H:%M:%fZ', 'now');

CREATE TABLE author (
  position INTEGER PRIMARY KEY CHECK (position >= 1),
  name     TEXT NOT NULL UNIQUE CHECK (name <> '')
) STRICT;

-- What left the study and may hold data of participants.
CREATE TABLE output (
  id              INTEGER PRIMARY KEY,
  kind            TEXT NOT NULL CHECK (kind <> '' AND kind NOT GLOB '*[^a-z_]*'),
  path            TEXT NOT NULL CHECK (path <> ''),
  program_version TEXT NOT NULL,
  made_utc        TEXT NOT NULL CHECK (made_utc GLOB '????-??-??T??:??:??*Z')
) STRICT;

CREATE TRIGGER output_no_update BEFORE UPDATE ON output
BEGIN SELECT RAISE(ABORT, 'an output is append-only'); END;
CREATE TRIGGER output_no_delete BEFORE DELETE ON output
BEGIN SELECT RAISE(ABORT, 'an output is append-only'); END;
CREATE TRIGGER output_no_replace BEFORE INSERT ON output
WHEN EXISTS (SELECT 1 FROM output WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'an output is append-only'); END;

-- That somebody withdrew, without saying who: of those whose data were deleted nothing else remains.
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
  recordings    INTEGER NOT NULL CHECK (recordings >= 0)
) STRICT;

CREATE TRIGGER withdrawal_no_update BEFORE UPDATE ON withdrawal
BEGIN SELECT RAISE(ABORT, 'a withdrawal is append-only'); END;
CREATE TRIGGER withdrawal_no_delete BEFORE DELETE ON withdrawal
BEGIN SELECT RAISE(ABORT, 'a withdrawal is append-only'); END;
CREATE TRIGGER withdrawal_no_replace BEFORE INSERT ON withdrawal
WHEN EXISTS (SELECT 1 FROM withdrawal WHERE id = NEW.id)
BEGIN SELECT RAISE(ABORT, 'a withdrawal is append-only'); END;

-- Of a participant whose data are kept: nothing is measured and nothing is used any more.
ALTER TABLE participant ADD COLUMN withdrawn INTEGER NOT NULL DEFAULT 0 CHECK (withdrawn IN (0, 1));

CREATE TRIGGER participant_stays_withdrawn BEFORE UPDATE ON participant
WHEN OLD.withdrawn = 1 AND NEW.withdrawn = 0
BEGIN SELECT RAISE(ABORT, 'a withdrawal is final'); END;
CREATE TRIGGER session_of_no_withdrawn_participant BEFORE INSERT ON session
WHEN EXISTS (SELECT 1 FROM participant WHERE id = NEW.participant_id AND withdrawn = 1)
BEGIN SELECT RAISE(ABORT, 'the participant has withdrawn'); END;
CREATE TRIGGER session_of_withdrawn_participant_stays_closed BEFORE UPDATE ON session
WHEN NEW.state = 'open' AND OLD.state <> 'open'
  AND EXISTS (SELECT 1 FROM participant WHERE id = NEW.participant_id AND withdrawn = 1)
BEGIN SELECT RAISE(ABORT, 'the participant has withdrawn'); END;
CREATE TRIGGER decision_leaves_withdrawn_data_out BEFORE INSERT ON decision
WHEN NEW.verdict = 'include' AND EXISTS (
       SELECT 1 FROM session JOIN participant ON participant.id = session.participant_id
       WHERE session.id = NEW.session_id AND withdrawn = 1)
BEGIN SELECT RAISE(ABORT, 'the participant has withdrawn: their data stay excluded'); END;

-- The detectors of perceived instability of every presentation. Attempts of earlier versions have none stored: their rows are
-- missing, which is not the same as a value of 0.

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

CREATE TRIGGER instability_no_update BEFORE UPDATE ON instability
BEGIN SELECT RAISE(ABORT, 'an instability is append-only'); END;
CREATE TRIGGER instability_no_delete BEFORE DELETE ON instability
BEGIN SELECT RAISE(ABORT, 'an instability is append-only'); END;
CREATE TRIGGER instability_no_replace BEFORE INSERT ON instability
WHEN EXISTS (SELECT 1 FROM instability WHERE attempt_id = NEW.attempt_id AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'an instability is append-only'); END;
CREATE TRIGGER instability_has_its_presentation BEFORE INSERT ON instability
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'an instability needs its presentation'); END;

-- What stimuli were made from, a row each: a force model with another kind of file needs no further column. The columns
-- height_field_sha256, surface_sha256 and tool_sha256 of presentation remain, and are empty in attempts from now on.

CREATE TABLE presentation_asset (
  attempt_id INTEGER NOT NULL,
  position   INTEGER NOT NULL,
  role       TEXT NOT NULL CHECK (role <> '' AND role NOT GLOB '*[^0-9a-z_]*'),
  sha256     TEXT NOT NULL CHECK (length(sha256) = 64 AND sha256 NOT GLOB '*[^0-9a-f]*'),
  PRIMARY KEY (attempt_id, position, role),
  FOREIGN KEY (attempt_id, position) REFERENCES presentation (attempt_id, position)
) STRICT, WITHOUT ROWID;

-- A damaged hash stays where it is, where its own rule finds it: a study with one can still be read.
INSERT INTO presentation_asset
SELECT attempt_id, position, role, sha256 FROM (
  SELECT attempt_id, position, 'height_field' AS role, height_field_sha256 AS sha256 FROM presentation
  UNION ALL
  SELECT attempt_id, position, 'surface', surface_sha256 FROM presentation
  UNION ALL
  SELECT attempt_id, position, 'tool', tool_sha256 FROM presentation)
WHERE length(sha256) = 64 AND sha256 NOT GLOB '*[^0-9a-f]*'
ORDER BY attempt_id, position, role;

CREATE TRIGGER presentation_asset_no_update BEFORE UPDATE ON presentation_asset
BEGIN SELECT RAISE(ABORT, 'a presentation_asset is append-only'); END;
CREATE TRIGGER presentation_asset_no_delete BEFORE DELETE ON presentation_asset
BEGIN SELECT RAISE(ABORT, 'a presentation_asset is append-only'); END;
CREATE TRIGGER presentation_asset_no_replace BEFORE INSERT ON presentation_asset
WHEN EXISTS (SELECT 1 FROM presentation_asset WHERE attempt_id = NEW.attempt_id AND position = NEW.position
                                                AND role = NEW.role)
BEGIN SELECT RAISE(ABORT, 'a presentation_asset is append-only'); END;
CREATE TRIGGER presentation_asset_has_its_presentation BEFORE INSERT ON presentation_asset
WHEN NOT EXISTS (SELECT 1 FROM presentation WHERE attempt_id = NEW.attempt_id
                                              AND position = NEW.position)
BEGIN SELECT RAISE(ABORT, 'a presentation_asset needs its presentation'); END;

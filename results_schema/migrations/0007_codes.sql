-- Reasons and remarks as codes with arguments, beside the same words in English. Missing of what was stored before, and
-- of an event whose text is a name or data.

ALTER TABLE attempt ADD COLUMN invalid_reason_json TEXT CHECK (invalid_reason_json IS NULL OR json_valid(invalid_reason_json));
ALTER TABLE attempt ADD COLUMN flag_reason_json TEXT CHECK (flag_reason_json IS NULL OR json_valid(flag_reason_json));
ALTER TABLE decision ADD COLUMN reason_json TEXT CHECK (reason_json IS NULL OR json_valid(reason_json));
ALTER TABLE event ADD COLUMN text_json TEXT CHECK (text_json IS NULL OR json_valid(text_json));

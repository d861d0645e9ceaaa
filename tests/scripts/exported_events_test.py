#!/usr/bin/env python3
"""Every row of the table `event` is found again in an export: by its own import.py, by its import.R where R is installed, and in
the BIDS dataset; an export for the public has every row and none of the experimenter's words. Argument: the program asperity."""
import collections
import csv
import json
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
STUDY = ROOT / "tests/earlier_studies/present/study"
IN_OWN_WORDS = ("note", "unblinded", "trial_repeated", "consent_seen")
R = """
source(file.path(commandArgs(TRUE)[1], "import.R"), chdir = TRUE)
counts <- table(tables$events$participant, tables$events$session, tables$events$kind)
for (row in seq_len(nrow(counted <- as.data.frame(counts)))) if (counted$Freq[row] > 0) cat(
  as.character(counted$Var1[row]), as.character(counted$Var2[row]), as.character(counted$Var3[row]), counted$Freq[row], "\\n")
"""


def add_words(study):
    """Events of the windows, with words of an experimenter, in the session of P01."""
    database = sqlite3.connect(study / "study.sqlite")
    with database:
        session, time_ns = database.execute(
            "SELECT session.id, clock_zero_ns FROM session JOIN participant ON participant.id = participant_id "
            "WHERE label = 'P01'").fetchone()
        for number, kind in enumerate(IN_OWN_WORDS):
            words = f"Ada remarked {kind}"
            database.execute("INSERT INTO event (session_id, time_ns, kind, text, data_json, text_json) VALUES (?, ?, ?, ?, ?, ?)",
                             (session, time_ns + number, kind, words, "null", json.dumps(words)))
    database.close()
    (study / "study.sqlite.sha256").unlink()


def stored(study):
    """Per participant, session and kind: the texts, as often as they are stored."""
    database = sqlite3.connect(f"file:{study}/study.sqlite?immutable=1", uri=True)
    texts = collections.defaultdict(list)
    for label, session, kind, text in database.execute(
            "SELECT label, session, kind, text FROM event JOIN session ON session.id = event.session_id "
            "JOIN participant ON participant.id = session.participant_id"):
        texts[label, session, kind].append(text)
    return {key: sorted(each) for key, each in texts.items()}


def from_tables(out):
    rows = subprocess.run([sys.executable, "-B", "-c", "import json, sys; sys.path.insert(0, sys.argv[1]); "
                           "print(json.dumps(__import__('import').read_rows('events.tsv')))", out],
                          text=True, capture_output=True, check=True).stdout
    texts = collections.defaultdict(list)
    for row in json.loads(rows):
        texts[row["participant"], row["session"], row["kind"]].append(row["text"] or "")
    return {key: sorted(each) for key, each in texts.items()}


def from_bids(out):
    counts = collections.Counter()
    for path in out.rglob("*_events.tsv"):
        label, session = path.name.split("_")[:2]
        with open(path, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE):
                if row["trial_type"] not in ("attempt", "presentation"):
                    counts[label[len("sub-"):], int(session[len("ses-"):]), row["trial_type"]] += 1
    return counts


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    study, own, public = folder / "study", folder / "own", folder / "public"
    shutil.copytree(STUDY, study, copy_function=shutil.copyfile)
    add_words(study)
    expected = stored(study)
    counts = {key: len(texts) for key, texts in expected.items()}
    assert sum(counts.values()) > 30 and len({kind for _, _, kind in counts}) > 5, counts
    for out, options in ((own, ()), (public, ("--public",))):
        subprocess.run([PROGRAM, "export", study, "--out", out, "--formats", "bids", *options], check=True, capture_output=True)
        assert {key: len(texts) for key, texts in from_tables(out).items()} == counts
        assert from_bids(out) == counts
    assert from_tables(own) == expected
    words = {text for (_, _, kind), texts in expected.items() if kind in IN_OWN_WORDS for text in texts}
    assert len(words) > 3, words
    for path in public.rglob("*"):
        text = path.read_text(encoding="utf-8") if path.is_file() else ""
        assert not [each for each in words if each in text], path
    if shutil.which("Rscript"):
        script = folder / "count.R"
        script.write_text(R, encoding="utf-8")
        lines = subprocess.run(["Rscript", "--vanilla", script, own], text=True, capture_output=True, check=True).stdout.splitlines()
        found = {(label, int(session), kind): int(count) for label, session, kind, count in map(str.split, lines)}
        assert found == counts, (found, counts)
    print(f"{sum(counts.values())} events of {len(counts)} sessions and kinds{'' if shutil.which('Rscript') else ' (not in R, which is missing)'}")

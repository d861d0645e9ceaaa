#!/usr/bin/env python3
"""A participant withdraws by the command line: nothing of them is left, and the others are as before.

Argument: the program asperity.
"""
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
LABEL = "virtual0002"
KEPT = "virtual0003"


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, check=False, stdin=subprocess.DEVNULL)


def asperity(*arguments):
    done = run(*arguments)
    assert done.returncode == 0, (arguments, done)
    return done.stdout


def exported(study, tables, *options):
    asperity("export", study, "--out", tables, "--formats", "none", *options)
    return {path.name: path.read_text(encoding="utf-8").splitlines() for path in tables.glob("*.tsv")}


def rows_of(study, query):
    with sqlite3.connect(f"file:{study}/study.sqlite?immutable=1", uri=True) as store:
        return store.execute(query).fetchall()


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    study = folder / "study"
    asperity("new", study, "--demo")
    exported(study, folder / "without_participants")
    asperity("simulate", study / "protocols" / "chapter_selection.json", "--study", study, "--participants", "4",
             "--seed", "1", "--recordings", "all")
    (study / f"sheet-{LABEL}.png").write_bytes(b"the last question")
    (study / f"sheet-{LABEL}.png.4711-0.tmp").write_bytes(b"as a program leaves it that is killed")
    (study / "study.sqlite.version-4").write_bytes(b"an older study with " + LABEL.encode())
    before = exported(study, folder / "before")
    asperity("copy", study, folder / "copy")
    asperity("report", study, "--out", folder / f"{LABEL}.html")
    again = run("report", study, "--out", folder / f"{LABEL}.html")
    assert again.returncode == 1 and "already exists" in again.stderr, again
    refused = run("export", study, "--out", folder / "before")
    assert refused.returncode == 1 and "is not empty" in refused.stderr, refused

    unknown = run("withdraw", study, "nobody", "--delete")
    assert unknown.returncode == 1 and "has no participant nobody" in unknown.stderr, unknown
    unasked = run("withdraw", study, LABEL, "--delete")
    assert unasked.returncode == 2 and f"--confirm {LABEL}" in unasked.stderr and "Nothing was deleted" in unasked.stderr, unasked
    mistyped = run("withdraw", study, LABEL, "--delete", "--confirm", KEPT)
    assert mistyped.returncode == 2 and "nothing was deleted" in mistyped.stderr, mistyped
    alone = run("withdraw", study, LABEL, "--confirm", LABEL)
    assert alone.returncode == 2, alone
    for blank in ("", "  "):
        nobody = run("withdraw", study, LABEL, "--delete", "--confirm", LABEL, "--by", blank)
        assert nobody.returncode == 2 and "--by: the text is blank: enter the name of the person" in nobody.stderr, nobody
    assert rows_of(study, "SELECT count(*) FROM withdrawal") == [(0,)]
    said = asperity("withdraw", study, LABEL, "--delete", "--confirm", LABEL, "--by", "R. Keeper")
    assert "1 session" in said and "deleted" in said, said
    listed = re.findall(r"^  \d{4}-\d\d-\d\d \d\d:\d\d  ([a-z ]+)  (.*)$", said, re.MULTILINE)
    assert listed == [("export", str(folder / "before")), ("copy of the study", str(folder / "copy")),
                      ("report", str(folder / f"{LABEL}.html"))], said
    again = run("withdraw", study, LABEL, "--delete", "--confirm", LABEL)
    assert again.returncode == 1 and f"has no participant {LABEL}; its last deletion" in again.stderr, again
    assert "is complete" in again.stderr, again
    assert rows_of(study, "SELECT count(*), count(label) FROM withdrawal") == [(1, 0)]

    assert "no problems found" in asperity("verify", study)
    holding = [path for path in study.rglob("*") if LABEL in path.name
               or (path.is_file() and LABEL.encode() in path.read_bytes())]
    assert not holding, holding
    after = exported(study, folder / "after")
    for name in ("MANIFEST.tsv", "stimuli.tsv"):  # numbers of rows, hashes; means over all participants
        del before[name], after[name]
    for name, rows in before.items():
        kept = [row for row in rows if not row.startswith(LABEL + "\t")]
        assert after[name] == kept, name
    assert len(before["sessions.tsv"]) == len(after["sessions.tsv"]) + 1
    sys.path.insert(0, str(folder / "after"))
    sys.dont_write_bytecode = True
    rows = __import__("import").read_rows("attempts.tsv")
    assert len(rows) == len(after["attempts.tsv"]) - 1 and all(row["virtual"] is True and row["session"] == 1 for row in rows)
    store = sqlite3.connect(study / "study.sqlite")
    try:
        store.execute("DELETE FROM event")
        sys.exit("the rules of the store have not come back")
    except sqlite3.IntegrityError:
        store.close()

    said = asperity("withdraw", study, KEPT, "--reason", "not_eligible")
    assert "kept and excluded" in said, said
    again = run("withdraw", study, KEPT)
    assert again.returncode == 1 and "already" in again.stderr, again
    tables = exported(study, folder / "kept")
    columns = tables["participants.tsv"][0].split("\t")
    withdrawn = {row.split("\t")[0] for row in tables["participants.tsv"][1:]
                 if row.split("\t")[columns.index("withdrawn")] == "1"}
    assert withdrawn == {KEPT}, withdrawn
    public = exported(study, folder / "public", "--public")
    assert not [row for rows in public.values() for row in rows if KEPT in row]
    assert rows_of(study, "SELECT data, reason, sessions FROM withdrawal ORDER BY id") == [
        ("deleted", "consent_withdrawn", 1), ("kept", "not_eligible", 1)]
    assert [kind for (kind,) in rows_of(study, "SELECT kind FROM output ORDER BY id")] == [
        "export", "export", "copy", "report", "export", "export", "public_export"], "what was refused is not listed"
    assert rows_of(study, "SELECT count(*) FROM output WHERE made_utc IS NULL OR path = ''") == [(1,)], "the report's path"
    analysed = asperity("analyze", study, "--json")
    assert KEPT not in analysed and LABEL not in analysed
    assert "2 participants" in asperity("analyze", study), "of four one was deleted and one is not used"
    for (label,) in rows_of(study, "SELECT label FROM participant WHERE withdrawn = 0"):
        asperity("withdraw", study, label)
    nobody = run("analyze", study)
    assert nobody.returncode == 0 and "who have withdrawn" in nobody.stderr, nobody
    asperity("report", study, "--out", folder / "report.html")
    report = (folder / "report.html").read_text(encoding="utf-8")
    assert "four participants were withdrawn" in report and "no sessions yet" not in report, report[:3000]
    assert "No data: all participants with sessions were withdrawn" in report and "No data yet" not in report, report[:3000]

#!/usr/bin/env python3
"""What docs/withdrawal.md says to do takes one participant out of a study. Argument: the program asperity."""
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
GONE = "virtual0002"


def asperity(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, check=True).stdout


def exported(study, tables):
    asperity("export", study, "--out", tables, "--formats", "none")
    return {path.name: path.read_text(encoding="utf-8").splitlines() for path in tables.glob("*.tsv")}


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    study, rest, script = folder / "study", folder / "rest", folder / "take_out.py"
    page = (ROOT / "docs" / "withdrawal.md").read_text(encoding="utf-8")
    script.write_text(re.search(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL).group(1), encoding="utf-8")
    asperity("new", study, "--demo")
    asperity("simulate", study / "protocols" / "chapter_selection.json", "--study", study, "--participants", "3",
             "--seed", "1", "--recordings", "all")
    asperity("copy", study, rest)
    (rest / f"sheet-{GONE}.png").write_bytes(b"the last question")
    nobody = subprocess.run([sys.executable, script, rest, "nobody"], text=True, capture_output=True, check=False)
    assert nobody.returncode == 1 and "has no participant nobody" in nobody.stderr, nobody
    subprocess.run([sys.executable, script, rest, GONE], check=True)

    assert "everything holds" in asperity("verify", rest)
    holding = [path for path in rest.rglob("*") if GONE in path.name
               or (path.is_file() and GONE.encode() in path.read_bytes())]
    assert not holding, holding
    before, after = exported(study, folder / "before"), exported(rest, folder / "after")
    del before["MANIFEST.tsv"], after["MANIFEST.tsv"]  # numbers of rows and hashes
    for name, rows in before.items():
        kept = [row for row in rows if not row.startswith(GONE + "\t")]
        assert after[name] == kept, name
    assert len(before["sessions.tsv"]) == len(after["sessions.tsv"]) + 1
    sys.path.insert(0, str(folder / "after"))
    sys.dont_write_bytecode = True
    rows = __import__("import").read_rows("attempts.tsv")
    assert len(rows) == len(after["attempts.tsv"]) - 1 and all(row["virtual"] is True and row["session"] == 1 for row in rows)
    try:
        sqlite3.connect(rest / "study.sqlite").execute("DELETE FROM event")
        sys.exit("the rules of the store have not come back")
    except sqlite3.IntegrityError:
        pass

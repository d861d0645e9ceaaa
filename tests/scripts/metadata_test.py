#!/usr/bin/env python3
"""A study's authors, license, ethics approval and dealt places: stated when it is made, changed later, exported, and asked for where
they are missing. Argument: the program asperity."""
import json
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
WARNING = "asperity: warning: The study has"


def asperity(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, check=True)


def stated(study):
    told = json.loads(asperity("metadata", study, "--json").stdout)
    return told["authors"], told["license"], told["ethics_approval"]


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    study, bare = folder / "study", folder / "bare"
    asperity("new", study, "--author", "Doe, Jane", "--author", "Roe, Richard", "--license", "CC0-1.0", "--ethics", "Board, 12/2026")
    assert stated(study) == (["Doe, Jane", "Roe, Richard"], "CC0-1.0", "Board, 12/2026")
    assert "Doe, Jane; Roe, Richard" in asperity("metadata", study).stdout
    asperity("metadata", study, "--license", "CC-BY-4.0", "--ethics", "")
    assert stated(study) == (["Doe, Jane", "Roe, Richard"], "CC-BY-4.0", None)
    assert WARNING not in asperity("export", study, "--out", folder / "stated", "--formats", "none").stderr

    for blank in ("--author", "--license", "--ethics"):
        for command in (["new", folder / "blank"], ["metadata", study]):
            refused = subprocess.run([PROGRAM, *map(str, command), blank, " \t "], text=True, capture_output=True, check=False)
            assert refused.returncode == 2 and f"{blank}: the text is blank: enter a" in refused.stderr, refused
    refused = subprocess.run([PROGRAM, "new", folder / "blank", "--license", ""], text=True, capture_output=True, check=False)
    assert refused.returncode == 2 and not (folder / "blank").exists(), refused
    asperity("metadata", study, "--license", "  CC0-1.0 ")
    assert stated(study) == (["Doe, Jane", "Roe, Richard"], "CC0-1.0", None)

    # Places of a whole study, which are dealt to the study of a station.
    def places():
        return json.loads(asperity("metadata", study, "--json").stdout)["dealt_places"]

    assert places() == [] and "places" not in asperity("metadata", study).stdout
    assert "dealt places     1-12\n" in asperity("metadata", study, "--deal", "1-12").stdout
    asperity("metadata", study, "--deal", "25-30", "--license", "CC0-1.0")
    assert places() == ["1-12", "25-30"]
    taken = subprocess.run([PROGRAM, "metadata", study, "--deal", "12-13"], text=True, capture_output=True, check=False)
    assert taken.returncode == 1 and "the places 1-12 are dealt to the study" in taken.stderr, taken
    wrong = subprocess.run([PROGRAM, "metadata", study, "--deal", "12-1"], text=True, capture_output=True, check=False)
    assert wrong.returncode == 2 and "write FROM-TO, such as 13-24" in wrong.stderr, wrong
    assert places() == ["1-12", "25-30"]

    asperity("new", bare)
    assert stated(bare) == ([], None, None)
    told = asperity("export", bare, "--out", folder / "not_stated", "--formats", "none").stderr
    assert f"{WARNING} neither authors nor a licence" in told and f"asperity metadata {bare} --author" in told, told
    asperity("metadata", bare, "--license", "CC0-1.0")
    told = asperity("export", bare, "--out", folder / "no_authors", "--formats", "none").stderr
    assert f"{WARNING} no authors" in told and "--author" in told and "--license" not in told, told
    asperity("metadata", bare, "--license", "", "--author", "Doe, Jane")
    told = asperity("export", bare, "--out", folder / "no_license", "--formats", "none").stderr
    assert f"{WARNING} no licence" in told and "--author" not in told and "--license" in told, told

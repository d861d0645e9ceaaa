#!/usr/bin/env python3
"""An exported study gives R the same numbers as the program. Argument: the program asperity. Needs R (r-base-core) and nothing
else of R's."""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
TOLERANCE = 1e-6


def asperity(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, check=True).stdout


def found(folder, table, kind, options):
    path = folder / f"{kind}.json"
    path.write_text(json.dumps(options), encoding="utf-8")
    told = json.loads(asperity("analyze", "--table", folder / table, "--as", kind, "--options", path, "--json"))
    return {(kind, finding["quantity"], finding["key"]): finding["value"] for finding in told["findings"]}


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    study, out, work = folder / "study", folder / "out", folder / "work"
    work.mkdir()
    asperity("new", study, "--demo")
    asperity("simulate", study / "protocols" / "chapter_selection.json", "--study", study, "--participants", "16", "--seed", "5",
             "--recordings", "none")
    asperity("export", study, "--out", out)
    subprocess.run(["Rscript", "--vanilla", ROOT / "tests/scripts/exported_study.R", out, work], check=True)
    models, forces, textures = (part.split() for part in (work / "levels.txt").read_text(encoding="utf-8").split("--"))
    ours = {**found(work, "counts.csv", "proportion", {}),
            **found(work, "pairs.csv", "paired", {"items": models, "conf": 0.95}),
            **found(work, "forces.csv", "rmanova", {"within": {"model": forces, "texture": textures}, "between": None,
                                                    "conf": 0.95})}
    with open(work / "results.csv", encoding="utf-8", newline="") as file:
        theirs = {(row["kind"], row["quantity"], row["key"]): float(row["value"]) for row in csv.DictReader(file)}
    assert len(theirs) == 4 * len(models) + 2 * (len(models) - 1) + 15, theirs
    for name, value in theirs.items():
        ours_value = ours[name]
        assert ours_value is not None and abs(ours_value - value) <= TOLERANCE * abs(value) + 1e-12, (name, ours_value, value)
    # The counts are those of the study's own analysis.
    text = asperity("analyze", study, "--json")
    for model in models:
        assert model in text
    print(f"{len(theirs)} numbers of R's are the program's")

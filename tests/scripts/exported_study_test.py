#!/usr/bin/env python3
"""An exported study gives R the same numbers as the program, and a study of every library protocol loads in R, in Python's
standard library and in pandas. Argument: the program asperity. Needs R (r-base-core) and nothing else of R's, and pandas."""
import csv
import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import pandas

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
TOLERANCE = 1e-6
# What stands in for a photograph that is fetched from elsewhere.
STAND_IN = "stone"


def asperity(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, check=True).stdout


def r(script, *arguments):
    subprocess.run(["Rscript", "--vanilla", ROOT / "tests/scripts" / script, *arguments], check=True)


def found(folder, table, kind, options):
    path = folder / f"{kind}.json"
    path.write_text(json.dumps(options), encoding="utf-8")
    told = json.loads(asperity("analyze", "--table", folder / table, "--as", kind, "--options", path, "--json"))
    return {(kind, finding["quantity"], finding["key"]): finding["value"] for finding in told["findings"]}


def compare(theirs, ours):
    for name, value in theirs.items():
        ours_value = ours[name]
        assert ours_value is not None and abs(ours_value - value) <= TOLERANCE * abs(value) + 1e-12, (name, ours_value, value)


def numbers_in(path):
    with open(path, encoding="utf-8", newline="") as file:
        return {tuple(row[name] for name in row if name != "value"): float(row["value"]) for row in csv.DictReader(file)}


def one_study_in_depth(folder):
    """Proportions, Bradley-Terry and an analysis of variance of one study."""
    study, out, work = folder / "study", folder / "out", folder / "work"
    work.mkdir()
    asperity("new", study, "--demo")
    asperity("simulate", study / "protocols" / "chapter_selection.json", "--study", study, "--participants", "16", "--seed", "5",
             "--recordings", "none")
    asperity("export", study, "--out", out)
    r("exported_study.R", out, work)
    models, forces, textures = (part.split() for part in (work / "levels.txt").read_text(encoding="utf-8").split("--"))
    ours = {**found(work, "counts.csv", "proportion", {}),
            **found(work, "pairs.csv", "paired", {"items": models, "conf": 0.95}),
            **found(work, "forces.csv", "rmanova", {"within": {"model": forces, "texture": textures}, "between": None,
                                                    "conf": 0.95})}
    theirs = numbers_in(work / "results.csv")
    assert len(theirs) == 4 * len(models) + 2 * (len(models) - 1) + 15, theirs
    compare(theirs, ours)
    return study, len(theirs)


def protocols_in(folder):
    """Without translations, NAME.LANGUAGE.json."""
    return [path for path in sorted(folder.glob("*.json")) if "." not in path.stem]


def add_every_protocol(study):
    """The library's protocols with two virtual participants each; pictures that it fetches from elsewhere are made up."""
    for path in protocols_in(ROOT / "protocols" / "library"):
        text = path.read_text(encoding="utf-8")
        for name in set(re.findall(r'"stimuli/(\w+)\.png"', text)):
            if name.endswith("_photo") or (study / "stimuli" / f"{name}.png").exists():
                continue
            photograph = study / "stimuli" / f"{name}_photo.png"
            asperity("synth", STAND_IN, "--out", study / "stimuli" / f"{name}.png", "--width-m", "0.1", "--pixels", "256",
                     *(() if photograph.exists() else ("--photo", "lambert", photograph)))
        (study / "protocols" / path.name).write_text(text, encoding="utf-8")
        if path.stem != "chapter_selection":
            asperity("simulate", study / "protocols" / path.name, "--study", study, "--participants", "2", "--seed", "7",
                     "--recordings", "none")
    return len(protocols_in(study / "protocols"))


def ours_of(outcome):
    """What exported_protocols.R computes, as the study's own analysis has it."""
    name, ours = outcome["protocol"], {}
    ours[name, "answers", ""] = outcome["answers"]
    for finding in outcome["findings"]:
        key = {"pc": "correct", "pc.cp.lower": "correct.low", "pc.cp.upper": "correct.high"}.get(finding["quantity"])
        if key:
            ours[name, key, ""] = finding["value"]
        if finding["quantity"] == "pl.logworth.sumzero":
            ours[name, "worth", finding["key"]] = finding["value"]
    for table in outcome["tables"]:
        for row in table["rows"] if table["name"] == "shares" and outcome["kind"] == "selection" else ():
            if row["column"] == "all":
                ours[name, "share", row["item"]] = row["share"]
                ours[name, "share.low", row["item"]] = row["clopper_pearson_low"]
                ours[name, "share.high", row["item"]] = row["clopper_pearson_high"]
    return ours


def every_protocol(folder, study):
    protocols = add_every_protocol(study)
    out = folder / "of_every_protocol"
    asperity("export", study, "--out", out)
    r("exported_protocols.R", out, folder / "results.csv")
    theirs = numbers_in(folder / "results.csv")
    outcomes = json.loads(asperity("analyze", study, "--json"))["outcomes"]
    assert len({name for name, *_ in theirs}) == len(outcomes) == protocols, (theirs, protocols)
    ours = {}
    for outcome in outcomes:
        ours.update(ours_of(outcome))
    worths = {name for name in theirs if name[1] == "worth"}
    # Where an item was never chosen no finite scale fits, and both say so in their way.
    assert any(name in ours for name in worths)
    compare({name: value for name, value in theirs.items() if name in ours or name not in worths}, ours)
    standard_library_reads(out)
    pandas_reads(out, {outcome["protocol"]: outcome["answers"] for outcome in outcomes})
    r_reads_the_public_form(study, folder / "public")
    return protocols, len(theirs)


def r_reads_the_public_form(study, out):
    asperity("export", study, "--out", out, "--public")
    r("exported_protocols.R", out, out.parent / "results_of_public.csv")
    assert numbers_in(out.parent / "results_of_public.csv") == numbers_in(out.parent / "results.csv")


def script_of(out):
    spec = importlib.util.spec_from_file_location("import_of_export", out / "import.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    return script


def standard_library_reads(out):
    """import.py without pandas: every cell of every table has its type and lies in its range."""
    script = script_of(out)
    types = {"integer": int, "number": float, "boolean": bool}
    told = script.codebook()
    assert len(script.files()) >= 9
    for name in script.files():
        for row in script.read_rows(name):
            for column, cell in row.items():
                kind = told[name][column]
                assert type(cell) is types.get(kind["type"], str) or (cell is None and kind["missing"] != "never"), (name, column, cell)
                if isinstance(cell, (int, float)) and not isinstance(cell, bool):
                    lowest, highest = (kind[end] and float(kind[end]) for end in ("minimum", "maximum"))
                    assert lowest is None or cell >= lowest, (name, column, cell, lowest)
                    assert highest is None or cell <= highest, (name, column, cell, highest)


def pandas_reads(out, counted):
    """import.py with pandas: the same cells, in columns of the codebook's types, and as many answered trials as the program counts."""
    script = script_of(out)
    columns = {"integer": "Int64", "number": "float64", "boolean": "boolean"}
    told = script.codebook()
    tables = script.read_tables()
    for name in script.files():
        table = tables[name.rsplit(".", 1)[0].replace("/", "_")]
        rows = script.read_rows(name)
        assert len(table) == len(rows), name
        for column in table.columns:
            kind = told[name][column]
            expected = columns.get(kind["type"], "string" if kind["levels"] is None else "category")
            assert str(table[column].dtype) == expected, (name, column, table[column].dtype)
            for row, cell in zip(rows, table[column]):
                assert pandas.isna(cell) if row[column] is None else cell == row[column], (name, column, row[column], cell)
    answers = script.answered_trials(tables, who="virtual")
    assert len(answers) > 0 and answers["virtual"].all() and answers["valid"].all()
    attempts = answers.drop_duplicates(["participant", "session", "trial"])
    assert attempts["protocol"].astype("string").value_counts().to_dict() == counted


with tempfile.TemporaryDirectory() as temporary:
    folder = pathlib.Path(temporary)
    study, numbers = one_study_in_depth(folder)
    protocols, more = every_protocol(folder, study)
    print(f"{numbers + more} numbers of R's are the program's; {protocols} protocols were read")

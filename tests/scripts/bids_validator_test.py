#!/usr/bin/env python3
"""The BIDS validator, which also checks HED tags, finds no error and no warning in exported datasets: of simulated and of windowed
sessions, with their recordings and without, own and public, also of participants with different protocols and numbers of sessions; and
every column has a description. Arguments: the program asperity, the program bids-validator."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM, VALIDATOR = sys.argv[1:]
ABOUT = ("--author", "A. Author", "--author", "B. Author", "--license", "CC-BY-4.0", "--ethics", "Ethics board, 12/2026")


def asperity(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True)


def problems_of(dataset):
    told = subprocess.run([VALIDATOR, dataset, "--json"], text=True, capture_output=True, check=False)
    issues = json.loads(told.stdout)["issues"]
    return [(kind, issue["key"], [(file["file"] or {}).get("relativePath", "") + ": " + str(file["evidence"]) for file in issue["files"][:3]])
            for kind in ("errors", "warnings") for issue in issues[kind]]


def columns_without_description(dataset):
    for table in sorted([*dataset.rglob("*.tsv"), *dataset.rglob("*.tsv.gz")]):
        sidecar = json.loads((table.parent / (table.name.split(".")[0] + ".json")).read_text(encoding="utf-8"))
        columns = sidecar["Columns"] if table.suffix == ".gz" else table.read_text(encoding="utf-8").split("\n", 1)[0].split("\t")
        yield from (f"{table.name}: {column}" for column in columns if not sidecar.get(column, {}).get("Description"))


def validate(study, out, *options):
    asperity("export", study, "--out", out, *options)
    datasets = [path.parent for path in sorted(out.rglob("dataset_description.json")) if "bids" in path.parent.name]
    assert datasets
    for dataset in datasets:
        problems = problems_of(dataset)
        assert not problems, (dataset, json.dumps(problems, indent=1, ensure_ascii=False))
        assert not list(columns_without_description(dataset)), dataset
    return len(datasets)


def with_tags(path):
    """A protocol of the demonstration with HED tags of the levels of one factor."""
    protocol = json.loads(path.read_text(encoding="utf-8"))
    factor = next(iter(protocol["factors"].values()))
    factor["hed"] = {str(level): "Item, (Rough, Manufactured-material)" for level in factor["levels"]}
    path.write_text(json.dumps(protocol), encoding="utf-8")
    return path


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    simulated, people = folder / "simulated", folder / "people"
    asperity("new", simulated, "--demo", *ABOUT)
    with_tags(simulated / "protocols/chapter_selection.json")
    for name in ("chapter_selection", "chapter_matching", "chapter_recognition", "roughness_force", "semantic_differential", "amplitude_jnd"):
        asperity("simulate", simulated / f"protocols/{name}.json", "--study", simulated, "--participants", "2", "--seed", "3")
    # Of further participants, with two sessions each.
    asperity("simulate", simulated / "protocols/chapter_matching.json", simulated / "protocols/roughness_in_pairs.json", "--study", simulated,
             "--participants", "1", "--seed", "4")
    shutil.copytree(ROOT / "tests/earlier_studies/present/study", people)
    asperity("metadata", people, *ABOUT)
    number = 0
    for study in (simulated, people):
        number += validate(study, folder / (study.name + "_own"), "--formats", "bids")
        number += validate(study, folder / (study.name + "_public"), "--formats", "bids", "--public")
    number += validate(simulated, folder / "recorded", "--formats", "physio")
    asperity("metadata", simulated, "--author", "A. Author")
    number += validate(simulated, folder / "one_author", "--formats", "bids")
    print(f"{number} datasets without an error or a warning")

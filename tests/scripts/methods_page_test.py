#!/usr/bin/env python3
"""docs/methods.md has a row for every library protocol, with the trials and minutes that `check` states, and with analyses that exist.

An analysis exists if a study of the protocol (tests/golden/results) has its quantity, which the README of its method states. Argument: the program asperity.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
STUDIES = ROOT / "tests" / "golden" / "results"
# Their READMEs state the quantity of each analysis in the findings of a study, in the words of the page.
METHODS = ROOT / "app" / "findings" / "methods"


def tables(text, *columns):
    """The rows of the tables with these columns, as dictionaries."""
    header = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|"):
            header = []
        elif not header:
            header = cells if set(columns) <= set(cells) else [""]
        elif len(cells) == len(header) > 1 and not cells[0].startswith("---"):
            yield dict(zip(header, cells))


def rows(text):
    """Per library protocol: the kind, the trials and the minutes that its row states."""
    for row in tables(text, "library protocol"):
        name = row["library protocol"].strip("`")
        if re.fullmatch(r"\w+", name):
            yield name, row


def stated_quantities():
    """The quantity of each analysis that the READMEs of the methods state."""
    return {row["analysis"]: row["quantity"].strip("`") for page in sorted(METHODS.glob("*/README.md"))
            for row in tables(page.read_text(encoding="utf-8"), "analysis", "quantity")}


def analyses(page):
    """Per library protocol: the analyses that its row states; "the same" stands for those of the last row without these words."""
    last = []
    for name, row in page.items():
        parts = re.split("[,;] ", row["analysis"])
        if parts[0] == "the same":
            parts[:1] = last
        else:
            last = parts
        yield name, parts


def quantities(name):
    """The quantities of the findings of a study of the protocol."""
    text = (STUDIES / name / "analysis.txt").read_text(encoding="utf-8")
    return set(re.findall(r"^findings \S+ \| (\S+) \|", text, re.MULTILINE))


def main():
    page = dict(rows((ROOT / "docs" / "methods.md").read_text(encoding="utf-8")))
    protocols = {path.stem: path for path in sorted((ROOT / "protocols" / "library").glob("*.json")) if "." not in path.stem}
    wrong = [f"{name}: docs/methods.md has no row for this library protocol" for name in protocols.keys() - page.keys()]
    wrong += [f"{name}: docs/methods.md has a row for it, and the library has no such protocol" for name in page.keys() - protocols.keys()]
    for name in protocols.keys() & page.keys():
        stated = subprocess.run([PROGRAM, "check", protocols[name]], text=True, capture_output=True, check=True).stdout
        trials = re.search(r"(\d+) trials?,", stated).group(1)
        minutes = re.search(r"about (\d+) min in all", stated).group(1)
        row = page[name]
        if (row["trials"], row["minutes"]) != (trials, minutes):
            wrong.append(f"{name}: docs/methods.md states {row['trials']} trials and {row['minutes']} min, "
                         f"check states {trials} trials and {minutes} min")
        kind = json.loads(protocols[name].read_text(encoding="utf-8"))["kind"]
        if f"`{kind}`" not in row["kind"]:
            wrong.append(f"{name}: docs/methods.md states the kind {row['kind']}, the protocol {kind}")
    known = stated_quantities()
    for name, stated in analyses(page):
        found = quantities(name)
        wrong += [f"{name}: docs/methods.md states \"{part}\", and a study of it has no such number, or no README of a method states its quantity"
                  for part in stated if known.get(part) not in found]
    print("\n".join(sorted(wrong)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""docs/methods.md has a row for every library protocol, with the trials and minutes that `check` states. Argument: the program asperity."""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]


def rows(text):
    """Per library protocol: the kind, the trials and the minutes that its row states."""
    header = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if "library protocol" in cells:
            header = cells
        elif line.startswith("|") and header and len(cells) == len(header):
            row = dict(zip(header, cells))
            name = row["library protocol"].strip("`")
            if re.fullmatch(r"\w+", name):
                yield name, row
        elif not line.startswith("|"):
            header = []


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
    print("\n".join(sorted(wrong)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

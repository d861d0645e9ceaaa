#!/usr/bin/env python3
"""Every number of docs/published-counts.md is what the command of that page says. Usage: … asperity"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = [ROOT / "docs/data/wu_2009" / name for name in ("most_realistic.csv", "matched.csv", "recognised.csv")]
ROW = re.compile(r"^\| .* \| (?P<value>[-+.0-9e]+) \| `(?P<quantity>[^`]+)` \|(?: `(?P<key>[^`]+)`)? \|$")


def digits(text: str) -> int:
    return len(re.sub(r"e.*|[-+.]", "", text).lstrip("0")) or 1


run = subprocess.run([sys.argv[1], "analyze", "--as", "seedpaper", "--json", "--table", *map(str, TABLES)],
                     capture_output=True, text=True, check=True)
found = {(each["quantity"], each["key"]): each["value"] for each in json.loads(run.stdout)["findings"]}
wrong = []
rows = 0
for line in (ROOT / "docs/published-counts.md").read_text(encoding="utf-8").splitlines():
    row = ROW.match(line)
    if row is None:
        continue
    rows += 1
    key = (row["quantity"], (row["key"] or "").replace("\\|", "|"))
    places = digits(row["value"])
    if key not in found:
        wrong.append(f"{key} is none of the command's findings")
    elif f"{found[key]:.{places - 1}e}" != f"{float(row['value']):.{places - 1}e}":
        wrong.append(f"{key}: the page says {row['value']}, the command {found[key]}")
if rows < 30:
    wrong.append(f"only {rows} rows were understood")
print("\n".join(wrong))
sys.exit(1 if wrong else 0)

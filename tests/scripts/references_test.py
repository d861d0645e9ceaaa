#!/usr/bin/env python3
"""Every publication that a comment names by a key such as [Wu 2009], or that a report cites, stands in docs/references.md."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEY = re.compile(r"[A-Z][\w'’. -]* (?:18|19|20)\d\d[a-z]?")
FOLDERS = ("analysis", "app", "bench", "device", "docs", "protocols", "renderers", "results_schema", "stimuli", "tests")

known = set(re.findall(r"^\*\*\[([^\]]+)\]\*\*", (ROOT / "docs/references.md").read_text(encoding="utf-8"), re.M))
missing = []
for folder in FOLDERS:
    for path in sorted((ROOT / folder).rglob("*")):
        if path.suffix not in {".h", ".cpp", ".md"} or path.name == "references.md":
            continue
        for bracket in re.findall(r"\[([^\[\]\n]+)\]", path.read_text(encoding="utf-8")):
            for key in bracket.split(", "):
                if KEY.fullmatch(key) and key not in known:
                    missing.append(f"{path.relative_to(ROOT)}: [{key}] has no entry in docs/references.md")
cited = re.findall(r'Reference\{"([^"]+)"', (ROOT / "app/findings/outcome/references.cpp").read_text(encoding="utf-8"))
missing += [f"app/findings/outcome/references.cpp: [{key}] has no entry in docs/references.md" for key in cited if key not in known]
if len(known) < 40 or len(cited) < 8:
    missing.append(f"docs/references.md: only {len(known)} entries were understood, and {len(cited)} of those that reports cite")
print("\n".join(missing))
sys.exit(1 if missing else 0)

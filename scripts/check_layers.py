#!/usr/bin/env python3
"""Fails when a source file includes a folder that its own folder may not know.

The table is the architecture (docs/architecture.md). Qt is allowed in app/gui, app/figures and
app/report only.
"""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "analysis": set(),
    "stimuli": {"analysis"},
    "device": {"analysis"},
    "renderers": {"stimuli", "device", "analysis"},
    "protocols": {"stimuli", "analysis"},
    "results_schema": set(),
    "app": {"analysis", "stimuli", "device", "renderers", "protocols", "results_schema"},
}
EVERYTHING = set(MAY_INCLUDE) | {"tests", "bench"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')
WITH_QT = ("app/gui/", "app/figures/", "app/report/")
QT = re.compile(r"^(Q[A-Z]|Qt)")


def complaints(root: pathlib.Path):
    for folder in sorted(MAY_INCLUDE):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in {".h", ".cpp"}:
                continue
            relative = path.relative_to(root).as_posix()
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                target = match.group(2)
                first = target.split("/")[0]
                if first in EVERYTHING and first != folder and first not in MAY_INCLUDE[folder]:
                    yield f"{relative}:{number}: {folder}/ may not include {first}/ ({target})"
                if QT.match(target) and not relative.startswith(WITH_QT):
                    yield f"{relative}:{number}: Qt belongs in {', '.join(WITH_QT)} ({target})"


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if root.is_file():
        root = root.parent.parent
    found = list(complaints(root))
    print("\n".join(found) if found else "layers: every include points the allowed way")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Fails when a source file includes a folder that its own folder may not know.

The rules are the tables of docs/layers.md with the columns "folder" and "may include": what people read and the
check are one. A row holds for its folder and all below it that have no separate row, and a row of all folders in one (a/*/) for each of them; what a component of app/ may include, the
folders inside it may include as well. "all" means every folder, "Qt" the headers of Qt. The rows themselves must not form a circle.
"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')
QT = re.compile(r"^(Q[A-Z]|Qt)")
NAME = re.compile(r"`([^`]+)`")


def read_rules(page: pathlib.Path) -> dict[str, set[str]]:
    """Folder, without the slash at its end → what it may include."""
    rules: dict[str, set[str]] = {}
    is_rule = False
    for line in page.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|"):
            is_rule = False
        elif cells[:2] == ["folder", "may include"]:
            is_rule = True
        elif is_rule and NAME.search(cells[0]):
            folder = NAME.search(cells[0]).group(1).rstrip("/")
            rules[folder] = {"all"} if cells[1] == "all" else {name.rstrip("/") for name in NAME.findall(cells[1])}
    return rules


def with_each_folder(rules: dict[str, set[str]], root: pathlib.Path) -> dict[str, set[str]]:
    """Instead of the row of all folders in one (a/*) a row for each that has none of its own."""
    each = {}
    for pattern in [row for row in rules if row.endswith("/*")]:
        allowed = rules.pop(pattern)
        each |= {path.relative_to(root).as_posix(): allowed for path in sorted(root.glob(pattern)) if path.is_dir()}
    return each | rules


def around(folder: str):
    """The folder, then the ones that it is in: a/b/c, a/b, a."""
    parts = folder.split("/")
    for length in range(len(parts), 0, -1):
        yield "/".join(parts[:length])


class Layers:
    def __init__(self, rules: dict[str, set[str]]):
        self.rules = rules

    def row_of(self, path: str) -> str | None:
        return next((folder for folder in around(path) if folder in self.rules), None)

    def may_include(self, row: str) -> set[str]:
        """A folder in a component may include what the component may; the component does not get what the whole of app/ may."""
        return set().union(*(self.rules.get(folder, set()) for folder in around(row) if folder == row or folder.count("/") == 1))

    def permits(self, row: str, target: str) -> bool:
        allowed = self.may_include(row)
        return target == row or "all" in allowed or any(folder in allowed for folder in around(target))

    def circles(self):
        """Rows that may include each other, by whatever way."""
        steps = {row: {other for other in self.rules if other != row and "all" not in self.may_include(row)
                       and self.permits(row, other) and not row.startswith(other + "/")} for row in self.rules}
        for row in sorted(self.rules):
            seen: set[str] = set()
            ahead = [row]
            while ahead:
                for other in steps[ahead.pop()] - seen:
                    seen.add(other)
                    ahead.append(other)
            if row in seen:
                yield f"docs/layers.md: {row}/ may include itself by way of others; remove one of the names in their rows"


def complaints(root: pathlib.Path):
    layers = Layers(with_each_folder(read_rules(root / "docs" / "layers.md"), root))
    if not layers.rules:
        yield "docs/layers.md: no table has the columns folder and may include"
    yield from layers.circles()
    tops = {folder.split("/")[0] for folder in layers.rules} | {"bench"}
    for top in sorted(tops - {"bench", "tests"}):
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in {".h", ".cpp"}:
                continue
            relative = path.relative_to(root).as_posix()
            row = layers.row_of(path.parent.relative_to(root).as_posix())
            if row == "app":
                yield f"{relative}: its folder has no row in docs/layers.md"
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                target = match.group(2)
                if QT.match(target) and not {"Qt", "all"} & layers.may_include(row):
                    yield f"{relative}:{number}: {row}/ may not include Qt ({target})"
                if target.split("/")[0] not in tops:
                    continue
                of_target = layers.row_of(target.rpartition("/")[0]) or target.split("/")[0]
                if not layers.permits(row, of_target):
                    yield f"{relative}:{number}: {row}/ may not include {of_target}/ ({target})"


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if root.is_file():
        root = root.parent.parent
    found = list(complaints(root))
    print("\n".join(found) if found else "layers: every include points the allowed way")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

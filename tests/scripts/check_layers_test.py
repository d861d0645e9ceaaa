"""The check of layers has to fail on a tree with a forbidden include, an unlisted folder or a circle of rows, and say where."""
import pathlib
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_layers.py"
HEAD = "| folder | may include | contents |\n| --- | --- | --- |\n"
ROWS = {"analysis": "–", "device": "`analysis`", "renderers": "`device`", "app": "all", "app/words": "`analysis`",
        "app/tasks": "`app/words`, `device`", "app/gui": "`Qt`, `app/tasks`", "app/gui/look": "–", "app/gui/data": "`app/gui/look`"}


def check(files: dict[str, str], rows: dict[str, str]) -> tuple[int, str]:
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "docs").mkdir()
        table = "".join(f"| [`{name}/`](x) | {may} | … |\n" for name, may in rows.items())
        (root / "docs" / "layers.md").write_text(HEAD + table + "\nText.\n", encoding="utf-8")
        for name, text in files.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        result = subprocess.run([sys.executable, CHECK, root], capture_output=True, text=True)
        return result.returncode, result.stdout + result.stderr


def expect(what: str, files: dict[str, str], reported: list[str], rows: dict[str, str] = ROWS) -> None:
    status, said = check(files, rows)
    missing = [part for part in reported if part not in said]
    if status != (1 if reported else 0) or missing:
        sys.exit(f"{what}: exited {status}; not reported: {missing}\n{said}")


expect("allowed includes", {
    "app/gui/data/page.cpp": '#include <QString>\n#include "app/gui/look/theme.h"\n#include "app/tasks/run.h"\n',
    "app/tasks/run.cpp": '#include "app/words/phrase.h"\n#include "device/drivers.h"\n',
}, [])
expect("forbidden includes", {
    "device/wrong.cpp": '#include "device/ok.h"\n#include "renderers/force/force_renderer.h"\n',
    "analysis/wrong.cpp": "#include <QString>\n",
    "app/words/wrong.cpp": '#include "app/tasks/run.h"\n',
    "app/gui/look/wrong.cpp": '#include "app/gui/data/page.h"\n',
    "app/gui/data/wrong.cpp": '#include "renderers/force/force_renderer.h"\n',
}, ["device/wrong.cpp:2:", "analysis/wrong.cpp:1:", "app/words/wrong.cpp:1:", "app/gui/look/wrong.cpp:1:",
    "app/gui/data/wrong.cpp:1:"])
expect("a folder without a row", {"app/new/file.cpp": "\n"}, ["app/new/file.cpp: its folder has no row"])
expect("a circle", {}, ["app/words/ may include itself by way of others"],
       ROWS | {"app/words": "`analysis`, `app/tasks`"})
expect("folders that a row with * has together", {
    "app/tasks/one/a.cpp": '#include "device/ok.h"\n#include "app/tasks/two/b.h"\n',
    "app/tasks/two/b.cpp": '#include "app/gui/look/theme.h"\n#include "app/tasks/two/b.h"\n',
    "app/gui/all.cpp": '#include "app/tasks/one/a.h"\n',
}, ["app/tasks/one/a.cpp:2:", "app/tasks/two/b.cpp:1:"], ROWS | {"app/tasks/*": "`device`"})

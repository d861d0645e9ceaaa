"""The check of words finds a planted sentence of every row of the glossary, wherever it stands, and leaves good ones."""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_words.py"
spec = importlib.util.spec_from_file_location("check_words", SCRIPT)
check_words = importlib.util.module_from_spec(spec)
sys.modules["check_words"] = check_words
spec.loader.exec_module(check_words)

GOOD = (
    "The proportion of correct responses is .62, 95 % CI [.51, .72], N = 20.",
    "The least share of the workspace that the handle reached.",
    "Right-handed participants hold it in the right hand.",
    "There is no difference, and there are no responses of this kind.",
    "The number of trials is no longer than the plan.",
    "A person moves the handle along the border of the workspace.",
    "He was in doubt about it.",
    "It is set in the protocol.",
)


def rows_in(text):
    return {row for row, _, _ in check_words.findings_in(text)}


wrong = [row for row, _, _, planted in check_words.GLOSSARY if row not in rows_in(planted)]
assert not wrong, f"not found in their own sentences: {wrong}"
found = {text: rows_in(text) for text in GOOD if rows_in(text)}
assert not found, f"found in good sentences: {found}"
assert len(check_words.EXCEPTIONS) <= 60
assert all(reason for _, reason in check_words.EXCEPTIONS)

with tempfile.TemporaryDirectory() as folder:
    root = pathlib.Path(folder)
    planted = "Nobody mends it."
    for name, text in {
        "app/gui/page.cpp": f'// {planted}\nauto a = tr("{planted}");\nauto b = name("nobody");\n',
        "app/cli/parts.cpp": 'const char* kText =\n    "Nobody "\n    "mends it.";\n',
        "app/raw.cpp": f'const char* kText = R"({planted})";\n',
        "protocols/library/a.json": f'{{"prompt": "{planted}"}}\n',
        "docs/page.md": f"It is `nobody`.\n\n```\n{planted}\n```\n\n    {planted}\n\n{planted}\n",
        "app/README.md": f"{planted}\n",
        "tests/README.md": f"{planted}\n",
        "scripts/build": f"#!/bin/sh\n# {planted}\n",
        "tests/page.cpp": f'auto a = "{planted}";\n',
    }.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    result = subprocess.run([sys.executable, SCRIPT, root], capture_output=True, text=True)
    places = {line.split(": ")[0] for line in result.stdout.splitlines() if "“" in line}
    expected = {"app/gui/page.cpp:2", "app/cli/parts.cpp:2", "app/raw.cpp:1", "protocols/library/a.json:1", "docs/page.md:9",
                "app/README.md:1", "tests/README.md:1", "scripts/build:2"}
    assert result.returncode == 1 and places == expected, (result.returncode, places, result.stdout, result.stderr)
    counts = subprocess.run([sys.executable, SCRIPT, "--counts", root], capture_output=True, text=True).stdout
    assert "     2 windows" in counts and "     6 documents" in counts, counts

with tempfile.TemporaryDirectory() as folder:
    assert subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True).returncode == 0

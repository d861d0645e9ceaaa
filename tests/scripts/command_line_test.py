#!/usr/bin/env python3
"""The documents know the same subcommands and options as the program. Argument: the program asperity."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]+")
COMMAND = re.compile(r"(?:\basperity|scripts/run|\$ASPERITY) ([a-z][a-z-]*)(.*)")
GLOBAL = {"--help", "--version"}


def help_of(*subcommand):
    return subprocess.run([PROGRAM, *subcommand, "--help"], text=True, capture_output=True, check=True).stdout


def options_of(subcommand):
    lines = help_of(subcommand).split("Options:")[1].splitlines()
    declared = (line for line in lines if re.match(r"  -", line))
    return {found for line in declared for found in OPTION.findall(line.split("Needs:")[0])} | {"--help"}


complaints = []
subcommands = re.findall(r"^  ([a-z][a-z-]*) ", help_of().split("Subcommands:")[1], re.MULTILINE)
options = {name: options_of(name) for name in subcommands}
reference = (ROOT / "docs" / "command-line.md").read_text(encoding="utf-8")
sections = {part.split("\n", 1)[0]: part for part in re.split(r"^## ", reference, flags=re.MULTILINE)[1:]}

for name in sorted(set(subcommands) ^ set(sections)):
    complaints.append(f"docs/command-line.md and --help do not agree that there is a subcommand {name}")
for name in sorted(set(subcommands) & set(sections)):
    named = set(OPTION.findall(sections[name])) | GLOBAL
    for option in sorted((options[name] | GLOBAL) ^ named):
        complaints.append(f"docs/command-line.md and --help do not agree on {name} {option}")

manual = (ROOT / "app" / "desktop" / "asperity.1").read_text(encoding="utf-8")
for name in sorted(set(subcommands) ^ set(re.findall(r"^\.B ([a-z][a-z-]*)$", manual, re.MULTILINE))):
    if name != "asperity":  # the synopsis
        complaints.append(f"app/desktop/asperity.1 and --help do not agree that there is a subcommand {name}")

# Commands anywhere in the documents: lines of code blocks that begin with them.
for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md")), *sorted(ROOT.glob("*/README.md"))]:
    text = path.read_text(encoding="utf-8").replace("\\\n", " ")
    for line in re.findall(r"^(?:    |\$ )?((?:asperity|scripts/run) .*)$", text, re.MULTILINE):
        match = COMMAND.match(line)
        if match is None:
            continue
        name, rest = match.groups()
        if name not in options:
            complaints.append(f"{path.relative_to(ROOT)}: there is no subcommand {name}: {line}")
            continue
        for option in sorted(set(OPTION.findall(rest)) - options[name]):
            complaints.append(f"{path.relative_to(ROOT)}: {name} has no option {option}: {line}")

if complaints:
    sys.exit("\n".join(complaints))

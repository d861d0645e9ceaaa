#!/usr/bin/env python3
"""The documents know the same subcommands and options as the program. Argument: the program asperity."""
import gzip
import pathlib
import re
import subprocess
import sys
import tempfile

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

# The man page, as installing makes it, with the sentences of --help.
with tempfile.TemporaryDirectory() as folder:
    page = pathlib.Path(folder, "asperity.1")
    subprocess.run(["cmake", "-D", f"PROGRAM={PROGRAM}", "-D", f"TEMPLATE={ROOT / 'app/desktop/asperity.1.in'}", "-D", f"OUTPUT={page}",
                    "-P", ROOT / "cmake" / "man_page.cmake"], check=True)
    manual = page.read_text(encoding="utf-8")
    if gzip.decompress(pathlib.Path(f"{page}.gz").read_bytes()).decode() != manual:
        complaints.append("the compressed man page differs from the man page")
listed = re.search(r"^\.SH SUBCOMMANDS$(.*?)^\.SH ", manual, re.MULTILINE | re.DOTALL).group(1)
entries = dict(re.findall(r"^\.TP\n\.B (.*)\n(.*)$", listed.replace("\\-", "-"), re.MULTILINE))
helped = dict(re.findall(r"^  ([a-z][a-z-]*) +(.*)$", help_of().split("Subcommands:")[1], re.MULTILINE))
for name in sorted(name for name in entries.keys() | helped.keys() if entries.get(name) != helped.get(name)):
    complaints.append(f"the man page and --help do not agree on the subcommand {name}")

# What a new study and the README state about versions is the same sentence.
with tempfile.TemporaryDirectory() as folder:
    made = subprocess.run([PROGRAM, "new", pathlib.Path(folder, "study")], text=True, capture_output=True, check=True).stdout
rule = re.search(r"Before 1\.0\.0, .*$", made)
readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
if rule is None or "the package of each version stays available" not in rule[0] or rule[0].strip() not in readme:
    complaints.append(f"README.md does not contain what a new study states about versions: {made}")

# Commands anywhere in the documents: lines of code blocks that begin with them. What follows -- is a command by itself.
for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md")), *sorted(ROOT.glob("*/README.md"))]:
    text = path.read_text(encoding="utf-8").replace("\\\n", " ")
    lines = re.findall(r"^(?:    |\$ )?((?:asperity|scripts/run) .*)$", text, re.MULTILINE)
    for line in [("asperity " if at else "") + part for line in lines for at, part in enumerate(line.split(" -- "))]:
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

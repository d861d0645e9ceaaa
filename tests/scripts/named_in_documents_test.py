#!/usr/bin/env python3
"""Every file, subcommand and option that a document names is there. Argument: the program asperity."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
FOLDERS = {"analysis", "app", "bench", "cmake", "device", "docs", "protocols", "renderers", "results_schema", "scripts", "stimuli", "tests"}
# Of a study, which has folders of the same names.
OF_A_STUDY = re.compile(r"^(stimuli|protocols|recordings|locks|device)/")


def documents():
    return [ROOT / "README.md", *(path for folder in sorted(FOLDERS) for path in sorted((ROOT / folder).rglob("*.md")))]


def slug(heading):
    words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words.replace("`", "")).replace(" ", "-")


def anchors(document):
    text = re.sub(r"^```.*?^```", "", document.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    return {slug(line.lstrip("#")) for line in text.splitlines() if line.startswith("#")}


def wrong_links(document, text):
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"^[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (document.parent / path).resolve() if path else document
        if not file.exists():
            yield f"the link to {target} leads nowhere"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file):
            yield f"the link to {target} names a heading that is not there"


def wrong_files(text):
    for name in re.findall(r"`([a-z_]+/[\w.\-/]*\w)`", text):
        # "my_model" and the like stand for names of the reader's own.
        if name.split("/")[0] not in FOLDERS or OF_A_STUDY.match(name) or "/my_" in name:
            continue
        if not (ROOT / name).exists() and not list((ROOT / name).parent.glob(pathlib.Path(name).name + ".*")):
            yield f"there is no {name}"


def helps():
    listing = subprocess.run([PROGRAM, "--help"], text=True, capture_output=True, check=True).stdout
    names = re.findall(r"^  ([a-z][a-z\-]+) ", listing.split("Subcommands:")[1], re.MULTILINE)
    return {name: subprocess.run([PROGRAM, name, "--help"], text=True, capture_output=True, check=True).stdout for name in names}


def commands(text):
    joined = text.replace("\\\n", " ")
    for line in joined.splitlines():
        found = re.match(r"^(?:    |\$ )?(?:asperity|scripts/run)\s+(.+)$", line) if line.startswith((" ", "$", "a", "s")) else None
        if found and not line.lstrip().startswith("asperity is"):
            yield from found.group(1).split("#")[0].split(" -- ")  # after -- the command that is submitted
    for code in re.findall(r"`(?:asperity|scripts/run) ([^`]+)`", joined):
        yield code


def wrong_commands(text, helped):
    for command in commands(text):
        words = command.split()
        if words and words[0].startswith("--isa") and len(words) > 2:
            words = words[2:]
        if not words or not re.fullmatch(r"[a-z][a-z\-]+", words[0]):
            continue
        if words[0] not in helped:
            yield f"there is no subcommand {words[0]} (in \"{command.strip()[:60]}\")"
            continue
        for option in re.findall(r"(?<![\w\-])--[a-z][a-z0-9\-]*", command):
            if option != "--help" and not re.search(re.escape(option) + r"(?![\w\-])", helped[words[0]]):
                yield f"{words[0]} has no option {option}"


found = []
known = helps()
for page in documents():
    content = page.read_text(encoding="utf-8")
    for wrong in (*wrong_links(page, content), *wrong_files(content), *wrong_commands(content, known)):
        found.append(f"{page.relative_to(ROOT)}: {wrong}")
if found:
    sys.exit("\n".join(sorted(set(found))))

#!/usr/bin/env python3
"""Finds words that the glossary replaces, in shown text and in documents.

Usage: check_words.py [--counts] [--area AREA] [ROOT]

Prints FILE:LINE: the phrase and what to write instead, then the number of findings per area; exits with 1 if there are any.
--counts prints only the numbers, per area and per row of the glossary. --area prints the findings of one area.

Shown text is what stands in string literals of C++ with at least two words and in texts of the library's protocols; the
sources of translations are among these literals. Scripts are read whole. In documents code is left out: fenced and indented blocks, `inline`
code and links' targets. A pattern is a phrase, not a bare word: "a share of the workspace" and "the right hand" are fine.
"""
import argparse
import collections
import dataclasses
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Name, pattern, what to write, a sentence that has to be found.
GLOSSARY = (
    ("go", r"\b(?:one|a|each|every|whole|first|last|next) go(?:es)?\b(?! (?:on|to|into|with|at|by|in|out|through|back))|"
           r"\bgoes at (?:a|the|one) trial",
     "attempt, trial, assignment", "How often is a whole go right?"),
    # A participant may be told something.
    ("tell", r"\b(?:is|are|was|were) told\b|\btells (?:how|what|which|who|that|whether|it|them|of|a|no|apart)\b|"
             r"\b(?:tell|told) apart\b|\btold (?:by|of)\b",
     "report, state, indicate, determine", "The file tells how many there are."),
    ("say of things", r"\b(?:file|line|table|protocol|number|device|page|sentence|figure|column|row|study|report|window|note|"
                      r"remark|it|which|that|what) says?\b|\bsays (?:so|nothing|what|how|which|that|something)\b",
     "state, show, specify", "The table says how it was made."),
    ("mend", r"\bmend(?:s|ed|ing)?\b", "fix, correct, repair", "Mend the sound, then resume."),
    ("go on", r"\b(?:go|goes|going|gone|went) on (?:with|from|until|after|to count)|\bcan(?:not)? go on\b|\bgo on\b",
     "resume, continue", "The session can be gone on with."),
    # A hand may let go of a handle.
    ("let go of", r"\b(?:is|are|was|were|be|been|being) let go\b|\b(?:device|force|lock|kernel|program)s? lets? go\b",
     "release, switch off, close", "The device was let go of."),
    ("broken off", r"\b(?:broken|breaks?|broke|breaking) off\b", "interrupted", "The session was broken off."),
    ("set aside", r"\bsets? aside\b|\bsetting aside\b", "invalidated, repeated by the experimenter",
     "The attempt was set aside."),
    ("so that … so", r"\bso (?:is|are|was|were|has|have|does|do|can) (?:it|they|the|an?|one)\b|\bas it (?:is|was), so\b",
     "this way, as follows, the same applies", "As it is, so it is."),
    ("whoever", r"\b(?:whoever|nobody|somebody|anybody|everybody)\b",
     "the passive, the user, the experimenter, the participant", "Whoever opens it reads it."),
    ("beside", r"\bbeside\b(?! oneself)", "next to, in addition to", "The number stands beside it."),
    ("doubts", r"\bdoubts?\b(?! about)|\bdoubted\b|\bdoubtful\b", "warnings", "The texture has two doubts."),
    ("is no X", r"(?<!there )\b(?:is|are|was|were) no (?!longer|more|less|fewer|later|earlier|other|one|way|need|such|difference|"
                r"significant|evidence|effect|better|worse|greater|larger|smaller)[a-z]+",
     "is not a, there is no", "It is no number."),
    ("share", r"\bshares? of (?:the )?(?:answers|trials|responses|attempts|choices|participants|right|correct)",
     "proportion of", "The share of answers that were right."),
    ("right answer", r"\b(?:right|wrong) (?:answers?|ones?|choices?|responses?|assignments?)\b|\banswer(?:s|ed)? (?:is |are |was |"
                     r"were )?(?:right|wrong(?:ly)?|rightly)\b",
     "correct, incorrect", "How many right answers are there?"),
    ("persons", r"\bpersons\b|\bpeople(?:'s|’s)? (?:sessions?|answers?|responses?|attempts?|trials?)\b|"
                r"\b(?:each|every|per|by|of|over) (?:person|people)\b",
     "participant", "The mean over people."),
    ("women less men", r"\b(?:women|men) (?:less|minus) (?:women|men)\b", "difference (women − men)", "women less men"),
    ("after Holm", r"\bafter Holm\b", "Holm-corrected", "p = .03 after Holm"),
    ("splitting anew", r"\bsplit(?:ting|s)? (?:the )?\w* ?anew\b|\brandom permutations?\b|\banew\b",
     "permutation test, again", "Splitting the participants anew gives p = .04."),
    ("taken for", r"\btaken? for (?:one another|each other|another|the other)\b", "confused with",
     "Two surfaces are taken for one another."),
    ("of its own", r"\bof (?:its|their|one's|one’s|his|her|your|our) own\b", "its own, separate", "It has a file of its own."),
    ("stand-in", r"\bstand-ins?\b|\bstands? in for\b", "simulated model, test double", "A stand-in for the device."),
    ("hindrance", r"\bhindrances?\b|\bobstacles?\b", "blocker", "There is a hindrance."),
    ("at all", r"(?<!or not )\bat all\b|\bwholly\b", "(delete), completely", "It is wholly there."),
    ("what is known", r"\bwhat is known\b|\bnothing is known\b|\bnot known of\b", "known, unknown",
     "Of these nothing is known."),
    ("answers carry bits", r"\bcarr(?:y|ies|ied) (?:[\d.]+ )?bits\b", "transmitted information", "The answers carry bits."),
    ("asked of the hand", r"\basked of the hand\b|\bexplored as asked\b|\bas asked\b", "instructed exploration, as requested",
     "It was not explored as asked."),
    ("likewise", r"\blikewise\b|\bas above\b", "the same applies; say it", "The others likewise."),
)

# Phrases that are right where they stand, each with its reason; at most 60.
EXCEPTIONS = (
    ("somebody else's copyright", "the licence's own term"),
    ("--beside", "the name of an option"),
    ("no right or wrong answers", "the phrase of instructions for a question of opinion"),
)

AREAS = (
    ("participant", ("app/gui/participant/", "app/session/respondents/", "protocols/library/")),
    ("analysis and report", ("app/findings/", "app/figures/", "app/report/", "app/exports/", "analysis/")),
    ("windows", ("app/gui/",)),
    ("command line", ("app/cli/", "app/desktop/")),
    ("reasons and remarks", ("app/words/reason", "app/words/device_remarks", "app/words/offered_reasons", "app/words/event_kinds")),
    ("errors and other text", ("app/", "protocols/", "stimuli/", "device/", "renderers/", "results_schema/")),
    ("scripts", ("scripts/",)),
    ("documents", ()),  # every .md, wherever it stands
)

STRING = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<end>[^()\\\s]*)\((?P<raw>.*?)\)(?P=end)"|"(?P<text>(?:\\.|[^"\\\n])*)"|'
                    r"'(?:\\.|[^'\\\n])+'", re.DOTALL)
INCLUDE = re.compile(r"^[ \t]*#[^\n]*", re.MULTILINE)
WORDS = re.compile(r"[A-Za-z]{2,}[^A-Za-z]+[A-Za-z]{2,}")
ESCAPES = {"\\n": "\n", "\\t": "\t", '\\"': '"', "\\\\": "\\"}


@dataclasses.dataclass
class Finding:
    area: str
    place: str
    row: str
    phrase: str
    instead: str


def literals(source):
    """(line, text) of the string literals, those that follow one another as one."""
    source = INCLUDE.sub(lambda found: " " * len(found.group()), source)
    begun, text, end = None, "", 0
    for found in STRING.finditer(source):
        is_string = found.group("text") is not None or found.group("raw") is not None
        if not is_string:
            continue
        if begun is not None and source[end:found.start()].strip():
            yield source.count("\n", 0, begun) + 1, text
            begun = None
        if begun is None:
            begun, text = found.start(), ""
        part = found.group("text")
        text += re.sub(r"\\.", lambda escape: ESCAPES.get(escape.group(), escape.group()), part) if part is not None \
            else found.group("raw")
        end = found.end()
    if begun is not None:
        yield source.count("\n", 0, begun) + 1, text


def prose(document):
    """(line, text) of the paragraphs of a document, without code."""
    fenced = False
    for number, line in enumerate(document.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced and not line.startswith("    "):
            yield number, re.sub(r"\]\([^)]*\)", "]", re.sub(r"`[^`]*`", "`x`", line))


def texts_of_json(source):
    """(line, text) of the members of a protocol that people read."""
    for number, line in enumerate(source.splitlines(), 1):
        for found in re.finditer(r'("(?:\\.|[^"\\])*")(\s*:)?', line):
            if not found.group(2):
                yield number, json.loads(found.group(1))


def is_script(path):
    """Whose comments and texts are read whole; but not this file, which has every phrase."""
    return path.parent.name == "scripts" and path.suffix in ("", ".sh") and path.is_file()


def shown_texts(path, source):
    if path.suffix == ".md":
        return prose(source)
    if is_script(path):
        return enumerate(source.splitlines(), 1)
    read = texts_of_json if path.suffix == ".json" else literals
    return ((line, text) for line, text in read(source) if WORDS.search(text))


def area_of(name):
    if name.endswith(".md"):
        return "documents"
    return next((area for area, beginnings in AREAS if name.startswith(beginnings)), None)


def findings_in(text):
    """(row, phrase, instead) of each place that the glossary does not have."""
    for phrase, _ in EXCEPTIONS:
        text = text.replace(phrase, " " * len(phrase))
    for row, pattern, instead, _ in GLOSSARY:
        for found in re.finditer(pattern, text, re.IGNORECASE):
            yield row, found.group(), instead


def check(root):
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root).as_posix()
        if name.startswith(("build", ".")) or not (path.suffix in (".cpp", ".h", ".md", ".json") or is_script(path)):
            continue
        if path.suffix != ".md" and name.startswith(("tests/", "bench/")):
            continue
        area = area_of(name)
        if area is None or (path.suffix == ".json" and not name.startswith("protocols/library/")):
            continue
        for line, text in shown_texts(path, path.read_text(encoding="utf-8")):
            for row, phrase, instead in findings_in(text):
                yield Finding(area, f"{name}:{line}", row, phrase, instead)


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("-h", "--help", action="store_true")
    parser.add_argument("--counts", action="store_true")
    parser.add_argument("--area")
    parser.add_argument("root", nargs="?", type=pathlib.Path, default=ROOT)
    arguments = parser.parse_args()
    if arguments.help:
        print(__doc__.strip())
        return 0
    found = list(check(arguments.root.resolve()))
    areas = collections.Counter(finding.area for finding in found)
    rows = collections.Counter(finding.row for finding in found)
    for finding in found:
        if not arguments.counts and arguments.area in (None, finding.area):
            print(f"{finding.place}: “{finding.phrase}” ({finding.row}): write {finding.instead}")
    for area, _ in AREAS:
        print(f"{areas[area]:6} {area}")
    if arguments.counts:
        print()
        for row, count in rows.most_common():
            print(f"{count:6} {row}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

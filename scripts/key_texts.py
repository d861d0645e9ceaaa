#!/usr/bin/env python3
"""Prints the texts and words of the keys of a protocol, a translation and a rendering (labels, meanings, computed defaults), of
the designs of a discrimination, of the tests of kinds, of the pages of the form of a protocol and of drivers (their constant
sentences) as lines that lupdate reads."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROTOCOLS = ROOT / "protocols"
TOKEN = re.compile(r'//[^\n]*|R"\((?P<raw>.*?)\)"|"(?P<text>(?:[^"\\]|\\.)*)"|' r"'(?:[^'\\]|\\.)'|\w+|\S", re.DOTALL)
BRACKETS = {"(": ")", "{": "}", "[": "]"}


def tokens_of(source):
    """Words and signs; of texts, with adjacent ones joined, the content between quotation marks, as a tuple."""
    tokens = []
    for match in TOKEN.finditer(source):
        if match["raw"] is not None:
            text = match["raw"].replace("\\", "\\\\").replace('"', '\\"')
        else:
            text = match["text"]
        if text is None:
            if not match[0].startswith("//"):
                tokens.append(match[0])
        elif tokens and isinstance(tokens[-1], tuple):
            tokens[-1] = (tokens[-1][0] + text,)
        else:
            tokens.append((text,))
    return tokens


def name_before(tokens, at):
    """The function that the bracket at `at` calls, without the arguments of its template."""
    at -= 1
    depth = 0
    while at > 0 and (tokens[at] == ">" or depth > 0):
        depth += {">": 1, "<": -1}.get(tokens[at], 0)
        at -= 1
    return tokens[at] if at >= 0 and isinstance(tokens[at], str) else ""


def texts_among(opening, name, arguments):
    """The texts in the argument positions of labels and meanings."""
    texts = [argument[0][0] if len(argument) == 1 and isinstance(argument[0], tuple) else None for argument in arguments]
    if name == "reported_as":
        return texts[:1]
    if name == "RemovedKey":
        return texts[1:]
    if name == "KindTest":
        return texts[1:2]
    if opening == "{":  # a word: {name, value, meaning}
        if len(texts) > 3 and all(texts[:3]) and texts[3] is None:  # a page: {id, label, meaning, parts}
            return texts[1:3]
        return texts[2:] if len(texts) == 3 and texts[1] is None else []
    if name == "table_of":
        return texts[:1]
    if name.endswith("_key") or name == "with_computed_default":
        return texts[1:]
    return []


def calls_in(tokens):
    """The brackets that enclose something: (bracket, name before it, arguments)"""
    open_brackets = []
    for at, token in enumerate(tokens):
        if token in BRACKETS.values():
            yield open_brackets.pop()
        if token == "," and open_brackets:
            open_brackets[-1][2].append([])
        elif open_brackets:
            open_brackets[-1][2][-1].append(token)
        if token in BRACKETS:
            open_brackets.append((token, name_before(tokens, at), [[]]))


def texts_in(source):
    tokens = tokens_of(source)
    for call in calls_in(tokens):
        yield from texts_among(*call)
    for at, token in enumerate(tokens):
        # .meaning = "…", and constants such as kNameMeaning
        if isinstance(token, tuple) and tokens[at - 1] == "=" and str(tokens[at - 2]).lower().endswith("meaning"):
            yield token[0]
        # the name of a design: .name = "…", with blanks, which names of keys do not have
        if isinstance(token, tuple) and tokens[at - 3 : at] == [".", "name", "="] and " " in token[0]:
            yield token[0]


def constants():
    """The texts of constants by their names: "ChoiceForm::kName", and without the class "kName"."""
    found = {}
    for path in sorted(PROTOCOLS.rglob("*.h")):
        source = path.read_text(encoding="utf-8")
        for constant in re.finditer(r'\b(k\w+) ?(?:=|\{) ?"(\w+)"', source):
            found[constant[1]] = constant[2]
            owners = re.findall(r"^struct (\w+)", source[: constant.start()], re.MULTILINE)
            if owners:
                found[f"{owners[-1]}::{constant[1]}"] = constant[2]
    return found


def words_in(source, named):
    """The names of words: {name, value, meaning}. `named`: the texts of constants, by their names."""
    for opening, _, arguments in calls_in(tokens_of(source)):
        if opening != "{" or len(arguments) != 3 or len(arguments[2]) != 1 or not isinstance(arguments[2][0], tuple):
            continue
        name, value = arguments[:2]
        if len(name) == 1 and isinstance(name[0], tuple):
            if not isinstance(value[0], tuple):
                yield name[0][0]
        elif "".join(map(str, name)) in named:
            yield named["".join(map(str, name))]


def sentences_of_driver(source):
    """The constant sentences that a driver states: its summary, remarks and blockers. Not those that are made of parts."""
    tokens = tokens_of(source)
    for at, token in enumerate(tokens):
        if token not in ("summary", "remark", "blocker") or tokens[at + 1 : at + 2] != ["="]:
            continue
        end = at + 2
        while end < len(tokens) and tokens[end] not in (",", ";", "}"):
            end += 1
        stated = tokens[at + 2 : end]
        if "+" not in stated:
            yield from (each[0] for each in stated if isinstance(each, tuple) and each[0])


def main():
    if len(sys.argv) > 1:
        print("Usage: scripts/key_texts.py\n\nPrints a QT_TRANSLATE_NOOP line for each text, for scripts/translations.")
        sys.exit(0 if sys.argv[1:] in (["-h"], ["--help"]) else 2)
    texts = {}
    words = {}
    named = constants()
    folders = [PROTOCOLS / name for name in ("keys", "kind_keys", "shapes")]
    paths = [path for folder in folders for path in sorted(folder.iterdir())]
    paths += [PROTOCOLS / "form" / "form_pages.cpp", PROTOCOLS / "file" / "translation.cpp",
              ROOT / "app" / "study_files" / "rendering_files.cpp"]
    kinds = sorted((PROTOCOLS / "kinds").iterdir())
    paths += [path for path in kinds if "KindTest{" in path.read_text(encoding="utf-8")]
    for path in paths:
        source = path.read_text(encoding="utf-8")
        texts |= dict.fromkeys(texts_in(source))
        words |= dict.fromkeys(words_in(source, named))
    for text in filter(None, texts):
        print(f'QT_TRANSLATE_NOOP("Keys", "{text}")')
    for word in words:
        print(f'QT_TRANSLATE_NOOP("WordsOfKeys", "{word}")')
    drivers = {}
    for path in sorted((ROOT / "device").rglob("*.cpp")):
        drivers |= dict.fromkeys(sentences_of_driver(path.read_text(encoding="utf-8")))
    for sentence in drivers:
        print(f'QT_TRANSLATE_NOOP("Drivers", "{sentence}")')


main()

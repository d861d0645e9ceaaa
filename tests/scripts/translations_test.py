#!/usr/bin/env python3
"""Every text of the windows has its finished translation, with the same places for values.

Texts are what app/gui passes through tr(), what analysis/, app/, protocols/, stimuli/ and renderers/ make with phrase()
for windows and terminal, and what tables of keys contain, most of them in protocols/keys ("Keys")."""
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDER = os.path.join(ROOT, "app", "gui", "translations")
LANGUAGES = ("de", "en")
REFRESH = "run scripts/translations and fill what is new"
# phrase("Context", "Words" "that may go on")
PHRASE = r'\bphrase\(\s*"(\w+)",\s*(?:"(?:[^"\\]|\\.)*"\s*)+\)'
complaints = []


def messages(folder, language):
    """(class, text, comment) -> (is it finished, is it a plural, its translations)"""
    found = {}
    for context in ElementTree.parse(os.path.join(folder, f"asperity_{language}.ts")).getroot().iter("context"):
        for message in context.iter("message"):
            key = (context.findtext("name"), message.findtext("source"), message.findtext("comment") or "")
            translation = message.find("translation")
            is_plural = message.get("numerus") == "yes"
            forms = [form.text or "" for form in translation] if is_plural else [translation.text or ""]
            found[key] = (translation.get("type") is None and all(forms), is_plural, forms)
    return found


def values(text):
    return sorted(set(re.findall(r"%L?[1-9]", text)))


def mnemonics(text):
    return len(re.findall(r"&(?=\w)(?!\w+;)", text))


def complain(language, key, what):
    complaints.append(f'asperity_{language}.ts, {key[0]}, "{key[1]}": {what}')


def sources():
    """(path, text)"""
    for component in ("analysis", "app", "protocols", "stimuli", "renderers"):
        for folder, _, files in os.walk(os.path.join(ROOT, component)):
            for name in files:
                if name.endswith((".h", ".cpp")):
                    path = os.path.join(folder, name)
                    with open(path, encoding="utf-8") as source:
                        yield os.path.relpath(path, ROOT), source.read()


def names_without_namespace():
    """What the sources declare for tr() and give to phrase() apart from classes of the namespace."""
    declared = {"Drivers", "Keys", "WordsOfKeys"}
    for _, text in sources():
        declared |= set(re.findall(r"Q_DECLARE_TR_FUNCTIONS\((\w+)\)", text))
        declared |= set(re.findall(PHRASE, text))
    return declared


def check_phrases():
    """lupdate passes over a phrase() whose words are no literals, without a word."""
    for path, text in sources():
        begun = len(re.findall(r"\bphrase\(\s*(?!const )[^)\s]", text))
        if begun != len(re.findall(PHRASE, text)):
            complaints.append(f"{path}: a phrase() is not made of two literals, and cannot be translated")


def check_translation(language, key, is_plural, forms):
    source = key[1]
    if is_plural and len(forms) != 2:
        complain(language, key, f"needs a singular and a plural, has {len(forms)} forms")
    for index, form in enumerate(forms):
        if values(form) != values(source):
            complain(language, key, f'"{form}" has {values(form)} in place of {values(source)}')
        # The singular may say "one" without a number, the plural may not.
        if "%n" in form if not is_plural else index > 0 and "%n" not in form:
            complain(language, key, f'"{form}" has %n where it should not be, or lacks it')
        if "(s)" in form:
            complain(language, key, f'"{form}" leaves the plural to the reader')
        if source.strip() != source and (form[0] == " ", form[-1] == " ") != (source[0] == " ", source[-1] == " "):
            complain(language, key, f'"{form}" begins or ends with another blank')
        if mnemonics(form) != mnemonics(source):
            complain(language, key, f'"{form}" has another number of mnemonics (&)')


with tempfile.TemporaryDirectory() as fresh:
    refreshed = subprocess.run([os.path.join(ROOT, "scripts", "translations"), "--into", fresh], text=True,
                               capture_output=True, timeout=120)
    if refreshed.returncode != 0:
        sys.exit(f"scripts/translations ended with {refreshed.returncode}: {refreshed.stderr}")
    # What it warns of (a class without Q_OBJECT, tr() of a class in a function that it misreads) files a text
    # under another class than the program looks it up under. Outside of app/gui there is no tr(): a class that lupdate
    # does not know is no matter there.
    complaints += [line for line in refreshed.stderr.splitlines()
                   if line.strip() and ("undeclared qualified class" not in line or "/app/gui/" in line)]
    for language in LANGUAGES:
        kept = messages(FOLDER, language)
        wanted = messages(fresh, language)
        for name in {key[0] for key in wanted} - names_without_namespace():
            if not name.startswith("asperity::"):
                complaints.append(f"{name} is no class that looks up texts: its tr() is written where it is misread")
        for key, (finished, is_plural, forms) in wanted.items():
            if not finished:
                complain(language, key, f"has no finished translation; {REFRESH}")
            else:
                check_translation(language, key, is_plural, forms)
        for key in kept.keys() - wanted.keys():
            complain(language, key, f"is no text of the windows any more; {REFRESH}")
        if language == "de" and len(wanted) < 100:
            complaints.append(f"only {len(wanted)} texts were found in app")
        for name, what in (("SessionChecks", "phrase() was found in app"), ("Keys", "text was found in protocols/keys"),
                           ("WordsOfKeys", "word was found in protocols/keys"),
                           ("Drivers", "sentence was found in device")):
            if language == "de" and not any(key[0] == name for key in wanted):
                complaints.append(f"no {what}")
    check_phrases()

if complaints:
    sys.exit("\n".join(complaints))

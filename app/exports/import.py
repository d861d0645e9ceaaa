"""Loads an export of Asperity with the correct types.

    import importlib.util, sys
    sys.path.insert(0, "DIR")
    import_asperity = __import__("import")          # or: python3 -i DIR/import.py
    tables = import_asperity.read_tables()          # pandas: every .tsv and .csv of the folder, by name
    answers = import_asperity.answered_trials(tables)

Types come from codebook.tsv. Integers that can be missing are Int64, Boolean values are boolean, a text with declared levels
is a category, missing is <NA>. In the files, a text that begins with an apostrophe is preceded by a second one, so that
no spreadsheet reads it as a formula; one apostrophe is removed here.

`read_rows` requires only the standard library and returns a list of dictionaries with None for missing.
"""
import csv
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent


def _cells(path):
    """Returns the names of the columns and the cells as in the file; missing is None."""
    is_csv = path.suffix == ".csv"
    with open(path, encoding="utf-8", newline="") as file:
        if is_csv:
            rows = [[cell or None for cell in row] for row in csv.reader(file)]
        else:
            rows = [[None if cell == "n/a" else cell for cell in line.rstrip("\n").split("\t")] for line in file]
    return rows[0], rows[1:]


def _typed(text, kind):
    if text is None:
        return None
    if kind == "integer":
        return int(text)
    if kind == "number":
        return float(text)
    if kind == "boolean":
        return text == "1"
    return text[1:] if text.startswith("'") else text


def codebook(folder=FOLDER):
    """Returns the rows of codebook.tsv, by file and column."""
    names, rows = _cells(pathlib.Path(folder) / "codebook.tsv")
    told = {}
    for row in rows:
        row = dict(zip(names, (_typed(cell, "text") for cell in row)))
        told.setdefault(row["file"], {})[row["column"]] = row
    return told


def files(folder=FOLDER):
    """Returns the tables that read_tables reads: not those of the datasets in bids/ and psychds/, which contain the same answers."""
    return [name for name in codebook(folder) if name.endswith((".tsv", ".csv")) and "*" not in name
            and "bids/" not in name and name not in ("codebook.tsv", "MANIFEST.tsv")]


def read_rows(name, folder=FOLDER, described_as=None):
    """Returns one table as a list of dictionaries."""
    told = codebook(folder)[described_as or name]
    names, rows = _cells(pathlib.Path(folder) / name)
    return [{column: _typed(cell, told[column]["type"]) for column, cell in zip(names, row)} for row in rows]


def read_table(name, folder=FOLDER, described_as=None):
    """Returns one table as a pandas.DataFrame."""
    import pandas
    told = codebook(folder)[described_as or name]
    rows = read_rows(name, folder, described_as)
    table = pandas.DataFrame(rows, columns=_cells(pathlib.Path(folder) / name)[0], dtype=object)
    for column in table.columns:
        kind, levels = told[column]["type"], told[column]["levels"]
        if kind == "text" and levels is not None:
            declared = levels.split(" | ")
            others = sorted(set(table[column].dropna()) - set(declared))
            table[column] = pandas.Categorical(table[column], categories=declared + others)
        else:
            dtype = {"integer": "Int64", "number": "float64", "boolean": "boolean"}.get(kind, "string")
            table[column] = table[column].astype(dtype)
    return table


def read_tables(folder=FOLDER):
    """Returns every table as a pandas.DataFrame, by name without its extension, with "_" for "/"."""
    return {name.rsplit(".", 1)[0].replace("/", "_"): read_table(name, folder) for name in files(folder)}


def answered_trials(tables, who=None, counted=True):
    """Returns one row per answer to a question of a trial, with the trial, the attempt and its conditions. By default these
    are the answers of human participants in study sessions that count in analyses (counts_in_analyses). `who` is "run",
    "pilot" or "virtual"; `counted=False` also returns answers that do not count. Without `who` ("run"), a ValueError with
    the possible arguments is raised if there are answers, but none of the default ones."""
    is_default, who = who is None, "run" if who is None else who
    if who not in ("run", "pilot", "virtual"):
        raise ValueError(f'answered_trials: who is {who!r}; it must be "run", "pilot" or "virtual"')
    keys = ["participant", "session", "trial", "virtual", "mode"]
    answers = tables["responses"].dropna(subset=["trial"]).merge(tables["attempts"], on=keys + ["attempt"])
    answers = answers.merge(tables["trials"], on=keys)
    group = answers["mode"].astype("string").mask(answers["virtual"].astype(bool), "virtual")
    kept = group == who
    if counted:
        kept &= answers["counts_in_analyses"]
    if is_default and len(answers) and not kept.any():
        groups = sorted(group.unique())
        raise ValueError(f"no participant has a response that counts in analyses; the study has responses of the groups {groups}; "
                         f'use answered_trials(tables, who="{groups[0]}") for those of a group, and counted=False to '
                         "include those that do not count")
    return answers[kept].sort_values(keys[:3] + ["attempt", "item"]).reset_index(drop=True)


if __name__ == "__main__":
    tables = read_tables()
    for name, table in tables.items():
        print(f"{name}: {len(table)} rows")

"""Loads an export of Asperity with the correct types.

    import importlib.util, sys
    sys.path.insert(0, "DIR")
    import_asperity = __import__("import")          # or: python3 -i DIR/import.py
    tables = import_asperity.read_tables()          # pandas: every .tsv and .csv of the folder, by name
    answers = import_asperity.answered_trials(tables)

Types come from codebook.tsv. Whole numbers that can be missing are Int64, truths are boolean, a text with declared levels is
a category, missing is <NA>. A text that begins with an apostrophe was written with one more, so that no spreadsheet takes it
for a formula: it is removed here.

`read_rows` does the same with the standard library alone, as a list of dictionaries with None for missing.
"""
import csv
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent


def _cells(path):
    """The names of the columns and the cells as in the file; missing is None."""
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
    """What codebook.tsv says, by file and column."""
    names, rows = _cells(pathlib.Path(folder) / "codebook.tsv")
    told = {}
    for row in rows:
        row = dict(zip(names, (_typed(cell, "text") for cell in row)))
        told.setdefault(row["file"], {})[row["column"]] = row
    return told


def files(folder=FOLDER):
    """The tables that read_tables reads: not those of the datasets below bids/ and psychds/, which are the same answers."""
    return [name for name in codebook(folder) if name.endswith((".tsv", ".csv")) and "*" not in name
            and "bids/" not in name and name not in ("codebook.tsv", "MANIFEST.tsv")]


def read_rows(name, folder=FOLDER, described_as=None):
    """One table as a list of dictionaries."""
    told = codebook(folder)[described_as or name]
    names, rows = _cells(pathlib.Path(folder) / name)
    return [{column: _typed(cell, told[column]["type"]) for column, cell in zip(names, row)} for row in rows]


def read_table(name, folder=FOLDER, described_as=None):
    """One table as a pandas.DataFrame."""
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
    """Every table as a pandas.DataFrame, by name without ending, "/" as "_"."""
    return {name.rsplit(".", 1)[0].replace("/", "_"): read_table(name, folder) for name in files(folder)}


def answered_trials(tables, who=None, counted=True):
    """One row per answer to a question of a trial, with the trial, the attempt and its conditions. Only those that count
    in analyses (counts_in_analyses), of people in a session that was run for results. `who` is "run", "pilot" or "virtual";
    `counted=False` keeps those that do not count as well. Without `who` ("run") a ValueError states what to pass if there
    are answers, but none of these."""
    is_default, who = who is None, "run" if who is None else who
    if who not in ("run", "pilot", "virtual"):
        raise ValueError(f'answered_trials: who is "run", "pilot" or "virtual", not {who!r}')
    keys = ["participant", "session", "trial", "virtual", "mode"]
    answers = tables["responses"].dropna(subset=["trial"]).merge(tables["attempts"], on=keys + ["attempt"])
    answers = answers.merge(tables["trials"], on=keys)
    group = answers["mode"].astype("string").mask(answers["virtual"].astype(bool), "virtual")
    kept = group == who
    if counted:
        kept &= answers["counts_in_analyses"]
    if is_default and len(answers) and not kept.any():
        groups = sorted(group.unique())
        raise ValueError(f"no participant has a response that counts in analyses; the study has responses of the groups {groups}: "
                         f'answered_trials(tables, who="{groups[0]}") returns those of a group, counted=False also those '
                         "that do not count")
    return answers[kept].sort_values(keys[:3] + ["attempt", "item"]).reset_index(drop=True)


if __name__ == "__main__":
    tables = read_tables()
    for name, table in tables.items():
        print(f"{name}: {len(table)} rows")

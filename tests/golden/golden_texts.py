"""The results of a study as lines of text: analysis, report and export, without what names the program, folders and the time."""
import collections
import csv
import hashlib
import html.parser
import io
import json
import re

DIGITS = 11
# Of what has more rows there is a line for each column.
ROWS_OF_TABLES_IN_FULL = 60  # of the analysis
ROWS_IN_FULL = 12  # of findings, of which many are the cells of tables, and of exported tables
VALUES_IN_FULL = 10  # different cells of a column
LONGEST_CELL = 200
A_NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
NO_VALUE = ("", "n/a")


def mask(text, study):
    """The text without what names the program, the machine, the folder and the time."""
    text = re.sub(r"(?i)(asperity) \d+\.\d+\.\d+(?: \(commit [^)]*\))?", r"\1 VERSION", text)
    text = re.sub(r'"Version": "\d+\.\d+\.\d+"', '"Version": "VERSION"', text)
    text = text.replace(str(study), "STUDY").replace(str(study.parent), "FOLDER")
    # Everything that the study itself dates is from 2001.
    return re.sub(r"\b20(?!01)\d\d-\d\d-\d\d(?:T\d\d:\d\d:\d\d(?:\.\d+)?Z)?", "TIME", text)


def shown(value):
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:.{DIGITS}g}"
    return str(value) if isinstance(value, (int, str)) else json.dumps(value, ensure_ascii=False)


def row_of(values):
    return "\t".join(shown(value).replace("\n", "\\n") for value in values).rstrip("\t")


def digest(cells):
    """Letters only, so that no part of it is compared as a number."""
    text = "\n".join(cells)
    return hashlib.sha256(text.encode()).hexdigest()[:8].translate(str.maketrans("0123456789abcdef", "ghijklmnopabcdef"))


def column_line(name, cells):
    """All cells of a long column in one line: how often each of a few different ones occurs, or the number, the range and the mean of
    numbers. Their order changes the mean in which a cell weighs its row number, and of others a digest."""
    cells = [shown(float(cell)) if A_NUMBER.fullmatch(cell) and not cell.lstrip("-").isdigit() else cell for cell in cells]
    counts = collections.Counter(cells)
    if len(counts) == 1:
        return f"  {name}\tall\t{cells[0][:LONGEST_CELL]}"
    numbers = [(row, float(cell)) for row, cell in enumerate(cells, 1) if A_NUMBER.fullmatch(cell)]
    parts = [name]
    if len(counts) <= VALUES_IN_FULL:
        parts += [f"{count} × {cell[:LONGEST_CELL]}" for cell, count in sorted(counts.items())]
    elif len(numbers) + sum(counts[cell] for cell in NO_VALUE) == len(cells):
        values = [number for _, number in numbers]
        parts += [f"{len(values)} numbers", f"{shown(min(values))} to {shown(max(values))}", f"mean {shown(sum(values) / len(values))}"]
    else:
        parts += [f"{len(counts)} different cells", *(cell[:LONGEST_CELL] for cell in list(counts)[:2])]
    if numbers:
        parts.append(f"weighted {shown(sum(row * number for row, number in numbers) / sum(row for row, _ in numbers))}")
    else:
        parts.append(f"in the order {digest(cells)}")
    return "  " + "\t".join(parts)


def columns_of(columns, rows, known=()):
    """A line for each column. The names alone of those without a value, and of those whose line is known."""
    yield f"  {len(rows)} rows"
    short = {"all n/a": [], "as in the tables before": []}
    for place, column in enumerate(columns):
        cells = [row[place] if place < len(row) else "" for row in rows]
        in_full = len(cells) <= ROWS_IN_FULL and len(set(cells)) > 1
        line = "  " + "\t".join([column, *cells]) if in_full else column_line(column, cells)
        if set(cells) <= set(NO_VALUE):
            short["all n/a"].append(column)
        elif line in known:
            short["as in the tables before"].append(column)
        else:
            yield line
    yield from (f"  {words}: {', '.join(names)}" for words, names in short.items() if names)


def analysis_lines(document):
    """A line for each count, remark, row of a table and finding."""
    yield f"format {document['format']}"
    for outcome in document["outcomes"]:
        yield ""
        for name, value in outcome.items():
            if name == "remarks":
                yield from (f"remark\t{remark}" for remark in value)
            elif name == "questions":
                for question in value:
                    yield f"question {question['name']}"
                    yield from (f"  {key}\t{shown(part)}" for key, part in question.items() if key not in ("name", "finding"))
                    finding = question.get("finding") or {}
                    yield f"  finding\t{' | '.join(shown(finding.get(part)) for part in ('analysis', 'quantity', 'key', 'value', 'status'))}"
            elif name == "tables":
                for table in value:
                    yield f"table {table['name']}"
                    yield from (f"  {key}\t{shown(part)}" for key, part in table.items() if key not in ("name", "columns", "rows"))
                    yield from rows_or_columns(table["columns"], [[row.get(name) for name in table["columns"]] for row in table["rows"]],
                                               ROWS_OF_TABLES_IN_FULL)
            elif name == "findings":
                yield from finding_lines(value)
            else:
                yield f"{name}\t{shown(value)}"


def rows_or_columns(columns, rows, most):
    if len(rows) <= most:
        yield "  " + row_of(columns)
        yield from ("  " + row_of(row) for row in rows)
    else:
        yield from columns_of(columns, [[shown(cell) for cell in row] for row in rows])


def finding_lines(findings):
    """Findings stand under what they have in common: analysis, quantity, unit, confidence level and method. The numbers of the method stand
    with the finding, because those of a simulation differ between participants."""
    cells = ("key", "value", "low", "high", "n", "status", "word", "of_method", "others")
    groups = {}
    for finding in findings:
        heading = [shown(finding.get(name)) for name in ("analysis", "quantity", "unit", "confidence", "method")]
        numbers = re.findall(r"\d+(?:\.\d+)?", heading[-1])
        heading[-1] = re.sub(r"\d+(?:\.\d+)?", "#", heading[-1])
        row = {name: finding.get(name) for name in cells}
        row["status"] = None if row["status"] == "ok" else row["status"]
        row["of_method"] = " ".join(numbers)
        row["others"] = "; ".join(f"{name}={shown(value)}" for name, value in finding.items()
                                  if name not in (*cells, "analysis", "quantity", "unit", "confidence", "method"))
        groups.setdefault(tuple(heading), []).append(row)
    for heading, rows in groups.items():
        yield "findings " + " | ".join(heading)
        columns = [name for name in cells if any(shown(row[name]) for row in rows)]
        yield from rows_or_columns(columns, [[row[name] for name in columns] for row in rows], ROWS_IN_FULL)


class FigureTexts(html.parser.HTMLParser):
    """The title and the words of a figure. Where they lie, and which numbers the axes have, depends on fonts and on the version of
    Qt; the numbers that are drawn are those of tables. The description stands below the figure."""

    def __init__(self, svg):
        super().__init__()
        self.texts = []
        self.tag = ""
        self.feed(svg)

    def handle_starttag(self, tag, attrs):
        self.tag = tag

    def handle_data(self, data):
        if self.tag in ("title", "text") and data.strip() and not re.fullmatch(r"[-−+\d.,\s%]+", data):
            self.texts.append(data.strip())


def report_lines(text):
    """The page line by line. A row of a table whose tags are those of the row before is the texts of its cells. Errors: ValueError
    for a cell with a bar, which joins the parts of stored names."""
    text = re.sub(r"<style>.*?</style>", "<style/>", text, flags=re.S)
    text = re.sub(r"<svg.*?</svg>", lambda found: "<svg>" + " | ".join(dict.fromkeys(FigureTexts(found[0]).texts)) + "</svg>",
                  text, flags=re.S)
    tags_before = None
    for line in text.splitlines():
        tags = re.findall(r"<[^>]*>", line) if line.startswith("<tr>") else None
        if tags and tags == tags_before:
            cells = [re.sub(r"<[^>]*>", "", cell) for cell in re.split(r"</t[hd]>", line)[:-1]]
            if any("|" in cell for cell in cells):
                raise ValueError(f"a stored name is displayed: {cells}")
            line = " | ".join(cells)
        tags_before = tags
        if line:
            yield line


def export_lines(folder, study):
    """Of tables their columns, of other files the number of lines. Files of participants and sessions that are of one kind stand together. Cells of
    .sav files are those of tables, and their bytes depend on ReadStat and the time; the manifest holds the hashes of them."""
    kinds = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            kinds.setdefault(kind_of(path.relative_to(folder).as_posix()), []).append(path)
    known = set()  # tables have many columns in common
    for kind, paths in kinds.items():
        count = f"\t{len(paths)} files" if len(paths) > 1 else ""
        if paths[0].suffix == ".sav" or paths[0].name == "MANIFEST.tsv":
            yield kind + count
        elif is_text(paths[0]):
            lines = [line for path in paths for line in mask(path.read_text(encoding="utf-8"), study).splitlines()]
            yield f"{kind}{count}\t{len(lines)} lines"
        else:
            yield kind + count
            tables = [list(csv.reader(io.StringIO(mask(path.read_text(encoding="utf-8"), study)),
                                      delimiter="\t" if path.suffix == ".tsv" else ",",
                                      quoting=csv.QUOTE_NONE if path.suffix == ".tsv" else csv.QUOTE_MINIMAL)) for path in paths]
            for columns in dict.fromkeys(tuple(table[0]) for table in tables):
                lines = list(columns_of(columns, [row for table in tables if tuple(table[0]) == columns for row in table[1:]], known))
                known |= set(lines)
                yield from lines


def simulated_lines(folder):
    """What a session of a virtual participant left: attempts, responses, and of every surface times and forces. Without columns whose
    texts contain numbers or hashes of computed surfaces."""
    for name in ("attempts", "presentations", "compliance", "responses"):
        columns, *rows = [line.split("\t") for line in (folder / f"{name}.tsv").read_text(encoding="utf-8").splitlines()]
        # The measures of the exploration have a unit each.
        place = columns.index("quantity") if "quantity" in columns else None
        for quantity in dict.fromkeys(row[place] for row in rows) if place is not None else ("",):
            yield f"{name} {quantity}".rstrip()
            chosen = [row for row in rows if place is None or row[place] == quantity]
            yield f"  {len(chosen)} rows"
            for column, cells in zip(columns, zip(*chosen), strict=True):
                if not column.endswith(("_json", "_sha256")) and set(cells) != {"n/a"}:
                    yield column_line(column, cells)


def common_lines(folder, study):
    """The lines of the files of an export that are not tables, each after the name of its file: protocols have most of them in common.
    Of a line of the codebook without the file that has the column: files have many columns in common."""
    lines = set()
    for path in folder.rglob("*"):
        if path.is_file() and is_text(path):
            kind = kind_of(path.relative_to(folder).as_posix())
            for line in mask(path.read_text(encoding="utf-8"), study).splitlines():
                if path.name == "codebook.tsv":
                    line = line.partition("\t")[2]
                if line.strip(" {}[],"):
                    lines.add(f"{kind}\t{line.strip()}")
    return lines


def is_text(path):
    return path.name == "codebook.tsv" or path.suffix not in (".tsv", ".csv", ".sav")


def kind_of(name):
    """The same of all participants, sessions and protocols."""
    return re.sub(r"(su(?:b|bject)|ses(?:sion)?|task)-[^/_]+", r"\1-*", name)

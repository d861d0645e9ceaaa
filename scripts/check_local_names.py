#!/usr/bin/env python3
"""Fails when a file-local name is declared twice in a target that is compiled in groups.

Usage: check_local_names.py BUILD_FOLDER

To the compiler a group of sources is one file (cmake/README.md, "Groups"). CMake chooses the groups by the order of the
sources, so two sources with a name in common compile until another source is inserted before them. The whole target
therefore counts as one group.

File-local are names in an anonymous namespace, `static` functions and variables, constants without `inline`, aliases,
and macros that stay defined. No other source of the target may declare the same name, nor may a header that one of
them includes. Two file-local functions of one name are refused whatever their parameters: they would overload each
other in some groups and not in others. A function of a header may be overloaded, with other parameters. A type that two
sources define is refused too. What the language allows twice is allowed: `using namespace`, and aliases that agree word
for word. A name in another named namespace is another name.

The groups are read from the build folder, as CMake wrote them. Sources that are compiled alone are in none.
"""
import collections
import dataclasses
import enum
import functools
import json
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GROUP = re.compile(r"/CMakeFiles/([^/]+)\.dir/Unity/unity_\d+_cxx\.cxx$")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
MACRO = re.compile(r"\s*#\s*(define|undef)\s+(\w+)")
TOKEN = re.compile(
    r"""
    (?P<nothing> \s+ | //[^\n]* | /\*.*?\*/ )
  | (?P<directive> ^[ \t]*\#(?:\\\n|[^\n])* )
  | (?P<string> (?:u8|[uUL])?R"(?P<end>[^()\\\s]*)\(.*?\)(?P=end)" | (?:u8|[uUL])?"(?:\\.|[^"\\\n])*" )
  | (?P<number> \.?\d(?:[eEpP][+-]|'\w|[\w.])* )
  | (?P<character> (?:u8|[uUL])?'(?:\\.|[^'\\\n])+' )
  | (?P<operator> \boperator\s*(?:\(\s*\)|\[\s*\]|""\s*\w+|[^\w\s(]+) )
  | (?P<word> [A-Za-z_]\w* )
  | (?P<sign> :: | . )
    """,
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)
CLOSING = {"(": ")", "[": "]", "{": "}"}
CLASS_KEYS = {"class", "struct", "union", "enum"}
SPECIFIERS = {"static", "inline", "constexpr", "constinit", "const", "extern", "typedef", "thread_local"}
TAKING_PARENTHESES = {"alignas", "decltype", "noexcept", "__attribute__"}  # whose parentheses hold no parameters
EVERY_SCOPE = "#define"
TEST_MACROS = {"TEST", "TEST_F", "TEST_P"}


class Unreadable(Exception):
    pass


class Sort(enum.Enum):
    LOCAL = enum.auto()
    TYPE = enum.auto()  # defined, and not file-local: once for all sources
    SHARED = enum.auto()


@dataclasses.dataclass
class Token:
    """A token, or everything between two brackets: then `text` is the opening one."""

    kind: str
    text: str
    line: int
    inside: list["Token"] = dataclasses.field(default_factory=list)


@dataclasses.dataclass(frozen=True)
class Declaration:
    scope: str  # the named namespaces around it
    name: str
    line: int
    sort: Sort
    parameters: str | None = None  # of a function
    alias_of: str | None = None
    path: pathlib.Path | None = None


# ---- Reading a source

def tokens_of(text: str, macros: dict[str, int]) -> list[Token]:
    """Brackets with what is inside as one token. Fills `macros` with those that stay defined and their lines."""
    everything = Token("file", "", 1)
    open_brackets = [everything]
    line = 1
    for match in TOKEN.finditer(text):
        token = Token(match.lastgroup, match.group(), line)
        line += token.text.count("\n")
        if token.kind == "directive":
            macro = MACRO.match(token.text)
            if macro and macro[1] == "define":
                macros[macro[2]] = token.line
            elif macro:
                macros.pop(macro[2], None)
        elif token.kind == "sign" and token.text in CLOSING.values():
            if CLOSING.get(open_brackets.pop().text) != token.text:
                raise Unreadable(f"{token.line}: {token.text} closes nothing")
        elif token.kind != "nothing":
            open_brackets[-1].inside.append(token)
            if token.kind == "sign" and token.text in CLOSING:
                open_brackets.append(token)
    if len(open_brackets) > 1:
        raise Unreadable(f"{open_brackets[-1].line}: {open_brackets[-1].text} is not closed")
    return everything.inside


def texts_of(tokens: list[Token]) -> list[str]:
    return [token.text for token in tokens]


def spelling(tokens: list[Token]) -> str:
    return " ".join(token.text + (spelling(token.inside) + CLOSING[token.text] if token.inside else "")
                    for token in tokens).removeprefix(":: ")


def statements(tokens: list[Token]):
    """The declarations of a scope, each without its semicolon."""
    statement: list[Token] = []
    for index, token in enumerate(tokens):
        following = tokens[index + 1].text if index + 1 < len(tokens) else ";"
        if token.text != ";":
            statement.append(token)
        if token.text == ";" or following != ";" and (
                ends_with_body(statement) or is_macro_call(statement) and following != "{"):
            if statement:
                yield statement
            statement = []
    if statement:
        yield statement


def is_macro_call(statement: list[Token]) -> bool:
    return (texts_of(statement)[1:] == ["("] and statement[0].kind == "word"
            and statement[0].text not in TAKING_PARENTHESES and not is_pointer(statement[1]))


def is_pointer(brackets: Token) -> bool:
    """As in `int (*name)(double)`."""
    return texts_of(brackets.inside[:1]) in (["*"], ["&"])


def is_linkage(statement: list[Token]) -> bool:
    return texts_of(statement)[:1] == ["extern"] and [token.kind for token in statement[1:]] == ["string"]


def ends_with_body(statement: list[Token]) -> bool:
    """Of a namespace or a function; behind types and initialisers stands a semicolon."""
    if statement[-1].text != "{":
        return False
    head = without_template(statement[:-1])
    texts = texts_of(head)
    if "namespace" in texts[:2] or is_linkage(head):
        return True
    if "=" in texts or "(" not in texts:
        return False
    # In `X::X() : a_{1} {}` only the last braces are the body.
    return ":" not in texts or head[-1].kind != "word" and texts[-1] != ">"


def without_template(statement: list[Token]) -> list[Token]:
    """Without `template <...>`."""
    while texts_of(statement[:1]) == ["template"]:
        depth = 0
        end = 0
        while end == 0 or depth > 0:
            end += 1
            depth += {"<": 1, ">": -1}.get(statement[end].text, 0)
        statement = statement[end + 1:]
    return statement


def without_attributes(statement: list[Token]) -> list[Token]:
    kept: list[Token] = []
    for token in statement:
        if token.text == "(" and kept and kept[-1].text in TAKING_PARENTHESES:
            kept.pop()
        elif not (token.text == "[" and texts_of(token.inside) == ["["]):
            kept.append(token)
    return kept


def declarations_of(tokens: list[Token], scope: str = "", is_local: bool = False):
    for statement in statements(tokens):
        texts = texts_of(statement)
        if texts[0] == "using" or "namespace" in texts[:2] and "=" in texts:
            if texts[1] != "namespace":
                yield from declared_alias(statement, scope)
        elif "namespace" in texts[:2]:
            names = [token.text for token in statement[:-1] if token.kind == "word"]
            names = [name for name in names if name not in ("inline", "namespace")]
            inner = "::".join(([scope] if scope else []) + names)
            yield from declarations_of(statement[-1].inside, inner, is_local or not names)
        elif is_linkage(statement[:-1]):
            yield from declarations_of(statement[-1].inside, scope, is_local)
        elif texts[0] in TEST_MACROS and texts[1:2] == ["("]:
            class_name = "_".join(texts_of(statement[1].inside)[::2] + ["Test"])
            yield Declaration(scope, class_name, statement[0].line, Sort.TYPE)
        elif not is_macro_call(statement[:2]):
            for found in declared(without_attributes(without_template(statement)), scope):
                yield dataclasses.replace(found, sort=Sort.LOCAL) if is_local else found


def declared_alias(statement: list[Token], scope: str):
    """Of `using A = B`, `using B::A` and `namespace A = B`."""
    texts = texts_of(statement)
    name, meaning = statement[-1], statement[1:]
    if "=" in texts:
        name, meaning = statement[1], statement[texts.index("=") + 1:]
    yield Declaration(scope, name.text, name.line, Sort.LOCAL, alias_of=spelling(meaning))


def declared(statement: list[Token], scope: str):
    """What a declaration of a type, a function or variables declares."""
    specifiers = set(texts_of(statement)) & SPECIFIERS
    rest = [token for token in statement if token.text not in SPECIFIERS]
    if rest and rest[0].text in CLASS_KEYS:
        rest = [token for token in rest if token.text not in CLASS_KEYS]
        following = rest[1].text if len(rest) > 1 else ";"
        if rest[0].text != "{" and following in ("{", ":", ";", "final"):
            yield Declaration(scope, rest[0].text, rest[0].line, Sort.SHARED if following == ";" else Sort.TYPE)
        if "{" in texts_of(rest):
            rest = rest[texts_of(rest).index("{"):]  # behind a type there may be variables of it

    depth = 0
    end = 1
    while end < len(rest) and (depth > 0 or rest[end].text not in ("(", "=", "{", "[", ":", ",")):
        depth += {"<": 1, ">": -1}.get(rest[end].text, 0)
        end += 1
    brackets = rest[end] if end < len(rest) and rest[end].text == "(" else None
    parameters = None
    if brackets and is_pointer(brackets):
        name = brackets.inside[1]
    elif 1 < end <= len(rest) and rest[end - 2].text not in ("::", "~", "operator"):
        name = rest[end - 1]
        parameters = parameter_types(brackets.inside) if brackets else None
    else:
        return  # a member of a class
    if name.kind not in ("word", "operator"):
        return
    is_constant = parameters is None and specifiers & {"const", "constexpr"} and not specifiers & {"inline", "extern"}
    sort = Sort.LOCAL if "static" in specifiers or is_constant else Sort.SHARED
    # An operator has no other name to choose.
    key = f"{name.text}({parameters})" if name.kind == "operator" else name.text
    yield Declaration(scope, key, name.line, sort, parameters)
    for comma, name, following in zip(rest[end:], rest[end + 1:], rest[end + 2:] + [Token("sign", "=", 0)]):
        if comma.text == "," and name.kind == "word" and following.text in ("=", "{", "["):
            yield Declaration(scope, name.text, name.line, sort)


def parameter_types(tokens: list[Token]) -> str:
    types = []
    one: list[Token] = []
    depth = 0
    for token in tokens + [Token("sign", ",", 0)]:
        depth += {"<": 1, ">": -1}.get(token.text, 0)
        if token.text != "," or depth > 0:
            one.append(token)
            continue
        if "=" in texts_of(one):
            one = one[:texts_of(one).index("=")]
        if len(one) > 1 and one[-1].kind == "word" and one[-2].text != "::":
            one = one[:-1]  # its name
        types.append(spelling(one))
        one = []
    return ", ".join(types)


@functools.cache
def read(path: pathlib.Path) -> list[Declaration]:
    macros: dict[str, int] = {}
    try:
        found = list(declarations_of(tokens_of(path.read_text(encoding="utf-8"), macros)))
    except (Unreadable, IndexError) as problem:
        raise Unreadable(f"{place(path)}:{problem}") from problem
    found += [Declaration(EVERY_SCOPE, name, line, Sort.LOCAL) for name, line in macros.items()]
    return [dataclasses.replace(one, path=path) for one in found]


# ---- Reading the build

def sources_of_targets(build: pathlib.Path) -> dict[str, list[pathlib.Path]]:
    """The sources that are compiled in groups, by target."""
    sources = collections.defaultdict(list)
    for command in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        group = pathlib.Path(command["directory"], command["file"])
        match = GROUP.search(group.as_posix())
        if match:
            members = INCLUDE.findall(group.read_text(encoding="utf-8"))
            sources[match[1]] += [(group.parent / member).resolve() for member in members]
    return dict(sorted(sources.items()))


@functools.cache
def included_by(path: pathlib.Path) -> list[pathlib.Path]:
    """Headers of the tree."""
    names = INCLUDE.findall(path.read_text(encoding="utf-8"))
    places = [folder / name for name in names for folder in (path.parent, ROOT)]
    return [one.resolve() for one in places if one.is_file()]


def headers_of(sources: list[pathlib.Path]) -> list[pathlib.Path]:
    headers: list[pathlib.Path] = []
    seen = set(sources)
    unread = list(sources)
    while unread:
        for header in included_by(unread.pop()):
            if header not in seen:
                seen.add(header)
                headers.append(header)
                unread.append(header)
    return sorted(headers)


# ---- Judging

def collide(one: Declaration, other: Declaration) -> bool:
    if one.path == other.path or one.alias_of is not None and one.alias_of == other.alias_of:
        return False
    if one.scope != other.scope and EVERY_SCOPE not in (one.scope, other.scope):
        return False
    if one.sort == other.sort == Sort.TYPE:
        return True
    if Sort.LOCAL not in (one.sort, other.sort):
        return False
    both_local = one.sort == other.sort
    return both_local or None in (one.parameters, other.parameters) or one.parameters == other.parameters


def complaints(target: str, sources: list[pathlib.Path]):
    by_name = collections.defaultdict(list)
    for source in sources:
        for found in read(source):
            by_name[found.name].append(found)
    for header in headers_of(sources):
        for found in read(header):
            by_name[found.name].append(dataclasses.replace(found, sort=Sort.SHARED))
    for name, found in sorted(by_name.items()):
        places = {f"{place(one.path)}:{one.line}": None
                  for one in found if any(collide(one, other) for other in found)}
        if places:
            yield f"{target}: {name} is declared in " + " and in ".join(places)


def place(path: pathlib.Path) -> str:
    return os.path.relpath(path, ROOT) if path.is_relative_to(ROOT) else str(path)


def main() -> int:
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    targets = sources_of_targets(pathlib.Path(sys.argv[1]))
    if not targets:
        sys.exit(f"names: no target in {sys.argv[1]} is compiled in groups; configure with ASPERITY_COMPILE_IN_GROUPS=ON")
    try:
        found = [complaint for target, sources in targets.items() for complaint in complaints(target, sources)]
    except Unreadable as problem:
        sys.exit(f"names: cannot read {problem}")
    if not found:
        print("names: every file-local name is declared once in its target")
        return 0
    print("\n".join(found))
    print("Sources of one target are compiled in groups, as if they were one file (cmake/README.md). Give what is the "
          "same one home in a header, and what is not the same a more specific name.")
    return 1


if __name__ == "__main__":
    sys.exit(main())

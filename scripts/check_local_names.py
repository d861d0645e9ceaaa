#!/usr/bin/env python3
"""Fails when a file-local name is declared twice in a target that is compiled in groups.

Usage: check_local_names.py BUILD_FOLDER

To the compiler a group of sources is one file (cmake/README.md, "Groups"). CMake chooses the groups by the order of the
sources, so two sources with a name in common compile until another source is inserted before them. The whole target
therefore counts as one group.

File-local are names in an anonymous namespace, `static` functions and variables, constants without `inline`, aliases,
and macros that stay defined. No other source of the target may declare the same name, nor may a header that one of
them includes. Refused are in particular:

- two file-local functions of one name, whatever their parameters: they would overload each other in some groups only;
- a file-local function with the name of a header's, unless the parameters differ and the compiler finds that of the
  header by its arguments, of which one is of a type of ours: it looks no further than an anonymous namespace;
- two types that sources define with one name, in an anonymous namespace or not;
- a constant, a type or an alias inside of a function with the name of a file-local one (-Wshadow).

What the language allows twice is allowed: `using namespace`, and aliases that agree word for word. A name in another
named namespace is another name.

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
TEST_MACROS = {"TEST", "TEST_F", "TEST_P"}


class Unreadable(Exception):
    pass


class Kind(enum.Enum):
    TYPE = enum.auto()
    ANNOUNCED_TYPE = enum.auto()
    FUNCTION = enum.auto()
    VARIABLE = enum.auto()
    ALIAS = enum.auto()
    MACRO = enum.auto()


class Reach(enum.Enum):
    INNER = enum.auto()  # inside of a function
    LOCAL = enum.auto()  # to the file
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
    kind: Kind
    reach: Reach
    meaning: str = ""  # the types of a function's parameters; what an alias stands for
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
    """Of a namespace, a function or a statement; behind types and initialisers stands a semicolon."""
    if statement[-1].text != "{":
        return False
    head = without_template(statement[:-1])
    texts = texts_of(head)
    if texts in ([], ["else"], ["do"], ["try"]):
        return True
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
            names = namespaces_of(statement)
            inner = "::".join(filter(None, [scope, *names]))
            yield from declarations_of(statement[-1].inside, inner, is_local or not names)
        elif is_linkage(statement[:-1]):
            yield from declarations_of(statement[-1].inside, scope, is_local)
        elif texts[0] in TEST_MACROS and texts[1:2] == ["("]:
            class_name = "_".join(texts_of(statement[1].inside)[::2] + ["Test"])
            yield Declaration(scope, class_name, statement[0].line, Kind.TYPE, Reach.SHARED)
        elif not is_macro_call(statement[:2]):
            for found in declared(without_attributes(without_template(statement)), scope):
                yield dataclasses.replace(found, reach=Reach.LOCAL) if is_local else found


def namespaces_of(statement: list[Token]) -> list[str]:
    """Those that a statement opens by name."""
    return [token.text for token in statement if token.kind == "word" and token.text not in ("inline", "namespace")]


def is_type(statement: list[Token]) -> bool:
    return next((text for text in texts_of(statement) if text not in SPECIFIERS), "") in CLASS_KEYS


def declared_alias(statement: list[Token], scope: str):
    """Of `using A = B`, `using B::A` and `namespace A = B`."""
    texts = texts_of(statement)
    name, meaning = statement[-1], statement[1:]
    if "=" in texts:
        name, meaning = statement[1], statement[texts.index("=") + 1:]
    yield Declaration(scope, name.text, name.line, Kind.ALIAS, Reach.LOCAL, spelling(meaning))


def declared(statement: list[Token], scope: str):
    """What a declaration of a type, a function or variables declares."""
    specifiers = set(texts_of(statement)) & SPECIFIERS
    rest = [token for token in statement if token.text not in SPECIFIERS]
    if is_type(rest):
        rest = [token for token in rest if token.text not in CLASS_KEYS]
        following = rest[1].text if len(rest) > 1 else ";"
        if rest[0].text != "{" and following in ("{", ":", ";", "final"):
            kind = Kind.ANNOUNCED_TYPE if following == ";" else Kind.TYPE
            yield Declaration(scope, rest[0].text, rest[0].line, kind, Reach.SHARED)
        if "{" in texts_of(rest):
            rest = rest[texts_of(rest).index("{"):]  # behind a type there may be variables of it

    depth = 0
    end = 1
    while end < len(rest) and (depth > 0 or rest[end].text not in ("(", "=", "{", "[", ":", ",")):
        depth += {"<": 1, ">": -1}.get(rest[end].text, 0)
        end += 1
    brackets = rest[end] if end < len(rest) and rest[end].text == "(" else None
    kind = Kind.VARIABLE
    if brackets and is_pointer(brackets):
        name = brackets.inside[1]
    elif 1 < end <= len(rest) and rest[end - 2].text not in ("::", "~", "operator"):
        name = rest[end - 1]
        kind = Kind.FUNCTION if brackets else Kind.VARIABLE
    else:
        return  # a member of a class
    if name.kind not in ("word", "operator"):
        return
    parameters = parameter_types(brackets.inside) if kind == Kind.FUNCTION else ""
    is_constant = kind == Kind.VARIABLE and specifiers & {"const", "constexpr"}
    is_local = "static" in specifiers or is_constant and not specifiers & {"inline", "extern"}
    reach = Reach.LOCAL if is_local else Reach.SHARED
    # An operator has no other name to choose.
    key = f"{name.text}({parameters})" if name.kind == "operator" else name.text
    yield Declaration(scope, key, name.line, kind, reach, parameters)
    for comma, name, following in zip(rest[end:], rest[end + 1:], rest[end + 2:] + [Token("sign", "=", 0)]):
        if comma.text == "," and name.kind == "word" and following.text in ("=", "{", "["):
            yield Declaration(scope, name.text, name.line, Kind.VARIABLE, reach)


def inner_declarations(tokens: list[Token], scope: str = "", encloses: str = "namespace"):
    """Constants, types and aliases inside of functions, which are not members of a class."""
    for statement in statements(tokens):
        texts = texts_of(statement)
        found = []
        if encloses == "function" and (texts[0] in ("const", "constexpr", "static") or is_type(statement)):
            found = declared(without_attributes(statement), scope)
        elif encloses == "function" and texts[0] == "using" and "=" in texts:
            found = declared_alias(statement, scope)
        for one in found:
            if one.kind in (Kind.VARIABLE, Kind.TYPE, Kind.ALIAS):
                yield dataclasses.replace(one, reach=Reach.INNER)
        inner, inside = scope, "function"
        if "namespace" in texts[:2]:
            inner, inside = "::".join(filter(None, [scope, *namespaces_of(statement)])), "namespace"
        elif is_linkage(statement[:-1]):
            inside = "namespace"
        elif is_type(without_template(statement)):
            inside = "class"
        for token in statement:
            yield from inner_declarations(token.inside, inner, inside if token.text == "{" else "function")


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
        tokens = tokens_of(path.read_text(encoding="utf-8"), macros)
        found = list(declarations_of(tokens)) + list(inner_declarations(tokens))
    except (Unreadable, IndexError) as problem:
        raise Unreadable(f"{place(path)}:{problem}") from problem
    found += [Declaration("", name, line, Kind.MACRO, Reach.LOCAL) for name, line in macros.items()]
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

def collide(one: Declaration, other: Declaration, types: set[str]) -> bool:
    """`types` are those of ours."""
    kinds = {one.kind, other.kind}
    if one.path == other.path or Kind.MACRO not in kinds and one.scope != other.scope:
        return False
    reaches = {one.reach, other.reach}
    if Reach.INNER in reaches:
        alike = kinds == {Kind.VARIABLE} or kinds <= {Kind.TYPE, Kind.ANNOUNCED_TYPE, Kind.ALIAS}
        return len(reaches) == 2 and (alike or Kind.MACRO in kinds)
    if kinds == {Kind.ALIAS} and one.meaning == other.meaning:
        return False
    if kinds == {Kind.TYPE}:
        return True
    if reaches == {Reach.LOCAL, Reach.SHARED} and kinds == {Kind.FUNCTION}:
        shared = one if one.reach == Reach.SHARED else other
        return one.meaning == other.meaning or types.isdisjoint(re.findall(r"\w+", shared.meaning))
    return Reach.LOCAL in reaches


def complaints(target: str, sources: list[pathlib.Path]):
    headers = headers_of(sources)
    found = [one for source in sources for one in read(source)]
    for header in headers:
        found += [dataclasses.replace(one, reach=Reach.SHARED) if one.reach == Reach.LOCAL else one
                  for one in read(header)]
    types = {one.name for one in found if one.kind in (Kind.TYPE, Kind.ANNOUNCED_TYPE)}
    types |= {one.name for one in found
              if one.kind == Kind.ALIAS and not types.isdisjoint(re.findall(r"\w+", one.meaning))}
    by_name = collections.defaultdict(list)
    for one in found:
        by_name[one.name].append(one)
    for name, declarations in sorted(by_name.items()):
        places = {f"{place(one.path)}:{one.line}": None
                  for one in declarations if any(collide(one, other, types) for other in declarations)}
        if places:
            yield f"{target}: {name} is declared in " + " and in ".join(places)


def place(path: pathlib.Path) -> str:
    return os.path.relpath(path, ROOT) if path.is_relative_to(ROOT) else str(path)


def main() -> int:
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    targets = sources_of_targets(pathlib.Path(sys.argv[1]))
    if not targets:
        sys.exit(f"names: no target of {sys.argv[1]} is compiled in groups; "
                 "configure with ASPERITY_COMPILE_IN_GROUPS=ON")
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

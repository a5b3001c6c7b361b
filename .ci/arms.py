#!/usr/bin/env python3
"""Finds default arms in matches over enums: python3 .ci/arms.py [FILE ...]

A kind, a scene or a sampler that is added later would fall into the default arm, be drawn or judged as another, and pass. So an arm
must name what it stands for. clippy's `wildcard_enum_match_arm` refuses `_` where the matched value is an enum itself; this looks into
tuples, `Some(..)` and other variants as well:

    match (work, scene) {
        (Work::Exact, Scene::Grey { .. }) => ..,
        (Work::Exact, _) => ..,         scenes: a default arm
        (other, ..) => ..,              works and scenes: a default arm
    }

A place of a pattern is looked at if another arm names a variant `Enum::Variant` there, by its full name, by `Self::` or under another
name of a `use`. `_`, `..` and a new name are defaults there unless the arm has a guard. Enums of other crates are passed over; so are
`if let`, `let else` and `matches!`, which say themselves that they look for one thing.

Without arguments all Rust files of the repository are read. Exit code 0: none; 1: each with its file, line and enum. `--self-test` tries
the rule on planted matches. Nothing but Python's standard library is needed.
"""

import argparse
import collections
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from imports import ROOT, closing, read_use, tokens  # noqa: E402

FOLDERS = ["adapters", "benches", "calibration", "crates", "examples", "fuzz", "tests"]

# Enums of other crates, which may grow or have more variants than anybody lists; the reason stands where clippy is told the same.
FOREIGN = {"Component", "ErrorKind", "ParseErrorKind", "ParseStringErrorKind", "Token", "Unexpected", "Value"}

# A pattern: what it is, by which path, and what stands in it.
Pattern = collections.namedtuple("Pattern", "form path parts")
Arm = collections.namedtuple("Arm", "patterns guarded line")
Default = collections.namedtuple("Default", "line enum")
WILD = Pattern("wild", (), ())


def split(toks, separator):
    """Parts of `toks` between separators that stand in no bracket."""
    parts, i, start = [], 0, 0
    while i < len(toks):
        if toks[i].text in ("(", "[", "{"):
            i = closing(toks, i)
        elif toks[i].text == separator:
            parts.append(toks[start:i])
            start = i + 1
        i += 1
    parts.append(toks[start:])
    return [part for part in parts if part]


def read_pattern(toks):
    """The alternatives of a pattern."""
    return [read_one(part) for part in split(toks, "|")]


def read_one(toks):
    toks = [t for t in toks if t.text not in ("&", "ref", "mut", "box")]
    words = [t.text for t in toks]
    if not words:
        return Pattern("other", (), ())
    if len(words) > 2 and words[1] == "@":
        return read_one(toks[2:])
    if words[0] == "(" and closing(toks, 0) == len(toks) - 1:
        parts = split(toks[1:-1], ",")
        if len(parts) == 1 and words[-2] != ",":
            alternatives = read_pattern(parts[0])
            return alternatives[0] if len(alternatives) == 1 else Pattern("any", (), tuple(alternatives))
        return Pattern("tuple", (), tuple(tuple(read_pattern(part)) for part in parts))
    if words == ["_"] or words == [".", "."]:
        return WILD
    path = []
    i = 0
    while i < len(words) and (re.match(r"[A-Za-z_]", words[i]) or words[i] == "::"):
        if words[i] != "::":
            path.append(words[i])
        i += 1
    if not path:
        return Pattern("other", (), ())
    if i == len(words) and len(path) == 1 and re.match(r"[a-z_]", path[0]) and path[0] not in ("true", "false"):
        return WILD
    parts = ()
    if i < len(words) and words[i] == "(":
        parts = tuple(tuple(read_pattern(part)) for part in split(toks[i + 1:closing(toks, i)], ","))
    return Pattern("path", tuple(path), parts)


def spread(patterns):
    """Alternatives in brackets as alternatives of their own."""
    for pattern in patterns:
        if pattern.form == "any":
            yield from spread(pattern.parts)
        else:
            yield pattern


def read_arms(toks):
    """The arms of a match, given what stands in its braces."""
    arms, i = [], 0
    while i < len(toks):
        start = i
        while i < len(toks) and toks[i].text != "=>":
            i = (closing(toks, i) if toks[i].text in ("(", "[", "{") else i) + 1
        if i >= len(toks):
            break
        head = without_attributes(toks[start:i])
        guard = next((k for k, t in enumerate(head) if t.text == "if" and depth_is_zero(head, k)), None)
        arms.append(Arm(tuple(spread(read_pattern(head[:guard]))), guard is not None, head[0].line if head else 0))
        i += 1
        if i < len(toks) and toks[i].text == "{":
            i = closing(toks, i) + 1
            i += i < len(toks) and toks[i].text == ","
            continue
        while i < len(toks) and toks[i].text != ",":
            i = (closing(toks, i) if toks[i].text in ("(", "[", "{") else i) + 1
        i += 1
    return arms


def without_attributes(toks):
    while len(toks) > 1 and toks[0].text == "#":
        toks = toks[closing(toks, 1) + 1:]
    return toks


def depth_is_zero(toks, k):
    return sum((t.text in ("(", "[", "{")) - (t.text in (")", "]", "}")) for t in toks[:k]) == 0


def enum_of(pattern, names):
    """The enum that a pattern names a variant of; nothing if it is foreign or no variant."""
    if pattern.form != "path" or len(pattern.path) < 2:
        return None
    enum, variant = pattern.path[-2:]
    enum = names.get(enum, enum)
    is_type = lambda word: re.match(r"[A-Z]", word) and (len(word) == 1 or re.search(r"[a-z]", word))
    return enum if is_type(enum) and is_type(variant) and enum not in FOREIGN else None


def defaults(arms, names):
    """The default arms among arms whose patterns stand in the same place."""
    enum = next((e for arm in arms for p in arm.patterns for e in [enum_of(p, names)] if e), None)
    wild = [arm for arm in arms if WILD in arm.patterns and not arm.guarded]
    found = [Default(arm.line, enum) for arm in wild if enum]
    inside = collections.defaultdict(list)
    for arm in arms:
        for pattern in arm.patterns:
            if pattern.parts:
                inside[pattern.form, pattern.path[-1:]].append((arm, pattern.parts))
    for rows in inside.values():
        width = max(len(parts) for _, parts in rows)
        # A default stands for all that is inside as well.
        rows = rows + [(arm, ((WILD,),)) for arm in wild]
        for k in range(width):
            inner = defaults([Arm(tuple(spread(part_at(parts, k, width))), arm.guarded, arm.line) for arm, parts in rows], names)
            # `(A::X | A::Y, _)` beside pairs of the same enum, as in `eq`, does name what it stands for.
            named = {(arm.line, enum_of(p, names)) for arm, parts in rows for j in range(len(parts)) if j != k for p in inside_of(parts[j])}
            found += [default for default in inner if (default.line, default.enum) not in named]
    return found


def inside_of(patterns):
    """The patterns and all that stand in them."""
    for pattern in spread(patterns):
        yield pattern
        for part in pattern.parts:
            yield from inside_of(part)


def part_at(parts, k, width):
    """What stands at place `k` of `width`; `..` stands for all that is left out, and may stand anywhere."""
    rest = next((i for i, part in enumerate(parts) if part == (WILD,) and len(parts) < width), None)
    if rest is None:
        return parts[k] if k < len(parts) else (WILD,)
    if k < rest:
        return parts[k]
    behind = k - (width - len(parts))
    return parts[behind] if behind > rest else (WILD,)


def aliases(toks):
    """Other names of enums, by `use .. as ..`."""
    found = {}
    for i, token in enumerate(toks):
        if token.text == "use" and i + 1 < len(toks) and toks[i + 1].text not in ("<",):
            tree, _ = read_use(toks, i + 1)
            found.update({name: path[-1] for name, path, _ in tree if path and name not in ("*", "_", path[-1])})
    return found


def owner(toks, i):
    """The type that the block at `i` belongs to, if `i` is an `impl`."""
    words, k = [], i + 1
    if k < len(toks) and toks[k].text == "<":
        depth = 0
        while k < len(toks):
            depth += (toks[k].text == "<") - (toks[k].text == ">")
            k += 1
            if depth == 0:
                break
    while k < len(toks) and toks[k].text != "{":
        words.append(toks[k].text)
        k += 1
    if "for" in words:
        words = words[words.index("for") + 1:]
    name = next((w for w in reversed(words[: words.index("<")] if "<" in words else words) if re.match(r"[A-Z$]", w)), None)
    return name, k


def in_text(text):
    """The default arms of a file."""
    toks = tokens(text)
    names, selves, found = aliases(toks), [], []
    for i, token in enumerate(toks):
        if token.text == "impl" and (i == 0 or toks[i - 1].text in ("}", ";", "]", "unsafe", "{")):
            name, start = owner(toks, i)
            if name and start < len(toks):
                selves.append((start, closing(toks, start), name))
        if token.text == "match" and (i == 0 or toks[i - 1].text not in (".", "fn")):
            start = i + 1
            while start < len(toks) and toks[start].text != "{":
                start = (closing(toks, start) if toks[start].text in ("(", "[") else start) + 1
            own = next((name for a, b, name in reversed(selves) if a < i < b), "Self")
            arms = read_arms(toks[start + 1:closing(toks, start)])
            found += defaults(arms, {**names, "Self": own})
    return sorted(set(found))


# Planted matches: what they are, the match, and the lines of the default arms in it.
PLANTED = [
    ("every variant is named", "match work { Work::A => 1, Work::B(_) | Work::C { .. } => 2 }", []),
    ("a plain default", "match work {\nWork::A => 1,\n_ => 2 }", [3]),
    ("a new name is a default", "match work {\nWork::A => 1,\nother => f(other) }", [3]),
    ("a name for named variants is none", "match work {\nWork::A => 1,\nother @ (Work::B | Work::C) => f(other) }", []),
    ("a guard is no default", "match work {\n_ if early => 0,\nWork::A => 1, Work::B => 2 }", []),
    ("a default in one place of a tuple", "match (work, scene) {\n(Work::A, Scene::X) => 1,\n(Work::B, _) => 2, (Work::A, Scene::Y) => 3 }", [3]),
    ("dots in a tuple", "match (a, b, c) {\n(Some(F::X(_)), ..) => 1,\n(_, Some(T::Y), _) => 2,\n(_, _, None) => 3 }", [2, 3, 4]),
    ("a default beside tuples", "match (work, scene) {\n(Work::A, Scene::X) => 1,\n_ => 2 }", [3]),
    ("a default inside Some", "match kind {\nSome(Kind::A) => 1,\nSome(_) => 2,\nNone => 3 }", [3]),
    ("a default beside Some", "match kind {\nSome(Kind::A) => 1,\n_ => 2 }", [3]),
    ("a default in a variant's own place", "match work {\nWork::Samples(Kind::A, _) => 1,\nWork::Samples(..) => 2,\nWork::B => 3 }", [3]),
    ("alternatives in brackets", "match w {\n(Work::A | Work::B, Scene::X) => 1,\n(Work::C, Scene::X | Scene::Y) => 2 }", []),
    ("Self in an impl", "impl Work { fn f(&self) { match self {\nSelf::A => 1,\n_ => 2 } } }", [3]),
    ("another name of a use", "use a::SampleKind as Kind; fn f() { match k {\nKind::A => 1,\n_ => 2 } }", [3]),
    ("pairs of the same enum", "match (self, other) {\n(A::X(a), A::X(b)) => a == b,\n(A::Y, A::Y) => true,\n(A::X(_) | A::Y, _) => false }", []),
    ("numbers, texts and constants", 'match n {\n1 => 1, 2..5 => 2, f64::NAN => 3, "a" => 4,\n_ => 5 }', []),
    ("enums of other crates", "match v {\nValue::Null => 1,\n_ => 2 }", []),
    ("a match in an arm", "match w { Work::A => match s {\nScene::X => 1,\n_ => 2 }, Work::B => 3 }", [3]),
    ("arms with blocks and closures", "match w {\nWork::A => { f(|_| 1) }\nWork::B => g(|x| x, 2),\n_ => {} }", [4]),
]


def self_test():
    failed = 0
    for words, text, expected in PLANTED:
        found = sorted({default.line for default in in_text(text)})
        failed += found != expected
        print(f"{'ok  ' if found == expected else 'FAIL'} {words}" + ("" if found == expected else f": {found}, not {expected}"))
    print(f"{len(PLANTED)} planted matches, {failed} wrong")
    return 1 if failed else 0


def rust_files():
    return sorted(file for folder in FOLDERS for file in (ROOT / folder).rglob("*.rs") if "target" not in file.parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", type=pathlib.Path, metavar="FILE", help="only these files")
    parser.add_argument("--self-test", action="store_true", help="try the rule on planted matches")
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    files, count = arguments.files or rust_files(), 0
    for file in files:
        for default in in_text(file.read_text()):
            shown = file.relative_to(ROOT) if file.is_relative_to(ROOT) else file
            print(f"{shown}:{default.line}: a default arm over {default.enum} (name every variant that it stands for)")
            count += 1
    print(f"{len(files)} files, {count} default arms")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())

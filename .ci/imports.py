#!/usr/bin/env python3
"""Finds loops of imports between the files and the folders of a crate: python3 .ci/imports.py [CRATE ...]

A file imports another if it names something that is defined there: by `use`, or by a path such as `crate::a::b`, `super::b` or
`child::b`. What is re-exported counts for the file that defines it, however long the way. These are no imports:

  mod child;                 a parent declares what it is made of
  pub use child::Name;       and hands it on, from lib.rs or from any file above it; if the same file uses Name, it imports it
  list! { child::Name, }     and lists it, in a call of a macro that stands as an item
  #[cfg(test)]               a test may look at everything

A loop of files: they import each other, however far round. A child may import from the file above it, unless that file imports from
the child; with --above it always may. A loop of folders: modules side by side import each other, each with all that is below it,
though no file does. What is in a loop cannot be understood, tested or moved alone. To cut one, put what both need into a file below,
or what needs both into a file above.

Without arguments all crates of the workspace are read. Exit code 0: no loop; 1: each loop with its files, and which line imports what.
`--self-test` tries the rule on planted crates. Nothing but Python's standard library is needed.
"""

import argparse
import collections
import itertools
import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

TOKEN = re.compile(
    r"""(?P<skip>\s+|//[^\n]*|/\*(?:[^*]|\*(?!/))*\*/|b?r(?P<hashes>\#*)".*?"(?P=hashes)|[bc]?"(?:[^"\\]|\\.)*"|b?'(?:[^'\\]|\\.[^']*)')"""
    r"""|(?P<token>(?:r\#)?[A-Za-z_]\w*|'\w+|\$\w+|\$|\d[\w.]*|::|->|=>|.)""",
    re.DOTALL,
)
OPEN, CLOSE = "([{", ")]}"
ITEMS = {"fn", "struct", "enum", "trait", "type", "const", "static", "union"}

Token = collections.namedtuple("Token", "text line")
# A path as it is written, from which module, and in which line.
Mention = collections.namedtuple("Mention", "path line")
# `use path as name`; `name` is `*` for a glob.
Use = collections.namedtuple("Use", "name path line public")
Edge = collections.namedtuple("Edge", "source line name target")
# What is in the loop, and the imports that hold it together.
Loop = collections.namedtuple("Loop", "what members edges")


class Module:
    """A module: a file, or an inline one in a file."""

    def __init__(self, path, file, parent):
        self.path, self.file, self.parent = path, file, parent
        self.children, self.items, self.uses, self.mentions, self.words = {}, set(), [], [], collections.Counter()
        self.declared = []

    def root(self):
        return self if self.parent is None else self.parent.root()


def tokens(text):
    found, line = [], 1
    for match in TOKEN.finditer(text):
        if match["token"]:
            found.append(Token(match["token"], line))
        line += match[0].count("\n")
    return found


def closing(toks, i):
    """The index of the bracket that closes the one at `i`."""
    depth = 0
    for j in range(i, len(toks)):
        depth += (toks[j].text in OPEN) - (toks[j].text in CLOSE)
        if depth == 0:
            return j
    return len(toks) - 1


def end_of_item(toks, i):
    """The index behind the item that begins at `i`: behind its block or its semicolon."""
    while i < len(toks):
        if toks[i].text == "{":
            return closing(toks, i) + 1
        if toks[i].text in "([":
            i = closing(toks, i)
        elif toks[i].text == ";":
            return i + 1
        i += 1
    return i


def is_test(attribute):
    return [t.text for t in attribute] in (["cfg", "(", "test", ")"], ["test"])


def read_use(toks, i, prefix=()):
    """The paths of the tree at `i` with their names, and the index behind it."""
    path, found = list(prefix), []
    while i < len(toks):
        text = toks[i].text
        if text == "{":
            end, i = closing(toks, i), i + 1
            while i < end:
                branch, i = read_use(toks, i, path)
                found += branch
                i += toks[i].text == ","
            return found, end + 1
        if text == "*":
            return [("*", tuple(path), toks[i].line)], i + 1
        if text == "as":
            return [(toks[i + 1].text, tuple(path), toks[i].line)], i + 2
        if text in (",", ";", "}"):
            break
        if text != "::":
            path.append(text)
        i += 1
    line = toks[i - 1].line
    if path and path[-1] == "self":
        path.pop()
    return [(path[-1] if path else "", tuple(path), line)], i


def read_module(module, toks):
    """Fills a module with what its tokens declare, define, use and mention; tests are passed over."""
    i, public = 0, False
    while i < len(toks):
        text = toks[i].text
        if text == "#" and i + 1 < len(toks) and toks[i + 1].text in "[!":
            start = i + 1 + (toks[i + 1].text == "!")
            end = closing(toks, start)
            i = end_of_item_behind_attributes(toks, end + 1) if is_test(toks[start + 1:end]) else end + 1
        elif text == "pub":
            public, i = True, closing(toks, i + 1) + 1 if toks[i + 1].text == "(" else i + 1
        elif text == "use":
            tree, i = read_use(toks, i + 1)
            module.uses += [Use(name, path, at, public) for name, path, at in tree]
            public = False
        elif text == "mod" and i + 2 < len(toks) and toks[i + 2].text == ";":
            module.declared.append(toks[i + 1].text)
            i, public = i + 3, False
        elif text == "mod" and i + 2 < len(toks) and toks[i + 2].text == "{":
            end = closing(toks, i + 2)
            child = Module(module.path + (toks[i + 1].text,), module.file, module)
            module.children[toks[i + 1].text] = child
            read_module(child, toks[i + 3:end])
            i, public = end + 1, False
        elif text == "macro_rules":
            module.items.add(toks[i + 2].text)
            i, public = end_of_item(toks, i), False
        elif i + 2 < len(toks) and toks[i + 1].text == "!" and toks[i + 2].text in OPEN:
            i, public = end_of_item(toks, i), False
        elif text in ITEMS:
            if toks[i + 1].text not in ("fn", "unsafe", "extern", "async"):
                module.items.add(toks[i + 1].text)
            end = end_of_item(toks, i)
            read_body(module, toks[i + 1:end])
            i, public = end, False
        elif text == "impl":
            end = end_of_item(toks, i)
            read_body(module, toks[i + 1:end])
            i, public = end, False
        else:
            module.words[text] += 1
            i += 1
    return module


def end_of_item_behind_attributes(toks, i):
    while i + 1 < len(toks) and toks[i].text == "#":
        i = closing(toks, i + 1) + 1
    return end_of_item(toks, i)


def read_body(module, toks):
    """What the inside of an item uses and mentions; a `use` in a block counts for the whole module."""
    i = 0
    while i < len(toks):
        text, line = toks[i].text, toks[i].line
        # `use<'a>` says what an opaque type captures.
        if text == "use" and toks[i + 1].text != "<":
            tree, i = read_use(toks, i + 1)
            module.uses += [Use(name, path, at, False) for name, path, at in tree]
            continue
        if re.match(r"[A-Za-z_]", text):
            path, i = read_path(toks, i)
            module.words[path[0]] += 1
            if len(path) > 1:
                module.mentions.append(Mention(path, line))
            continue
        i += 1


def read_path(toks, i):
    """The path that begins at `i`; one that goes on behind `::`, as of `<T>::x` or `$crate::x`, is passed over."""
    follows = i > 0 and toks[i - 1].text in ("::", ".")
    path = [toks[i].text]
    i += 1
    while i + 1 < len(toks) and toks[i].text == "::" and re.match(r"[A-Za-z_]", toks[i + 1].text):
        path.append(toks[i + 1].text)
        i += 2
    return (("",), i) if follows else (tuple(path), i)


def file_of(parent, name):
    """The file of a declared module: beside lib.rs, main.rs and mod.rs, else in the folder of its parent."""
    file = parent.file
    folder = file.parent if parent.path == () or file.name == "mod.rs" else file.with_suffix("")
    inline = parent.path[len(module_of_file(parent).path):]
    folder = folder.joinpath(*inline)
    return next((f for f in (folder / f"{name}.rs", folder / name / "mod.rs") if f.exists()), None)


def module_of_file(module):
    """The outermost module in the same file."""
    while module.parent is not None and module.parent.file == module.file:
        module = module.parent
    return module


def read_crate(root_file):
    root = Module((), root_file, None)
    queue = [read_module(root, tokens(root_file.read_text()))]
    while queue:
        module = queue.pop()
        queue += module.children.values()
        for name in module.declared:
            file = file_of(module, name)
            if file is None:
                raise SystemExit(f"cannot read module {name} of {module.file}: it has no file")
            child = Module(module.path + (name,), file, module)
            module.children[name] = child
            queue.append(read_module(child, tokens(file.read_text())))
    return root


def all_modules(module):
    yield module
    for child in module.children.values():
        yield from all_modules(child)


def begin(module, path):
    """Where a path starts, and what is left of it; nothing if it leads out of the crate."""
    head, rest = path[0], path[1:]
    if head in ("crate", "$crate"):
        return module.root(), rest
    if head == "self":
        return module, rest
    if head == "super":
        return (module.parent, rest) if module.parent else None
    if head in module.children:
        return module.children[head], rest
    return None


def resolve(module, path, tried=None):
    """The module that defines what a path names and the name there, `None` for a module itself; nothing if it is foreign."""
    if not path:
        return None
    tried = set() if tried is None else tried
    start = begin(module, path)
    return by_use(module, path, tried) if start is None else descend(*start, tried)


def descend(module, rest, tried):
    if not rest:
        return module, None
    head = rest[0]
    if head == "super":
        return descend(module.parent, rest[1:], tried) if module.parent else None
    if head == "self":
        return descend(module, rest[1:], tried)
    if head in module.children:
        return descend(module.children[head], rest[1:], tried)
    if head in module.items:
        return module, head
    return by_use(module, rest, tried) or (module, head)


def by_use(module, path, tried):
    """A path that begins with a name that a `use` has brought; each is tried once, since some lead in circles."""
    for use in module.uses:
        if use.name not in (path[0], "*") or (module, use) in tried:
            continue
        tried.add((module, use))
        found = resolve(module, use.path + (path if use.name == "*" else path[1:]), tried)
        # What a glob does not define is none of its names.
        if found and (use.name != "*" or found[1] is None or found[1] in found[0].items):
            return found
    return None


def is_below(path, module):
    return len(path) > len(module.path) and path[: len(module.path)] == module.path


def imports(module):
    """What one module imports from other files."""
    found = []
    for use in module.uses:
        target = resolve(module, use.path)
        if target is None:
            continue
        if use.name == "*":
            found += [(use.line, word, by_use(module, (word,), set())) for word in module.words if not use.public]
            continue
        handed_on = use.public and is_below(target[0].path, module) and not module.words[use.name]
        if target[1] is not None and not handed_on:
            found.append((use.line, use.name, target))
    found += [(mention.line, "::".join(mention.path), resolve(module, mention.path)) for mention in module.mentions]
    for line, name, target in found:
        if target is not None and target[1] is not None and target[0].file != module.file:
            yield Edge(module.file, line, name, target[0].file)


def connected(graph):
    """The strongly connected sets of more than one node, by Tarjan's algorithm."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for target in sorted(graph.get(node, ())):
            if target not in index:
                visit(target)
                low[node] = min(low[node], low[target])
            elif target in stack:
                low[node] = min(low[node], index[target])
        if low[node] == index[node]:
            at = stack.index(node)
            found.append(sorted(stack[at:]))
            del stack[at:]

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return sorted(nodes for nodes in found if len(nodes) > 1)


def graph_of(edges, node):
    """Which node imports which; `node` gives that of a file, or nothing."""
    graph = collections.defaultdict(set)
    for edge in edges:
        source, target = node(edge.source), node(edge.target)
        if source is not None and target is not None and source != target:
            graph[source].add(target)
    return graph


def file_loops(edges):
    """Files that import each other."""
    for files in connected(graph_of(edges, lambda file: file)):
        yield Loop("files", files, [e for e in edges if e.source in files and e.target in files])


def folder_loops(edges, paths, known):
    """Modules side by side that import each other where none of the `known` loops of files does."""
    for parent in sorted({path[:i] for path in paths.values() for i in range(len(path))}):
        def child(file, depth=len(parent)):
            path = paths[file]
            return path[: depth + 1] if len(path) > depth and path[:depth] == parent else None

        for members in connected(graph_of(edges, child)):
            if not any(len({child(file) for file in loop.members} & set(members)) > 1 for loop in known):
                between = [e for e in edges if child(e.source) in members and child(e.target) in members and child(e.source) != child(e.target)]
                yield Loop("folders", ["::".join(path) for path in members], between)


def loops_of(root_file, above=False):
    """The loops of a crate."""
    modules = list(all_modules(read_crate(root_file)))
    paths = {module.file: module.path for module in reversed(modules)}
    is_above = lambda edge: paths[edge.target] == paths[edge.source][: len(paths[edge.target])]
    edges = sorted({edge for module in modules for edge in imports(module)})
    files = list(file_loops([edge for edge in edges if not (above and is_above(edge))]))
    return files + list(folder_loops(edges, paths, files))


def tell(root_file, base, above):
    """Prints the loops of a crate; how many there are."""
    found = loops_of(root_file, above)
    for loop in found:
        print(f"\nloop of {len(loop.members)} {loop.what} in {root_file.relative_to(base)}: {' '.join(named(loop.members, root_file))}")
        for source, edges in itertools.groupby(loop.edges, lambda edge: edge.source):
            print(f"  {source.relative_to(base)}")
            for target, names in itertools.groupby(sorted(edges, key=lambda edge: edge.target), lambda edge: edge.target):
                words = sorted({f"{edge.name}:{edge.line}" for edge in names})
                print(f"    from {target.relative_to(base)}: {', '.join(words)}")
    return len(found)


def named(members, root_file):
    """Files without folder and ending; folders as they are."""
    return [m if isinstance(m, str) else m.relative_to(root_file.parent).with_suffix("").as_posix() for m in members]


def root_files(folders):
    files = [folder / "src" / name for folder in folders for name in ("lib.rs", "main.rs")]
    return [file for file in files if file.exists()]


def workspace():
    manifests = sorted(ROOT.glob("*/Cargo.toml")) + sorted(ROOT.glob("*/*/Cargo.toml"))
    return [manifest.parent for manifest in manifests]


# Planted crates: what they are, their files, and the loops that must be found.
PLANTED = [
    ("two files that import each other",
     {"lib.rs": "mod a; mod b;", "a.rs": "use crate::b::B; pub struct A(B);", "b.rs": "pub struct B; fn f(a: &crate::a::A) {}"}, ["a b"]),
    ("a loop of three, through super, self and a tree",
     {"lib.rs": "mod a; mod b; mod c;", "a.rs": "use super::{b::{B}}; pub struct A(B);", "b.rs": "use crate::c as d; pub struct B(d::C);",
      "c.rs": "pub struct C; pub fn f() { let _: super::a::A; }"}, ["a b c"]),
    ("a child that imports from a parent which uses it",
     {"lib.rs": "mod a;", "a.rs": "mod b; pub struct A; fn f() { b::g() }", "a/b.rs": "use super::A; pub fn g() {}"}, ["a/b a"]),
    ("an opaque type that captures",
     {"lib.rs": "mod a;", "a.rs": "pub fn f<'a>(x: &'a [u8]) -> impl Iterator<Item = u8> + use<'a> { x.iter().copied() }"}, []),
    ("a parent that declares, hands on and lists",
     {"lib.rs": "mod a;", "a.rs": "mod b; pub use b::B; pub trait T {} list! { b::B, }", "a/b.rs": "use super::T; pub struct B; impl T for B {}"}, []),
    ("a parent that hands on and uses as well",
     {"lib.rs": "mod a;", "a.rs": "mod b; pub use b::B; pub trait T { fn f(b: B); }", "a/b.rs": "use super::T; pub struct B;"}, ["a/b a"]),
    ("siblings through what their parent hands on",
     {"lib.rs": "mod a;", "a.rs": "mod b; mod c; pub use b::B; pub(crate) use c::C;", "a/b.rs": "use super::C; pub struct B(C);",
      "a/c.rs": "pub struct C; fn f(_: super::B) {}"}, ["a/b a/c"]),
    ("a glob through lib.rs",
     {"lib.rs": "mod a; mod b; pub use a::*;", "a.rs": "pub struct A; fn f() { crate::b::g() }", "b.rs": "use crate::*; pub fn g() -> A { A }"}, ["a b"]),
    ("folders that import each other, though no file does",
     {"lib.rs": "mod a; mod b;", "a.rs": "mod c; pub struct A;", "a/c.rs": "use crate::b::B; pub struct C(B);", "b.rs": "use crate::a::A; pub struct B(A);"},
     ["a b"]),
    ("tests, comments and texts",
     {"lib.rs": "mod a; mod b;", "a.rs": "use crate::b::B; pub struct A(B);",
      "b.rs": "// crate::a::A\npub struct B; const S: &str = \"crate::a::A\"; #[cfg(test)] mod tests { use crate::a::A; }"}, []),
    ("inline modules belong to their file",
     {"lib.rs": "mod a; mod b;", "a.rs": "pub mod inner { pub struct A; } fn f(_: crate::b::B) {}", "b.rs": "pub struct B(crate::a::inner::A);"}, ["a b"]),
    ("other crates and names of one's own",
     {"lib.rs": "mod a; mod b;", "a.rs": "use std::fmt; use crate::b::B; pub enum E { X } fn f(_: B) -> E { E::X }", "b.rs": "use serde::a; pub struct B;"}, []),
]


def self_test():
    failed = 0
    for words, files, expected in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            src = pathlib.Path(folder).resolve()
            for name, text in files.items():
                (src / name).parent.mkdir(exist_ok=True)
                (src / name).write_text(text)
            found = [" ".join(named(loop.members, src / "lib.rs")) for loop in loops_of(src / "lib.rs")]
        failed += found != expected
        print(f"{'ok  ' if found == expected else 'FAIL'} {words}" + ("" if found == expected else f": {found}, not {expected}"))
    print(f"{len(PLANTED)} planted crates, {failed} wrong")
    return 1 if failed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("crates", nargs="*", type=pathlib.Path, metavar="CRATE", help="folders that hold src/lib.rs or src/main.rs")
    parser.add_argument("--above", action="store_true", help="let every file import from the files above it, whatever these import")
    parser.add_argument("--self-test", action="store_true", help="try the rule on planted crates")
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    base = ROOT if not arguments.crates else pathlib.Path("/")
    files = root_files([folder.resolve() for folder in arguments.crates] or workspace())
    if not files:
        raise SystemExit("cannot look for loops: there is no src/lib.rs and no src/main.rs")
    count = sum(tell(file, base, arguments.above) for file in files)
    print(f"{len(files)} crates, {count} loops")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())

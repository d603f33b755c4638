#!/usr/bin/env python3
"""Reads the interface of each module of emitted Verilog with slang's parser.

    python slang_interfaces.py DIR...

Every DIR is the output of `reliefrtl emit`. Prints one JSON object a file of DIR/rtl/filelist.f: {"dir", "file", "modules",
"errors", "name", "params": [[name, default], ...], "ports": [[name, direction, has a range], ...]}, where `modules` counts
the modules of the file and all else is that of the first.
"""

import functools
import json
import pathlib
import sys

from pyslang import syntax


@functools.cache
def interface(text):
    """Name, parameters and ports of the first module of a text, as they are written. Many directories hold the same text."""
    tree = syntax.SyntaxTree.fromText(text)
    root = tree.root
    members = root.members if root.kind == syntax.SyntaxKind.CompilationUnit else [root]
    modules = [m for m in members if m.kind == syntax.SyntaxKind.ModuleDeclaration]
    header = modules[0].header
    params = [
        [x.name.value, str(x.initializer.expr).strip()]
        for declaration in (header.parameters.declarations if header.parameters else [])
        for x in getattr(declaration, "declarators", [])
        if x.kind == syntax.SyntaxKind.Declarator
    ]
    ports = [
        [p.declarator.name.value, p.header.direction.valueText, len(p.header.dataType.dimensions) > 0]
        for p in header.ports.ports
        if p.kind == syntax.SyntaxKind.ImplicitAnsiPort
    ]
    # Names in the header, declarations in the body.
    ports += [
        [x.name.value, d.header.direction.valueText, len(d.header.dataType.dimensions) > 0]
        for d in modules[0].members
        if d.kind == syntax.SyntaxKind.PortDeclaration
        for x in d.declarators
        if x.kind == syntax.SyntaxKind.Declarator
    ]
    errors = sum(1 for d in tree.diagnostics if d.isError())
    return {"modules": len(modules), "errors": errors, "name": header.name.value, "params": params, "ports": ports}


def main():
    """One line a file."""
    for directory in sys.argv[1:]:
        for file in (pathlib.Path(directory) / "rtl/filelist.f").read_text().split():
            print(json.dumps({"dir": directory, "file": file, **interface((pathlib.Path(directory) / file).read_text())}))
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Elaborates emitted Verilog with slang: any warning is an error.

    python slang_check.py [--benches] DIR...
    python slang_check.py --words WORD...
    python slang_check.py --keywords

Every DIR is the output of `reliefrtl emit`: rtl/filelist.f names its files, from DIR. Each module is a top of its own,
at its default parameters; with --benches, each file of testbench/ is instead, with the look into the loop compiled in.
With --words, slang's own command line is elaborated, whatever it reads.
With --keywords, the words that slang takes for keywords are printed, a line each, without underscores.
Prints how many modules were elaborated; ends with 1 if slang had anything to say.
"""

import pathlib
import shlex
import sys

from pyslang import driver, parsing


def check(directory, benches):
    """Elaborates one output directory; returns the number of modules, or None if slang complained."""
    files = [directory / line for line in (directory / "rtl/filelist.f").read_text().split()]
    asked = sorted((directory / "testbench").glob("*.v")) if benches else files
    tops = [word for file in asked for word in ("--top", file.stem)]
    define = ["-DITERATIONS"] if benches else []
    read = files + asked if benches else files
    # Options come before files, so that a file's name can't be taken for one.
    return elaborate([*define, *tops, *map(str, read)])


def elaborate(words):
    """Elaborates what a command line names; returns the number of tops, or None if slang complained."""
    words = ["slang", "--std", "1364-2005", "-Wextra", "-Werror", *words]
    d = driver.Driver()
    d.addStandardArgs()
    if not d.parseCommandLine(shlex.join(words)) or not d.processOptions() or not d.parseAllSources():
        return None
    compilation = d.createCompilation()
    # "True" leaves out the line that only counts errors and warnings.
    d.reportCompilation(compilation, True)
    d.runAnalysis(compilation)
    clean = d.reportDiagnostics(True) and d.diagEngine.numErrors + d.diagEngine.numWarnings == 0
    return len(compilation.getRoot().topInstances) if clean else None


def main():
    """Checks all directories, also after a bad one."""
    if sys.argv[1:2] == ["--words"]:
        count = elaborate(sys.argv[2:])
        print(f"modules elaborated without a warning: {count}")
        return 1 if count is None else 0
    if sys.argv[1:] == ["--keywords"]:
        kinds = [kind for kind in dir(parsing.TokenKind) if kind.endswith("Keyword")]
        print("\n".join(kind.removesuffix("Keyword").lower() for kind in kinds))
        return 0
    benches = "--benches" in sys.argv[1:]
    directories = [word for word in sys.argv[1:] if word != "--benches"]
    counts = [(directory, check(pathlib.Path(directory), benches)) for directory in directories]
    bad = [directory for directory, count in counts if count is None]
    for directory in bad:
        print(f"slang_check.py: not clean: {directory}", file=sys.stderr)
    if bad or not counts:
        return 1
    print(f"modules elaborated without a warning: {sum(count for _, count in counts)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

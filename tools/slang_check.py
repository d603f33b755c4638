#!/usr/bin/env python3
"""Elaborates emitted Verilog with slang: any warning is an error.

    python slang_check.py DIR...

Every DIR is the output of `reliefrtl emit`: rtl/filelist.f names its files, from DIR. Each module is a top of its own,
at its default parameters. Prints how many modules were elaborated; ends with 1 if slang had anything to say.
"""

import pathlib
import shlex
import sys

from pyslang import driver


def check(directory):
    """Elaborates one output directory; returns the number of modules, or None if slang complained."""
    files = [directory / line for line in (directory / "rtl/filelist.f").read_text().split()]
    tops = [word for file in files for word in ("--top", file.stem)]
    # Options come before files, so that a file's name can't be taken for one.
    words = ["slang", "--std", "1364-2005", "-Wextra", "-Werror", *tops, *map(str, files)]
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
    counts = [(directory, check(pathlib.Path(directory))) for directory in sys.argv[1:]]
    bad = [directory for directory, count in counts if count is None]
    for directory in bad:
        print(f"slang_check.py: not clean: {directory}", file=sys.stderr)
    if bad or not counts:
        return 1
    print(f"modules elaborated without a warning: {sum(count for _, count in counts)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

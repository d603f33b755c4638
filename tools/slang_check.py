"""Elaborates the named files with slang (pyslang) as Verilog-2005; prints the diagnostics, nothing if all is clean."""
import sys

from pyslang import driver

d = driver.Driver()
d.addStandardArgs()
if not d.parseCommandLine("slang --std 1364-2005 -Wextra " + " ".join(sys.argv[1:])):
    sys.exit(2)
if not d.processOptions() or not d.parseAllSources():
    sys.exit(1)
d.reportCompilation(d.createCompilation(), True)

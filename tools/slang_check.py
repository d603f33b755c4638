"""Elaborates the named files with slang (pyslang) as Verilog-2005; prints nothing and exits 0 if all is clean."""
import sys
from pyslang import driver

d = driver.Driver()
d.addStandardArgs()
options = "slang --std 1364-2005 -q -Wextra -Werror "
if not d.parseCommandLine(options + " ".join(sys.argv[1:])) or not d.processOptions():
    sys.exit(2)
ok = d.parseAllSources()
compilation = d.createCompilation()
for diagnostic in compilation.getAllDiagnostics():
    d.diagEngine.issue(diagnostic)
print(d.textDiagClient.getString(), end="") if hasattr(d, "textDiagClient") else None
sys.exit(0 if ok and not d.diagEngine.numErrors and not d.diagEngine.numWarnings else 1)

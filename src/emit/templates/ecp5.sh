#!/bin/sh
# Places and routes {{ top }} on an ECP5 (LFE5U-85F, speed grade 8) at each seed of nextpnr.
#   sh flow/ecp5.sh [SEED...]
# YOSYS and NEXTPNR name the programs. Results go to pnr/ beside rtl/.
set -eu
cd "$(dirname "$0")/.."
mkdir -p pnr
"${YOSYS:-yosys}" -q -s flow/ecp5.ys
for seed in "${@:-1}"; do
  "${NEXTPNR:-nextpnr-ecp5}" --85k --speed 8 --package CABGA756 --freq {{ mhz }} --seed "$seed" \
    --placer-heap-timingweight 60 \
    --json pnr/{{ top }}.json --lpf flow/{{ top }}.lpf --lpf-allow-unconstrained --timing-allow-fail \
    --report "pnr/{{ top }}-$seed.json" --textcfg "pnr/{{ top }}-$seed.config" -q
  echo "seed $seed: pnr/{{ top }}-$seed.json"
done

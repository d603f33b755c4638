#!/bin/sh
# Puts Berkeley HardFloat beside registers, so that `reliefrtl synth --beside` measures it as it measures our units, in the same run.
#
#   sh tools/hardfloat.sh SOURCE DIR
#
# SOURCE is the directory `source` of its Verilog (Release 1), which is not part of this project; DIR gets copies of the files that the wrappers of
# tools/hardfloat.v need. Then:
#
#   reliefrtl synth --unit fp_add,fp_mul,fp_lt --latency 1,2 --beside hf_add_l1=DIR,hf_add_l2=DIR,hf_mul_l1=DIR,hf_mul_l2=DIR,hf_lt_l1=DIR
set -eu
if [ $# -ne 2 ] || [ ! -f "$1/addRecFN.v" ]; then
    echo "usage: sh tools/hardfloat.sh SOURCE DIR; SOURCE holds addRecFN.v" >&2
    exit 2
fi
here=$(dirname "$0")
mkdir -p "$2"
for file in addRecFN.v mulRecFN.v compareRecFN.v HardFloat_primitives.v HardFloat_rawFN.v isSigNaNRecFN.v HardFloat_consts.vi HardFloat_localFuncs.vi \
    RISCV/HardFloat_specialize.v RISCV/HardFloat_specialize.vi; do
    cp "$1/$file" "$2/"
done
cp "$here/hardfloat.v" "$2/"

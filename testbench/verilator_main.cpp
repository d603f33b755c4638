// SPDX-License-Identifier: MIT OR Apache-2.0
// Clocks a bench until it is done, and returns its exit code. The class that Verilator makes of the bench is VTOP (its --prefix, by default
// V and the top's name): build with -CFLAGS -DVTOP=Vrelief_tb_traverse, or with --prefix Vtb and without VTOP.
#include <cstdint>
#include <cstdio>
#include <memory>

#ifndef VTOP
#define VTOP Vtb
#endif
#define RELIEF_QUOTED(name) #name
#define RELIEF_HEADER(name) RELIEF_QUOTED(name.h)

#include RELIEF_HEADER(VTOP)
#include "verilated.h"

int main(int argc, char** argv) {
  const auto context = std::make_unique<VerilatedContext>();
  context->commandArgs(argc, argv);
  const auto top = std::make_unique<VTOP>(context.get());
  uint64_t clocks = 0;
  top->clk = 0;
  top->eval();
  while (!top->done && !context->gotFinish()) {
    top->clk = 1;
    top->eval();
    top->clk = 0;
    top->eval();
    ++clocks;
  }
  std::printf("clocks: %llu\n", static_cast<unsigned long long>(clocks));
  top->final();
  return top->done ? top->exit_code : 4;
}

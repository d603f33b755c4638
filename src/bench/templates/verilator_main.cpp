// Clocks a bench (built with --prefix Vtb) until it is done, and returns its exit code.
#include <cstdint>
#include <cstdio>
#include <memory>

#include "Vtb.h"
#include "verilated.h"

int main(int argc, char** argv) {
  const auto context = std::make_unique<VerilatedContext>();
  context->commandArgs(argc, argv);
  const auto top = std::make_unique<Vtb>(context.get());
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

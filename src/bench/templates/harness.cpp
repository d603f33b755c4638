// Sends rays from memory through {{ top }} and keeps what comes out: the traversal alone is timed, by processor time.
// Prints one line of JSON, and ends with 0 (all results as expected), 1 (some are not), 6 (a ray never came back), 7 (one was never sent).
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <vector>

#include "Vdut.h"
#include "verilated.h"

namespace {

constexpr uint64_t kInputs = {{ inputs|length }};
constexpr uint64_t kOutputs = {{ outputs|length }};
constexpr uint64_t kTags = {{ tags }};
constexpr uint64_t kPatience = {{ patience }};  // clocks without a result after which rays count as lost

double processor() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

inline void clock(Vdut* top) {
  top->clk = 0;
  top->eval();
  top->clk = 1;
  top->eval();
}

// The words of rays.bin: how many of the memory and of rays, then the memory, the rays and the expected results.
std::vector<uint64_t> read() {
  std::vector<uint64_t> words;
  if (std::FILE* file = std::fopen("rays.bin", "rb")) {
    std::fseek(file, 0, SEEK_END);
    words.resize(static_cast<size_t>(std::ftell(file)) / sizeof(uint64_t));
    std::rewind(file);
    if (std::fread(words.data(), sizeof(uint64_t), words.size(), file) != words.size()) words.clear();
    std::fclose(file);
  }
  return words;
}

}  // namespace

int main() {
  const std::vector<uint64_t> words = read();
  if (words.size() < 2) return 2;
  const uint64_t memory = words[0], rays = words[1];
  const uint64_t* image = words.data() + 2;
  const uint64_t* sent = image + memory;
  const uint64_t* expected = sent + rays * kInputs;

  VerilatedContext context;
  Vdut dut{&context};
  Vdut* const top = &dut;
  const double start = processor();
  top->rst = 1;
  top->in_valid = 0;
  top->out_ready = 1;
{%- for words in sizes %}
  top->load_en_{{ loop.index0 }} = 0;
{%- else %}
  top->load_en = 0;
{%- endfor %}
  for (int k = 0; k < 4; ++k) clock(top);
  top->rst = 0;
{%- if sizes %}
  const uint64_t* word = image;
{%- for words in sizes %}
  top->load_en_{{ loop.index0 }} = 1;
  for (uint64_t k = 0; k < {{ words }}; ++k) {
    top->load_addr_{{ loop.index0 }} = k;
    top->load_data_{{ loop.index0 }} = *word++;
    clock(top);
  }
  top->load_en_{{ loop.index0 }} = 0;
{%- endfor %}
{%- else %}
  top->load_en = 1;
  for (uint64_t k = 0; k < memory; ++k) {
    top->load_addr = k;
    top->load_data = image[k];
    clock(top);
  }
  top->load_en = 0;
{%- endif %}
  // A last load may be on its way through registers.
  for (int k = 0; k < 8; ++k) clock(top);

  std::vector<uint64_t> results(rays * kOutputs);
  std::vector<uint64_t> pending(kTags, rays);  // the ray of each tag in flight
  const double loaded = processor(), loaded_wall = wall();
  uint64_t next = 0, back = 0, clocks = 0, quiet = 0;
  bool extra = false;
  while (back < rays && quiet < kPatience) {
    // What stands at the ports is transferred at the next edge; ready does not depend on valid.
    const uint64_t tag = next % kTags;
    const bool valid = next < rays && pending[tag] == rays;
    top->in_valid = valid;
    if (valid) {
      const uint64_t* ray = sent + next * kInputs;
      top->in_tag = tag;
{%- for name in inputs %}
      top->{{ name }} = ray[{{ loop.index0 }}];
{%- endfor %}
      if (top->in_ready) pending[tag] = next++;
    }
    ++quiet;
    if (top->out_valid) {
      uint64_t& ray = pending[top->out_tag % kTags];
      if (ray == rays) {
        extra = true;
        break;
      }
      uint64_t* row = results.data() + ray * kOutputs;
{%- for name in outputs %}
      row[{{ loop.index0 }}] = top->{{ name }};
{%- endfor %}
      ray = rays;
      ++back;
      quiet = 0;
    }
    clock(top);
    ++clocks;
  }
  const double done = processor(), done_wall = wall();

  uint64_t wrong = 0, first = rays;
  for (uint64_t k = 0; k < rays; ++k) {
    bool same = true;
    for (uint64_t p = 0; p < kOutputs; ++p) same &= results[k * kOutputs + p] == expected[k * kOutputs + p];
    if (!same && wrong++ == 0) first = k;
  }
  std::printf(
      "{\"load_s\": %.9f, \"run_s\": %.9f, \"wall_s\": %.9f, \"clocks\": %llu, \"compared\": %llu, \"wrong\": %llu, \"first_wrong\": %llu}\n",
      loaded - start, done - loaded, done_wall - loaded_wall, static_cast<unsigned long long>(clocks),
      static_cast<unsigned long long>(back), static_cast<unsigned long long>(wrong), static_cast<unsigned long long>(first));
  if (extra) return 7;
  if (back < rays) return 6;
  return wrong == 0 ? 0 : 1;
}

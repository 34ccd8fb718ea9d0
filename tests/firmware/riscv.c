/* Start-up and semihosting for RISC-V's `virt` board as QEMU models it. Loaded into RAM, .data with it. */
#include "device.h"

int main(void);

/* From virt.ld. */
extern char bss_begin[], bss_end[];
extern void (*const init_begin[])(void);
extern void (*const init_end[])(void);

/* QEMU knows the breakpoint by what stands around it, on one page and uncompressed. */
static void ask_host(uint32_t operation, const void* argument) {
  register uint32_t a0 __asm__("a0") = operation;
  register const void* a1 __asm__("a1") = argument;
  __asm__ volatile(
      ".balign 16\n .option push\n .option norvc\n"
      "slli zero, zero, 0x1f\n ebreak\n srai zero, zero, 7\n .option pop\n"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
}

void put(const char* text) { ask_host(0x04, text); }

static void leave(uint32_t code) {
  const uint32_t reason[2] = {0x20026, code};
  for (;;) ask_host(0x20, reason);
}

__attribute__((aligned(4), used)) static void fault(void) {
  put("FAULT\n");
  leave(99);
}

__attribute__((used)) static void reset(void) {
  char* to;
  void (*const* init)(void);
  for (to = bss_begin; to < bss_end; ++to) *to = 0;
  for (init = init_begin; init < init_end; ++init) (*init)();
  leave((uint32_t)main());
}

__attribute__((naked, section(".start"), used)) void start(void) {
  __asm__ volatile(
      "la sp, stack_end\n"
      "la t0, fault\n csrw mtvec, t0\n"
#ifdef __riscv_flen
      "li t0, 0x2000\n csrs mstatus, t0\n" /* the FPU is off until mstatus says otherwise */
#endif
      "j reset\n");
}

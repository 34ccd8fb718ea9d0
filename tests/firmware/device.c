/* Start-up, semihosting, a clock and a painted stack for Arm's MPS2 boards as QEMU models them. */
#include "device.h"

int main(void);

/* From mps2.ld. */
extern uint32_t stack_begin[], stack_end[], data_begin[], data_end[], bss_begin[], bss_end[];
extern const uint32_t data_source[];
extern void (*const init_begin[])(void);
extern void (*const init_end[])(void);

#define REGISTER(address) (*(volatile uint32_t*)(address))

/* Semihosting: QEMU carries out what the breakpoint asks for. */
static void ask_host(uint32_t operation, const void* argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void put(const char* text) { ask_host(0x04, text); }

static void leave(uint32_t code) {
  const uint32_t reason[2] = {0x20026, code};
  for (;;) ask_host(0x20, reason);
}

static void fault(void) {
  put("FAULT\n");
  leave(99);
}

static void reset(void) {
  uint32_t* to;
  const uint32_t* from = data_source;
  void (*const* init)(void);
#ifdef __ARM_FP
  REGISTER(0xE000ED88) |= 0xFu << 20; /* the FPU is off until CPACR says otherwise */
  __asm__ volatile("dsb\n isb" ::: "memory");
#endif
  for (to = data_begin; to < data_end; ++to) *to = *from++;
  for (to = bss_begin; to < bss_end; ++to) *to = 0;
  for (init = init_begin; init < init_end; ++init) (*init)();
  leave((uint32_t)main());
}

__attribute__((section(".vectors"), used)) static const void* const vectors[] = {
    stack_end, (const void*)reset, (const void*)fault, (const void*)fault,
    (const void*)fault, (const void*)fault, (const void*)fault};

/* CMSDK timer 0: counts down at 25 MHz. With -icount shift=6 an instruction takes 64 ns. */
static void start_clock(void) {
  REGISTER(0x40000000) = 0;
  REGISTER(0x40000008) = 0xFFFFFFFFu;
  REGISTER(0x40000004) = 0xFFFFFFFFu;
  REGISTER(0x40000000) = 1;
}
static uint32_t ticks(void) { return 0xFFFFFFFFu - REGISTER(0x40000004); }

#define PAINT 0xDEADBEEFu

__attribute__((noinline)) cost measure(void (*work)(void)) {
  volatile uint32_t* word;
  uint32_t* top;
  uint32_t before;
  cost result;
  __asm__ volatile("mov %0, sp" : "=r"(top)); /* below it nothing is alive */
  for (word = stack_begin; word < top; ++word) *word = PAINT;
  start_clock();
  before = ticks();
  work();
  result.ticks = ticks() - before;
  for (word = stack_begin; word < top && *word == PAINT; ++word) continue;
  result.stack = (uint32_t)((const volatile char*)top - (const volatile char*)word);
  return result;
}

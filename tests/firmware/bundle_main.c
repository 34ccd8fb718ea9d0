/* Runs the bundle's example, whose main is called `example` here, where there may be no stdio. */
#include "device.h"

extern volatile float newtons;
int example(void);

int main(void) {
  const int result = example();
  put_number("run example result ", (uint32_t)result);
  put_real(" newtons ", newtons);
  put("\nend\n");
  return result;
}

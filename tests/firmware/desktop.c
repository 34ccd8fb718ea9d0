/* The same programs on the desktop, for the bits that the boards must give. */
#include "device.h"

#include <stdio.h>

void put(const char* text) { fputs(text, stdout); }

cost measure(void (*work)(void)) {
  const cost none = {0, 0};
  work();
  return none;
}

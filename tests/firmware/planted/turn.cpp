// A pivot whose stack grows with the problem.
#include "kernel.h"

using lcpush::Dictionary;

int real_turn(Dictionary<float>& dictionary, int entering, float* scratch,
              int* candidates) __asm__("__real__Z4turnRN6lcpush10DictionaryIfiEEiPfPi");
int wrap_turn(Dictionary<float>& dictionary, int entering, float* scratch,
              int* candidates) __asm__("__wrap__Z4turnRN6lcpush10DictionaryIfiEEiPfPi");

int wrap_turn(Dictionary<float>& dictionary, int entering, float* /*scratch*/, int* candidates) {
  float* const column = static_cast<float*>(
      __builtin_alloca(static_cast<unsigned>(dictionary.size()) * sizeof(float)));
  return real_turn(dictionary, entering, column, candidates);
}

// What the playground's solver takes when it is no page's: `page_answers SCENE`. Processor time of
// an answer while a hand drags, and of one in full: the median of 100.
#include <cstdio>
#include <vector>

#include "bench/stopwatch.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "play/answers.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: page_answers SCENE\n");
    return 2;
  }
  const std::string text = lcpush::desktop::read_scene_text(argv[1]);
  lcpush::desktop::Playground playground;
  for (const char* question : {"drag", "solve"}) {
    std::vector<double> times;
    for (int k = 0; k < 100; ++k) {
      const double begin = lcpush::bench::cpu_ms();
      (void)playground.answer_to(question, text);
      times.push_back(lcpush::bench::cpu_ms() - begin);
    }
    std::printf("%s: median %.2f ms\n", question, lcpush::bench::median(times));
  }
  return 0;
}

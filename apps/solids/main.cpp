// clearcut-solids FILE_NAME UP TURN BODY < file > answer: reads a STEP solid for clearcut.
//
// A program of its own, because loading the CAD kernel takes longer than planning a pocket, and because the kernel
// breaks down over some damaged files.
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <iterator>

#include "solid_answer.h"

int main(int count, char** arguments) {
  if (count != 5) {
    std::cerr << "usage: clearcut-solids FILE_NAME UP TURN BODY < file\n";
    return 2;
  }
  const clearcut::read::SolidChoice choice{arguments[2], std::strtod(arguments[3], nullptr), arguments[4]};
  // The kernel prints messages on standard output.
  const int out = dup(STDOUT_FILENO);
  if (out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const std::string answer = clearcut::solid_answer(text, arguments[1], choice);
  std::size_t sent = 0;
  while (sent < answer.size()) {
    const ssize_t written = write(out, answer.data() + sent, answer.size() - sent);
    if (written <= 0) return 1;
    sent += static_cast<std::size_t>(written);
  }
  // Skips the kernel's own shutdown, which takes as long as its start.
  _exit(0);
}

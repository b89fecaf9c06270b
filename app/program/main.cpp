/// shellback: thermo-elasto-hydrodynamic lubrication of journal bearings.
#include <csignal>
#include <string>
#include <vector>

#include "app/program/cli.hpp"
#include "core/freed_memory.hpp"

int main(int argc, char** argv) {
  shellback::keep_freed_memory();
  // A closed pipe and a file at its size limit are failed writes, to be told, and no death.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  return shellback::program::run_program(words);
}

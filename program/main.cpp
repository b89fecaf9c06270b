/// shellback: thermo-elasto-hydrodynamic lubrication of journal bearings.
#include <string>
#include <vector>

#include "core/freed_memory.hpp"
#include "program/cli.hpp"

int main(int argc, char** argv) {
  shellback::keep_freed_memory();
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  return shellback::program::run_program(words);
}

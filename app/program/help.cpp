/// help: the reference of the case file.
#include <iostream>

#include "app/key_reference.hpp"
#include "app/program/commands.hpp"

namespace shellback::program {

int help(const Request& request) {
  std::cout << app::key_reference(app::case_page(), request.names);
  return kDone;
}

}  // namespace shellback::program

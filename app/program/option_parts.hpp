#pragma once
/// Options that several commands have.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/program/request.hpp"

namespace shellback::program {

/// The case, and changes of it.
void add_case_options(CLI::App& command, Request& request);

/// An option that takes a list; each part of it says something.
CLI::Option* add_list(CLI::App& command, const std::string& name, std::vector<std::string>& list,
                      const std::string& words);

/// How many threads, by -j: one where nothing is said, or as many as there are cores.
void add_threads(CLI::App& command, Request& request, const std::string& words);
void add_cores(CLI::App& command, Request& request, const std::string& what);

void add_force(CLI::App& command, Request& request);

/// Where the state of `what`, which takes its time, is kept.
void add_state(CLI::App& command, Request& request, const std::string& what);

}  // namespace shellback::program

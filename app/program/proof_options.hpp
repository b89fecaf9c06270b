#pragma once
/// The commands that prove the program itself, with their options.
#include <CLI/CLI.hpp>

#include "app/program/request.hpp"

namespace shellback::program {

void add_validate(CLI::App& app, Request& request);
void add_chart(CLI::App& app, Request& request);
void add_stress(CLI::App& app, Request& request);
void add_study(CLI::App& app, Request& request);
void add_honesty(CLI::App& app, Request& request);
void add_auto_honesty(CLI::App& app, Request& request);

}  // namespace shellback::program

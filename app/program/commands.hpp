#pragma once
/// The commands on a case: read, work, print, save. Each gives the exit code; all throw
/// InputError and FileError.
#include "app/program/request.hpp"
#include "bearing/case.hpp"
#include "bearing/over_time/warm_up.hpp"

namespace shellback::program {

[[nodiscard]] int chart(const Request& request);
[[nodiscard]] int check(const Request& request);
[[nodiscard]] int export_film(const Request& request);
[[nodiscard]] int help(const Request& request);
[[nodiscard]] int honesty(const Request& request);
[[nodiscard]] int identify(const Request& request);
[[nodiscard]] int report(const Request& request);
[[nodiscard]] int run(const Request& request);
[[nodiscard]] int compare(const Request& request);
[[nodiscard]] int auto_honesty(const Request& request);
[[nodiscard]] int stress(const Request& request);
/// Of run: a case with a load cycle, `text` of its file.
[[nodiscard]] int cycle(const Request& request, const std::string& text,
                        const bearing::Case& subject);
/// Of run --transient: speeds one after the other.
[[nodiscard]] int course(const Request& request, const bearing::WarmUpOptions& options);
[[nodiscard]] int study(const Request& request);
/// Of study: plan, run, submit, status and merge.
[[nodiscard]] int study_of_many(const Request& request);
[[nodiscard]] int surface(const Request& request);
[[nodiscard]] int sweep(const Request& request);
[[nodiscard]] int running_in(const Request& request);  ///< of run
[[nodiscard]] int transient(const Request& request);   ///< of run
[[nodiscard]] int validate(const Request& request);

}  // namespace shellback::program

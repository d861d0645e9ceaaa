// What a lab tells the drivers on the command line.

#pragma once

#include <CLI/CLI.hpp>

#include "app/study_files/program.h"
#include "device/drivers.h"

namespace asperity {

/// Adds --firmware, --library and --service. `options` has to outlive the command.
inline void add_driver_options(CLI::App& command, DriverOptions& options) {
  options.closing_program = program_file();
  command.add_option("--firmware", options.firmware, "File with the firmware of a Falcon");
  command.add_option("--library", options.library,
                     "File of the manufacturer's library, if the system does not find it "
                     "(force_dimension, openhaptics)");
  command.add_option("--service", options.service,
                     "HOST:PORT of Haply's Inverse Service, if not 127.0.0.1:10001 (inverse3)");
}

}  // namespace asperity

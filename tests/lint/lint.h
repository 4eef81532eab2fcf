// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kambara::lint {

struct Fault {
    std::string file;  ///< relative to the root
    int line = 0;      ///< 0: the whole file
    std::string what;
};

/// Reads every source under app, ui, core, hardware and tests of `root`, and reports: includes
/// against the table of directions or not named from the root, Qt or VTK in core or hardware, VTK
/// outside ui/scene3d, an operating-system header in core, files past 600 lines (400 in ui), a
/// missing licence line, headers without #pragma once, sources that end in neither .h nor .cpp.
std::vector<Fault> faults_of_sources(const std::filesystem::path& root);

/// Compiles every header of app, ui, core and hardware by itself with `compiler` (a command with
/// its flags) and reports those that fail. Folders in `without` are left out: what they need is
/// not installed.
std::vector<Fault> faults_of_headers(const std::filesystem::path& root, const std::string& compiler,
                                     const std::vector<std::string>& without = {});

std::string to_string(const Fault& fault);

}  // namespace kambara::lint

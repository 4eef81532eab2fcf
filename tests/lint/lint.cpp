// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lint/lint.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <future>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <thread>

namespace kambara::lint {
namespace {

namespace fs = std::filesystem;

constexpr int most_lines = 600;
constexpr int most_lines_in_ui = 400;

// Which rooms a room may include beside itself. This is the table that the rooms' READMEs tell.
const std::map<std::string, std::set<std::string>>& allowed_includes() {
    static const std::set<std::string> base{"core/base"};
    static const std::set<std::string> image{"core/image", "core/base"};
    static const std::set<std::string> camera{"core/camera", "core/geometry", "core/base"};
    static const std::set<std::string> devices{"core/devices", "core/image", "core/base",
                                               "core/recording"};
    static const auto with = [](std::set<std::string> rooms, const std::set<std::string>& more) {
        rooms.insert(more.begin(), more.end());
        return rooms;
    };
    static const std::map<std::string, std::set<std::string>> table{
        {"core/base", {}},
        {"core/image", base},
        {"core/geometry", base},
        {"core/camera", with(base, {"core/geometry"})},
        {"core/calibration", with(camera, image)},
        {"core/matching", image},
        {"core/stereo", camera},
        {"core/pointing", camera},
        {"core/devices", image},
        {"core/tracking", with(with(camera, image), {"core/matching", "core/stereo"})},
        {"core/recording", with(image, {"core/camera", "core/tracking"})},
        {"core/report", base},
        {"core/vsystem",
         {"core/base", "core/image", "core/geometry", "core/camera", "core/calibration",
          "core/matching", "core/tracking", "core/stereo", "core/pointing", "core/devices",
          "core/recording", "core/report"}},
        {"hardware/v4l2", devices},
        {"hardware/media", devices},
        {"hardware/visca", devices},
        {"hardware/gamepad", devices},
        {"hardware/simulated", with(with(devices, camera), {"core/calibration/target.h"})},
        {"ui",
         with(with(camera, image), {"core/vsystem/vsystem_interface.h", "core/vsystem/command.h",
                                    "core/vsystem/snapshot.h", "core/tracking/track_state.h",
                                    "core/stereo/position.h", "ui/calibration", "ui/experiments",
                                    "core/devices/gamepad.h", "core/pointing/stick_law.h"})},
        // The guided session's window: the session is core/calibration's.
        {"ui/calibration",
         with(with(camera, image), {"core/calibration", "core/vsystem/snapshot.h", "ui"})},
        // The experiments' forms: what they find is core/stereo's and core/pointing's.
        {"ui/experiments",
         with(with(camera, image),
              {"core/stereo", "core/pointing", "core/calibration", "core/vsystem/snapshot.h",
               "core/vsystem/command.h", "core/vsystem/head_view.h", "ui", "ui/calibration"})},
    };
    return table;
}

// core/base/result.h -> core/base; ui/video/view.h -> ui; app/cli/x.h -> app. Two folders of ui may
// include more than the others: ui/calibration/x.h -> ui/calibration.
std::string room_of(const std::string& path) {
    const auto first = path.find('/');
    const std::string top = path.substr(0, first);
    for (const char* room : {"ui/calibration", "ui/experiments"}) {
        if (path.starts_with(std::string(room) + "/")) {
            return room;
        }
    }
    if (top != "core" && top != "hardware") {
        return top;
    }
    const auto second = path.find('/', first + 1);
    return second == std::string::npos ? top : path.substr(0, second);
}

bool is_ours(const std::string& include) {
    const std::string top = include.substr(0, include.find('/'));
    return top == "core" || top == "hardware" || top == "ui" || top == "app" || top == "tests";
}

bool is_vtk(const std::string& include) {
    static const std::regex pattern(R"(^(.*/)?(vtk\w*|QVTK\w*)\.h$)");
    return std::regex_match(include, pattern);
}

bool is_qt(const std::string& include) {
    static const std::regex pattern(R"(^(.*/)?(Q[A-Za-z]\w*(\.h)?|q[a-z0-9_]+\.h)$)");
    return std::regex_match(include, pattern);
}

// C++'s own headers have no ending and those of libraries lie in folders: what is left are the
// system's, and C's, which C++ has under other names.
bool is_operating_system(const std::string& include) {
    static const std::regex folders(R"(^(sys|linux|net|netinet|arpa|asm|mach|bits)/.*)");
    static const std::set<std::string> libraries{"fftw3.h", "hpdf.h"};
    const bool bare =
        include.find('/') == std::string::npos && include.find('.') != std::string::npos;
    return std::regex_match(include, folders) || include == "csignal" ||
           (bare && !libraries.contains(include));
}

struct Include {
    std::string name;
    bool in_quotes;
};

// Of an include whose name a macro holds, the macro's name.
std::optional<Include> included(const std::string& line) {
    static const std::regex pattern(R"(^\s*#\s*include\s*(?:(["<])([^">]+)[">]|(\w+)).*)");
    std::smatch match;
    if (!std::regex_match(line, match, pattern)) {
        return std::nullopt;
    }
    return match[3].matched ? Include{match[3].str(), true}
                            : Include{match[2].str(), match[1].str() == "\""};
}

void check_foreign_include(const std::string& file, int line, const Include& include,
                           std::vector<Fault>& faults) {
    const std::string room = room_of(file);
    const bool core = room.starts_with("core/");
    const bool hardware = room.starts_with("hardware/");
    if (include.in_quotes) {
        faults.push_back({file, line, "named from the project's root, or in <>: " + include.name});
    } else if ((core || hardware) && (is_qt(include.name) || is_vtk(include.name))) {
        faults.push_back({file, line, "Qt and VTK stay out of core and hardware: " + include.name});
    } else if (core && is_operating_system(include.name)) {
        faults.push_back({file, line, "core calls no operating system: " + include.name});
    } else if (is_vtk(include.name) && room != "tests" && !file.starts_with("ui/scene3d/")) {
        faults.push_back({file, line, "VTK stays in ui/scene3d: " + include.name});
    }
}

void check_include(const std::string& file, int line, const Include& found,
                   std::vector<Fault>& faults) {
    const std::string& include = found.name;
    if (!is_ours(include)) {
        check_foreign_include(file, line, found, faults);
        return;
    }
    const std::string room = room_of(file);
    if (room == "app" || room == "tests") {
        return;
    }
    const std::string other = room_of(include);
    const auto entry = allowed_includes().find(room);
    if (entry == allowed_includes().end()) {
        faults.push_back({file, line, "the room " + room + " is not in the table of includes"});
    } else if (other != room && !entry->second.contains(other) &&
               !entry->second.contains(include)) {
        faults.push_back({file, line, room + " may not include " + include});
    }
}

void check_file(const fs::path& root, const fs::path& path, std::vector<Fault>& faults) {
    const std::string file = path.lexically_relative(root).generic_string();
    std::ifstream stream(path);
    std::string line;
    int number = 0;
    bool once = false;
    bool licensed = false;
    while (std::getline(stream, line)) {
        ++number;
        once = once || line == "#pragma once";
        licensed = licensed ||
                   (number <= 3 &&
                    line.find("SPDX-License-Identifier: GPL-3.0-or-later") != std::string::npos);
        if (const auto include = included(line)) {
            check_include(file, number, *include, faults);
        }
    }
    const int most = file.starts_with("ui/") ? most_lines_in_ui : most_lines;
    if (number > most) {
        faults.push_back(
            {file, 0,
             std::to_string(number) + " lines, more than " + std::to_string(most) + ": cut it"});
    }
    if (!licensed) {
        faults.push_back({file, 0, "the licence line is missing"});
    }
    if (path.extension() != ".cpp" && path.extension() != ".h") {
        faults.push_back({file, 0, "sources end in .h or .cpp"});
    }
    if (path.extension() == ".h" && !once) {
        faults.push_back({file, 0, "#pragma once is missing"});
    }
}

std::vector<fs::path> files_under(const fs::path& root, std::initializer_list<const char*> tops,
                                  const std::set<std::string>& endings) {
    std::vector<fs::path> files;
    for (const char* top : tops) {
        if (!fs::is_directory(root / top)) {
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            if (entry.is_regular_file() && endings.contains(entry.path().extension().string())) {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string quoted(const std::string& text) {
    return "'" + text + "'";
}

}  // namespace

std::string to_string(const Fault& fault) {
    return fault.file + (fault.line > 0 ? ":" + std::to_string(fault.line) : "") + ": " +
           fault.what;
}

std::vector<Fault> faults_of_sources(const fs::path& root) {
    std::vector<Fault> faults;
    for (const fs::path& path : files_under(
             root, {"app", "ui", "core", "hardware", "tests"},
             {".h", ".cpp", ".c", ".cc", ".cxx", ".hh", ".hpp", ".hxx", ".inl", ".inc", ".ipp"})) {
        check_file(root, path, faults);
    }
    return faults;
}

std::vector<Fault> faults_of_headers(const fs::path& root, const std::string& compiler,
                                     const std::vector<std::string>& without) {
    auto headers = files_under(root, {"app", "ui", "core", "hardware"}, {".h"});
    std::erase_if(headers, [&](const fs::path& header) {
        const std::string file = header.lexically_relative(root).generic_string();
        return std::any_of(without.begin(), without.end(), [&](const std::string& folder) {
            return file.starts_with(folder + "/");
        });
    });
    const unsigned workers = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::future<std::vector<Fault>>> parts;
    for (unsigned worker = 0; worker < workers; ++worker) {
        parts.push_back(std::async(std::launch::async, [&, worker] {
            std::vector<Fault> faults;
            for (std::size_t i = worker; i < headers.size(); i += workers) {
                // As an include of an empty file: a header as the main file has its own warnings.
                const std::string command = compiler + " -fsyntax-only -I" + quoted(root.string()) +
                                            " -include " + quoted(headers[i].string()) +
                                            " -x c++ /dev/null";
                if (std::system(command.c_str()) != 0) {
                    faults.push_back({headers[i].lexically_relative(root).generic_string(), 0,
                                      "does not compile by itself"});
                }
            }
            return faults;
        }));
    }
    std::vector<Fault> faults;
    for (auto& part : parts) {
        auto found = part.get();
        faults.insert(faults.end(), std::make_move_iterator(found.begin()),
                      std::make_move_iterator(found.end()));
    }
    return faults;
}

}  // namespace kambara::lint

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/simulate_command.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "app/cli/terminal.h"
#include "app/sources/sources.h"
#include "core/base/angles.h"
#include "core/base/text_file.h"
#include "core/camera/rig_file.h"
#include "hardware/media/picture_file.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

// A folder that takes its final name only when all is in it; else it goes away.
class FolderInTheMaking {
  public:
    static Result<std::unique_ptr<FolderInTheMaking>> make(const fs::path& wanted) {
        std::error_code code;
        if (fs::exists(wanted, code) &&
            !(fs::is_directory(wanted, code) && fs::is_empty(wanted, code))) {
            return Error{wanted.string() + " is there already and not empty.",
                         "Name a new folder, or remove that one."};
        }
        fs::path temporary = wanted.lexically_normal();
        if (!temporary.has_filename()) {
            temporary = temporary.parent_path();
        }
        temporary += ".part";
        fs::remove_all(temporary, code);
        for (const char* inner : {"left", "right", "pan_tilt"}) {
            if (!fs::create_directories(temporary / inner, code)) {
                return Error{
                    "The folder " + wanted.string() + " can't be made (" + code.message() + ").",
                    "Check that the folder above may be written to."};
            }
        }
        return std::unique_ptr<FolderInTheMaking>(new FolderInTheMaking(temporary, wanted));
    }
    ~FolderInTheMaking() {
        std::error_code code;
        fs::remove_all(temporary_, code);
    }
    const fs::path& path() const { return temporary_; }
    Result<Done> finish() {
        std::error_code code;
        fs::remove(wanted_, code);  // empty, as was made sure of
        fs::rename(temporary_, wanted_, code);
        if (code) {
            return Error{
                "The folder " + wanted_.string() + " can't take its name (" + code.message() + ").",
                "Check that nothing else writes there."};
        }
        return Done{};
    }

  private:
    FolderInTheMaking(fs::path temporary, fs::path wanted)
        : temporary_(std::move(temporary)), wanted_(std::move(wanted)) {}
    fs::path temporary_;
    fs::path wanted_;
};

std::string truth_header() {
    return "frame,time_s,x_mm,y_mm,z_mm,left_x_px,left_y_px,right_x_px,right_y_px,pan_deg,"
           "tilt_deg\n";
}

// The truth of a frame: the target's reference point (its centre), its pixels, the head.
std::string truth_row(const SimulatedWorld& world, const Snapshot& snapshot) {
    const Eigen::Vector3d in_left = world.T_left_from_target(snapshot.frame).t_mm;
    const Eigen::Vector3d in_rig = world.rig().left.T_camera_from_rig.inverse() * in_left;
    const auto left = world.rig().left.project(in_rig);
    const auto right = world.rig().right->project(in_rig);
    char row[320];
    std::snprintf(
        row, sizeof row, "%lld,%.6f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n",
        static_cast<long long>(snapshot.frame), static_cast<double>(snapshot.time_ns) * 1e-9,
        in_left.x(), in_left.y(), in_left.z(), left ? left->x() : NAN, left ? left->y() : NAN,
        right ? right->x() : NAN, right ? right->y() : NAN,
        deg_from_rad(snapshot.head->angles.pan_rad), deg_from_rad(snapshot.head->angles.tilt_rad));
    return row;
}

Result<Done> write_pictures(const fs::path& folder, const Snapshot& snapshot) {
    char name[32];
    std::snprintf(name, sizeof name, "%06lld.png", static_cast<long long>(snapshot.frame));
    const std::pair<const char*, const Frame&> pictures[] = {
        {"left", snapshot.pictures.stereo.left},
        {"right", snapshot.pictures.stereo.right},
        {"pan_tilt", snapshot.pictures.pan_tilt}};
    for (const auto& [which, frame] : pictures) {
        if (auto written = write_picture(folder / which / name, *frame.picture); !written) {
            return written;
        }
    }
    return Done{};
}

Result<nlohmann::json> simulate(const SimulateOptions& options) {
    SteadyClock clock;
    SourceOptions source;
    source.left = "sim:" + options.profile;
    source.pan_tilt_pictures = true;
    auto sources = open_sources(source, clock);
    if (!sources) {
        return sources.error();
    }
    const auto world = sources->world;
    const auto frames = static_cast<std::int64_t>(
        std::llround(std::max(1.0, options.seconds * world->profile().rate_hz)));
    auto folder = FolderInTheMaking::make(options.out);
    if (!folder) {
        return folder.error();
    }
    const auto method = position_method_from(options.position_method);
    if (!method) {
        return method.error();
    }
    VisionSystemOptions system_options;
    system_options.tracker.position.method = *method;
    system_options.every_frame = true;
    system_options.start_paused = true;
    auto opened = open_vision_system(std::move(sources->parts), system_options, clock);
    if (!opened) {
        return opened.error();
    }
    VsystemInterface& system = **opened;
    const bool moving = !world->profile().calibration_target;
    const Rectangle rectangle = world->suggested_template(31);
    // The head follows the target, as it would at sea, unless the water hides it.
    const bool followed = moving && system.execute(SelectTemplate{rectangle, std::nullopt}).ok() &&
                          system.execute(StartTracking{}).ok();
    if (options.servo) {
        if (const auto done = system.execute(ServoHead{}); !done) {
            return done.error();
        }
    }
    std::string truth = truth_header();
    ProgressLine progress;
    for (std::int64_t i = 0; i < frames && !interrupted(); ++i) {
        const SnapshotPtr snapshot = system.latest();
        if (const auto written = write_pictures((*folder)->path(), *snapshot); !written) {
            return written.error();
        }
        truth += truth_row(*world, *snapshot);
        progress.show(static_cast<double>(i + 1) / static_cast<double>(frames),
                      "frame " + std::to_string(i + 1) + " of " + std::to_string(frames));
        const auto before = snapshot->frame;
        if (const auto done = system.execute(Flow{Flow::Kind::step}); !done) {
            break;  // the profile's own end
        }
        while (system.latest()->frame == before && system.latest()->run == RunState::paused) {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        if (system.latest()->frame == before) {
            break;
        }
    }
    const fs::path& path = (*folder)->path();
    const std::pair<const char*, std::string> texts[] = {
        {"truth.csv", truth},
        {"rig.yaml", rig_to_text(world->rig())},
        {"template.txt", to_string(rectangle) + "\n"}};
    for (const auto& [name, text] : texts) {
        if (std::string(name) == "template.txt" && !moving) {
            continue;
        }
        if (const auto written = write_text_file_atomically(path / name, text); !written) {
            return written.error();
        }
    }
    if (const auto finished = (*folder)->finish(); !finished) {
        return finished.error();
    }
    return nlohmann::json{{"frames", system.latest()->frame},
                          {"rate_hz", world->profile().rate_hz},
                          {"head_follows", followed},
                          {"out", options.out.string()}};
}

}  // namespace

Outcome run_simulate(const SimulateOptions& options) {
    const auto report = simulate(options);
    if (!report) {
        Outcome outcome{report.error()};
        outcome.json = nlohmann::json{{"error", report.error().text()}}.dump(2);
        return outcome;
    }
    return {std::nullopt, report->dump(2), "Recorded in " + options.out.string() + "\n"};
}

}  // namespace kambara::cli

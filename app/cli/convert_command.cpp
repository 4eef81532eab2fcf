// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/convert_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/now.h"
#include "core/base/text_file.h"
#include "core/camera/foreign_formats.h"
#include "core/camera/rig_file.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t largest_file = std::size_t{1} << 20;

Result<PictureSize> parse_size(const std::string& text) {
    PictureSize size;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d,%d%c", &size.width_px, &size.height_px, &rest) != 2 ||
        size.width_px < 16 || size.height_px < 16 || size.width_px > 20000 ||
        size.height_px > 20000) {
        return Error{"The size \"" + text + "\" is not understood.",
                     "Give it as W,H in pixels, for example 640,480."};
    }
    return size;
}

// KITTI keeps its pictures beside the calibration.
std::optional<PictureSize> size_beside(const fs::path& calibration) {
    for (const char* folder : {"left", "image_0", "image_2"}) {
        const auto files = files_of_pattern(calibration.parent_path() / folder / "*.png");
        if (!files) {
            continue;
        }
        if (const auto picture = read_picture(files->front())) {
            return PictureSize{picture->width(), picture->height()};
        }
    }
    return std::nullopt;
}

std::optional<Error> misused(const ConvertOptions& options) {
    const std::size_t wanted = options.from == "opencv" || options.from == "ros" ? 2 : 1;
    const bool known = wanted == 2 || options.from == "kalibr" || options.from == "kitti";
    if (!known) {
        return Error{"There is no format \"" + options.from + "\" to convert from.",
                     "Choose opencv, ros, kalibr or kitti."};
    }
    if (options.files.size() != wanted) {
        return Error{"Converting from " + options.from + " takes " + std::to_string(wanted) +
                         " file(s), and " + std::to_string(options.files.size()) + " were given.",
                     "opencv: intrinsics.yml extrinsics.yml; ros: left.yaml right.yaml; kalibr: "
                     "camchain.yaml; kitti: calib.txt."};
    }
    if (!options.out) {
        return Error{"Nothing says where to write the rig file.", "Name it with --out."};
    }
    return std::nullopt;
}

Result<Rig> imported(const ConvertOptions& options) {
    std::optional<PictureSize> size;
    if (options.size) {
        const auto parsed = parse_size(*options.size);
        if (!parsed) {
            return parsed.error();
        }
        size = *parsed;
    }
    std::vector<std::string> texts;
    for (const fs::path& file : options.files) {
        auto text = read_text_file(file, largest_file);
        if (!text) {
            return text.error();
        }
        texts.push_back(std::move(*text));
    }
    if (options.from == "opencv") {
        return rig_from_opencv(texts[0], texts[1], size);
    }
    if (options.from == "ros") {
        return rig_from_ros(texts[0], texts[1]);
    }
    if (options.from == "kalibr") {
        return rig_from_kalibr(texts[0]);
    }
    return rig_from_kitti(texts[0], size ? size : size_beside(options.files[0]));
}

Outcome failed(const Error& error) {
    return {error, Json{{"error", error.text()}}.dump(2), ""};
}

Outcome wrong_usage(const Error& error) {
    Outcome outcome = failed(error);
    outcome.wrong_usage = true;
    return outcome;
}

Outcome import_rig(const ConvertOptions& options) {
    if (const auto fault = misused(options)) {
        return wrong_usage(*fault);
    }
    auto rig = imported(options);
    if (!rig) {
        return failed(rig.error());
    }
    rig->provenance.created = now_iso8601();
    rig->provenance.program = program_name;
    if (const auto written = write_rig_file(*options.out, *rig); !written) {
        return failed(written.error());
    }
    char line[200];
    std::snprintf(line, sizeof line, "%d x %d px, baseline %.3f mm.\n", rig->left.width_px,
                  rig->left.height_px, baseline_mm(*rig));
    return {std::nullopt,
            Json{{"width_px", rig->left.width_px},
                 {"height_px", rig->left.height_px},
                 {"baseline_mm", baseline_mm(*rig)},
                 {"out", options.out->string()}}
                .dump(2),
            line + ("Rig file: " + options.out->string() + "\n")};
}

Outcome export_rig(const ConvertOptions& options) {
    if (options.files.size() != 2) {
        return wrong_usage({"Converting to " + options.to + " takes a rig file and a folder.",
                            "For example: convert rig.yaml --to " + options.to + " folder."});
    }
    const auto rig = read_rig_file(options.files[0]);
    if (!rig) {
        return failed(rig.error());
    }
    struct Names {
        const char* format;
        Result<ExportedPair> (*write)(const Rig&);
        const char* first;
        const char* second;
    };
    constexpr Names formats[] = {
        {"opencv", rig_to_opencv, "intrinsics.yml", "extrinsics.yml"},
        {"ros", rig_to_ros, "left.yaml", "right.yaml"},
        {"kalibr", rig_to_kalibr, "camchain.yaml", nullptr},
    };
    for (const Names& format : formats) {
        if (options.to != format.format) {
            continue;
        }
        const auto files = format.write(*rig);
        if (!files) {
            return failed(files.error());
        }
        const fs::path folder = options.files[1];
        std::error_code code;
        fs::create_directories(folder, code);
        if (!fs::is_directory(folder, code)) {
            return failed({"The folder " + folder.string() + " can't be made.",
                           "Check that the folder above may be written to."});
        }
        auto written = write_text_file_atomically(folder / format.first, files->first);
        if (written && format.second != nullptr) {
            written = write_text_file_atomically(folder / format.second, files->second);
        }
        if (!written) {
            return failed(written.error());
        }
        char line[200];
        std::snprintf(line, sizeof line,
                      "Written for %s in %s; largest difference between the lens models %.5f px.\n",
                      format.format, folder.c_str(), files->worst_residual_px);
        Json left_out = Json::array();
        std::string summary = line;
        if (rig->pan_tilt) {
            left_out.push_back("pan_tilt");
            summary += "The pan-tilt camera is left out: only the pair goes over.\n";
        }
        if (rig->medium == Medium::water) {
            left_out.push_back("medium");
            summary += "The format can't say that the rig holds in water: keep it in mind.\n";
        }
        return {std::nullopt,
                Json{{"worst_residual_px", files->worst_residual_px},
                     {"left_out", left_out},
                     {"out", folder.string()}}
                    .dump(2),
                summary};
    }
    return wrong_usage({"There is no format \"" + options.to + "\" to convert to.",
                        "Choose opencv, ros or kalibr."});
}

}  // namespace

Outcome run_convert(const ConvertOptions& options) {
    if (options.from.empty() == options.to.empty()) {
        return failed({"Nothing says which way to convert.", "Give either --from or --to."});
    }
    return options.to.empty() ? import_rig(options) : export_rig(options);
}

}  // namespace kambara::cli

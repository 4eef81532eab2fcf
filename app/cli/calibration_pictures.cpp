// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibration_pictures.h"

#include <atomic>
#include <cstdio>
#include <optional>
#include <utility>

#include "core/base/worker_pool.h"
#include "core/calibration/target_detector.h"
#include "hardware/media/picture_file.h"
#include "hardware/media/picture_pairs.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

// FNV-1a over the pixels: whether it is the same picture, not whether somebody forged it.
std::string hash_of(const Image& picture) {
    std::uint64_t hash = 14695981039346656037U;
    for (int y = 0; y < picture.height(); ++y) {
        const std::uint8_t* row = picture.row(y);
        for (std::size_t i = 0; i < picture.row_bytes(); ++i) {
            hash = (hash ^ row[i]) * 1099511628211U;
        }
    }
    char text[24];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

// One picture of one camera, and what came of it.
struct Piece {
    std::size_t camera = 0;
    std::size_t view = 0;
    std::optional<Error> unreadable;
    PictureSize size;
    CameraSight sight;
    std::string mark;
};

void look(const fs::path& file, const Target& target, Piece& piece) {
    const auto picture = read_picture(file);
    if (!picture) {
        piece.unreadable = picture.error();
        return;
    }
    piece.size = {picture->width(), picture->height()};
    piece.mark = picture_mark(file, *picture);
    auto found = detect_target(grey_from(*picture), target);
    if (found) {
        piece.sight.corners = std::move(*found);
    } else {
        piece.sight.fault = found.error().cause;
    }
}

}  // namespace

std::string picture_mark(const fs::path& file, const Image& picture) {
    return file.filename().string() + " " + hash_of(picture);
}

Result<CalibrationFiles> calibration_files(const std::array<std::string, most_cameras>& patterns) {
    CalibrationFiles files;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (patterns[c].empty()) {
            continue;
        }
        auto found = files_of_pattern(patterns[c]);
        if (!found) {
            return found.error();
        }
        files.of_camera[c] = std::move(*found);
        if (files.of_camera[c].size() != files.views()) {
            return Error{"There are " + std::to_string(files.views()) + " left and " +
                             std::to_string(files.of_camera[c].size()) + " " + camera_names[c] +
                             " pictures.",
                         "Give pairs: the same number on both sides, in the same order."};
        }
        if (const auto pairs = check_pairs(files.of_camera[0], files.of_camera[c]); !pairs) {
            return pairs.error();
        }
    }
    return files;
}

Result<CalibrationViews> look_at_all(const CalibrationFiles& files, const Target& target,
                                     ProgressLine& progress) {
    std::vector<Piece> pieces;
    for (std::size_t view = 0; view < files.views(); ++view) {
        for (std::size_t c = 0; c < most_cameras; ++c) {
            if (!files.of_camera[c].empty()) {
                pieces.push_back({c, view, {}, {}, {}, {}});
            }
        }
    }
    WorkerPool pool;
    const std::size_t at_once = 8;
    for (std::size_t from = 0; from < pieces.size(); from += at_once) {
        progress.show(static_cast<double>(from) / static_cast<double>(pieces.size()),
                      "looking for the target");
        pool.for_each(std::min(at_once, pieces.size() - from), [&](std::size_t i) {
            Piece& piece = pieces[from + i];
            look(files.of_camera[piece.camera][piece.view], target, piece);
        });
    }
    CalibrationViews result;
    result.views.resize(files.views());
    for (Piece& piece : pieces) {
        if (piece.unreadable) {
            return *piece.unreadable;
        }
        auto& size = result.sizes[piece.camera];
        if (size && *size != piece.size) {
            return Error{files.of_camera[piece.camera][piece.view].string() + " has " +
                             std::to_string(piece.size.width_px) + " x " +
                             std::to_string(piece.size.height_px) +
                             " pixels, the pictures before it " + std::to_string(size->width_px) +
                             " x " + std::to_string(size->height_px) + ".",
                         "Calibrate a camera from pictures of one size."};
        }
        size = piece.size;
        result.views[piece.view].sights[piece.camera] = std::move(piece.sight);
        result.marks.push_back(std::move(piece.mark));
    }
    return result;
}

}  // namespace kambara::cli

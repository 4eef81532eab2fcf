// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace kambara {

/// Reads a picture of any common format as 8-bit grey or BGR (16-bit pictures lose their low
/// byte, an alpha channel is dropped). Refuses what is missing, truncated or not a picture.
Result<Image> read_picture(const std::filesystem::path& path);

/// Writes a picture in the format of the name's ending (png, ppm, pgm, tiff, jpg, ...); the file
/// appears whole or not at all.
Result<Done> write_picture(const std::filesystem::path& path, const Image& picture);

/// Whether write_float_tiff takes the name: it ends in .tiff or .tif.
Result<Done> check_float_tiff_name(const std::filesystem::path& path);

/// Writes 32-bit floating-point values, row by row, as a one-channel TIFF.
Result<Done> write_float_tiff(const std::filesystem::path& path, const std::vector<float>& values,
                              int width, int height);

/// The files that a pattern names, in order: `*` and `?` in the last part of the path (sorted by
/// name, digits by value), a printf form such as `left/%06d.png` (from the first number at which a
/// file exists), or one file. Refuses a pattern that names nothing, and numbers with a gap.
Result<std::vector<std::filesystem::path>> files_of_pattern(const std::filesystem::path& pattern);

}  // namespace kambara

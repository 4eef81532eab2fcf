// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/picture_file.h"

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <vector>

#include "core/base/text_file.h"
#include "core/image/opencv_view.h"
#include "hardware/media/picture_completeness.h"

namespace kambara {
namespace {

Result<Done> write_encoded(const std::filesystem::path& path, const cv::Mat& pixels) {
    std::vector<unsigned char> bytes;
    bool encoded = false;
    try {
        encoded = cv::imencode(path.extension().string(), pixels, bytes);
    } catch (const cv::Exception&) {
        // An ending that no encoder knows is reported below, like any other failure to encode.
    }
    if (!encoded) {
        return Error{"No picture format goes with the name " + path.string() + ".",
                     "Let it end in .png, .tiff, .ppm, .pgm or .jpg."};
    }
    return write_text_file_atomically(
        path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace

Result<Image> read_picture(const std::filesystem::path& path) {
    const auto bytes = read_text_file(path, std::size_t{512} << 20);
    if (!bytes) {
        return bytes.error();
    }
    const Error undecodable{path.string() +
                                " can't be read as a picture: it is damaged, cut short "
                                "or of another kind.",
                            "Check the file, or leave it out."};
    if (bytes->empty() || is_cut_short(*bytes)) {
        return undecodable;
    }
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    cv::Mat pixels;
    try {
        const cv::Mat raw(1, static_cast<int>(bytes->size()), CV_8UC1,
                          const_cast<char*>(bytes->data()));
        pixels = cv::imdecode(raw, cv::IMREAD_ANYCOLOR);
    } catch (const cv::Exception&) {
        return undecodable;
    }
    if (pixels.empty() || (pixels.type() != CV_8UC1 && pixels.type() != CV_8UC3)) {
        return undecodable;
    }
    return image_from_opencv(pixels);
}

Result<Done> write_picture(const std::filesystem::path& path, const Image& picture) {
    return write_encoded(path, opencv_view(picture));
}

Result<Done> check_float_tiff_name(const std::filesystem::path& path) {
    const auto ending = path.extension();
    if (ending != ".tiff" && ending != ".tif") {
        return Error{
            "A map of scores is written as TIFF, and " + path.string() + " does not end so.",
            "Let the name end in .tiff."};
    }
    return Done{};
}

Result<Done> write_float_tiff(const std::filesystem::path& path, const std::vector<float>& values,
                              int width, int height) {
    if (auto named = check_float_tiff_name(path); !named) {
        return named;
    }
    return write_encoded(path, cv::Mat(height, width, CV_32FC1, const_cast<float*>(values.data())));
}

}  // namespace kambara

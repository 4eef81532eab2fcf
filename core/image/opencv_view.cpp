// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/opencv_view.h"

#include <algorithm>
#include <stdexcept>

namespace kambara {

cv::Mat opencv_view(const Image& picture) {
    if (picture.empty()) {
        return {};
    }
    return cv::Mat(picture.height(), picture.width(), picture.channels() == 1 ? CV_8UC1 : CV_8UC3,
                   const_cast<std::uint8_t*>(picture.row(0)), picture.row_bytes());
}

Image image_from_opencv(const cv::Mat& matrix) {
    if (matrix.type() != CV_8UC1 && matrix.type() != CV_8UC3) {
        throw std::invalid_argument("kambara::image_from_opencv: not an 8-bit grey or BGR matrix");
    }
    Image picture(matrix.cols, matrix.rows, matrix.channels());
    for (int y = 0; y < matrix.rows; ++y) {
        const std::uint8_t* in = matrix.ptr<std::uint8_t>(y);
        std::copy(in, in + picture.row_bytes(), picture.row(y));
    }
    return picture;
}

}  // namespace kambara

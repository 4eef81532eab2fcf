// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/image/image.h"

namespace kambara {

/// The picture as OpenCV sees it, without a copy. Valid while `picture` lives; OpenCV has no
/// read-only matrix, so the caller keeps from writing. Include this from .cpp files only.
cv::Mat opencv_view(const Image& picture);

/// A copy of an 8-bit OpenCV matrix of 1 or 3 channels; other kinds throw std::invalid_argument.
Image image_from_opencv(const cv::Mat& matrix);

}  // namespace kambara

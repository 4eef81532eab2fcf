// SPDX-License-Identifier: GPL-3.0-or-later
// For tests under ThreadSanitizer: OpenCV's pool of threads is not instrumented, so that all it
// shares with its callers would look like a race.
#include <opencv2/core/utility.hpp>

namespace {

const bool alone = [] {
    cv::setNumThreads(1);
    return true;
}();

}  // namespace

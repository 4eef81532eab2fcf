// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/picture_image.h"

namespace kambara::ui {

QImage image_sharing(const ImagePtr& picture) {
    if (!picture || picture->empty()) {
        return {};
    }
    const auto format =
        picture->channels() == 3 ? QImage::Format_BGR888 : QImage::Format_Grayscale8;
    const auto let_go = [](void* holder) { delete static_cast<ImagePtr*>(holder); };
    return QImage(picture->row(0), picture->width(), picture->height(),
                  static_cast<int>(picture->row_bytes()), format, let_go, new ImagePtr(picture));
}

}  // namespace kambara::ui

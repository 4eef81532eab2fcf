// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "core/image/image.h"

namespace kambara::ui {

/// The picture as Qt draws it, without a copy: the image shares the picture's memory and keeps it
/// alive for as long as any copy of the image lives. Never written to. Null for a null picture.
QImage image_sharing(const ImagePtr& picture);

}  // namespace kambara::ui

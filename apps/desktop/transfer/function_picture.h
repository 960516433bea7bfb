// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/colours/transfer_function.h"

#include <QImage>

#include <string>

namespace vs::desktop {

// A small picture of a transfer function in its own positions: over one quantity the hills of its opacity in
// its colours above a strip of them, over two its shapes.
QImage functionPicture(const render::TransferFunction& function, QSize pixels, const QColor& ground);

// A named colour map from left to right.
QImage colourMapPicture(const std::string& map, QSize pixels);

} // namespace vs::desktop

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"

#include <vector>

namespace vs::desktop {

class SlicePen;
class StudioController;

// Makes all tools and has them: the studio owns it, and knows the one in hand as a Tool and no more. At first
// the camera is in hand.
class ToolBox : public QObject {
    Q_OBJECT

public:
    explicit ToolBox(StudioController& studio);

    // The tool of a class.
    template <class T>
    [[nodiscard]] T& get() const {
        for (Tool* tool : tools_) {
            if (auto* found = qobject_cast<T*>(tool)) {
                return *found;
            }
        }
        qFatal("there is no such tool in the box");
    }
    // What seed, paint and measure tool do with a pen on a slice.
    [[nodiscard]] SlicePen& slicePen() const { return *slicePen_; }

private:
    std::vector<Tool*> tools_;
    SlicePen* slicePen_;
};

} // namespace vs::desktop

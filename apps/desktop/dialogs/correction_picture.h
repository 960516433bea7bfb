// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/slices/slice_view.h"
#include "volume/grid/volume.h"

#include <QWidget>

namespace vs::desktop {

// The middle slice of one kind through a volume as it would be seen if its voxels lay elsewhere, with the
// patient's directions at its edges. Drawn without the device: the document stays as it is.
class CorrectionPicture : public QWidget {
    Q_OBJECT

public:
    // The volume must outlive it; `window` is what is shown from black to white.
    CorrectionPicture(const volume::Volume& volume, const Range& window, render::SliceKind kind);

    void show(const volume::GridGeometry& grid);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const volume::Volume& volume_;
    Range window_;
    render::SliceKind kind_;
    volume::GridGeometry grid_;
};

} // namespace vs::desktop

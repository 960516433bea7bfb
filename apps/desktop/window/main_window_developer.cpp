// SPDX-License-Identifier: Apache-2.0
// What only builds for developers have (VOLUME_STUDIO_DEVELOPER).
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include "gl/shader_reload.h"

namespace vs::desktop {

void MainWindow::makeDeveloperActions() {
#ifdef VOLUME_STUDIO_DEVELOPER
    actions_->add({"reloadShaders", nullptr, tr("Reload shaders"),
                   tr("Read the shaders in VOLUME_STUDIO_SHADER_DIR again"), tr("Ctrl+F5"),
                   [this] { reloadShaders(); }});
    connect(&studio_, &StudioController::pictureChanged, this, &MainWindow::tellShaderFault);
    connect(&studio_.slices(), &SliceController::pictureChanged, this, &MainWindow::tellShaderFault);
#endif
}

void MainWindow::reloadShaders() {
    const QString folder = qEnvironmentVariable("VOLUME_STUDIO_SHADER_DIR");
    if (folder.isEmpty()) {
        studio_.host().say(
            tr("VOLUME_STUDIO_SHADER_DIR is not set: start with the folder src of the sources in it"));
        return;
    }
    gl::reloadShaders();
    studio_.host().say(tr("Shaders are those in %1").arg(folder));
    studio_.picture().drawAnew();
    studio_.slices().drawAnew();
    studio_.host().wake();
}

// Programs compile when they are used next, so what is wrong with a shader is known after a picture. The log
// has all of it.
void MainWindow::tellShaderFault() {
    if (const auto fault = gl::takeShaderFault()) {
        studio_.host().say(QString::fromStdString(*fault).section('\n', 0, 0));
    }
}

} // namespace vs::desktop

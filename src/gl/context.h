// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vs::gl {

struct DeviceInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool isSoftware = false; // rendering happens on the CPU (llvmpipe, softpipe)
    int max3DTextureSize = 0;
    std::size_t maxStorageBlockBytes = 0;
};

// An OpenGL 4.5 core context: either our own, without any window (EGL, surfaceless), or one that the host
// program made current. GL objects belong to the thread and context they were made with. Driver messages of
// type error are counted and the first ones logged, never thrown out of the driver.
class Context {
public:
    // Our own context on a device of `listDevices()` (by its index), or on the best one: a hardware device
    // where there is one, else the software renderer. $VOLUME_STUDIO_DEVICE (an index) chooses when `device`
    // is not given. Throws GlError if no device offers OpenGL 4.5.
    static Context createHeadless(std::optional<int> device = {});
    // Uses the context that is current on this thread (the window's). Throws GlError if it is older than 4.5.
    static Context adoptCurrent();

    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    // Makes this the context of the calling thread. One that was adopted is made current by its host first.
    void makeCurrent();
    [[nodiscard]] const DeviceInfo& device() const;
    // The number of GL errors that the driver has reported, or kept for whoever asks, since the context was
    // made.
    [[nodiscard]] int errorCount() const;
    // From now on finds barriers that are missing between what shaders write and what comes after
    // (gl/hazards.h): each hazard is logged, and counts as an error. With VOLUME_STUDIO_HAZARDS=1 every
    // context does so from its beginning.
    void watchHazards();
    // Gives away the texts of the hazards found so far, which count no more.
    [[nodiscard]] std::vector<std::string> takeHazards();
    // Throws GlError if there were GL errors or hazards: what was computed cannot be relied on.
    void requireNoErrors() const;
    // Throws ContextLost if the driver was reset since the current context was made, now and whenever it is
    // asked: what was computed, and what is on the device, cannot be relied on.
    static void requireDevice();
    // Whether the current context renders on the CPU.
    static bool isSoftware();
    // Waits until the device has done everything submitted so far.
    static void finish();

private:
    struct Impl;
    explicit Context(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

struct ListedDevice {
    int index = 0;
    std::optional<DeviceInfo> info; // nothing if the device offers no OpenGL 4.5
};

// Every device that EGL knows here, each tried with a context of its own.
std::vector<ListedDevice> listDevices();

} // namespace vs::gl

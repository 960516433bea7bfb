// SPDX-License-Identifier: Apache-2.0
#include "gl/context.h"

#include "base/error.h"
#include "base/log.h"
#include "gl/errors.h"
#include "gl/hazard_watch.h"
#include "gl/limits.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <charconv>
#include <cstdlib>
#include <cstring>

namespace vs::gl {

struct Context::Impl {
    EGLDisplay display = EGL_NO_DISPLAY; // none for an adopted context
    EGLContext context = EGL_NO_CONTEXT;
    DeviceInfo device;
    ContextRecord record;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (currentRecord() == &record) {
            setCurrentRecord(nullptr);
        }
        if (context != EGL_NO_CONTEXT) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display, context);
        }
    }
};

namespace {

std::string text(GLenum what) {
    const auto* s = reinterpret_cast<const char*>(glGetString(what));
    return s != nullptr ? s : "";
}

DeviceInfo describeCurrent() {
    DeviceInfo info{text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION), false, 0, 0};
    info.isSoftware = info.renderer.find("llvmpipe") != std::string::npos ||
                      info.renderer.find("softpipe") != std::string::npos;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &info.max3DTextureSize);
    GLint block = 0;
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    info.maxStorageBlockBytes = std::size_t(block);
    return info;
}

void GLAPIENTRY onMessage(GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                          const void* user) {
    if (type == GL_DEBUG_TYPE_ERROR && source == GL_DEBUG_SOURCE_SHADER_COMPILER) {
        return; // Program throws what the shader compiler says, with the file's name
    }
    if (type == GL_DEBUG_TYPE_ERROR) {
        addErrorMessage(*static_cast<ContextRecord*>(const_cast<void*>(user)), message);
    } else if (type != GL_DEBUG_TYPE_PUSH_GROUP && type != GL_DEBUG_TYPE_POP_GROUP) {
        tell(type == GL_DEBUG_TYPE_PERFORMANCE ? LogLevel::Performance : LogLevel::Debug,
             fmt::format("OpenGL: {}", message));
    }
}

void watchIn(ContextRecord& record) {
    if (!record.hazards) {
        record.hazards = std::make_unique<HazardChecker>(makeHazardChecker());
    }
}

void listenForErrors(ContextRecord& record) {
    setCurrentRecord(&record);
    if (const char* asked = std::getenv("VOLUME_STUDIO_HAZARDS"); asked != nullptr && *asked == '1') {
        watchIn(record);
    }
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, &record);
    // What nobody is told need not be made.
    const auto listen = [](GLenum type, LogLevel level) {
        glDebugMessageControl(GL_DONT_CARE, type, GL_DONT_CARE, 0, nullptr,
                              isLogged(level) ? GL_TRUE : GL_FALSE);
    };
    listen(GL_DEBUG_TYPE_PERFORMANCE, LogLevel::Performance);
    listen(GL_DEBUG_TYPE_OTHER, LogLevel::Debug);
}

// The displays that could carry a context without a window: each EGL device, then Mesa's surfaceless
// platform.
std::vector<EGLDisplay> candidateDisplays() {
    std::vector<EGLDisplay> displays;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base")) {
        EGLint count = 0;
        eglQueryDevicesEXT(0, nullptr, &count);
        std::vector<EGLDeviceEXT> devices(std::size_t(count > 0 ? count : 0));
        if (count > 0 && eglQueryDevicesEXT(count, devices.data(), &count) == EGL_TRUE) {
            for (EGLDeviceEXT device : devices) {
                displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
            }
        }
    }
    if (displays.empty() && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    return displays;
}

// A 4.5 core context, with further attributes, or EGL_NO_CONTEXT.
EGLContext makeContext(EGLDisplay display, EGLConfig config, std::initializer_list<EGLint> further) {
    std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       4,
                                   EGL_CONTEXT_MINOR_VERSION,       5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    attributes.insert(attributes.end(), further);
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

// A current 4.5 core context on this display, or EGL_NO_CONTEXT.
EGLContext contextOn(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        return EGL_NO_CONTEXT;
    }
    EGLConfig config = nullptr; // EGL_KHR_no_config_context
    if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) {
        // Of any surfaces or none: a display without windows has no configuration for them.
        const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLint found = 0;
        if (eglChooseConfig(display, wanted, &config, 1, &found) != EGL_TRUE || found == 0) {
            return EGL_NO_CONTEXT;
        }
    }
    EGLContext context = EGL_NO_CONTEXT;
    if (epoxy_has_egl_extension(display, "EGL_EXT_create_context_robustness")) {
        context =
            makeContext(display, config,
                        {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT, EGL_LOSE_CONTEXT_ON_RESET_EXT});
    }
    if (context == EGL_NO_CONTEXT) { // some that have the extension have it for other drivers only
        context = makeContext(display, config, {});
    }
    if (context != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
        eglDestroyContext(display, context);
        context = EGL_NO_CONTEXT;
    }
    return context;
}

std::optional<int> deviceFromEnvironment() {
    const char* value = std::getenv("VOLUME_STUDIO_DEVICE");
    if (value == nullptr || *value == '\0') {
        return std::nullopt;
    }
    int device = 0;
    const char* end = value + std::strlen(value);
    const auto result = std::from_chars(value, end, device);
    if (result.ec != std::errc() || result.ptr != end) {
        throw GlError("VOLUME_STUDIO_DEVICE={}: not the number of a device; give one that `vstudio devices` "
                      "lists, for example 0",
                      value);
    }
    return device;
}

} // namespace

Context::Context(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

Context Context::createHeadless(std::optional<int> device) {
    if (!device) {
        device = deviceFromEnvironment();
    }
    const auto displays = candidateDisplays();
    std::unique_ptr<Impl> software; // kept in case no hardware device follows
    for (std::size_t i = 0; i < displays.size(); ++i) {
        if (device && *device != int(i)) {
            continue;
        }
        const EGLContext context = contextOn(displays[i]);
        if (context == EGL_NO_CONTEXT) {
            continue;
        }
        auto impl = std::make_unique<Impl>();
        impl->display = displays[i];
        impl->context = context;
        impl->device = describeCurrent();
        if (impl->device.isSoftware && !device && !software) {
            software = std::move(impl);
            continue;
        }
        software.reset(); // its destructor unbinds, so make ours current after it
        eglMakeCurrent(impl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl->context);
        noteDeviceMemory();
        listenForErrors(impl->record);
        return Context(std::move(impl));
    }
    if (software) {
        eglMakeCurrent(software->display, EGL_NO_SURFACE, EGL_NO_SURFACE, software->context);
        noteDeviceMemory();
        listenForErrors(software->record);
        return Context(std::move(software));
    }
    if (device) {
        throw GlError("device {} does not offer OpenGL 4.5; `vstudio devices` lists those that do", *device);
    }
    throw GlError("no device here offers OpenGL 4.5; install a GPU driver or Mesa's software renderer "
                  "(Debian: libgl1-mesa-dri libegl-mesa0)");
}

Context Context::adoptCurrent() {
    if (epoxy_gl_version() < 45) {
        throw GlError("the window's OpenGL is {}.{}, 4.5 is needed; update the graphics driver or set "
                      "LIBGL_ALWAYS_SOFTWARE=1 for Mesa's software renderer",
                      epoxy_gl_version() / 10, epoxy_gl_version() % 10);
    }
    auto impl = std::make_unique<Impl>();
    impl->device = describeCurrent();
    noteDeviceMemory();
    listenForErrors(impl->record);
    return Context(std::move(impl));
}

void Context::makeCurrent() {
    if (impl_->context != EGL_NO_CONTEXT) {
        eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context);
    }
    setCurrentRecord(&impl_->record);
}

const DeviceInfo& Context::device() const { return impl_->device; }

int Context::errorCount() const {
    if (currentRecord() == &impl_->record) {
        collectErrors();
    }
    return impl_->record.total();
}

void Context::watchHazards() { watchIn(impl_->record); }

std::vector<std::string> Context::takeHazards() {
    return impl_->record.hazards ? impl_->record.hazards->take() : std::vector<std::string>();
}

void Context::requireNoErrors() const {
    if (impl_->record.hazards && impl_->record.hazards->count() > 0) {
        throw GlError("{} hazards were found, so the result cannot be relied on; the first: {}",
                      impl_->record.hazards->count(), impl_->record.hazards->first());
    }
    if (const int count = errorCount(); count > 0) {
        throw GlError("{} reported {} OpenGL errors, so the result cannot be relied on; update the graphics "
                      "driver or choose another device with VOLUME_STUDIO_DEVICE=N",
                      impl_->device.renderer, count);
    }
}

void Context::requireDevice() {
    ContextRecord* record = currentRecord();
    const bool isReset = glGetGraphicsResetStatus() != GL_NO_ERROR;
    if (record != nullptr) {
        record->isLost = record->isLost || isReset;
    }
    if (isReset || (record != nullptr && record->isLost)) {
        throw ContextLost("the graphics driver was reset, and all that was on the device is gone; start the "
                          "program again");
    }
}

bool Context::isSoftware() { return describeCurrent().isSoftware; }

void Context::finish() {
    glFinish();
    collectErrors();
}

std::vector<ListedDevice> listDevices() {
    std::vector<ListedDevice> result;
    const auto displays = candidateDisplays();
    for (std::size_t i = 0; i < displays.size(); ++i) {
        ListedDevice listed{int(i), {}};
        const EGLContext context = contextOn(displays[i]);
        if (context != EGL_NO_CONTEXT) {
            listed.info = describeCurrent();
            eglMakeCurrent(displays[i], EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(displays[i], context);
        }
        result.push_back(std::move(listed));
    }
    return result;
}

} // namespace vs::gl

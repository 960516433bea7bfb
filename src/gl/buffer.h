// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/check.h"
#include "gl/handle.h"

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace vs::gl {

namespace detail {
void deleteBuffer(unsigned int name);
}

// Who can reach a buffer's bytes: shared ones the host too, by a pointer.
enum class Reach { Device, Shared };

// Memory on the device that shaders read and write (storage block, uniform block, indirect arguments). All
// calls need a current context. Sizes and offsets are in bytes.
class Buffer {
public:
    Buffer() = default;
    // Contents start as zeros. Throws GlError when the device has no room for it.
    Buffer(std::size_t sizeBytes, const std::string& label, Reach reach = Reach::Device);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] unsigned int name() const { return handle_.name(); }
    explicit operator bool() const { return bool(handle_); }

    void write(std::span<const std::byte> bytes, std::size_t offset = 0);
    template <typename T>
    void write(std::span<const T> values, std::size_t offset = 0) {
        static_assert(std::is_trivially_copyable_v<T>);
        write(std::as_bytes(values), offset);
    }
    template <typename T>
    void writeValue(const T& value, std::size_t offset = 0) {
        write(std::span<const T>(&value, 1), offset);
    }

    void read(std::span<std::byte> bytes, std::size_t offset = 0) const;
    template <typename T>
    [[nodiscard]] std::vector<T> read(std::size_t count, std::size_t offset = 0) const {
        static_assert(std::is_trivially_copyable_v<T>);
        std::vector<T> values(count);
        read(std::as_writable_bytes(std::span<T>(values)), offset);
        return values;
    }
    template <typename T>
    [[nodiscard]] T readValue(std::size_t offset = 0) const {
        return read<T>(1, offset).front();
    }

    // The bytes themselves, of a shared buffer only. What the device wrote is in them after waitForDevice(),
    // what is written to them the device's next work sees.
    [[nodiscard]] std::span<std::byte> shared() const;
    // Waits until what was submitted so far has written shared buffers.
    static void waitForDevice();

    // Sets bytes [offset, offset + sizeBytes) to zero; everything when sizeBytes is 0.
    void clear(std::size_t offset = 0, std::size_t sizeBytes = 0);
    // Makes the buffer at least this large, throwing the contents away when it has to grow (it grows by at
    // least half).
    void reserve(std::size_t sizeBytes);

    void bindStorage(unsigned int binding) const;
    void bindUniform(unsigned int binding) const;

private:
    Handle<detail::deleteBuffer> handle_;
    std::size_t size_ = 0;
    std::string label_;
    std::byte* shared_ = nullptr;
    bool isStaged_ = false; // out of the host's reach but by copying (gl/staging.h)
};

} // namespace vs::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

namespace vs::gl {

// Owns one GL object name: made = created, destroyed = deleted, move only. The context that made it (or one
// that shares with it) must be current when it is destroyed.
template <void (*Delete)(unsigned int)>
class Handle {
public:
    Handle() = default;
    explicit Handle(unsigned int name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (name_ != 0) {
            Delete(name_);
        }
    }

    [[nodiscard]] unsigned int name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    unsigned int name_ = 0;
};

} // namespace vs::gl

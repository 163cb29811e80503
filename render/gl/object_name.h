#pragma once

#include <utility>

namespace lumi {

/// Owns one GL object name and deletes it with `Delete`; 0 owns nothing. The context that made the
/// object must be current when the owner goes.
template <void (*Delete)(unsigned)>
class ObjectName {
 public:
    ObjectName() = default;
    explicit ObjectName(unsigned name) : name_(name) {}
    ~ObjectName() {
        if (name_ != 0) Delete(name_);
    }
    ObjectName(ObjectName&& other) noexcept : name_(std::exchange(other.name_, 0U)) {}
    ObjectName& operator=(ObjectName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }

    [[nodiscard]] unsigned get() const { return name_; }

 private:
    unsigned name_ = 0;
};

}  // namespace lumi

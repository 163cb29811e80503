#pragma once

#include <stdlib.h>

#include <cstdlib>
#include <string>

namespace lumi {

/// A variable of the environment while this object lives.
class SetVariable {
 public:
    SetVariable(const char* name, const std::string& value) : name_(name) {
        const char* before = std::getenv(name);
        was_set_ = before != nullptr;
        if (was_set_) before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    ~SetVariable() {
        if (was_set_) {
            ::setenv(name_, before_.c_str(), 1);
        } else {
            ::unsetenv(name_);
        }
    }
    SetVariable(const SetVariable&) = delete;
    SetVariable& operator=(const SetVariable&) = delete;

 private:
    const char* name_;
    std::string before_;
    bool was_set_ = false;
};

}  // namespace lumi

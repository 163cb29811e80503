#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

namespace lumi {

/// A folder of its own for one test, gone at its end. Its name has a blank and is not ASCII, as
/// users' folders do.
class ScratchFolder {
 public:
    ScratchFolder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "lumi tést XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }

 private:
    std::filesystem::path path_;
};

}  // namespace lumi

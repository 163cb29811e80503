#pragma once

#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
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
    /// Writes without waiting for the disk, for tests that write thousands of files.
    std::filesystem::path put(const std::string& name, std::span<const std::uint8_t> bytes) const {
        // Overwriting would make some file systems flush.
        std::filesystem::remove(path_ / name);
        std::ofstream stream(path_ / name, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
        return path_ / name;
    }
    std::filesystem::path put_text(const std::string& name, const std::string& text) const {
        return put(name, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }

 private:
    std::filesystem::path path_;
};

}  // namespace lumi

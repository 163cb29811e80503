#pragma once

#include <filesystem>

namespace lumi {

/// A folder of this process alone, gone with this object with all that is in it: where the
/// environment says that temporary files belong (TMPDIR), or in /tmp where it names no folder. Its
/// path is absolute, so that no program takes a part of it for more than a name.
class TemporaryFolder {
 public:
    /// Throws Error (E-FILE-WRITE) when it cannot be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
    std::filesystem::path path_;
};

}  // namespace lumi

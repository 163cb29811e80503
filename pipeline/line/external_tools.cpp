#include "pipeline/line/external_tools.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "calib/work/child_process.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

constexpr double kTimeLimitS = 30;

/// As the environment says, unless there is nothing.
std::filesystem::path folder_of_temporary_files() {
    std::error_code status;
    const auto folder = std::filesystem::temp_directory_path(status);
    return status ? "/tmp" : folder;
}

/// A file of this process alone, gone with this object.
class TemporaryFile {
 public:
    TemporaryFile() : path_((folder_of_temporary_files() / "lumi.XXXXXX").string()) {
        const int descriptor = ::mkostemp(path_.data(), O_CLOEXEC);
        if (descriptor >= 0) ::close(descriptor);
    }
    ~TemporaryFile() { ::unlink(path_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

 private:
    std::string path_;
};

}  // namespace

std::string colmap_version(const std::string& program) {
    std::string output;
    const TemporaryFile log;
    ChildCommand command;
    command.arguments = {program, "-h"};
    command.log_path = log.path();
    command.time_limit_s = kTimeLimitS;
    command.on_output = [&](std::string_view text) { output += text; };
    try {
        const SilentProgress progress;
        static_cast<void>(run_child(command, progress));
    } catch (const Error&) {
        return program + " not found";
    }
    return output.substr(0, output.find('\n'));
}

}  // namespace lumi

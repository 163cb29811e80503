#include "pipeline/line/colmap_version.h"

#include "calib/work/child_process.h"
#include "calib/work/error.h"
#include "calib/work/temporary_folder.h"

namespace lumi {

std::string colmap_version(const std::string& program) {
    constexpr double kTimeLimitS = 30;
    std::string output;
    try {
        const TemporaryFolder scratch;
        ChildCommand command;
        command.arguments = {program, "-h"};
        command.log_path = scratch / "log";
        command.time_limit_s = kTimeLimitS;
        command.on_output = [&](std::string_view text) { output += text; };
        const SilentProgress progress;
        static_cast<void>(run_child(command, progress));
    } catch (const Error&) {
        return program + " not found";
    }
    return output.substr(0, output.find('\n'));
}

}  // namespace lumi

#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {

/// What the built program did.
struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string talk;
};

/// For the shell; the path has no quotes in it.
inline std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// Runs the program that was built, with shell words `before` it, such as a time limit.
inline Outcome lumi(const std::string& arguments, const std::string& before = "") {
    const ScratchFolder scratch;
    const std::string command = before + " " + quoted(LUMI_BINARY) + " " + arguments + " > " +
                                quoted(scratch / "out") + " 2> " + quoted(scratch / "talk");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_whole_text(scratch / "out"),
            read_whole_text(scratch / "talk")};
}

}  // namespace lumi

#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "calib/work/progress.h"

namespace lumi {

/// What every command is told, and how it speaks: results to stdout, talk to stderr.
struct CommandContext {
    bool json = false;   ///< Results as one JSON object.
    bool quiet = false;  ///< No talk but errors.
    int verbosity = 0;
    int threads = 0;               ///< 0: what the configuration says, or all cores.
    std::function<void()> chosen;  ///< What the command line asks for; set while it is parsed.
    std::unique_ptr<Progress> progress;  ///< Present while `chosen` runs.
    std::function<void()> clear_bar;     ///< Clears the terminal's line for other words.
    int exit_code = 0;  ///< Of a command that did its work; an Error brings its own.
    /// The one object of --json, null until the command has a result. It is printed when the
    /// command has ended, together with what ended it.
    std::unique_ptr<nlohmann::ordered_json> object = std::make_unique<nlohmann::ordered_json>();

    void print_result(const std::string& text) const;
    /// With --json, leaves the result in `object`.
    void print_result(const nlohmann::ordered_json& result) const;
    void say(const std::string& text) const;
};

/// Gives the context its progress: a bar with time left on a terminal, plain lines elsewhere,
/// nothing when quiet.
void start_progress(CommandContext& context);

}  // namespace lumi

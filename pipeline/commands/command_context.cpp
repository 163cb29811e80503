#include "pipeline/commands/command_context.h"

#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "pipeline/commands/text_progress.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {

void CommandContext::print_result(const std::string& text) const {
    std::cout << text << std::flush;
}

void CommandContext::print_result(const nlohmann::ordered_json& json_result) const {
    std::cout << json_text(json_result) << std::flush;
}

void CommandContext::say(const std::string& text) const {
    if (!quiet) std::cerr << text << std::flush;
}

std::unique_ptr<Progress> make_progress(const CommandContext& context) {
    if (context.quiet) return std::make_unique<SilentProgress>();
    if (::isatty(STDERR_FILENO) != 0) return std::make_unique<BarProgress>(std::cerr);
    return std::make_unique<LineProgress>(std::cerr);
}

}  // namespace lumi

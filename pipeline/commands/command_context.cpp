#include "pipeline/commands/command_context.h"

#include <unistd.h>

#include <iostream>

#include "pipeline/commands/text_progress.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {

void CommandContext::print_result(const std::string& text) const {
    if (clear_bar) clear_bar();
    std::cout << text << std::flush;
}

void CommandContext::print_result(const nlohmann::ordered_json& result) const {
    if (json) {
        *object = result;
    } else {
        print_result(json_text(result));
    }
}

void CommandContext::say(const std::string& text) const {
    if (quiet) return;
    if (clear_bar) clear_bar();
    std::cerr << text << std::flush;
}

void start_progress(CommandContext& context) {
    if (context.quiet) {
        context.progress = std::make_unique<SilentProgress>();
    } else if (::isatty(STDERR_FILENO) != 0) {
        auto bar = std::make_unique<BarProgress>(std::cerr);
        context.clear_bar = [clearable = bar.get()] { clearable->clear(); };
        context.progress = std::move(bar);
    } else {
        context.progress = std::make_unique<LineProgress>(std::cerr);
    }
}

}  // namespace lumi

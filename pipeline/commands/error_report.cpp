#include "pipeline/commands/error_report.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/error_of_exception.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kBugExitCode = 1;

/// What ended a command.
struct CommandFailure {
    std::string code;
    std::string what;
    std::string advice;
    int exit_code = kBugExitCode;
};

CommandFailure failure_of(const Error& error) {
    return {error.code(), error.what(), error.advice(), error.exit_code()};
}

/// Nothing where `work` came to its end.
std::optional<CommandFailure> failure_after(const std::function<void()>& work) {
    try {
        work();
        return std::nullopt;
    } catch (const std::exception& exception) {
        if (const std::optional<Error> error = error_of_exception(exception)) {
            return failure_of(*error);
        }
        return CommandFailure{
            "E-INTERNAL", exception.what(),
            "this is a bug of lumi: please report it with the command and its output"};
    }
}

void tell(const CommandFailure& failure, const CommandContext& context) {
    if (context.clear_bar) context.clear_bar();
    std::cerr << "error " << failure.code << ": " << printable(failure.what) << "\n  -> "
              << printable(failure.advice) << std::endl;
}

Json json_of(const CommandFailure& failure) {
    return {{"code", failure.code},
            {"what", failure.what},
            {"advice", failure.advice},
            {"exit_code", failure.exit_code}};
}

/// A path may hold bytes that are not UTF-8: work that is done must not fail over its telling.
std::string object_text(const Json& object) {
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

int run_and_report_errors(const std::function<void()>& work, const CommandContext& context) {
    const std::optional<CommandFailure> failure = failure_after(work);
    if (failure) tell(*failure, context);
    if (context.json) {
        Json object = context.object->is_null() ? Json::object() : *context.object;
        if (failure) object["error"] = json_of(*failure);
        context.print_result(object_text(object));
    }
    return failure ? failure->exit_code : 0;
}

}  // namespace lumi

#include "pipeline/commands/error_report.h"

#include <filesystem>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

void print(const Error& error, const CommandContext& context) {
    if (context.clear_bar) context.clear_bar();
    std::cerr << "error " << error.code() << ": " << printable(error.what()) << "\n  -> "
              << printable(error.advice()) << std::endl;
    if (!context.json) return;
    const nlohmann::ordered_json object{{"error",
                                         {{"code", error.code()},
                                          {"what", error.what()},
                                          {"advice", error.advice()},
                                          {"exit_code", error.exit_code()}}}};
    std::cout << object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
              << std::endl;
}

Error as_error(const std::filesystem::filesystem_error& error) {
    const bool is_full = error.code() == std::errc::no_space_on_device;
    return {is_full ? ErrorKind::kResources : ErrorKind::kBadInput, "E-FILE-SYSTEM", error.what(),
            is_full ? "free some disk space and run the same command again"
                    : "check that the path exists and that you may use it"};
}

}  // namespace

int run_and_report_errors(const std::function<void()>& work, const CommandContext& context) {
    try {
        work();
        return 0;
    } catch (const Error& error) {
        print(error, context);
        return error.exit_code();
    } catch (const std::bad_alloc&) {
        const Error error(ErrorKind::kResources, "E-MEMORY", "memory ran out",
                          "set a smaller max_width_px under [capture], or fewer --threads");
        print(error, context);
        return error.exit_code();
    } catch (const std::filesystem::filesystem_error& failure) {
        const Error error = as_error(failure);
        print(error, context);
        return error.exit_code();
    } catch (const std::exception& failure) {
        std::cerr
            << "error E-INTERNAL: " << printable(failure.what())
            << "\n  -> this is a bug of lumi: please report it with the command and its output"
            << std::endl;
        return 1;
    }
}

}  // namespace lumi

#include "calib/work/error_of_exception.h"

#include <filesystem>
#include <new>
#include <opencv2/core.hpp>

namespace lumi {
namespace {

bool is_out_of_memory(const std::exception& exception) {
    if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr) return true;
    const auto* of_opencv = dynamic_cast<const cv::Exception*>(&exception);
    return of_opencv != nullptr && of_opencv->code == cv::Error::StsNoMem;
}

}  // namespace

std::optional<Error> error_of_exception(const std::exception& exception) {
    if (const auto* error = dynamic_cast<const Error*>(&exception)) return *error;
    if (is_out_of_memory(exception)) {
        return Error(ErrorKind::kResources, "E-MEMORY", "memory ran out",
                     "set a smaller max_width_px under [capture], or fewer --threads");
    }
    if (const auto* failure = dynamic_cast<const std::filesystem::filesystem_error*>(&exception)) {
        const bool is_full = failure->code() == std::errc::no_space_on_device;
        return Error(is_full ? ErrorKind::kResources : ErrorKind::kBadInput, "E-FILE-SYSTEM",
                     failure->what(),
                     is_full ? "free some disk space and run the same command again"
                             : "check that the path exists and that you may use it");
    }
    return std::nullopt;
}

bool ends_all_work(const Error& error) {
    const bool is_of_files = error.code() == "E-FILE-WRITE" || error.code() == "E-FILE-SYSTEM";
    return error.kind() == ErrorKind::kInterrupted ||
           (error.kind() == ErrorKind::kResources && is_of_files);
}

}  // namespace lumi

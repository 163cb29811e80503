#include "calib/ingest/made_by_lumi.h"

#include <system_error>

#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarkName = ".made-by-lumi";

}  // namespace

bool is_made_by_lumi(const fs::path& folder) {
    std::error_code ignored;
    return folder.extension() == ".lumi" || fs::exists(folder / kMarkName, ignored) ||
           (fs::exists(folder / "stages.json", ignored) &&
            fs::exists(folder / "config.toml", ignored));
}

void mark_as_made_by_lumi(const fs::path& folder) {
    std::error_code ignored;
    if (fs::exists(folder / kMarkName, ignored)) return;
    write_whole_text(folder / kMarkName,
                     "lumi made what lies in this folder, and looks for no photographs in it.\n");
}

}  // namespace lumi

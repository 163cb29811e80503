#include "calib/ingest/made_by_lumi.h"

#include <system_error>

#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarkName = ".made-by-lumi";

}  // namespace

bool is_mark_of_lumi(const std::string& file_name) { return file_name == kMarkName; }

bool is_marked_as_made_by_lumi(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder / kMarkName, ignored);
}

bool is_made_by_lumi(const fs::path& folder) {
    std::error_code ignored;
    return folder.extension() == ".lumi" || is_marked_as_made_by_lumi(folder) ||
           (fs::exists(folder / "stages.json", ignored) &&
            fs::exists(folder / "config.toml", ignored));
}

void mark_as_made_by_lumi(const fs::path& folder) {
    if (is_marked_as_made_by_lumi(folder)) return;
    write_whole_text(folder / kMarkName,
                     "lumi made what lies in this folder, and looks for no photographs in it.\n");
}

}  // namespace lumi

#include "calib/work/temporary_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <string>

#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

fs::path folder_of_temporary_files() {
    std::error_code status;
    const fs::path folder = fs::temp_directory_path(status);
    return fs::absolute(status ? "/tmp" : folder);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (folder_of_temporary_files() / "lumi-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) refuse_write(pattern, errno);
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace lumi

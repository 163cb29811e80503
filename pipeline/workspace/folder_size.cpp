#include "pipeline/workspace/folder_size.h"

#include <cstdint>

namespace lumi {

namespace fs = std::filesystem;

double folder_mib(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    return static_cast<double>(bytes) / (1 << 20);
}

}  // namespace lumi

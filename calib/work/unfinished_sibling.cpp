#include "calib/work/unfinished_sibling.h"

#include <cerrno>
#include <random>
#include <string_view>

#include "calib/work/whole_file.h"

namespace lumi {
namespace {

std::string random_letters() {
    constexpr std::string_view kLetters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    constexpr int kCount = 6;
    std::random_device random;
    std::uniform_int_distribution<std::size_t> index(0, kLetters.size() - 1);
    std::string letters;
    for (int i = 0; i < kCount; ++i) letters += kLetters[index(random)];
    return letters;
}

}  // namespace

std::string unfinished_prefix(const std::filesystem::path& target) {
    return "." + target.filename().string() + ".new-";
}

std::filesystem::path make_unfinished_sibling(const std::filesystem::path& target,
                                              const std::function<int(const char* path)>& make) {
    while (true) {
        std::filesystem::path path =
            target.parent_path() / (unfinished_prefix(target) + random_letters());
        if (make(path.c_str()) >= 0) return path;
        if (errno != EEXIST) refuse_write(target, errno);
    }
}

}  // namespace lumi

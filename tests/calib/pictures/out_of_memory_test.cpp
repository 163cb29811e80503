#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/error_of_exception.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

constexpr int kSide = 4000;
constexpr std::size_t kMib = std::size_t{1} << 20;

std::size_t address_space_in_use() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// This process gets no more than so much memory while this lives.
class MemoryLimit {
 public:
    explicit MemoryLimit(std::size_t more_bytes) {
        ::getrlimit(RLIMIT_AS, &old_limit_);
        rlimit limit = old_limit_;
        limit.rlim_cur = address_space_in_use() + more_bytes;
        ::setrlimit(RLIMIT_AS, &limit);
    }
    ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &old_limit_); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
    rlimit old_limit_{};
};

enum class Ending { kRead, kOutOfMemory, kRefused };

Ending ending_within(std::size_t more_bytes, const std::filesystem::path& picture) {
    const MemoryLimit limit(more_bytes);
    try {
        static_cast<void>(read_color_image(picture));
    } catch (const std::exception& exception) {
        const std::optional<Error> error = error_of_exception(exception);
        return error && error->code() == "E-MEMORY" ? Ending::kOutOfMemory : Ending::kRefused;
    }
    return Ending::kRead;
}

/// One colour: small files of large pictures.
class OutOfMemory : public testing::TestWithParam<std::string> {
 protected:
    void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "the sanitizer takes all of the address space";
#endif
        const cv::Mat plain(kSide, kSide, CV_8UC3, cv::Scalar(40, 80, 120));
        ASSERT_TRUE(cv::imwrite(picture_.string(), plain,
                                {cv::IMWRITE_JPEG_PROGRESSIVE, 1, cv::IMWRITE_WEBP_QUALITY, 101}));
    }

    ScratchFolder scratch_;
    std::filesystem::path picture_ = scratch_ / ("picture" + GetParam());
};

/// The raster takes 46 MiB, and decoders as much again.
TEST_P(OutOfMemory, IsNoDamageOfAPicture) {
    EXPECT_EQ(ending_within(1024 * kMib, picture_), Ending::kRead);
    int failures = 0;
    for (std::size_t mib = 16; mib <= 128; mib += 16) {
        const Ending ending = ending_within(mib * kMib, picture_);
        EXPECT_NE(ending, Ending::kRefused) << mib << " MiB";
        if (ending == Ending::kOutOfMemory) ++failures;
    }
    EXPECT_GT(failures, 2);
}

INSTANTIATE_TEST_SUITE_P(OfEachDecoder, OutOfMemory,
                         testing::Values(".png", ".jpg", ".webp", ".tif"),
                         [](const auto& ending) { return ending.param.substr(1); });

}  // namespace
}  // namespace lumi
